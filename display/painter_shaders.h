// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

namespace povpreview::shaders {

// Common to all vertex shaders below. A position goes from picture to target pixels to the
// viewport's [-1, 1]; `up` is -1 where the target's lowest row shows the picture's top.
#define POVPREVIEW_TO_VIEWPORT                                       \
    "uniform vec2 scale;   // target pixels for a picture pixel\n"   \
    "uniform vec2 origin;  // of the part drawn, target pixels\n"    \
    "uniform vec2 tile;    // size of the part drawn, in the same\n" \
    "uniform float up;\n"                                            \
    "vec4 to_viewport(vec2 target) {\n"                              \
    "    vec2 p = (target - origin) / tile * 2.0 - 1.0;\n"           \
    "    return vec4(p.x, -up * p.y, 0.0, 1.0);\n"                   \
    "}\n"

inline constexpr const char* triangle_vertex = POVPREVIEW_TO_VIEWPORT R"(
layout(location = 0) in vec2 position;
layout(location = 1) in vec3 corner_colour;
// Centroid: where a triangle covers but part of a pixel, its colour must not be extrapolated to
// the pixel's centre outside of it.
centroid out vec3 colour;
void main() {
    colour = corner_colour;
    gl_Position = to_viewport(position * scale);
})";

inline constexpr const char* triangle_fragment = R"(
uniform vec2 range;  // of light, from and to
centroid in vec3 colour;
out vec4 result;
void main() { result = vec4(clamp(colour, range.x, range.y), 1.0); })";

inline constexpr const char* pixel_fragment = R"(
uniform sampler2D colours;
uniform usampler2D known;
uniform vec2 range;   // of light, from and to
uniform ivec2 first;  // picture pixel of the texture's first texel
uniform vec2 scale, origin, tile;
uniform float up;
out vec4 result;
void main() {
    vec2 target = origin + vec2(gl_FragCoord.x,
                                up < 0.0 ? gl_FragCoord.y : tile.y - gl_FragCoord.y);
    ivec2 texel = ivec2(floor(target / scale)) - first;
    if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, textureSize(known, 0))) ||
        texelFetch(known, texel, 0).r == 0u)
        discard;
    result = vec4(clamp(texelFetch(colours, texel, 0).rgb, range.x, range.y), 1.0);
})";

//  A line is a rectangle, `reach` wider than the line on all sides; the fragment's distance from
//  the line gives its coverage.
//
//      2+-------------------+3
//       |  from=======to    |       t: across
//      0+-------------------+1      ^--> d: along
inline constexpr const char* line_vertex = POVPREVIEW_TO_VIEWPORT R"(
layout(location = 0) in vec2 from;
layout(location = 1) in vec2 to;
layout(location = 2) in vec4 line_paint;
flat out vec4 paint;
uniform float half_width;  // target pixels
out vec2 place;            // along and across, target pixels from the line's start
out float line_length;
void main() {
    paint = line_paint;
    vec2 a = from * scale, b = to * scale;
    line_length = length(b - a);
    vec2 d = line_length > 0.0 ? (b - a) / line_length : vec2(1.0, 0.0);
    vec2 t = vec2(-d.y, d.x);
    float reach = half_width + 1.0;
    place = vec2((gl_VertexID & 1) == 0 ? -reach : line_length + reach,
                 (gl_VertexID & 2) == 0 ? -reach : reach);
    gl_Position = to_viewport(a + place.x * d + place.y * t);
})";

inline constexpr const char* line_fragment = R"(
flat in vec4 paint;
uniform float half_width;
in vec2 place;
in float line_length;
out vec4 result;
void main() {
    float beyond = max(max(-place.x, place.x - line_length), 0.0);
    float coverage = clamp(half_width + 0.5 - length(vec2(beyond, place.y)), 0.0, 1.0);
    result = vec4(paint.rgb, paint.a * coverage);
})";

inline constexpr const char* dot_vertex = POVPREVIEW_TO_VIEWPORT R"(
layout(location = 0) in vec2 centre;
uniform float radius;  // target pixels
out vec2 place;        // from the centre, target pixels
void main() {
    float reach = radius + 1.0;
    place = vec2((gl_VertexID & 1) == 0 ? -reach : reach, (gl_VertexID & 2) == 0 ? -reach : reach);
    gl_Position = to_viewport(centre * scale + place);
})";

// A bright core in a dark rim is seen on any ground.
inline constexpr const char* dot_fragment = R"(
uniform vec4 paint;
uniform float radius;
in vec2 place;
out vec4 result;
void main() {
    float away = length(place);
    float coverage = clamp(radius + 0.5 - away, 0.0, 1.0);
    float core = clamp(0.6 * radius + 0.5 - away, 0.0, 1.0);
    result = vec4(paint.rgb * core, paint.a * coverage);
})";

}  // namespace povpreview::shaders
