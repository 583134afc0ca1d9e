// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/detail/curved_items.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <optional>
#include <span>

#include "core/detail/row_bands.h"
#include "core/detail/solid_rays.h"
#include "core/detail/unknown_boxes.h"

namespace povpreview {

namespace {

/// Rows that are drawn in one go.
constexpr int band_rows = 64;

/// What drawing may take: roots and values of solids, each for ray_lanes rays and so some ten to
/// twenty nanoseconds. An object for each pixel of its box, and all objects for each pixel of the
/// picture, or in all if the picture is small; what would take more is left unknown, the dearest
/// first. An object that certainly takes less than the last figure need not be tried out.
constexpr double most_of_object = 112, most_of_all = 128;
constexpr double most_of_object_in_all = 5e6, most_in_all = 2e7;
constexpr double certainly_little = 4;

/// Rows of an object that are drawn to try out what it takes, and of wide ones one block of so
/// many, but not fewer than some.
constexpr int rows_tried = 5, blocks_to_one_tried = 4, blocks_tried = 4;

/// A point with |f| within this may lie on either side of a solid, since rounding decides, ours or
/// the ray tracer's (POV-Ray's own tolerances are of this order). A half space has no size of its
/// own to measure that by; the point's distance from the eye serves instead.
constexpr double doubt = 1e-9;

/// Depth of a condition's stack; DrawableScene allows no more.
constexpr std::size_t stack_depth = 32;

/// A truth value for each of the rays worked on.
using Mask = std::uint32_t;
constexpr Mask all_lanes = (Mask{1} << ray_lanes) - 1;

/// Where a condition holds for certain, and where it may.
struct Verdict {
    Mask sure = all_lanes, possible = all_lanes;
};

/// The truth values of all lanes, 0 or 1 each.
using Flags = std::array<std::uint8_t, ray_lanes>;

/// Eight of them at a time: the product has the sum of those shifted to each place in its top byte.
Mask mask_of(const Flags& flags) {
    static_assert(ray_lanes == 16 && std::endian::native == std::endian::little);
    std::uint64_t halves[2];
    std::memcpy(halves, flags.data(), sizeof halves);
    constexpr std::uint64_t gather = 0x0102040810204080;
    return static_cast<Mask>(halves[0] * gather >> 56 | halves[1] * gather >> 56 << 8);
}

/// `t`: of the points that have the values. `unit`: what their distance from the eye is by it, in
/// units of the values; 0 where these have a size of their own.
POVPREVIEW_WIDE_VECTORS
void find_inside(const RayLanes& __restrict values, const RayLanes& __restrict t, double unit,
                 Flags& __restrict sure, Flags& __restrict possible) {
    for (int i = 0; i < ray_lanes; ++i) {
        const double slack = unit > 0 ? doubt * unit * std::abs(t[i]) : doubt;
        sure[i] = values[i] < -slack;
        possible[i] = values[i] <= slack;
    }
}
Verdict inside(const RayLanes& values, const RayLanes& t, double unit) {
    Flags sure, possible;
    find_inside(values, t, unit, sure, possible);
    return {mask_of(sure), mask_of(possible)};
}

/// Those that are no farther, but for what ItemCanvas::draw() has to hear of as a tie.
POVPREVIEW_WIDE_VECTORS
void find_nearer(const RayLanes& __restrict nearness, const RayLanes& __restrict than,
                 Flags& __restrict flags) {
    for (int i = 0; i < ray_lanes; ++i)
        flags[i] = nearness[i] >= than[i] - ItemCanvas::coincidence * std::abs(than[i]);
}

/// One of the solids that a point must all be inside of, or not, for a condition to hold.
struct Literal {
    std::int32_t slot;
    bool inside;
};

/// A condition as such a list, if it can be written as one: most can.
std::optional<std::vector<Literal>> conjunction(const std::vector<ConditionStep>& steps) {
    std::vector<std::vector<Literal>> stack;
    for (ConditionStep step : steps) {
        if (step >= 0) {
            stack.push_back({{step, true}});
        } else if (step == condition_not && stack.back().size() == 1) {
            stack.back()[0].inside = !stack.back()[0].inside;
        } else if (step == condition_and) {
            const std::vector<Literal> last = std::move(stack.back());
            stack.pop_back();
            stack.back().insert(stack.back().end(), last.begin(), last.end());
        } else {
            return std::nullopt;
        }
    }
    return stack.empty() ? std::vector<Literal>{} : stack.front();
}

/// What z in a solid's frame is by distance in the world.
double z_scale(const Solid& solid) {
    return glm::length(glm::dvec3(solid.to_frame[0].z, solid.to_frame[1].z, solid.to_frame[2].z));
}

/// One object, row by row.
class CurvedDrawing {
   public:
    /// `nearest`: greatest_nearness() of the object. `box`: the pixels to be drawn.
    CurvedDrawing(const DrawableScene& scene, const CurvedObject& object, double nearest,
                  const PixelBox& box, const PixelRays& rays, ItemCanvas& canvas,
                  const PaintingPace& pace)
        : scene_(scene),
          object_(object),
          box_(box),
          rays_(rays),
          canvas_(canvas),
          pace_(pace),
          nearest_(std::min(nearest, std::numeric_limits<double>::max())) {
        const auto slot = [&](std::uint32_t solid) {
            const auto found = std::find(solids_.begin(), solids_.end(), solid);
            if (found != solids_.end()) return static_cast<std::int32_t>(found - solids_.begin());
            solids_.push_back(solid);
            return static_cast<std::int32_t>(solids_.size() - 1);
        };
        for (const CurvedPiece& piece : pieces()) {
            piece_slots_.push_back(slot(piece.solid));
            steps_.emplace_back();
            for (ConditionStep step : steps(piece))
                steps_.back().push_back(step < 0 ? step : slot(static_cast<std::uint32_t>(step)));
            conjunctions_.push_back(conjunction(steps_.back()));
        }
        rows_.resize(solids_.size());
        units_.resize(solids_.size());
        for (const std::uint32_t number : solids_) {
            const Solid& made = scene.solids[number];
            intricate_.push_back(is_intricate(made.kind) ? prepared(scene, made) : nullptr);
        }
    }

