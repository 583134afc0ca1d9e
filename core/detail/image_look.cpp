// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/detail/image_look.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <glm/mat4x3.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <numbers>

namespace povpreview {
namespace {

using Mapping = ImageLook::Mapping;
using Interpolation = ImageLook::Interpolation;

/// POV-Ray moves each place by so many texels to the right and up. So surfaces that lie along the
/// border between texels (a wall at x = 0) take the same one all over, and take the one it takes.
constexpr double nudge = 1e-10;

/// Opacity from which on a surface counts as opaque: all but what rounding halves takes away.
constexpr double least_opacity = 0.998;

/// From x towards z, as a share of a whole turn: 0 to 1.
double turn_of(double x, double z) {
    const double share = std::atan2(z, x) / (2 * std::numbers::pi);
    return share < 0 ? share + 1 : share;
}

/// A point in the pigment's space as shares of the image's width, rightwards, and of its height,
/// upwards. Nothing where the mapping has no value.
std::optional<glm::dvec2> shares_at(Mapping mapping, const glm::dvec3& p) {
    constexpr double pi = std::numbers::pi;
    if (mapping == Mapping::planar || mapping == Mapping::uv) return glm::dvec2(p);

    const double aside = std::sqrt(p.x * p.x + p.z * p.z);  // from the y axis
    const double turn = aside == 0 ? 0 : turn_of(p.x, p.z);
    switch (mapping) {
        case Mapping::spherical:
            if (aside == 0 && p.y == 0) return std::nullopt;
            return glm::dvec2(turn, 0.5 + std::atan2(p.y, aside) / pi);
        case Mapping::cylindrical:
            if (aside == 0) return std::nullopt;
            return glm::dvec2(turn, p.y);
        case Mapping::toroidal: {
            //          y
            //          |     .-.    the angle around the tube begins at its inside
            //          |   0-> o |  and goes over its lower half
            //  --------+-----'-'---- aside
            //                1
            const double inwards = 1 - aside;
            if (aside == 0 || (inwards == 0 && p.y == 0)) return std::nullopt;
            const double around = std::atan2(std::abs(p.y), inwards) / (2 * pi);
            return glm::dvec2(turn, p.y > 0 ? 1 - around : around);
        }
        default:
            return std::nullopt;
    }
}

/// A share of one side of the image, in texels from its beginning: in [0, size), or not-a-number
/// outside of a `once` map. `angle`: the share is one of an angle, which ends at the last texel,
/// where lengths of 1 begin anew.
double along_side(double share, double size, bool once, bool angle) {
    constexpr double outside = std::numeric_limits<double>::quiet_NaN();
    if (!once) {
        const double place = (share - std::floor(share)) * size + nudge;
        return place >= size ? place - size : place;
    }
    if (!angle && !(share >= 0 && share <= 1)) return outside;
    const double place = (share == 1 && !angle ? 0 : share) * size + nudge;
    return place >= size ? outside : place;
}

/// In texels from the upper left corner of the image; the first texel's centre is at (.5, .5).
std::optional<glm::dvec2> place_at(const ImageLook& look, const glm::dvec2& shares,
                                   const ImageTexels& image) {
    const bool turned = look.mapping != Mapping::planar && look.mapping != Mapping::uv,
               rolled = turned && look.mapping != Mapping::cylindrical;
    const double height = image.height;
    const double right = along_side(shares.x, image.width, look.once, turned);
    const double up = along_side(shares.y, height, look.once, rolled);
    if (std::isnan(right) || std::isnan(up)) return std::nullopt;
    const double down = height - up;
    return glm::dvec2(right, down >= height ? 0 : down);
}

/// Red, green, blue, opacity: sums of weighted texels.
struct Colour {
    std::array<double, 4> channels{};

    void add(double weight, const std::array<std::uint16_t, 4>& halves) {
        for (std::size_t i = 0; i < 4; ++i) channels[i] += weight * decoded(halves[i]);
    }
    void add(double weight, const Colour& other) {
        for (std::size_t i = 0; i < 4; ++i) channels[i] += weight * other.channels[i];
    }

   private:
    /// A half's exponent and digits in a float's places are its value, but for the offsets of the
    /// exponents, 15 and 127; that holds of subnormal ones too. What is not finite is infinite.
    static double decoded(std::uint32_t half) {
        const float size = std::bit_cast<float>((half & 0x7fffu) << 13) * 0x1p112f;
        const float known = size < 65536 ? size : std::numeric_limits<float>::infinity();
        return half & 0x8000u ? -known : known;
    }
};

/// A texel beside the image: the border's once more, or the other side's. `texel` is at most two
/// off the image.
std::size_t within(std::ptrdiff_t texel, std::ptrdiff_t size, bool once) {
    if (once) return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(texel, 0, size - 1));
    while (texel < 0) texel += size;
    while (texel >= size) texel -= size;
    return static_cast<std::size_t>(texel);
}

/// The `count` texels of one side that are nearest to a place, and how far from it their centres
/// are.
template <std::size_t count>
struct Neighbours {
    std::array<std::size_t, count> texels;
    std::array<double, count> distances;

