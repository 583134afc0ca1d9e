// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <vector>

#include "core/detail/detail_map.h"
#include "core/picture.h"

/// What a picture with detail has to look like, by the rule that Picture and DetailLayer state, in
/// double precision and without GL.
namespace povpreview::test {

/// Of a position in a triangle: the weights of its corners. Their least tells how far inside it is,
/// negative: outside.
inline glm::dvec3 weights_in(const Picture::Corner* corners, glm::dvec2 p) {
    const auto twice_area = [](glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
        return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    };
    const glm::dvec2 a = corners[0].position, b = corners[1].position, c = corners[2].position;
    const double all = twice_area(a, b, c);
    const double u = twice_area(p, b, c) / all, v = twice_area(a, p, c) / all;
    return {u, v, 1 - u - v};
}

class ShownDetail {
   public:
    explicit ShownDetail(const Picture& picture) : picture_(picture) {}

    /// What a position shows of a triangle that holds it.
    glm::dvec3 at(glm::dvec2 position, std::size_t triangle) const {
        const Picture::Corner* corners = &picture_.corners[triangle];
        const glm::dvec3 weights = weights_in(corners, position);
        glm::dvec3 plain(0);
        for (int i = 0; i < 3; ++i) plain += weights[i] * glm::dvec3(corners[i].colour);
        if (!picture_.detail) return plain;
        const Pixel pixel = picture_.detail->pixel_at(position);
        const std::uint32_t item = picture_.detail->item(pixel);
        if (item == DetailMap::unknown) return plain;
        Light sum;
        for (int i = 0; i < 3; ++i)
            if (picture_.lights[triangle + i].item == item)
                sum.add(weights[i], corners[i].colour, picture_.lights[triangle + i]);
        if (sum.weight > 1e-5) return sum.on(*picture_.detail, pixel);
        const Picture::Anchor* anchor = nearest_anchor(item, pixel);
        if (!anchor) return plain;
        Light alone;
        alone.add(1, anchor->corner.colour, anchor->light);
        return alone.on(*picture_.detail, pixel);
    }

   private:
    struct Light {
        glm::dvec3 colour{0}, illumination{0}, remainder{0};
        double weight = 0;
        bool shaded = true;

        void add(double share, const glm::vec3& of, const Picture::Light& light) {
            weight += share;
            colour += share * glm::dvec3(of);
            illumination += share * glm::dvec3(light.illumination);
            remainder += share * glm::dvec3(light.remainder);
            shaded = shaded && light.shaded;
        }
        glm::dvec3 on(const DetailMap& detail, Pixel pixel) const {
            const bool known = detail.albedo_state(pixel) == DetailMap::Albedo::known;
            if (!known || !shaded) return colour / weight;
            return (glm::dvec3(detail.albedo(pixel)) * illumination + remainder) / weight;
        }
    };

    const Picture::Anchor* nearest_anchor(std::uint32_t item, Pixel pixel) const {
        if (item + 1 >= picture_.first_anchors.size()) return nullptr;
        const auto width = static_cast<Pixel>(picture_.width);
        const glm::vec2 centre(float(pixel % width) + .5f, float(pixel / width) + .5f);
        const Picture::Anchor* nearest = nullptr;
        float least = std::numeric_limits<float>::infinity();
        for (std::uint32_t i = picture_.first_anchors[item]; i < picture_.first_anchors[item + 1];
             ++i) {
            const float distance = glm::distance(picture_.anchors[i].corner.position, centre);
            if (distance < least) nearest = &picture_.anchors[i];
            least = std::min(least, distance);
        }
        return nearest;
    }

    const Picture& picture_;
};

/// The picture's linear colour at every pixel centre.
inline std::vector<glm::vec3> rasterise_detail(const Picture& picture) {
    const ShownDetail shown(picture);
    const auto width = static_cast<std::size_t>(picture.width);
    std::vector<glm::vec3> image(width * static_cast<std::size_t>(picture.height));
    for (std::size_t t = 0; t < picture.corners.size(); t += 3) {
        const Picture::Corner* c = &picture.corners[t];
        glm::vec2 low = c[0].position, high = low;
        for (int i = 1; i < 3; ++i) {
            low = {std::min(low.x, c[i].position.x), std::min(low.y, c[i].position.y)};
            high = {std::max(high.x, c[i].position.x), std::max(high.y, c[i].position.y)};
        }
        for (int y = std::max(0, int(low.y)); y < std::min(picture.height, int(high.y) + 1); ++y)
            for (int x = std::max(0, int(low.x)); x < std::min(picture.width, int(high.x) + 1);
                 ++x) {
                const glm::dvec3 w = weights_in(c, {x + .5, y + .5});
                if (std::min({w.x, w.y, w.z}) >= -1e-9)
                    image[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)] =
                        shown.at({x + .5, y + .5}, t);
            }
    }
    for (std::size_t i = 0; i < picture.known.size(); ++i)
        if (picture.known[i]) image[i] = picture.pixels[i];
    return image;
}

}  // namespace povpreview::test