    void draw() {
        for (int y = box_.top; y < box_.bottom && !pace_.stopped(); ++y)
            draw_row(y, box_.left, box_.right);
    }

    /// What that will take, for each of its pixels.
    double work_a_pixel() {
        if (const double most = most_work_a_block() / ray_lanes; most <= certainly_little)
            return most;
        // They are drawn again later, which changes nothing.
        const int height = box_.bottom - box_.top, rows = std::min(rows_tried, height);
        // Of narrow boxes all blocks are tried.
        const int width = box_.right - box_.left, blocks = (width + ray_lanes - 1) / ray_lanes;
        const int step = std::clamp(blocks / blocks_tried, 1, blocks_to_one_tried);
        int tried = 0;
        for (int i = 0; i < rows && !pace_.stopped(); ++i) {
            const int y = box_.top + (2 * i + 1) * height / (2 * rows);
            for (int block = i % step; block < blocks; block += step) {
                const int left = box_.left + block * ray_lanes;
                const int right = std::min(left + ray_lanes, box_.right);
                draw_row(y, left, right);
                tried += right - left;
            }
        }
        return double(work_) / std::max(tried, 1);
    }

   private:
    void draw_row(int y, int left, int right) {
        const double* const shown = canvas_.nearness_from(canvas_.index(0, y));
        for (int x = left; x < right;) {
            const int count = gather(shown, x, right);
            if (count > 0) draw_gathered(y, count);
        }
        pace_.row_done();
    }

    /// Takes the next pixels of a row, from `x` on, that may show the object: not all of it is
    /// behind what they show. How many.
    int gather(const double* shown, int& x, int right) {
        int count = 0;
        for (; x < right && count < ray_lanes; ++x) {
            pixels_[std::size_t(count)] = x;
            count += !(shown[x] > nearest_);
        }
        // The rays that are left over are those of the last pixel.
        for (int i = 0; i < ray_lanes && count > 0; ++i)
            x_[i] = pixels_[std::size_t(std::min(i, count - 1))] + .5;
        return count;
    }

