// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/adaptive_lattice.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>

#include "core/colour.h"
#include "core/colour_table.h"
#include "core/edge_weight.h"

namespace povpreview {
namespace {

/// What a diamond promises whose corners are alike, against one between black and white: how far
/// blank areas are searched for what the samples have missed so far.
constexpr float blank_contrast = .004f;

/// Of the jump between two corners, what counts where their items are known to differ: between them
/// nothing is smeared.
constexpr float jump_share = .1f;

/// What a pixel promises whose item no corner is on: its colour is a guess.
constexpr float orphan_contrast = .1f;

/// Whether the first of two points is not farther from a third one than the second is.
bool is_nearer(LatticePoint p, LatticePoint q, LatticePoint at) {
    const auto distance2 = [&](LatticePoint r) {
        return (r.x - at.x) * (r.x - at.x) + (r.y - at.y) * (r.y - at.y);
    };
    return distance2(p) <= distance2(q);
}

int last_point(int pixels, int side) { return (std::max(pixels - 1, 1) + side - 1) / side * side; }

}  // namespace

AdaptiveLattice::AdaptiveLattice(const BfSquares& squares, int width, int height, int first_side)
    : squares_(squares),
      width_(width),
      height_(height),
      first_side_(first_side),
      right_(last_point(width, first_side)),
      below_(last_point(height, first_side)),
      encoded_(squares.pixels()),
      lights_of_(squares.pixels()),
      states_((std::size_t(right_) + 1) * (std::size_t(below_) + 1)) {
    assert(width >= 1 && height >= 1 && first_side >= 2 && (first_side & (first_side - 1)) == 0);
    squares.for_each_known(
        [&](Pixel pixel) { encoded_[squares.number(pixel)] = encode_srgb(squares.colour(pixel)); });
    for (int y = 0; y <= below_; y += first_side)
        for (int x = 0; x <= right_; x += first_side) ask({x, y});
    roots_left_ = asked_.size();
}

LatticePoint AdaptiveLattice::drawn_in(LatticePoint point) const {
    return {std::min(point.x, width_ - 1), std::min(point.y, height_ - 1)};
}

Pixel AdaptiveLattice::pixel_at(LatticePoint point) const {
    const auto [x, y] = drawn_in(point);
    return static_cast<Pixel>(y) * static_cast<Pixel>(width_) + static_cast<Pixel>(x);
}

bool AdaptiveLattice::is_root(LatticePoint point) const {
    return (point.x | point.y) % first_side_ == 0;
}

/// Whether a diamond has more of the image than a border that others have as well.
bool AdaptiveLattice::is_in(LatticePoint centre) const {
    if (centre.x < 0 || centre.y < 0 || centre.x > right_ || centre.y > below_) return false;
    if (is_root(centre)) return true;
    const int reach = Diamond(centre).reach;
    return centre.x - reach < std::max(width_ - 1, 1) &&
           centre.y - reach < std::max(height_ - 1, 1);
}

AdaptiveLattice::State& AdaptiveLattice::state(LatticePoint point) {
    return states_[std::size_t(point.y) * (std::size_t(right_) + 1) + std::size_t(point.x)];
}
AdaptiveLattice::State AdaptiveLattice::state(LatticePoint point) const {
    return states_[std::size_t(point.y) * (std::size_t(right_) + 1) + std::size_t(point.x)];
}

/// Asks for a point, and before it for those that its diamond's triangles come of.
void AdaptiveLattice::ask(LatticePoint point) {
    if (state(point) != State::open) return;
    if (!is_root(point))
        for (LatticePoint apex : Diamond(point).apexes())
            if (is_in(apex)) ask(apex);
    state(point) = State::asked;
    asked_.push_back(point);
}

std::optional<Pixel> AdaptiveLattice::next(const DetailMap* detail) {
    for (;;) {
        while (!asked_.empty()) {
            const LatticePoint point = asked_.front();
            asked_.pop_front();
            const Pixel pixel = pixel_at(point);
            // Others may have asked for it. Answers come in the order of the requests.
            const bool unsampled = squares_.state(pixel) == BfSquares::State::unsampled;
            coming_.push_back({point, squares_.requested() + unsampled});
            if (unsampled) return pixel;
        }
        take_complete(detail);
        if (open_.empty()) return std::nullopt;
        ask(open_.pop());
    }
}

void AdaptiveLattice::take_complete(const DetailMap* detail) {
    for (; !coming_.empty() && coming_.front().complete_after <= squares_.answered();
         coming_.pop_front())
        take(coming_.front().point, detail);
}

/// A point whose sample has come becomes a corner.
void AdaptiveLattice::take(LatticePoint corner, const DetailMap* detail) {
    state(corner) = State::corner;
    if (is_root(corner)) {
        if (--roots_left_ > 0) return;
        return for_each_square([&](LatticePoint centre) { weigh(centre, detail); });
    }
    const Diamond halved(corner);
    if (!halved.has_parts()) return;
    for (LatticePoint part : halved.parts())
        if (is_in(part) && state(part) == State::open) weigh(part, detail);
}

template <class Visit>
void AdaptiveLattice::for_each_square(const Visit& visit) const {
    for (int y = first_side_ / 2; y < below_; y += first_side_)
        for (int x = first_side_ / 2; x < right_; x += first_side_) visit(LatticePoint{x, y});
}

void AdaptiveLattice::weigh(LatticePoint centre, const DetailMap* detail) {
    open_.push(weight(Diamond(centre), detail), centre);
}

void AdaptiveLattice::accept(Pixel pixel, const RungLight& light) {
    if (!squares_.has_colour(pixel)) return;
    const std::uint32_t number = squares_.number(pixel);
    encoded_[number] = encode_srgb(light.colour);
    if (!light.shaded) return;
    if (lights_of_[number] == 0) {
        lights_.emplace_back();
        lights_of_[number] = static_cast<std::uint32_t>(lights_.size());
    }
    lights_[lights_of_[number] - 1] = {light.illumination, light.remainder};
}

/// Of a pixel that has been answered; null where it is not known.
const AdaptiveLattice::Light* AdaptiveLattice::light_at(Pixel pixel) const {
    const std::uint32_t light = lights_of_[squares_.number(pixel)];
    return light ? &lights_[light - 1] : nullptr;
}

/// What is asked for already is in the queue no more, or idle there.
void AdaptiveLattice::accept_detail(const DetailMap& detail) {
    BucketQueue<LatticePoint> before;
    std::swap(before, open_);
    while (!before.empty())
        if (const LatticePoint centre = before.pop(); state(centre) == State::open)
            weigh(centre, &detail);
}

/// What is known changed in the BF-square around the pixel.
void AdaptiveLattice::accept_doubt(Pixel pixel, const DetailMap& detail) {
    if (roots_left_ > 0) return;
    const std::size_t square = squares_.square_of(pixel);
    std::optional<LatticePoint> last;
    for (int i = 0; i < BfSquares::side * BfSquares::side; ++i) {
        const auto changed = squares_.pixel_in(square, i);
        if (!changed) continue;
        const auto centre = open_centre_at(*changed);
        if (centre && centre != last) weigh(*centre, &detail);
        last = centre;
    }
}

/// Of the diamond around a pixel, if it may still be halved.
std::optional<LatticePoint> AdaptiveLattice::open_centre_at(Pixel pixel) const {
    const auto width = static_cast<Pixel>(width_);
    const LatticePoint at{static_cast<int>(pixel % width), static_cast<int>(pixel / width)};
    LatticePoint centre{at.x / first_side_ * first_side_ + first_side_ / 2,
                        at.y / first_side_ * first_side_ + first_side_ / 2};
    const auto [one, other] = triangles(Diamond(centre));
    HalvedTriangle triangle = is_nearer(one.apex, other.apex, at) ? one : other;
    for (;;) {
        if (!triangle.has_centre()) return std::nullopt;
        if (state(triangle.centre()) == State::open) return triangle.centre();
        if (state(triangle.centre()) == State::asked) return std::nullopt;
        const auto [first, second] = triangle.halves();
        triangle = is_nearer(triangle.first, triangle.second, at) ? first : second;
    }
}

AdaptiveLattice::Corners AdaptiveLattice::corners(const Diamond& diamond) const {
    Corners corners;
    for (LatticePoint end : diamond.hypotenuse())
        corners.pixels[std::size_t(corners.count++)] = pixel_at(end);
    for (LatticePoint apex : diamond.apexes())
        if (is_in(apex) && state(apex) == State::corner)
            corners.pixels[std::size_t(corners.count++)] = pixel_at(apex);
    return corners;
}

/// The error that a diamond may be expected to have, summed over its pixels.
float AdaptiveLattice::weight(const Diamond& diamond, const DetailMap* detail) const {
    const Corners c = corners(diamond);
    const auto [x, y] = diamond.centre;
    const int reach = diamond.reach;
    const int across = std::min(x + reach, width_) - std::max(x - reach, 0),
              down = std::min(y + reach, height_) - std::max(y - reach, 0);
    // One that stands on a corner fills half of its box.
    const float area =
        float(across) * float(down) * (diamond.square ? 1.f : .5f) * (c.count == 4 ? 1.f : .5f);
    const float expected = (blank_contrast + contrast(c.all(), detail)) * area;
    return detail ? expected + orphan_contrast * float(orphans(diamond, c, *detail)) : expected;
}

/// Pixels in a diamond whose item none of its corners is on.
int AdaptiveLattice::orphans(const Diamond& diamond, const Corners& corners,
                             const DetailMap& detail) const {
    std::array<std::uint32_t, 4> items;
    items.fill(DetailMap::unknown);
    std::transform(corners.pixels.begin(), corners.pixels.begin() + corners.count, items.begin(),
                   [&](Pixel pixel) { return detail.item(pixel); });
    const auto [x, y] = diamond.centre;
    // Of large ones every n-th pixel of every n-th row tells enough.
    const int step = std::max(1, diamond.reach / 16);
    int orphans = 0;
    for (int j = std::max(y - diamond.reach, 0); j < std::min(y + diamond.reach, height_);
         j += step) {
        const int half = diamond.square ? diamond.reach : diamond.reach - std::abs(j - y);
        const Pixel row = pixel_at({0, j});
        for (int i = std::max(x - half, 0); i < std::min(x + half, width_); i += step) {
            const std::uint32_t item = detail.item(row + static_cast<Pixel>(i));
            orphans += item != DetailMap::unknown && item != items[0] && item != items[1] &&
                       item != items[2] && item != items[3];
        }
    }
    return orphans * step * step;
}

/// A sample as displayed; nothing where it has failed.
std::optional<glm::vec3> AdaptiveLattice::shown(Pixel pixel) const {
    if (!squares_.has_colour(pixel)) return std::nullopt;
    return glm::clamp(encoded_[squares_.number(pixel)], 0.f, 1.f);
}

/// The most by which two corners differ, as displayed. Where the texture is known, only the light
/// is to be found out.
float AdaptiveLattice::contrast(std::span<const Pixel> c, const DetailMap* detail) const {
    struct Corner {
        std::optional<glm::vec3> colour;
        std::uint32_t item = DetailMap::unknown;
        std::optional<glm::vec3> light;  // what the first corner's texture would be in its light
    };
    std::array<Corner, 4> corners;
    for (std::size_t i = 0; i < c.size(); ++i) {
        Corner& corner = corners[i];
        corner.colour = shown(c[i]);
        if (!detail) continue;
        corner.item = detail->item(c[i]);
        if (lights_.empty() || detail->albedo_state(c[i]) != DetailMap::Albedo::known) continue;
        if (const Light* light = light_at(c[i]))
            corner.light =
                roughly_encoded(detail->albedo(c[0]) * light->illumination + light->remainder);
    }
    const auto difference = [](const Corner& p, const Corner& q) {
        const bool known = p.item != DetailMap::unknown && q.item != DetailMap::unknown;
        const bool same = known && p.item == q.item;
        if (same && p.light && q.light) return colour_distance(*p.light, *q.light);
        if (!p.colour || !q.colour) return 0.f;
        const float jump = colour_distance(*p.colour, *q.colour);
        return known && !same ? jump * jump_share * jump_share : jump;
    };
    float most = 0;
    for (std::size_t i = 0; i < c.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            most = std::max(most, difference(corners[i], corners[j]));
    return std::sqrt(most);
}

/// colour_distance() of two samples; 0 where one has failed.
float AdaptiveLattice::jump(Pixel p, Pixel q) const {
    const auto a = shown(p), b = shown(q);
    return a && b ? colour_distance(*a, *b) : 0;
}

/// Calls visit with the path to each triangle that is not halved, of those at the path's end.
template <class Visit>
void AdaptiveLattice::for_each_leaf(Path& path, const Visit& visit) const {
    const HalvedTriangle triangle = path.back();
    if (!triangle.has_centre() || state(triangle.centre()) != State::corner) return visit();
    for (const HalvedTriangle& half : triangle.halves()) {
        path.push_back(half);
        for_each_leaf(path, visit);
        path.pop_back();
    }
}

void AdaptiveLattice::draw(Picture& picture, const DetailMap* detail,
                           std::span<const Pixel> anchors) const {
    if (roots_left_ > 0) return;
    for (Pixel pixel = 0; pixel < squares_.pixels(); ++pixel)
        if (squares_.has_colour(pixel)) picture.known[pixel] = 1;
    Path path;
    for_each_square([&](LatticePoint centre) {
        for (const HalvedTriangle& triangle : triangles(Diamond(centre))) {
            path.assign(1, triangle);
            for_each_leaf(path, [&] { draw(path, detail, anchors, picture); });
        }
    });
}

/// Corners without a sample, for it failed, are left out.
bool AdaptiveLattice::mix(std::span<const Part> parts, glm::vec3& encoded) const {
    glm::vec3 sum(0);
    float shares = 0;
    for (const Part& part : parts) {
        if (!(part.share > 0) || !squares_.has_colour(part.pixel)) continue;
        sum += part.share * encoded_[squares_.number(part.pixel)];
        shares += part.share;
    }
    if (shares > 0) encoded = sum / shares;
    return shares > 0;
}

bool AdaptiveLattice::mix_light(std::span<const Part> parts, const glm::vec3& albedo,
                                glm::vec3& linear) const {
    Light sum{glm::vec3(0), glm::vec3(0)};
    float shares = 0;
    for (const Part& part : parts) {
        const Light* const light = part.share > 0 ? light_at(part.pixel) : nullptr;
        if (!light) continue;
        sum.illumination += part.share * light->illumination;
        sum.remainder += part.share * light->remainder;
        shares += part.share;
    }
    if (shares > 0) linear = (albedo * sum.illumination + sum.remainder) / shares;
    return shares > 0;
}

namespace {

/// Twice the area of a triangle, signed.
int area2(LatticePoint a, LatticePoint b, LatticePoint c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// How much a point in a triangle has of each corner, times the triangle's area.
std::array<int, 3> shares_of(LatticePoint a, LatticePoint b, LatticePoint c, LatticePoint p) {
    const int sign = area2(a, b, c) < 0 ? -1 : 1;
    return {sign * area2(p, b, c), sign * area2(a, p, c), sign * area2(a, b, p)};
}

}  // namespace

/// A triangle's corners, by how much a pixel in it takes from each.
AdaptiveLattice::Parts3 AdaptiveLattice::parts(const HalvedTriangle& t, int x, int y) const {
    const LatticePoint a = drawn_in(t.apex), b = drawn_in(t.first), c = drawn_in(t.second);
    // Drawn in, a triangle may have no area, or miss pixels that it has had.
    const auto shares = area2(a, b, c) != 0 ? shares_of(a, b, c, {x, y})
                                            : shares_of(t.apex, t.first, t.second, {x, y});
    return {Part{pixel_at(t.apex), float(shares[0])}, Part{pixel_at(t.first), float(shares[1])},
            Part{pixel_at(t.second), float(shares[2])}};
}

/// What stands for a pixel of an item: the corners on it; where none is, those of the larger
/// triangles around, and then the item's anchor, unless a texture that is not known makes the rest
/// of the item differ from that by more than what is seen around the pixel does.
std::optional<AdaptiveLattice::Parts3> AdaptiveLattice::parts_on(
    std::uint32_t item, const Path& path, int x, int y, const DetailMap& detail,
    std::span<const Pixel> anchors) const {
    if (item == DetailMap::unknown) return std::nullopt;
    for (auto triangle = path.rbegin(); triangle != path.rend(); ++triangle) {
        Parts3 result = parts(*triangle, x, y);
        bool any = false;
        for (Part& part : result) {
            const bool on = detail.item(part.pixel) == item && squares_.has_colour(part.pixel);
            // A corner beyond an edge may be the only one on the item, at no distance.
            part.share = on ? std::max(part.share, 1e-3f) : 0;
            any = any || on;
        }
        if (any) return result;
    }
    const DetailMap::Albedo albedo = detail.albedo_state(pixel_at({x, y}));
    if (albedo != DetailMap::Albedo::constant && albedo != DetailMap::Albedo::known)
        return std::nullopt;
    if (item >= anchors.size() || anchors[item] == no_anchor || !squares_.has_colour(anchors[item]))
        return std::nullopt;
    return Parts3{Part{anchors[item], 1}, {anchors[item], 0}, {anchors[item], 0}};
}

/// The other diagonal of the diamond that a triangle is half of, if colours jump less along it: an
/// edge in the image runs that way, and triangles along it smear less of it.
std::optional<LatticePoint> AdaptiveLattice::better_diagonal(const HalvedTriangle& t) const {
    if (!t.has_centre()) return std::nullopt;
    const LatticePoint opposite{t.first.x + t.second.x - t.apex.x,
                                t.first.y + t.second.y - t.apex.y};
    if (!is_in(opposite) || state(opposite) != State::corner) return std::nullopt;
    if (jump(pixel_at(t.apex), pixel_at(opposite)) >= jump(pixel_at(t.first), pixel_at(t.second)))
        return std::nullopt;
    return opposite;
}

/// Draws the pixels of the triangle at the end of a path that are not known.
void AdaptiveLattice::draw(Path& path, const DetailMap* detail, std::span<const Pixel> anchors,
                           Picture& picture) const {
    const auto [a, b, c] = path.back();
    const auto opposite = better_diagonal(path.back());
    if (opposite) path.push_back({});
    const auto [left, right] = std::minmax({a.x, b.x, c.x});
    const auto [top, bottom] = std::minmax({a.y, b.y, c.y});
    for (int y = top; y <= std::min(bottom, height_ - 1); ++y)
        for (int x = left; x <= std::min(right, width_ - 1); ++x) {
            if (squares_.has_colour(pixel_at({x, y}))) continue;
            const auto shares = shares_of(a, b, c, {x, y});
            if (shares[0] < 0 || shares[1] < 0 || shares[2] < 0) continue;
            if (opposite) path.back() = {shares[1] >= shares[2] ? b : c, a, *opposite};
            draw(path, x, y, detail, anchors, picture);
        }
    if (opposite) path.pop_back();
}

/// Draws a pixel that is not known, if anything around it is.
void AdaptiveLattice::draw(const Path& path, int x, int y, const DetailMap* detail,
                           std::span<const Pixel> anchors, Picture& picture) const {
    const Pixel pixel = pixel_at({x, y});
    const auto on_item =
        detail ? parts_on(detail->item(pixel), path, x, y, *detail, anchors) : std::nullopt;
    glm::vec3 colour;
    if (on_item && detail->albedo_state(pixel) == DetailMap::Albedo::known &&
        mix_light(*on_item, detail->albedo(pixel), colour)) {
        picture.pixels[pixel] = colour;
    } else if (mix(on_item ? *on_item : parts(path.back(), x, y), colour)) {
        picture.pixels[pixel] = decode_quickly(colour);
    } else {
        return;
    }
    picture.known[pixel] = 1;
}

}  // namespace povpreview