    Neighbours(double place, std::uint32_t size, bool once) {
        const auto next = static_cast<std::ptrdiff_t>(place + 0.5);  // first centre at or after it
        for (std::size_t i = 0; i < count; ++i) {
            const std::ptrdiff_t texel =
                next + static_cast<std::ptrdiff_t>(i) - static_cast<std::ptrdiff_t>(count / 2);
            texels[i] = within(texel, size, once);
            distances[i] = std::abs(static_cast<double>(texel) + 0.5 - place);
        }
    }
};

/// Catmull and Rom's spline: the weight of a value at a distance up to 2.
double cubic(double d) {
    return d < 1 ? 1 + d * d * (1.5 * d - 2.5) : 2 + d * (-4 + d * (2.5 - 0.5 * d));
}

/// What a texel counts by its distances across and down: one's weight times the other's.
template <std::size_t count, typename Weight>
void add_separably(const ImageTexels& image, const glm::dvec2& place, bool once,
                   const Weight& weight, Colour& sum) {
    const Neighbours<count> columns(place.x, image.width, once), rows(place.y, image.height, once);
    std::array<double, count> across;
    for (std::size_t i = 0; i < count; ++i) across[i] = weight(columns.distances[i]);
    for (std::size_t j = 0; j < count; ++j) {
        const auto* row = image.texels.data() + rows.texels[j] * image.width;
        Colour along_row;
        for (std::size_t i = 0; i < count; ++i) along_row.add(across[i], row[columns.texels[i]]);
        sum.add(weight(rows.distances[j]), along_row);
    }
}

/// POV-Ray's normalised distance: by the inverse square of a texel's distance.
void add_by_nearness(const ImageTexels& image, const glm::dvec2& place, bool once, Colour& sum) {
    const Neighbours<2> columns(place.x, image.width, once), rows(place.y, image.height, once);
    std::array<double, 4> nearness;
    double all = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const double x = columns.distances[i % 2], y = rows.distances[i / 2];
        nearness[i] = 1 / std::max(x * x + y * y, 1e-30);  // at a centre: that texel alone
        all += nearness[i];
    }
    for (std::size_t i = 0; i < 4; ++i)
        sum.add(nearness[i] / all,
                image.texels[rows.texels[i / 2] * image.width + columns.texels[i % 2]]);
}

/// The image's colour at a place; adds nothing where the interpolation is none of those known.
void add_texels(const ImageTexels& image, const ImageLook& look, const glm::dvec2& place,
                Colour& sum) {
    switch (look.interpolation) {
        case Interpolation::none: {
            const auto column = static_cast<std::size_t>(place.x),
                       row = static_cast<std::size_t>(place.y);
            return sum.add(1, image.texels[row * image.width + column]);
        }
        case Interpolation::bilinear:
            return add_separably<2>(
                image, place, look.once, [](double d) { return 1 - d; }, sum);
        case Interpolation::bicubic:
            return add_separably<4>(image, place, look.once, cubic, sum);
        case Interpolation::normalised_distance:
            return add_by_nearness(image, place, look.once, sum);
    }
}

/// Linear light from the working gamma. Interpolation may overshoot to below 0, where the tracer's
/// own samples stay what they are as well.
float linear(double channel, float gamma) {
    const auto value = static_cast<float>(channel);
    return value > 0 && gamma != 1 ? std::pow(value, gamma) : value;
}

}  // namespace

std::optional<glm::vec3> image_albedo(const DrawableScene& scene, const ImageLook& look,
                                      const glm::dvec3& point, const glm::dvec2& uv) {
    const float gamma = scene.working_gamma;
    if (look.image >= scene.images.size() || !(gamma > 0 && std::isfinite(gamma)))
        return std::nullopt;
    const ImageTexels& image = scene.images[look.image];
    if (image.texels.empty() || image.texels.size() != std::size_t{image.width} * image.height)
        return std::nullopt;

    const glm::dvec3 from = look.mapping == Mapping::uv ? glm::dvec3(uv, 0) : point;
    const std::optional<glm::dvec2> shares =
        shares_at(look.mapping, look.to_map * glm::dvec4(from, 1));
    if (!shares) return std::nullopt;
    const std::optional<glm::dvec2> place = place_at(look, *shares, image);
    if (!place) return std::nullopt;

    Colour colour;
    add_texels(image, look, *place, colour);
    const auto& [red, green, blue, opacity] = colour.channels;
    if (!(opacity > least_opacity)) return std::nullopt;
    const float r = linear(red, gamma), g = linear(green, gamma), b = linear(blue, gamma);
    if (!std::isfinite(r) || !std::isfinite(g) || !std::isfinite(b)) return std::nullopt;
    return glm::vec3(r, g, b);
}

}  // namespace povpreview
