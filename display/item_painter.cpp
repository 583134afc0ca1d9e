// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/item_painter.h"

#include <cassert>
#include <glm/common.hpp>
#include <optional>
#include <string>

#include "core/error.h"
#include "display/items/draw_lists.h"
#include "display/items/face_list.h"
#include "display/items/image_pass.h"
#include "display/items/item_programs.h"
#include "display/items/item_target.h"
#include "display/items/object_list.h"

namespace povpreview {

using namespace items;

struct ItemPainter::Parts {
    explicit Parts(GlContext& gl_context)
        : context(gl_context), programs(gl_context), images(gl_context) {}

    void prepare(int width, int height);
    /// What was drawn, and where images are seen.
    ItemBuffer unpack(const DrawableScene& scene, const DrawLists& lists,
                      std::vector<SeenImage>& seen) const;
    void add_albedo(const DrawableScene& scene, const PixelRays& rays, ItemBuffer& buffer,
                    std::vector<SeenImage> seen);

    GlContext& context;
    ItemPrograms programs;
    ImagePass images;
    std::optional<ItemTarget> target;
};

namespace {

/// Nothing is known.
ItemBuffer unknown_buffer(int width, int height) {
    ItemBuffer buffer;
    buffer.width = width;
    buffer.height = height;
    const std::size_t pixels = static_cast<std::size_t>(width) * height;
    buffer.surfaces.assign(pixels, ItemBuffer::unknown);
    buffer.kinds.assign(pixels, Look::Kind::mixed);
    return buffer;
}

/// A scene for every shader. Drivers that compile when a shader is first drawn with do so then.
DrawableScene scene_of_everything() {
    DrawableScene scene;
    scene.polygons.width = scene.polygons.height = 8;
    scene.polygons.camera.to_pixels = glm::dmat4x3({8, 0, 0}, {0, 8, 0}, {4, 4, 1}, {0, 0, 0});
    scene.unknown = {{{-.5, -.5, 4}, {-.4, -.4, 5}}};
    const auto at = [](double z) {
        return glm::dmat4x3({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -z});
    };
    scene.solids = {{Solid::Kind::sphere, at(3), {}},
                    {Solid::Kind::cylinder, at(3), {}},
                    {Solid::Kind::torus, at(3), {.5}}};
    scene.conditions = {1};
    scene.pieces = {{0, 2, 0, 0, 0}, {1, 3, 0, 0, 0}, {0, 4, 0, 0, 1}, {2, 5, 0, 0, 0}};
    const Bounds bounds{{-1, -1, 2}, {1, 1, 4}};
    for (std::uint32_t i = 0; i < scene.pieces.size(); ++i) scene.objects.push_back({bounds, i, 1});
    scene.images.push_back({4, 4, std::vector<std::array<std::uint16_t, 4>>(16)});
    for (std::uint32_t i = 0; i < 6; ++i) {
        Look look{Look::Kind::image, {}};
        look.image.mapping = i % 2 ? ImageLook::Mapping::spherical : ImageLook::Mapping::planar;
        look.image.interpolation = static_cast<ImageLook::Interpolation>(i / 2);
        scene.looks.push_back(look);
        PolygonScene& polygons = scene.polygons;
        const double x = .5 * i - 1.5;
        for (const glm::dvec3& p : {glm::dvec3(x, -1, 2), {x + .5, -1, 2}, {x, 0, 2}}) {
            polygons.corners.push_back(static_cast<std::uint32_t>(polygons.points.size()));
            polygons.points.push_back(p);
        }
        polygons.faces.push_back({3 * i, 3, 1, i});
    }
    return scene;
}

}  // namespace

void ItemPainter::Parts::prepare(int width, int height) {
    const int limit = context.max_texture_size();
    if (width > limit || height > limit)
        throw Error(Exit::usage,
                    std::to_string(width) + " x " + std::to_string(height) +
                        " pixels are more than OpenGL's limit of " + std::to_string(limit) +
                        " a side",
                    context.description(), "choose a smaller size");
    if (target && target->width() == width && target->height() == height) return;
    target.reset();
    target.emplace(context, width, height);
}

ItemBuffer ItemPainter::Parts::unpack(const DrawableScene& scene, const DrawLists& lists,
                                      std::vector<SeenImage>& seen) const {
    const std::vector<std::uint32_t> pixels = target->read();
    ItemBuffer buffer;
    buffer.width = target->width();
    buffer.height = target->height();
    buffer.surfaces.resize(pixels.size());
    buffer.kinds.resize(pixels.size(), Look::Kind::mixed);
    std::vector<SeenImage> by_look(scene.looks.size());
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const glm::uvec4& label = lists.records.at(pixels[i]);
        buffer.surfaces[i] = label.x;
        const std::uint32_t look = label.y & ~Records::has_uvs;
        if (look >= scene.looks.size()) continue;
        buffer.kinds[i] = scene.looks[look].kind;
        if (buffer.kinds[i] != Look::Kind::image) continue;
        const auto width = static_cast<std::size_t>(buffer.width);
        const glm::ivec2 pixel(i % width, i / width);
        SeenImage& part = by_look[look];
        part.low = glm::min(part.low, pixel);
        part.high = glm::max(part.high, pixel);
    }
    for (std::uint32_t look = 0; look < by_look.size(); ++look) {
        by_look[look].look = look;
        if (by_look[look].high.x >= 0) seen.push_back(by_look[look]);
    }
    return buffer;
}

void ItemPainter::Parts::add_albedo(const DrawableScene& scene, const PixelRays& rays,
                                    ItemBuffer& buffer, std::vector<SeenImage> seen) {
    const std::vector<glm::vec4> drawn = images.draw(scene, rays, *target, std::move(seen));
    buffer.albedos.resize(drawn.size());
    bool any = false;
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        if (buffer.kinds[i] != Look::Kind::image) continue;
        const bool opaque = drawn[i].w == 1, outside = drawn[i].w == 0;
        any = any || opaque;
        if (opaque)
            buffer.albedos[i] = glm::vec3(drawn[i]);
        else
            buffer.kinds[i] = outside ? Look::Kind::traced : Look::Kind::mixed;
    }
    if (!any) buffer.albedos.clear();
}

ItemPainter::ItemPainter(GlContext& context) {
    context.make_current();
    parts_ = std::make_unique<Parts>(context);
    DrawableScene scene = scene_of_everything();
    for (const float gamma : {1.f, 2.2f}) {
        scene.working_gamma = gamma;
        paint(scene);
    }
}

ItemPainter::~ItemPainter() { parts_->context.make_current(); }

ItemBuffer ItemPainter::paint(const DrawableScene& scene) {
    const int width = scene.polygons.width, height = scene.polygons.height;
    assert(width > 0 && height > 0);
    const PixelRays rays(scene.polygons.camera);
    if (!rays.valid) return unknown_buffer(width, height);
    DrawLists lists;
    list_faces(scene, rays, lists);
    list_objects(scene, rays, lists);

    Parts& parts = *parts_;
    parts.context.make_current();
    parts.prepare(width, height);
    parts.target->begin(Records::background);
    parts.programs.draw(lists, rays, width, height);
    std::vector<SeenImage> seen;
    ItemBuffer buffer = parts.unpack(scene, lists, seen);
    if (!seen.empty()) parts.add_albedo(scene, rays, buffer, std::move(seen));
    if (parts.context.gl().GetError() != GL_NO_ERROR)
        throw Error(Exit::usage, "OpenGL cannot draw or read back the item buffer",
                    parts.context.description(), "choose another display backend");
    return buffer;
}

}  // namespace povpreview
