// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/item_painter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>

#include "core/error.h"
#include "display/image_file.h"
#include "tests/display/item_scene.h"

namespace povpreview::test {
namespace {

std::vector<Backend> backends() {
#ifdef POVPREVIEW_HAVE_OSMESA
    return {Backend::egl, Backend::osmesa};
#else
    return {Backend::egl};
#endif
}

/// One painter a backend for all tests: it takes its time to be made.
ItemPainter& painter_of(Backend backend) {
    static const std::unique_ptr<GlContext> contexts[] = {
        open_offscreen(Backend::egl),
        backends().size() > 1 ? open_offscreen(Backend::osmesa) : nullptr};
    static std::unique_ptr<ItemPainter> painters[2];
    const std::size_t i = backend == Backend::osmesa;
    if (!painters[i]) painters[i] = std::make_unique<ItemPainter>(*contexts[i]);
    return *painters[i];
}

/// Where POVPREVIEW_ITEM_PICTURES names a folder, buffers are written there, in false colour.
void write_picture(const ItemBuffer& buffer, const std::string& name) {
    const char* folder = std::getenv("POVPREVIEW_ITEM_PICTURES");
    if (!folder) return;
    Image image(buffer.width, buffer.height), albedo(buffer.width, buffer.height);
    for (std::size_t i = 0; i < buffer.surfaces.size(); ++i) {
        const std::uint32_t surface = buffer.surfaces[i];
        std::mt19937 noise(surface);
        for (int c = 0; c < 3; ++c) image.pixels[i][c] = static_cast<float>(noise() % 256) / 255.f;
        if (surface == ItemBuffer::background) image.pixels[i] = glm::vec3(0);
        if (surface == ItemBuffer::unknown) image.pixels[i] = glm::vec3(1, 1, 1);
        if (!buffer.albedos.empty()) albedo.pixels[i] = buffer.albedos[i];
    }
    write_image(image, std::string(folder) + "/" + name + ".png");
    if (!buffer.albedos.empty())
        write_image(albedo, std::string(folder) + "/" + name + "_albedo.png");
}

/// How a painted buffer compares with one by rays.
struct Agreement {
    std::size_t inner = 0;        ///< pixels whose eight neighbours show the same surface
    std::size_t inner_wrong = 0;  ///< of those
    std::size_t beyond_edge = 0;  ///< other pixels: those that show none of the surfaces around
    std::size_t unknown = 0;      ///< that need not be, anywhere
    std::size_t kinds_wrong = 0, albedos_wrong = 0;  ///< where the surface is right and inner
    std::size_t seen = 0;                            ///< pixels that show a surface
    std::string first_wrong;
};

Agreement compare(const ItemBuffer& painted, const ItemBuffer& expected, float albedo_slack) {
    Agreement result;
    EXPECT_EQ(painted.surfaces.size(), expected.surfaces.size());
    for (int y = 0; y < expected.height; ++y) {
        for (int x = 0; x < expected.width; ++x) {
            const auto at = static_cast<std::size_t>(y * expected.width + x);
            const std::uint32_t surface = expected.surfaces[at];
            bool inner = true, near = false;
            for (int j = std::max(y - 1, 0); j <= std::min(y + 1, expected.height - 1); ++j)
                for (int i = std::max(x - 1, 0); i <= std::min(x + 1, expected.width - 1); ++i) {
                    const std::uint32_t other =
                        expected.surfaces[static_cast<std::size_t>(j * expected.width + i)];
                    inner = inner && other == surface;
                    near = near || other == painted.surfaces[at];
                }
            const bool right = painted.surfaces[at] == surface;
            result.seen += surface != ItemBuffer::background && surface != ItemBuffer::unknown;
            result.unknown += !right && painted.surfaces[at] == ItemBuffer::unknown;
            result.inner += inner;
            const auto note = [&](const std::string& what) {
                if (result.first_wrong.empty())
                    result.first_wrong =
                        what + " at " + std::to_string(x) + ", " + std::to_string(y) + ": " +
                        std::to_string(painted.surfaces[at]) + " for " + std::to_string(surface);
            };
            if (inner && !right) ++result.inner_wrong, note("inner");
            if (!inner && !near && painted.surfaces[at] != ItemBuffer::unknown)
                ++result.beyond_edge, note("beyond");
            if (!inner || !right) continue;
            if (painted.kinds[at] != expected.kinds[at]) ++result.kinds_wrong, note("kind");
            if (expected.kinds[at] != Look::Kind::image) continue;
            if (painted.albedos.empty() ||
                !(glm::length(glm::vec3(painted.albedos[at] - expected.albedos[at])) <=
                  albedo_slack))
                ++result.albedos_wrong, note("albedo");
        }
    }
    return result;
}

class ItemPainterTest : public testing::TestWithParam<Backend> {
   protected:
    /// Paints the scene and holds it against rays. `shown`: pixels that must show something.
    Agreement expect_right(const ItemScene& made, const std::string& name,
                           std::size_t shown = 100) {
        const ItemBuffer painted = painter_of(GetParam()).paint(made.scene);
        if (GetParam() == Backend::egl) write_picture(painted, name);
        const Agreement agreement = compare(painted, made.expected(), .02f);
        EXPECT_GE(agreement.seen, shown) << name << ": the test shows nothing";
        EXPECT_LE(agreement.inner_wrong * 1000, agreement.inner) << name << agreement.first_wrong;
        EXPECT_LE(agreement.beyond_edge * 2000, painted.surfaces.size())
            << name << agreement.first_wrong;
        EXPECT_LE(agreement.unknown * 1000, painted.surfaces.size()) << name;
        EXPECT_LE(agreement.kinds_wrong * 1000, agreement.inner) << name << agreement.first_wrong;
        EXPECT_LE(agreement.albedos_wrong * 500, agreement.inner) << name << agreement.first_wrong;
        return agreement;
    }
};

INSTANTIATE_TEST_SUITE_P(Backends, ItemPainterTest, testing::ValuesIn(backends()),
                         [](const testing::TestParamInfo<Backend>& backend) {
                             return backend.param == Backend::egl ? "egl" : "osmesa";
                         });

constexpr int width = 160, height = 120;

TEST_P(ItemPainterTest, PolygonsHideEachOther) {
    ItemScene made(look_at({3, 2, -5}, {0, 0, 0}), width, height);
    made.box({-1, -1, -1}, {1, 1, 1});
    made.box({-.5, -.5, -3}, {.2, .3, 3});
    made.face({{-9, -1.2, -9}, {9, -1.2, -9}, {9, -1.2, 9}, {-9, -1.2, 9}});
    expect_right(made, "polygons", 9000);
}

TEST_P(ItemPainterTest, SpheresOfAllSizes) {
    ItemScene made(look_at({3, 2, -5}, {0, 0, 0}), width, height);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(-2, 2), radius(.02, .5);
    for (int i = 0; i < 60; ++i)
        made.sphere({place(random), place(random), place(random)}, radius(random));
    made.ellipsoid({{.3, .9, 0}, {-.9, .3, .1}, {0, 0, .2}, {.5, 0, -2}});
    expect_right(made, "spheres", 5000);
}

}  // namespace
}  // namespace povpreview::test
