// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/item_painter.h"

#include <cassert>
#include <optional>
#include <string>

#include "core/error.h"
#include "display/items/draw_lists.h"
#include "display/items/face_list.h"
#include "display/items/item_programs.h"
#include "display/items/item_target.h"
#include "display/items/object_list.h"

namespace povpreview {

using namespace items;

struct ItemPainter::Parts {
    explicit Parts(GlContext& gl_context) : context(gl_context), programs(gl_context) {}

    void prepare(int width, int height);
    ItemBuffer unpack(const DrawableScene& scene, const DrawLists& lists,
                      const std::vector<glm::uvec2>& pixels) const;

    GlContext& context;
    ItemPrograms programs;
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
                                      const std::vector<glm::uvec2>& pixels) const {
    ItemBuffer buffer;
    buffer.width = target->width();
    buffer.height = target->height();
    buffer.surfaces.resize(pixels.size());
    buffer.kinds.resize(pixels.size(), Look::Kind::mixed);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        buffer.surfaces[i] = pixels[i].x;
        std::uint32_t look = pixels[i].y;
        if (look & look_in_record) look = lists.records.at((look & ~look_in_record) + 1).z;
        if (look >= scene.looks.size()) continue;
        const Look::Kind kind = scene.looks[look].kind;
        buffer.kinds[i] = kind == Look::Kind::image ? Look::Kind::traced : kind;
    }
    return buffer;
}

ItemPainter::ItemPainter(GlContext& context) {
    context.make_current();
    parts_ = std::make_unique<Parts>(context);
}

ItemPainter::~ItemPainter() { parts_->context.make_current(); }

ItemBuffer ItemPainter::paint(const DrawableScene& scene) {
    const int width = scene.polygons.width, height = scene.polygons.height;
    assert(width > 0 && height > 0);
    const PixelRays rays(scene.polygons.camera);
    if (!rays.valid) return unknown_buffer(width, height);
    DrawLists lists;
    lists.look_rects.resize(scene.looks.size());
    list_faces(scene, rays, lists);
    list_objects(scene, rays, lists);

    Parts& parts = *parts_;
    parts.context.make_current();
    parts.prepare(width, height);
    parts.target->begin({ItemBuffer::background, no_look});
    parts.programs.draw(lists, rays, width, height);
    ItemBuffer buffer = parts.unpack(scene, lists, parts.target->read());
    if (parts.context.gl().GetError() != GL_NO_ERROR)
        throw Error(Exit::usage, "OpenGL cannot draw or read back the item buffer",
                    parts.context.description(), "choose another display backend");
    return buffer;
}

}  // namespace povpreview
