// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/core/detail/item_agreement.h"

#include <gtest/gtest.h>

#include <array>
#include <glm/geometric.hpp>

#include "core/detail/item_painter.h"

namespace povpreview::test {

namespace {

/// Of albedos, by half floats and a power.
constexpr double albedo_slack = 1e-4;

using Hit = RayCaster::Hit;

/// What rays show at a pixel's centre and right around it.
std::array<Hit, 9> hits_around(const RayCaster& caster, int x, int y, double slack) {
    std::array<Hit, 9> hits;
    for (int i = 0; i < 9; ++i)
        hits[i] = caster.cast(x + .5 + slack * (i % 3 - 1), y + .5 + slack * (i / 3 - 1));
    return hits;
}

struct PaintedPixel {
    std::uint32_t surface;
    Look::Kind kind;
    glm::dvec3 albedo;

    bool shows(const Hit& hit) const {
        if (surface != hit.surface || kind != hit.kind) return false;
        return kind != Look::Kind::image || glm::distance(albedo, hit.albedo) <= albedo_slack;
    }
    /// Whether what is painted is what some of these rays show, or lies between what they show.
    bool agrees(const std::array<Hit, 9>& hits) const {
        bool border = false;
        for (const Hit& hit : hits) {
            if (shows(hit)) return true;
            border = border || hit.surface != hits[0].surface;
        }
        return border && surface == ItemBuffer::unknown;
    }
};

}  // namespace

ItemBuffer painted(const DrawableScene& scene) { return paint_items(scene); }

void expect_right(const ItemScene& made, std::size_t shown, double slack) {
    const ItemBuffer buffer = painted(made.scene);
    const RayCaster caster(made.scene, made.pose);
    std::size_t seen = 0, wrong = 0;
    for (int y = 0; y < buffer.height; ++y) {
        for (int x = 0; x < buffer.width; ++x) {
            const auto at = static_cast<std::size_t>(y * buffer.width + x);
            const PaintedPixel pixel{buffer.surfaces[at], buffer.kinds[at],
                                     buffer.albedos.empty() ? glm::vec3(0) : buffer.albedos[at]};
            const Hit hit = caster.cast(x + .5, y + .5);
            seen += hit.surface != ItemBuffer::background && hit.surface != ItemBuffer::unknown;
            if (pixel.shows(hit) || pixel.agrees(hits_around(caster, x, y, slack))) continue;
            if (++wrong > 5) continue;
            ADD_FAILURE() << "at " << x << ", " << y << ": surface " << pixel.surface << " for "
                          << hit.surface << ", kind " << int(pixel.kind) << " for " << int(hit.kind)
                          << ", albedo off by " << glm::distance(pixel.albedo, hit.albedo);
        }
    }
    EXPECT_EQ(wrong, 0u) << "pixels";
    EXPECT_GE(seen, shown) << "the test shows too little";
}

}  // namespace povpreview::test
