// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "core/detail/item_canvas.h"
#include "core/detail/pixel_rays.h"

namespace povpreview {

/// What a place looks like without light.
struct SeenLook {
    Look::Kind kind = Look::Kind::mixed;
    std::optional<glm::vec3> albedo;  ///< linear; there where the kind is `image` or `pattern`
};

/// Whether places of such a look may have an albedo.
inline bool has_albedo(const Look& look) {
    return look.kind == Look::Kind::image || look.kind == Look::Kind::pattern;
}

/// Of what a canvas shows, drawn by these rays: at a place in pixels, so near. What its image or
/// pattern does not tell there is `traced`; nothing at all is plain, for a sky may be of any colour
/// and nothing tells it apart from light; what is unknown is `mixed`.
SeenLook seen_look(const DrawableScene& scene, const PixelRays& rays, const glm::dvec2& place,
                   double nearness, ItemCanvas::Source source);

}  // namespace povpreview
