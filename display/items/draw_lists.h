// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <bit>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "display/items/pixel_rays.h"

namespace povpreview::items {

/// A corner of a triangle of the image that a fragment shader fills by the record it belongs to.
struct ItemCorner {
    glm::vec2 position;    ///< pixels
    std::uint32_t record;  ///< its first texel
};

/// An ellipsoid: a rectangle of the image and how rays run in the frame where it is the unit
/// sphere. A pixel's ray is (x, y the pixel's offset from `reference`):
///
///     base + x base_x + y base_y + s (direction + x direction_x + y direction_y)
///
/// base_x, base_y and direction_x, direction_y are `across` and `down`, times one factor each.
struct SphereInstance {
    glm::vec4 rectangle;  ///< left, top, right, bottom
    glm::vec4 reference;  ///< pixel x, y; depth where s = 0; depth for a step of s
    glm::vec4 base;       ///< and the factor of base_x, base_y
    glm::vec4 direction;  ///< and the factor of direction_x, direction_y
    glm::vec3 across, down;
    std::uint32_t item;  ///< texel of its label
};

/// A sphere, cylinder or cone, cut off by planes (see CappedSolid): a rectangle of the image, as a
/// triangle strip, and rays as those of a SphereInstance in the solid's frame.
struct CappedInstance {
    glm::vec4 corners_low, corners_high;  ///< of the rectangle, two each
    glm::vec4 reference, base, direction;
    glm::vec3 across, down;
    glm::vec4 signs;      ///< and constant, see CanonicalSolid
    glm::vec4 planes[2];  ///< inside: dot(.xyz, p) + .w <= 0
    glm::uvec4 items;     ///< of the side and the caps, 0: open; bits: caps cut by the other plane
};

/// What fragment shaders look up, texel by texel: floats as their bits, or integers. Among them are
/// labels: surface and look, and two values of other use. What is drawn is the texel of a label.
class Records {
   public:
    Records() {
        push_bits(0, no_look, 0, 0);
        push_bits(0xffffffffu, no_look, 0, 0);
    }
    static constexpr std::uint32_t background = 0, unknown = 1;  ///< their labels
    /// The look of background and unknown, beyond all others.
    static constexpr std::uint32_t no_look = 0x7fffffffu;
    /// In a label's look: its texel follows the record of a face by two and two more texels with
    /// texture coordinates follow.
    static constexpr std::uint32_t has_uvs = 0x80000000u;

    std::uint32_t next() const { return static_cast<std::uint32_t>(texels_.size()); }
    void push(float a, float b, float c, float d) { push_bits(bits(a), bits(b), bits(c), bits(d)); }
    void push(const glm::dvec3& v, float d) { push(glm::vec3(v), bits(d)); }
    void push(const glm::dvec3& v, std::uint32_t d) { push(glm::vec3(v), d); }
    void push_bits(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        texels_.emplace_back(a, b, c, d);
    }
    /// A texel with the last value to be set later.
    glm::uvec4& at(std::uint32_t texel) { return texels_[texel]; }
    const glm::uvec4& at(std::uint32_t texel) const { return texels_[texel]; }
    std::vector<glm::uvec4>& texels() { return texels_; }

    static std::uint32_t bits(float value) { return std::bit_cast<std::uint32_t>(value); }
    static std::uint32_t bits(double value) { return bits(static_cast<float>(value)); }

   private:
    void push(const glm::vec3& v, std::uint32_t d) {
        push_bits(bits(v.x), bits(v.y), bits(v.z), d);
    }

    std::vector<glm::uvec4> texels_;
};

/// All that is drawn of a scene, in the image of its camera.
struct DrawLists {
    Records records;
    std::vector<ItemCorner> faces, unknown;
    std::vector<SphereInstance> spheres;
    std::vector<CappedInstance> capped;
    /// Objects by the shader that they need: without conditions, with them, with tori.
    std::vector<ItemCorner> simple_objects, objects, torus_objects;
};

}  // namespace povpreview::items
