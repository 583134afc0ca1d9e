// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/end_to_end/look_agreement.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace povpreview {
namespace {

/// Turns around the y axis from x towards z, 0 to 1.
double turns(const glm::dvec3& p) {
    const double angle = std::atan2(p.z, p.x) / (2 * std::numbers::pi);
    return angle < 0 ? angle + 1 : angle;
}

/// To the unit square, from its lower left corner.
glm::dvec2 mapped(ImageLook::Mapping mapping, const glm::dvec3& p) {
    constexpr double pi = std::numbers::pi;
    switch (mapping) {
        case ImageLook::Mapping::planar:
        case ImageLook::Mapping::uv:
            return glm::dvec2(p);
        case ImageLook::Mapping::spherical:
            return {turns(p), .5 + std::asin(p.y / glm::length(p)) / pi};
        case ImageLook::Mapping::cylindrical:
            return {turns(p), p.y};
        case ImageLook::Mapping::toroidal: {
            const double x = std::hypot(p.x, p.z) - 1;
            const double angle = std::acos(-x / std::hypot(x, p.y)) / (2 * pi);
            return {turns(p), p.y > 0 ? 1 - angle : angle};
        }
    }
    return {};
}

double half(std::uint16_t bits) {
    const int exponent = bits >> 10 & 31, digits = bits & 1023;
    const double size =
        exponent == 0 ? std::ldexp(digits, -24) : std::ldexp(digits + 1024, exponent - 25);
    return bits & 0x8000 ? -size : size;
}

class Lookup {
   public:
    Lookup(const ImageTexels& image, const ImageLook& look) : image_(image), look_(look) {}

    /// `x` and `y` in texels from the upper left corner; the first texel's centre is at (.5, .5).
    glm::dvec3 at(double x, double y) const {
        if (look_.interpolation == ImageLook::Interpolation::none)
            return texel(std::floor(x), std::floor(y));
        const double column = std::floor(x + .5), row = std::floor(y + .5);
        const double p = x + .5 - column, q = y + .5 - row;
        glm::dvec3 sum(0);
        double weights = 0;
        for (int j = -2; j < 2; ++j)
            for (int i = -2; i < 2; ++i) {
                const double w = weight(i, j, p, q);
                if (w == 0) continue;
                sum += w * texel(column + i, row + j);
                weights += w;
            }
        return sum / weights;
    }

   private:
    glm::dvec3 texel(double column, double row) const {
        const auto placed = [this](double i, double size) {
            if (look_.once) return std::clamp(i, 0., size - 1);
            return i - size * std::floor(i / size);
        };
        const auto& t = image_.texels.at(std::size_t(placed(row, image_.height)) * image_.width +
                                         std::size_t(placed(column, image_.width)));
        return {half(t[0]), half(t[1]), half(t[2])};
    }
    /// Of the texel i columns and j rows on from the one right and below of the middle.
    double weight(int i, int j, double p, double q) const {
        const bool close = i >= -1 && i < 1 && j >= -1 && j < 1;
        switch (look_.interpolation) {
            case ImageLook::Interpolation::bilinear:
                return close ? (i == 0 ? p : 1 - p) * (j == 0 ? q : 1 - q) : 0;
            case ImageLook::Interpolation::normalised_distance: {
                const double dx = i == 0 ? 1 - p : p, dy = j == 0 ? 1 - q : q;
                return close ? 1 / (dx * dx + dy * dy) : 0;
            }
            case ImageLook::Interpolation::bicubic:
                return cubic(i, p) * cubic(j, q);
            case ImageLook::Interpolation::none:
                break;
        }
        return 0;
    }
    static double cubic(int i, double p) {
        const double q = 1 - p;
        switch (i) {
            case -2:
                return -.5 * p * q * q;
            case -1:
                return .5 * q * (q * (3 * p + 1) + 1);
            case 0:
                return .5 * p * (p * (3 * q + 1) + 1);
            default:
                return -.5 * q * p * p;
        }
    }

    const ImageTexels& image_;
    const ImageLook& look_;
};

/// Of a triangle's point, by areas.
glm::dvec3 own_coordinates(const DrawableScene& scene, const Face& face, const glm::dvec3& point) {
    const glm::dvec3 a = scene.polygons.corner(face, 0), b = scene.polygons.corner(face, 1),
                     c = scene.polygons.corner(face, 2), normal = glm::cross(b - a, c - a);
    const double whole = glm::dot(normal, normal);
    const double at_b = glm::dot(glm::cross(point - a, c - a), normal) / whole,
                 at_c = glm::dot(glm::cross(b - a, point - a), normal) / whole;
    const glm::dvec2 uv = (1 - at_b - at_c) * glm::dvec2(scene.corner_uvs.at(face.first)) +
                          at_b * glm::dvec2(scene.corner_uvs.at(face.first + 1)) +
                          at_c * glm::dvec2(scene.corner_uvs.at(face.first + 2));
    return {uv, 0};
}

}  // namespace

std::optional<glm::dvec3> image_albedo(const DrawableScene& scene, const Seen& seen) {
    const ImageLook& look = scene.looks.at(seen.material).image;
    const ImageTexels& image = scene.images.at(look.image);
    const glm::dvec3 from = look.mapping == ImageLook::Mapping::uv
                                ? own_coordinates(scene, *seen.face, seen.point)
                                : seen.point;
    const glm::dvec2 at = mapped(look.mapping, look.to_map * glm::dvec4(from, 1));
    if (look.once && (at.x < 0 || at.x > 1 || at.y < 0 || at.y > 1)) return std::nullopt;
    const double x = (at.x - std::floor(at.x)) * image.width,
                 y = (std::ceil(at.y) - at.y) * image.height;
    const glm::dvec3 colour = Lookup(image, look).at(x, y);
    const auto linear = [&](double v) {
        return v <= 0 ? v : std::pow(v, static_cast<double>(scene.working_gamma));
    };
    return glm::dvec3(linear(colour.x), linear(colour.y), linear(colour.z));
}

}  // namespace povpreview