    void prepare_row(int y) {
        if (y == row_) return;
        row_ = y;
        const double length = glm::length(rays_.direction({(box_.left + box_.right) / 2., y + .5}));
        in_world_ = row_rays(rays_, glm::dmat4x3(1), y + .5);
        for (std::size_t i = 0; i < solids_.size(); ++i) {
            const Solid& solid = scene_.solids[solids_[i]];
            rows_[i] = row_rays(rays_, solid.to_frame, y + .5);
            units_[i] = solid.kind == Solid::Kind::half_space ? length * z_scale(solid) : 0;
        }
    }

    std::span<const CurvedPiece> pieces() const {
        return std::span(scene_.pieces).subspan(object_.first_piece, object_.pieces);
    }
    std::span<const ConditionStep> steps(const CurvedPiece& piece) const {
        return std::span(scene_.conditions).subspan(piece.first_condition, piece.conditions);
    }

    /// Each root of each piece might have to be tried by all of its condition.
    double most_work_a_block() const {
        const auto cost = [&](std::int32_t slot) {
            const IntricateSolid* intricate = intricate_[std::size_t(slot)].get();
            return double(intricate ? intricate->cost() : 1);
        };
        constexpr double roots = 2;
        double sum = 0;
        for (std::size_t p = 0; p < steps_.size(); ++p) {
            sum += cost(piece_slots_[p]);
            for (ConditionStep step : steps_[p])
                if (step >= 0) sum += roots * cost(step);
        }
        return sum;
    }

    void draw_gathered(int y, int count) {
        prepare_row(y);
        const std::size_t row = canvas_.index(0, y);
        const double* const shown = canvas_.nearness_from(row);
        const Mask within = all_lanes >> (ray_lanes - count);
        RayLanes before{};
        const auto look = [&] {
            for (int i = 0; i < count; ++i) before[i] = shown[pixels_[std::size_t(i)]];
        };
        look();
        Flags is_nearer;
        for (std::uint32_t p = 0; p < object_.pieces; ++p) {
            const auto slot = static_cast<std::size_t>(piece_slots_[p]);
            // After a mirror the nearest may lie before it.
            find_roots_of(slot, steps_[p].empty() && !rays_.after_mirror);
            for (const RayLanes& roots : roots_) {
                find_nearness(rays_.orthographic, roots, nearness_);
                find_nearer(nearness_, before, is_nearer);
                const Mask seen = within & mask_of(is_nearer);
                if (seen == 0) continue;
                const Verdict verdict = conjunctions_[p] ? all_hold(*conjunctions_[p], roots, seen)
                                                         : holds(steps_[p], roots, seen);
                if ((seen & verdict.possible) == 0) continue;
                draw_lanes(row, seen, verdict, ItemCanvas::piece_bit | (object_.first_piece + p));
                look();
            }
        }
    }

    void find_roots_of(std::size_t slot, bool nearest_only) {
        const IntricateSolid* intricate = intricate_[slot].get();
        work_ += intricate ? intricate->cost() : 1;
        if (intricate)
            find_roots(*intricate, rows_[slot], x_, in_world_, object_.bounds, nearest_only,
                       roots_);
        else
            find_roots(scene_.solids[solids_[slot]], rows_[slot], x_, roots_);
    }
    void find_values_of(std::size_t slot, const RayLanes& t, Mask lanes) {
        const IntricateSolid* intricate = intricate_[slot].get();
        work_ += intricate ? intricate->cost() : 1;
        if (intricate)
            find_values(*intricate, rows_[slot], x_, t, lanes, values_);
        else
            find_values(scene_.solids[solids_[slot]], rows_[slot], x_, t, values_);
    }

    void draw_lanes(std::size_t row, Mask seen, const Verdict& verdict, ItemCanvas::Source source) {
        for (Mask left = seen & verdict.possible; left != 0; left &= left - 1) {
            const int i = std::countr_zero(left);
            if (!std::isfinite(nearness_[i])) continue;
            const std::size_t pixel = row + std::size_t(pixels_[std::size_t(i)]);
            if (verdict.sure >> i & 1)
                canvas_.draw(pixel, nearness_[i], source);
            else
                canvas_.hide(pixel, nearness_[i]);
        }
    }

