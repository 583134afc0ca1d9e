// SPDX-License-Identifier: AGPL-3.0-or-later
#include "adapter/wire.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstring>
#include <glm/common.hpp>
#include <limits>
#include <utility>

#include "adapter/wire_generated.h"
#include "adapter/wire_values.h"
#include "core/colour.h"

namespace povpreview {

using namespace wire_values;

namespace {

static_assert(std::endian::native == std::endian::little,
              "frame sizes are copied as they lie in memory");

CameraDescription camera(const wire::Camera& from) {
    CameraDescription to;
    to.kind = enumerator<CameraKind>(from.kind(), wire::CameraKind::MAX, "camera kind");
    to.location = vec3(from.location());
    to.direction = vec3(from.direction());
    to.right = vec3(from.right());
    to.up = vec3(from.up());
    to.sky = vec3(from.sky());
    to.look_at = vec3(from.look_at());
    to.angle = from.angle();
    to.aperture = from.aperture();
    to.focal_distance = from.focal_distance();
    to.blur_samples = from.blur_samples();
    to.perturbed = from.perturbed();
    return to;
}

LightDescription light(const wire::LightSource& from) {
    LightDescription to;
    to.kind = enumerator<LightKind>(from.kind(), wire::LightKind::MAX, "light kind");
    to.position = vec3(from.position());
    to.points_at = vec3(from.points_at());
    to.colour = vec3(from.colour());
    to.parallel = from.parallel();
    to.shadowless = from.shadowless();
    to.jitter = from.jitter();
    to.area_rows = from.area_rows();
    to.area_columns = from.area_columns();
    to.in_group = from.in_group();
    return to;
}

std::vector<KindCount> counts(const flatbuffers::Vector<flatbuffers::Offset<wire::Count>>* from) {
    check_list(from, max_kinds, "kinds");
    std::vector<KindCount> to;
    if (from)
        for (const wire::Count* c : *from) to.push_back({name(c->kind()), c->count()});
    return to;
}

SceneDescription scene(const wire::Scene& from) {
    constexpr std::uint32_t largest = std::numeric_limits<std::int32_t>::max();
    if (from.width() < 1 || from.height() < 1 || from.width() > largest || from.height() > largest)
        throw WireFault(fmt::format("an image size of {} x {}", from.width(), from.height()));
    check_list(from.lights(), max_lights, "lights");
    check_list(from.features(), max_kinds, "features");
    SceneDescription to;
    to.width = static_cast<int>(from.width());
    to.height = static_cast<int>(from.height());
    to.working_gamma = from.working_gamma();
    to.antialias = from.antialias();
    if (from.camera()) to.camera = camera(*from.camera());
    if (from.lights())
        for (const wire::LightSource* l : *from.lights()) to.lights.push_back(light(*l));
    if (from.features())
        for (const flatbuffers::String* f : *from.features()) to.features.push_back(name(f));
    to.textures = counts(from.textures());
    to.objects = counts(from.objects());
    to.background = vec3(from.background());
    check_list(from.files(), max_files, "files");
    to.alpha = from.alpha();
    to.output = text(from.output());
    if (from.files())
        for (const flatbuffers::String* f : *from.files()) to.files.push_back(text(f));
    to.first_look = from.first_look();
    check_list(from.rungs(), wire_max_rungs, "rungs");
    if (!from.rungs() || from.rungs()->size() == 0) return to;  // the target alone
    to.ladder.rungs.clear();
    for (const wire::Rung* r : *from.rungs())
        to.ladder.rungs.push_back({name(r->name()), r->ready()});
    return to;
}

/// Sums of light up to this over many samples, and its product with albedos, stay finite.
constexpr float brightest = 1e30f;

/// Light as a picture can show it: none where it is no number, as in POV-Ray's own pictures.
glm::vec3 shown(glm::vec3 light) {
    for (int c = 0; c < 3; ++c)
        if (std::isnan(light[c])) light[c] = 0;
    return glm::clamp(light, -brightest, brightest);
}

template <class Vector>
void check_length(const Vector* vector, std::uint32_t count, const char* what) {
    if (vector && vector->size() != count)
        throw WireFault(fmt::format("{} {} in an answer of {}", vector->size(), what, count));
}

}  // namespace

// ---- framing

std::size_t FrameReader::take_header(std::span<const std::byte> bytes) {
    const std::size_t taken = std::min(sizeof header_ - header_have_, bytes.size());
    std::memcpy(header_ + header_have_, bytes.data(), taken);
    header_have_ += taken;
    if (header_have_ == sizeof header_) {
        std::uint32_t size = 0;
        std::memcpy(&size, header_, sizeof size);
        constexpr std::size_t smallest = 8;  // a root offset and an identifier
        if (size < smallest || size > wire_max_frame)
            throw WireFault(fmt::format("a message of {} bytes", size));
        size_ = size;
    }
    return taken;
}

void FrameReader::feed(std::span<const std::byte> bytes,
                       const std::function<void(std::span<const std::byte>)>& frame) {
    while (!bytes.empty()) {
        if (header_have_ < sizeof header_) {
            bytes = bytes.subspan(take_header(bytes));
            continue;
        }
        const auto part = bytes.first(std::min(size_ - body_.size(), bytes.size()));
        body_.insert(body_.end(), part.begin(), part.end());
        bytes = bytes.subspan(part.size());
        if (body_.size() == size_) {
            frame(body_);
            body_.clear();
            header_have_ = 0;
        }
    }
}

// ---- previewer to tracer

namespace {

void append_order(std::vector<std::byte>& out, flatbuffers::FlatBufferBuilder& builder,
                  wire::Order kind, flatbuffers::Offset<void> order) {
    builder.Finish(wire::CreateToTracer(builder, kind, order), "PVTR");
    const std::uint32_t size = builder.GetSize();
    const std::size_t end = out.size();
    out.resize(end + sizeof size + size);
    std::memcpy(out.data() + end, &size, sizeof size);
    std::memcpy(out.data() + end + sizeof size, builder.GetBufferPointer(), size);
}

}  // namespace

void append_trace(std::vector<std::byte>& out, std::uint64_t batch, const BatchKind& kind,
                  std::span<const glm::dvec2> positions) {
    assert(!positions.empty() && positions.size() <= wire_max_batch);
    flatbuffers::FlatBufferBuilder builder(positions.size_bytes() + 128);
    wire::Vec2d* to = nullptr;
    const auto vector =
        builder.CreateUninitializedVectorOfStructs<wire::Vec2d>(positions.size(), &to);
    for (const glm::dvec2& p : positions) *to++ = wire::Vec2d(p.x, p.y);
    const auto trace = wire::CreateTrace(builder, batch, static_cast<wire::RayKind>(kind.kind),
                                         static_cast<wire::Parts>(kind.parts), vector, kind.rung);
    append_order(out, builder, wire::Order::Trace, trace.Union());
}

void append_image(std::vector<std::byte>& out, std::uint32_t first,
                  std::span<const PixelLight> pixels, bool last) {
    assert(pixels.size() <= wire_max_batch);
    flatbuffers::FlatBufferBuilder builder(pixels.size_bytes() + 128);
    wire::Light* to = nullptr;
    const auto vector = builder.CreateUninitializedVectorOfStructs<wire::Light>(pixels.size(), &to);
    for (const PixelLight& p : pixels) {
        const float red = p.known ? p.colour.r : std::numeric_limits<float>::quiet_NaN();
        *to++ = wire::Light(wire::Vec3f(red, p.colour.g, p.colour.b), p.transmittance);
    }
    const auto image = wire::CreateImage(builder, first, vector, last);
    append_order(out, builder, wire::Order::Image, image.Union());
}

// ---- tracer to previewer

report::Answer::Answer(const wire::Answer& table)
    : table_(&table),
      batch_(table.batch()),
      first_(table.first()),
      count_(table.count()),
      rung_(table.rung()) {
    if (count_ < 1 || count_ > wire_max_batch || first_ > wire_max_batch - count_)
        throw WireFault(fmt::format("an answer for samples {} to {} of a batch", first_,
                                    std::uint64_t{first_} + count_));
    check_length(table.light(), count_, "colours");
    check_length(table.surface(), count_, "surfaces");
    check_length(table.shading(), count_, "shadings");
    check_length(table.signature(), count_, "signatures");
    check_length(table.cost_ns(), count_, "costs");
    if (!table.failed() || table.failed()->size() == 0) return;
    failed_.resize(count_);
    for (const std::uint32_t offset : *table.failed()) {
        if (offset >= count_)
            throw WireFault(fmt::format("failed sample {} in an answer of {}", offset, count_));
        failed_[offset] = true;
    }
}

void report::Answer::check_asked(std::uint32_t batch_count, const BatchKind& asked) const {
    const auto [kind, rung, parts] = asked;
    if (std::uint64_t{first_} + count_ > batch_count)
        throw WireFault(fmt::format("an answer for samples {} to {} of a batch of {}", first_,
                                    std::uint64_t{first_} + count_, batch_count));
    const bool full = kind == RayKind::full;
    if (full && rung_ < rung)
        throw WireFault(fmt::format("samples of rung {} instead of {}", rung_, rung));
    const auto require = [&](bool wanted, const void* vector, const char* what) {
        if (wanted && !vector) throw WireFault(fmt::format("an answer without {}", what));
    };
    require(full, table_->light(), "colours");
    require(!full || contains(parts, Parts::surface), table_->surface(), "surfaces");
    require(kind == RayKind::albedo || (full && contains(parts, Parts::shading)), table_->shading(),
            "albedo");
    require(kind == RayKind::probe || (full && contains(parts, Parts::signature)),
            table_->signature(), "signatures");
    require(true, table_->cost_ns(), "costs");
}

void report::Answer::read(std::uint32_t i, Sample& sample) const {
    assert(i < count_);
    const Sample blank{.position = sample.position,
                       .kind = sample.kind,
                       .rung = sample.kind == RayKind::full ? rung_ : target_rung,
                       .parts = sample.parts};
    sample = blank;
    if (const auto* light = table_->light()) {
        sample.colour = vec3(light->Get(i)->colour());
        sample.transmittance = light->Get(i)->transmittance();
    }
    if (const auto* surface = table_->surface()) {
        sample.surface = surface->Get(i)->identity();
        sample.reflected_surface = surface->Get(i)->reflected();
        sample.depth = surface->Get(i)->depth();
        sample.normal = vec3(surface->Get(i)->normal());
    }
    if (const auto* shading = table_->shading()) {
        sample.albedo = vec3(shading->Get(i)->albedo());
        if (sample.kind == RayKind::full) {  // an albedo ray knows nothing of these
            sample.illumination = vec3(shading->Get(i)->illumination());
            sample.remainder = vec3(shading->Get(i)->remainder());
        }
    }
    if (const auto* s = table_->signature()) {
        const wire::Signature& from = *s->Get(i);
        sample.signature = {from.primary(), from.lights(), from.reflected(), from.refracted()};
    }
    const bool usable = (failed_.empty() || !failed_[i]) && std::isfinite(sample.transmittance) &&
                        std::isfinite(sample.depth) && finite(sample.normal);
    if (!usable) {
        sample = blank;
        sample.failed = true;
    }
    sample.colour = shown(sample.colour);
    if (!finite(sample.albedo) || !finite(sample.illumination) || !finite(sample.remainder)) {
        sample.albedo = sample.illumination = glm::vec3(0);
        sample.remainder = sample.colour;
    }
    sample.illumination = shown(sample.illumination);
    sample.remainder = shown(sample.remainder);
    if (table_->cost_ns()) sample.cost_ns = table_->cost_ns()->Get(i);
}

Report decode_report(std::span<const std::byte> frame) {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(frame.data());
    flatbuffers::Verifier verifier(bytes, frame.size());
    if (frame.size() < 8 || !flatbuffers::BufferHasIdentifier(bytes, "PVPR") ||
        !verifier.VerifyBuffer<wire::ToPreviewer>("PVPR"))
        throw WireFault("bytes that are no report");
    const auto* root = flatbuffers::GetRoot<wire::ToPreviewer>(bytes);
    if (!root->report()) throw WireFault("an empty report");
    switch (root->report_type()) {
        case wire::Report::Hello: {
            const auto* from = root->report_as_Hello();
            return report::Hello{from->version(), text(from->povray()), from->threads()};
        }
        case wire::Report::Progress: {
            const auto* from = root->report_as_Progress();
            return report::Progress{
                enumerator<report::Stage>(from->stage(), wire::Stage::MAX, "stage"), from->done(),
                from->total()};
        }
        case wire::Report::Scene:
            return scene(*root->report_as_Scene());
        case wire::Report::Answer:
            return report::Answer(*root->report_as_Answer());
        case wire::Report::Geometry:
            return decode_geometry(*root->report_as_Geometry());
        case wire::Report::Texels:
            return decode_texels(*root->report_as_Texels());
        case wire::Report::RungReady:
            return report::RungReady{root->report_as_RungReady()->rung()};
        case wire::Report::Failure: {
            const auto* from = root->report_as_Failure();
            return report::Failure{text(from->message()), text(from->file()), from->line()};
        }
        case wire::Report::NONE:
            break;
    }
    throw WireFault(
        fmt::format("a report of unknown kind {}", static_cast<unsigned>(root->report_type())));
}

}  // namespace povpreview
