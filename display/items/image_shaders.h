// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

/// The shader that lays one image over the surfaces that show it, as POV-Ray 3.7 does (its
/// image_map pigments). Follows `records` in item_shaders.h.
namespace povpreview::items::shaders {

/// Before it come constants that spare software renderers the branches not taken:
///
///     const bool angles;  // whether the mapping is by angles
///     const int taps;     // texels a side: 1, 2 (bilinear, normalised distance) or 4
///     const bool linear;  // gamma is 1
inline constexpr const char* image_inputs = R"(
uniform usampler2D items;
uniform sampler2D depths;
uniform sampler2D image;  // texels in rows of 2048
uniform ivec2 size;       // of the image, texels
uniform uint look;
uniform bool orthographic;
// The rays, in the pigment's space: from the middle of the image.
uniform vec3 origin, along, across, down;
uniform vec2 middle;
uniform vec3 from_u, from_v, from_zero;  // texture coordinates' way into the same space
uniform int mapping, interpolation;  // as ImageLook
uniform bool once;
uniform float gamma;
layout(location = 0) out vec4 albedo;  // last: 0 not drawn, 1 drawn, 2 drawn but not opaque
const int mapping_spherical = 1, mapping_cylindrical = 2, mapping_toroidal = 3, mapping_uv = 4;
const int nearest_texel = 0, bilinear = 1, bicubic = 2;
const uint has_uvs = 0x80000000u;
const float nearest_depth = 1e-15;
)";

// The polynomial: a minimax-like fit (Chebyshev nodes) of atan(x) / x by x^2 for x up to
// tan(pi / 8), off by 2e-8; drivers' own arc functions may be off by 1e-4, several texels.
inline constexpr const char* image_angles = R"(
const float pi = 3.14159265;
float angle_of(float x, float y) {  // atan(y / x) of all quadrants, -pi to pi
    float small = min(abs(x), abs(y)), large = max(abs(x), abs(y));
    float t = large > 0.0 ? small / large : 0.0;
    bool over = t > 0.41421356;
    if (over) t = (t - 1.0) / (t + 1.0);
    float z = t * t;
    float a = t * (0.99999998 + z * (-0.33332786 + z * (0.19974082 + z * (-0.1384849 +
                   z * 0.07976292))));
    if (over) a += 0.25 * pi;
    if (abs(y) > abs(x)) a = 0.5 * pi - a;
    if (x < 0.0) a = pi - a;
    return y < 0.0 ? -a : a;
}
// From x towards z, as a share of a whole turn.
float turn_of(float x, float z) {
    float share = angle_of(x, z) / (2.0 * pi);
    return share < 0.0 ? share + 1.0 : share;
}
)";

inline constexpr const char* image_mapping = R"(
// The image's unit square, v upwards. False outside of the image.
bool map_point(vec3 p, out vec2 square) {
    float aside = length(p.xz);
    square = p.xy;
    if (!angles) return !once || all(equal(square, clamp(square, 0.0, 1.0)));
    if (mapping == mapping_spherical) {
        square = vec2(turn_of(p.x, p.z), 0.5 + angle_of(aside, p.y) / pi);
    } else if (mapping == mapping_cylindrical) {
        square.x = turn_of(p.x, p.z);
    } else if (mapping == mapping_toroidal) {
        float around = angle_of(1.0 - aside, abs(p.y)) / (2.0 * pi);
        square = vec2(turn_of(p.x, p.z), p.y > 0.0 ? 1.0 - around : around);
    }
    bool rolled = mapping == mapping_spherical || mapping == mapping_toroidal;
    bool free_x = rolled || mapping == mapping_cylindrical;
    return !once || ((rolled || (square.y >= 0.0 && square.y <= 1.0)) &&
                     (free_x || (square.x >= 0.0 && square.x <= 1.0)));
}
// Of the pixel's face; under a perspective camera, what is linear in the image are u, v and 1, each
// divided by the depth.
vec3 face_coordinates(uint face, vec2 pixel) {
    vec4 place = floats(face), slope = floats(face + 1u), u = floats(face + 3u),
         v = floats(face + 4u);
    vec2 offset = pixel - place.xy;
    vec2 coordinates = vec2(u.x + dot(u.yz, offset), u.w + dot(v.xy, offset));
    return vec3(orthographic ? coordinates : coordinates / (place.z + dot(slope.xy, offset)), 0.0);
}
)";

inline constexpr const char* image_fragment = R"(
// By floats: software renderers divide integers one by one.
ivec2 wrapped(ivec2 texel, ivec2 size) {
    vec2 t = vec2(texel), s = vec2(size);
    return ivec2(t - s * floor(t / s));
}
float cubic(float d) {  // Catmull and Rom's
    return d < 1.0 ? 1.0 + d * d * (1.5 * d - 2.5) : 2.0 + d * (-4.0 + d * (2.5 - 0.5 * d));
}
void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    uint item = texelFetch(items, pixel, 0).x;
    uint wanted = mapping == mapping_uv ? look | has_uvs : look;
    if (bits(item).y != wanted) discard;

    vec3 p;
    if (mapping == mapping_uv) {
        vec3 uv = face_coordinates(item - 2u, gl_FragCoord.xy);
        p = from_zero + uv.x * from_u + uv.y * from_v;
    } else {
        float depth = nearest_depth / texelFetch(depths, pixel, 0).r;
        vec2 offset = gl_FragCoord.xy - middle;
        vec3 aside = offset.x * across + offset.y * down;
        p = origin + (orthographic ? aside + depth * along : depth * (along + aside));
    }
    vec2 square;
    if (!map_point(p, square)) discard;

    square.y = -square.y;  // rows go down
    vec2 place = (square - floor(square)) * vec2(size);
    // Texels [first, first + taps) a side are weighed by their distance from the place.
    vec2 base = floor(place - 0.5), share = place - 0.5 - base;
    ivec2 first = taps == 1 ? ivec2(floor(place)) : ivec2(base) - (taps == 4 ? 1 : 0);
    vec4 sum = vec4(0.0);
    float weights = 0.0;
    for (int j = 0; j < taps; ++j) {
        for (int i = 0; i < taps; ++i) {
            vec2 d = abs(vec2(i, j) - float(taps / 4) - share);
            float weight = 1.0;
            if (interpolation == bilinear) weight = (1.0 - d.x) * (1.0 - d.y);
            else if (interpolation == bicubic) weight = cubic(d.x) * cubic(d.y);
            else if (interpolation != nearest_texel) weight = 1.0 / max(dot(d, d), 1e-12);
            ivec2 texel = first + ivec2(i, j);
            // At the borders: the same side's texels again, or the other side's.
            texel = once ? clamp(texel, ivec2(0), size - 1) : wrapped(texel, size);
            int number = texel.y * size.x + texel.x;
            sum += weight * texelFetch(image, ivec2(number & 2047, number >> 11), 0);
            weights += weight;
        }
    }
    sum /= weights;
    vec3 light = max(sum.rgb, 0.0);
    albedo = vec4(linear ? light : pow(light, vec3(gamma)), sum.a > 0.998 ? 1.0 : 2.0);
})";

}  // namespace povpreview::items::shaders
