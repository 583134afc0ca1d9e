// SPDX-License-Identifier: AGPL-3.0-or-later
//
// The mesh previewer on the ladder of accuracy: samples traced at a low rung are traced again at
// higher ones, and shown until then as what was learnt so far lets them look there.
#include <algorithm>
#include <cmath>

#include "core/mesh_previewer.h"
#include "core/sound_shading.h"

namespace povpreview {

namespace {

/// What is shown of samples not traced again yet is brought up to date when so many times as many
/// were traced as the last time: each step is too small to be seen as one.
constexpr double growth = 3;
constexpr std::size_t first_shift = 8;

/// The same for what a rung shows that has become better: it is close already.
constexpr std::size_t first_refresh = 128;

/// Where fewer pixels than one in so many were sampled below the target, tracing them again holds
/// up a lattice by little.
constexpr std::size_t pixels_to_one_low = 120;

/// More positions than this teach nothing: cornell and patio-radio_37 come to each error as soon.
constexpr std::size_t most_learnt = 2048;

}  // namespace

void MeshPreviewer::LowSample::show_at(SampleId sample, VertexId vertex) {
    for (std::size_t i = 0; i < samples.size(); ++i)
        if (!samples[i].valid()) {
            samples[i] = sample;
            vertices[i] = vertex;
            return;
        }
}

/// Remembers a sample that is below the target; null for all others. The pointer is good until the
/// next call.
MeshPreviewer::LowSample* MeshPreviewer::keep_low(const Sample& sample, bool usable,
                                                  std::optional<Pixel> pixel) {
    if (sample.rung == target_rung) return nullptr;
    low_.push_back({.position = sample.position,
                    .pixel = pixel,
                    .surface = sample.surface,
                    .light = light_of(sample, has_sound_shading(sample)),
                    .known = usable,
                    .rung = sample.rung});
    ++low_left_;
    return &low_.back();
}

void MeshPreviewer::accept_ready(Rung rung) {
    climb_.ready(rung);
    if (rung == target_rung) return;
    // What was not traced again since the last time stands as it is shown.
    for (LowSample& low : low_) {
        if (low.rung != rung) continue;
        if (low.stale) low.light = refresh_.apply(low.position, low.surface, low.light);
        low.stale = true;
    }
    refresh_ = RungShift(std::max(width_, height_));
    low_scanned_ = 0;
    shift_learnt_ = 0;
    shift_again_at_ = first_refresh;
}

/// Goes to the next rung when it is time to, or when there is nothing more to do on this one.
bool MeshPreviewer::climb(bool at_rest) {
    if (!climb_.climb(at_rest)) return false;
    low_scanned_ = shift_learnt_ = 0;
    for (const LowSample& low : low_)
        if (low.known && low.rung == climb_.current()) show(low, low.light);
    shift_all();
    if (climb_.at_target()) reach_target();
    return true;
}

/// From now on samples cost what the picture will cost, and squares may be filled. Where they are
/// cheap and the picture has hardly begun, it goes on as if there had been no lower rung.
void MeshPreviewer::reach_target() {
    const double full_ns = climb_.cost_ns(target_rung);
    plan_ = plan_at(full_ns);
    if (options_.lattice && plan_.lattice &&
        squares_.answered() <= std::max(2 * grid_.size(), squares_.pixels() / pixels_to_one_low))
        return start_lattice();
    albedo_fetch_.set_price(albedo_price_at(full_ns));
    for (std::size_t square = 0; square < squares_.squares(); ++square)
        if (is_dense(square)) squares_.fill(square);
}

/// Some positions of the first samples, spread over the image, traced at the next rung to learn
/// what that costs.
std::optional<Request> MeshPreviewer::next_trial_above() {
    if (grid_costs_.size() < early_samples_ || climb_.next() == climb_.current())
        return std::nullopt;
    // Not in order: the first samples are the image's corners, which are not like the rest.
    for (std::size_t i = 0; i < low_.size(); ++i) {
        const std::size_t low = (i * 61 + 30) % low_.size();
        if (low_[low].asked || climb_.place(low_[low].rung) >= climb_.place(climb_.next()))
            continue;
        if (!climb_.take_trial(!cost_known())) break;
        return ask_retrace(low, climb_.next());
    }
    return std::nullopt;
}

/// The first sample that was traced below a rung, or there when it was worse, and not asked for
/// again since.
std::optional<Request> MeshPreviewer::next_retrace(Rung rung) {
    if (low_left_ == 0) return std::nullopt;
    for (; low_scanned_ < low_.size(); ++low_scanned_) {
        const LowSample& low = low_[low_scanned_];
        if (!low.asked && (low.rung < rung || (low.stale && low.rung == rung)))
            return ask_retrace(low_scanned_++, rung);
    }
    return std::nullopt;
}

Request MeshPreviewer::ask_retrace(std::size_t low, Rung rung) {
    low_[low].asked = true;
    Pending pending{Pending::Use::retrace};
    pending.low = low;
    pending_.push_back(pending);
    return Request{low_[low].position, RayKind::full, rung};
}

void MeshPreviewer::accept_retrace(const Pending& pending, const Sample& sample, bool usable) {
    LowSample& low = low_[pending.low];
    low.asked = low.stale = false;
    const bool at_target = sample.rung == target_rung;
    if (usable) {
        if (low.known) learn_shift(low, sample);
        low.light = light_of(sample, has_sound_shading(sample));
        low.known = true;
    } else if (at_target && low.pixel) {
        squares_.spoil(*low.pixel);
    }
    low.rung = sample.rung;
    // What is above the current rung would stick out; it is shown when that is reached.
    if (usable && low.rung <= climb_.current()) show(low, shifted(low, climb_.current()));
    if (at_target && --low_left_ == 0 && climb_.at_target()) {
        low_ = {};
        low_scanned_ = 0;
    }
    climb();
    if (shift_learnt_ >= shift_again_at_ && low_left_ > 0) shift_all();
}

/// A sample in the light of a rung, as far as that has been learnt.
RungLight MeshPreviewer::shifted(const LowSample& low, Rung rung) const {
    RungLight light = low.stale ? refresh_.apply(low.position, low.surface, low.light) : low.light;
    for (std::size_t i = climb_.place(low.rung); i < climb_.place(rung); ++i)
        light = shifts_[i].apply(low.position, low.surface, light);
    return light;
}

/// Where rungs were skipped between the two, what is not known of them goes to the last one.
void MeshPreviewer::learn_shift(const LowSample& low, const Sample& sample) {
    if (shift_learnt_ == most_learnt) return;
    const RungLight light = light_of(sample, has_sound_shading(sample));
    if (sample.rung == low.rung) {
        refresh_.learn(low.position, low.surface, low.light, light);
        ++shift_learnt_;
    }
    if (sample.rung <= low.rung) return;
    climb_.compare(low.rung, low.light.colour, light.colour);
    const std::size_t last = climb_.place(sample.rung) - 1;
    const RungLight below = shifted(low, climb_.rung(last));
    shifts_[last].learn(low.position, low.surface, below, light);
    ++shift_learnt_;
}

void MeshPreviewer::show(const LowSample& low, const RungLight& light) {
    if (low.pixel) {
        squares_.replace(*low.pixel, light.colour);
        if (lattice_) lattice_->accept(*low.pixel, light);
    }
    for (std::size_t i = 0; i < low.samples.size() && low.samples[i].valid(); ++i)
        if (mesh_.relight(low.samples[i], light) && refining_ &&
            mesh_.triangulation().alive(low.vertices[i]))
            queue_around(low.vertices[i]);
}

/// Brings up to date all that is shown of samples not traced again yet.
void MeshPreviewer::shift_all() {
    shift_again_at_ =
        std::max(first_shift, static_cast<std::size_t>(growth * double(shift_learnt_)));
    for (const LowSample& low : low_)
        if (low.known && (low.rung < climb_.current() || (low.stale && !climb_.at_target())))
            show(low, shifted(low, climb_.current()));
}

}  // namespace povpreview