    /// For the lanes asked for; of others anything may be said. What rules all of them out is asked
    /// sooner from then on: it will do so for most of their neighbours.
    Verdict all_hold(std::vector<Literal>& literals, const RayLanes& t, Mask lanes) {
        Verdict all{lanes, lanes};
        for (std::size_t i = 0; i < literals.size(); ++i) {
            const auto slot = static_cast<std::size_t>(literals[i].slot);
            find_values_of(slot, t, all.possible);
            const Verdict in = inside(values_, t, units_[slot]);
            all.sure &= literals[i].inside ? in.sure : ~in.possible;
            all.possible &= literals[i].inside ? in.possible : ~in.sure;
            if (all.possible != 0) continue;
            std::swap(literals[i], literals[i / 2]);
            break;
        }
        return all;
    }

    /// The same of any condition.
    Verdict holds(const std::vector<ConditionStep>& condition, const RayLanes& t, Mask lanes) {
        Verdict stack[stack_depth];  // without a condition: everywhere
        std::size_t top = 0;
        for (ConditionStep step : condition) {
            switch (step) {
                case condition_not:
                    stack[top - 1] = {~stack[top - 1].possible, ~stack[top - 1].sure};
                    break;
                case condition_and:
                    --top;
                    stack[top - 1].sure &= stack[top].sure;
                    stack[top - 1].possible &= stack[top].possible;
                    break;
                case condition_or:
                    --top;
                    stack[top - 1].sure |= stack[top].sure;
                    stack[top - 1].possible |= stack[top].possible;
                    break;
                default: {
                    const auto slot = static_cast<std::size_t>(step);
                    find_values_of(slot, t, lanes);
                    stack[top++] = inside(values_, t, units_[slot]);
                }
            }
        }
        return stack[0];
    }

