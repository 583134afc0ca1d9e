// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include "display/painter_shaders.h"

namespace povpreview::shaders {

// Triangles over pixels of which something is known. Each pixel takes only those corners that lie
// on its own surface, weighted by how near they are:
//
//     a . . . . b      a and b lie on the floor, c on the wall: a pixel that shows the floor is
//      .floor /.       interpolated between a and b, one that shows the wall has c's light, and one
//       .   /wall      that shows neither takes the nearest anchor of its own.
//        c . .
//
// Where the albedo of the pixel is known, the corners give the light, else the colour.

// Triangles whose corners lie on one surface, as nearly all do.
inline constexpr const char* even_vertex = POVPREVIEW_TO_VIEWPORT R"(
layout(location = 0) in vec2 position;
layout(location = 1) in vec3 corner_colour;
layout(location = 2) in vec3 corner_illumination;
layout(location = 3) in vec3 corner_remainder;
layout(location = 4) in uvec3 corner_items;
layout(location = 5) in uint corner_shaded;
centroid out vec3 colour, illumination, remainder;
flat out uint item;
flat out uint shaded;
void main() {
    colour = corner_colour;
    illumination = corner_illumination;
    remainder = corner_remainder;
    item = corner_items.x;
    shaded = corner_shaded;
    gl_Position = to_viewport(position * scale);
})";

// Others: slot i of the sums belongs to corner i, so that after interpolation it holds the corner's
// own value times its weight.
inline constexpr const char* odd_vertex = POVPREVIEW_TO_VIEWPORT R"(
layout(location = 0) in vec2 position;
layout(location = 1) in vec3 corner_colour;
layout(location = 2) in vec3 corner_illumination;
layout(location = 3) in vec3 corner_remainder;
layout(location = 4) in uvec3 corner_items;
layout(location = 5) in uint corner_shaded;
centroid out mat3 colours, illuminations, remainders;
centroid out vec3 weights;
flat out uvec3 items;
flat out uint shaded;
void main() {
    int slot = gl_VertexID % 3;
    colours = illuminations = remainders = mat3(0.0);
    weights = vec3(0.0);
    colours[slot] = corner_colour;
    illuminations[slot] = corner_illumination;
    remainders[slot] = corner_remainder;
    weights[slot] = 1.0;
    items = corner_items;
    shaded = corner_shaded;
    gl_Position = to_viewport(position * scale);
})";

inline constexpr const char* detail = R"(
uniform vec2 range;   // of light, from and to
uniform vec2 scale, origin, tile;
uniform float up;
uniform usampler2D pixel_items;
uniform sampler2D pixel_albedos;   // where known, else alpha is 0
uniform usampler2D anchor_ranges;  // by item: first and end
uniform sampler2D anchors;         // texels of four: position, colour, illumination, remainder
out vec4 result;
const uint unknown = 0xffffffffu;

ivec2 pixel() {
    vec2 target = origin + vec2(gl_FragCoord.x,
                                up < 0.0 ? gl_FragCoord.y : tile.y - gl_FragCoord.y);
    return clamp(ivec2(floor(target / scale)), ivec2(0), textureSize(pixel_items, 0) - 1);
}
vec4 anchor(uint i, int part) {
    int width = textureSize(anchors, 0).x / 4;
    return texelFetch(anchors, ivec2(4 * (int(i) % width) + part, int(i) / width), 0);
}
// Light from a surface; `shaded` where illumination and remainder are known.
vec3 seen(ivec2 pixel, vec3 colour, vec3 illumination, vec3 remainder, bool shaded) {
    vec4 albedo = texelFetch(pixel_albedos, min(pixel, textureSize(pixel_albedos, 0) - 1), 0);
    return shaded && albedo.a > 0.5 ? albedo.rgb * illumination + remainder : colour;
}
// Light of an item none of whose samples is a corner here; `otherwise` if it has none at all.
vec3 from_anchor(ivec2 pixel, uint item, vec3 otherwise) {
    int width = textureSize(anchor_ranges, 0).x;
    uvec2 own = texelFetch(anchor_ranges, ivec2(int(item) % width, int(item) / width), 0).rg;
    float nearest = 3e38;
    uint chosen = unknown;
    for (uint i = own.x; i < own.y; ++i) {
        vec2 apart = anchor(i, 0).xy - (vec2(pixel) + 0.5);
        float distance = dot(apart, apart);
        if (distance < nearest) {
            nearest = distance;
            chosen = i;
        }
    }
    if (chosen == unknown) return otherwise;
    return seen(pixel, anchor(chosen, 1).rgb, anchor(chosen, 2).rgb, anchor(chosen, 3).rgb,
                anchor(chosen, 0).z > 0.5);
}
)";

inline const std::string even_fragment = std::string(detail) + R"(
centroid in vec3 colour, illumination, remainder;
flat in uint item;
flat in uint shaded;
void main() {
    ivec2 p = pixel();
    uint here = texelFetch(pixel_items, p, 0).r;
    vec3 light = colour;
    if (here == item && here != unknown)
        light = seen(p, colour, illumination, remainder, shaded == 7u);
    else if (here != unknown)
        light = from_anchor(p, here, colour);
    result = vec4(clamp(light, range.x, range.y), 1.0);
})";

inline const std::string odd_fragment = std::string(detail) + R"(
centroid in mat3 colours, illuminations, remainders;
centroid in vec3 weights;
flat in uvec3 items;
flat in uint shaded;
void main() {
    ivec2 p = pixel();
    uint here = texelFetch(pixel_items, p, 0).r;
    vec3 light = colours * vec3(1.0);
    if (here != unknown) {
        bvec3 own = equal(items, uvec3(here));
        vec3 chosen = vec3(own);
        float weight = dot(weights, chosen);
        uint corners = (own.x ? 1u : 0u) | (own.y ? 2u : 0u) | (own.z ? 4u : 0u);
        if (corners == 0u) {
            light = from_anchor(p, here, light);
        } else {
            // At a corner of another surface all of its own weigh nothing, and alike.
            chosen = weight > 1e-5 ? chosen / weight : vec3(0.0);
            if (weight > 1e-5)
                light = seen(p, colours * chosen, illuminations * chosen, remainders * chosen,
                             (shaded & corners) == corners);
            else
                light = from_anchor(p, here, light);
        }
    }
    result = vec4(clamp(light, range.x, range.y), 1.0);
})";

}  // namespace povpreview::shaders
