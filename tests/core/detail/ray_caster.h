// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "core/detail/item_buffer.h"

namespace povpreview::test {

/// A camera as POV-Ray has it: a pixel's ray goes to (orthographic: starts at)
/// direction + (px / width - .5) right + (.5 - py / height) up.
struct CameraPose {
    glm::dvec3 location{0, 0, -5}, direction{0, 0, 1}, right{4. / 3, 0, 0}, up{0, 1, 0};
    bool orthographic = false;

    StraightCamera straight(int width, int height) const;
};
/// Looks from `from` at `at`, with an image that is `width_by_distance` times as wide as far away.
CameraPose look_at(const glm::dvec3& from, const glm::dvec3& at, double width_by_distance = 4. / 3);

/// The item buffer by tracing rays in double precision, by the definitions in drawable_scene.h and
/// those of POV-Ray's image maps alone: what paint_items() has to come to.
class RayCaster {
   public:
    RayCaster(const DrawableScene& scene, const CameraPose& pose) : scene_(scene), pose_(pose) {}

    struct Hit {
        double depth = 0;  ///< in units of `direction`
        std::uint32_t surface = ItemBuffer::background;
        Look::Kind kind = Look::Kind::mixed;
        glm::dvec3 albedo{};
    };
    Hit cast(double px, double py) const;
    /// What the ray meets once the flat surface that it hits has reflected it.
    /// REQUIRES: cast() hits a face or a half space.
    Hit cast_reflected(double px, double py) const;
    ItemBuffer cast_all() const;

   private:
    struct Ray {
        glm::dvec3 from, along;
        bool reflected = false;
        glm::dvec3 at(double t) const { return from + t * along; }
    };
    struct Found;
    Ray ray_through(double px, double py) const;
    Found trace(const Ray& ray) const;
    Hit look_of(Found found) const;
    void cast_faces(const Ray& ray, Found& found) const;
    void cast_objects(const Ray& ray, Found& found) const;
    void cast_unknown(const Ray& ray, const std::vector<Bounds>& boxes, Found& found) const;
    bool holds(const CurvedPiece& piece, const glm::dvec3& p) const;
    /// Of an intricate solid; `from` and `along` are the ray in its frame.
    std::vector<double> roots_within(const Bounds& bounds, const Ray& ray, const Solid& solid,
                                     const glm::dvec3& from, const glm::dvec3& along) const;

    const DrawableScene& scene_;
    CameraPose pose_;
};

/// The colour of an image map at a point of its own space, in linear light; nothing outside of it.
std::optional<glm::dvec3> image_colour(const ImageTexels& image, const ImageLook& look,
                                       const glm::dvec3& p, double gamma);

}  // namespace povpreview::test
