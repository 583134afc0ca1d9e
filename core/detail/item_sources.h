// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "core/detail/item_buffer.h"
#include "core/detail/item_canvas.h"

namespace povpreview {

/// The surface that a canvas shows, as in an ItemBuffer.
inline std::uint32_t surface_of(const DrawableScene& scene, ItemCanvas::Source source) {
    if (source == ItemCanvas::nothing) return ItemBuffer::background;
    if (source == ItemCanvas::unknown) return ItemBuffer::unknown;
    if (source & ItemCanvas::piece_bit)
        return scene.pieces[source & ~ItemCanvas::piece_bit].surface;
    return scene.polygons.faces[source].surface;
}

/// REQUIRES: neither nothing nor unknown.
inline std::uint32_t material_of(const DrawableScene& scene, ItemCanvas::Source source) {
    if (source & ItemCanvas::piece_bit)
        return scene.pieces[source & ~ItemCanvas::piece_bit].material;
    return scene.polygons.faces[source].material;
}

/// Null if there is none.
inline const Look* look_of(const DrawableScene& scene, ItemCanvas::Source source) {
    if (source == ItemCanvas::nothing || source == ItemCanvas::unknown) return nullptr;
    const std::uint32_t number = material_of(scene, source);
    return number < scene.looks.size() ? &scene.looks[number] : nullptr;
}

}  // namespace povpreview