    const DrawableScene& scene_;
    const CurvedObject& object_;
    const PixelBox box_;
    const PixelRays& rays_;
    ItemCanvas& canvas_;
    const PaintingPace& pace_;
    const double nearest_;  // finite: something unknown hides what may be anywhere
    std::size_t work_ = 0;
    std::vector<std::uint32_t> solids_;              // that it needs; a slot is a place among them
    std::vector<std::int32_t> piece_slots_;          // by piece
    std::vector<std::vector<ConditionStep>> steps_;  // of each piece, with slots for solids
    std::vector<std::optional<std::vector<Literal>>> conjunctions_;  // the same, where they are so
    std::vector<std::unique_ptr<IntricateSolid>> intricate_;         // by slot; null for the others
    std::vector<RowRays> rows_;                                      // by slot
    std::vector<double> units_;                                      // by slot, see inside()
    int row_ = -1;                                                   // that these are of
    RowRays in_world_;
    std::array<int, ray_lanes> pixels_{};  // of the row, whose rays are worked on
    RayLanes x_{}, values_{}, nearness_{};
    std::vector<RayLanes> roots_;
};

bool is_sensible(const DrawableScene& scene, const Solid& solid) {
    double sum = 0;  // of zeros, unless something is not finite
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 3; ++j) sum += 0 * solid.to_frame[i][j];
    for (double c : solid.coefficients) sum += 0 * c;
    return sum == 0 && (!is_intricate(solid.kind) || is_sound(scene, solid));
}

/// Whether all indices of an object are in range, its conditions run and its solids are some.
bool sound(const DrawableScene& scene, const CurvedObject& object) {
    const auto within = [](std::uint64_t first, std::uint64_t count, std::size_t size) {
        return first + count <= size;
    };
    if (!within(object.first_piece, object.pieces, scene.pieces.size())) return false;
    for (std::uint32_t p = 0; p < object.pieces; ++p) {
        const CurvedPiece& piece = scene.pieces[object.first_piece + p];
        if (piece.solid >= scene.solids.size() || !is_sensible(scene, scene.solids[piece.solid]) ||
            !within(piece.first_condition, piece.conditions, scene.conditions.size()))
            return false;
        std::size_t depth = 0;
        for (std::uint32_t s = 0; s < piece.conditions; ++s) {
            const ConditionStep step = scene.conditions[piece.first_condition + s];
            const std::size_t taken = step >= 0 ? 0 : step == condition_not ? 1 : 2;
            if (depth < taken || step < condition_or) return false;
            depth = depth - taken + 1;
            if (depth > stack_depth) return false;
            if (step < 0) continue;
            const auto solid = static_cast<std::size_t>(step);
            if (solid >= scene.solids.size() || !is_sensible(scene, scene.solids[solid]))
                return false;
        }
        if (piece.conditions > 0 && depth != 1) return false;
    }
    return true;
}

/// An object to be drawn, and the pixels that may show it.
struct Drawn {
    const CurvedObject* object;
    PixelBox box;
    double work;     ///< for each of those
    double nearest;  ///< greatest_nearness()
    double pixels() const { return double(box.right - box.left) * double(box.bottom - box.top); }
};

/// The objects that are worth drawing, the nearest first, so that they hide others before these are
/// drawn; those that are not are put to the unknown.
std::vector<Drawn> choose(const DrawableScene& scene, const PixelRays& rays, ItemCanvas& canvas,
                          const PaintingPace& pace, std::vector<Bounds>& unknown) {
    std::vector<Drawn> objects;
    for (const CurvedObject& object : scene.objects) {
        if (!sound(scene, object)) {
            unknown.push_back(object.bounds);
            continue;
        }
        const PixelBox box = common_box(
            pixel_box(rays, object.bounds, canvas.width(), canvas.height()), canvas.area());
        if (box.top >= box.bottom || box.left >= box.right) continue;
        const double nearest = greatest_nearness(rays, object.bounds);
        CurvedDrawing drawing(scene, object, nearest, box, rays, canvas, pace);
        objects.push_back({&object, box, drawing.work_a_pixel(), nearest});
    }
    std::vector<std::size_t> cheapest_first(objects.size());
    std::iota(cheapest_first.begin(), cheapest_first.end(), std::size_t{0});
    std::stable_sort(cheapest_first.begin(), cheapest_first.end(),
                     [&](auto i, auto j) { return objects[i].work < objects[j].work; });
    double left =
        std::max(most_in_all, most_of_all * double(canvas.width()) * double(canvas.height()));
    for (std::size_t i : cheapest_first) {
        Drawn& drawn = objects[i];
        const double work = drawn.work * drawn.pixels();
        if ((drawn.work <= most_of_object || work <= most_of_object_in_all) && work <= left) {
            left -= work;
            continue;
        }
        unknown.push_back(drawn.object->bounds);
        drawn.object = nullptr;
    }
    std::erase_if(objects, [](const Drawn& drawn) { return drawn.object == nullptr; });
    std::stable_sort(objects.begin(), objects.end(),
                     [](const Drawn& a, const Drawn& b) { return a.nearest > b.nearest; });
    return objects;
}

}  // namespace

void draw_curved(const DrawableScene& scene, const PixelRays& rays, ItemCanvas& canvas,
                 const PaintingPace& pace) {
    std::vector<Bounds> unknown = scene.unknown;
    if (rays.after_mirror)
        unknown.insert(unknown.end(), scene.unknown_in_mirrors.begin(),
                       scene.unknown_in_mirrors.end());
    const std::vector<Drawn> objects = choose(scene, rays, canvas, pace, unknown);
    draw_bands(canvas, band_rows, [&](ItemCanvas& band) {
        for (const Drawn& drawn : objects) {
            const PixelBox box = common_box(drawn.box, band.area());
            if (box.top < box.bottom)
                CurvedDrawing(scene, *drawn.object, drawn.nearest, box, rays, band, pace).draw();
        }
        for (const Bounds& box : unknown)
            if (!pace.stopped()) hide_behind(box, rays, band, pace);
    });
}

}  // namespace povpreview
