// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

/// Shaders that draw surface identity. All of them write the depth themselves, as
/// nearest_depth / depth: that keeps a float's relative precision at every range, and no planes
/// near or far cut anything off.
namespace povpreview::items::shaders {

/// Of the triangles of ItemCorner.
inline constexpr const char* corner_vertex = R"(
layout(location = 0) in vec2 position;  // pixels
layout(location = 1) in uint corner_record;
uniform vec2 size;
flat out uint record;
void main() {
    record = corner_record;
    gl_Position = vec4(position / size * 2.0 - 1.0, 0.0, 1.0);
})";

/// Looking up records, and what fragments write. See draw_lists.h.
inline constexpr const char* records = R"(
uniform usamplerBuffer records;
uvec4 bits(uint texel) { return texelFetch(records, int(texel)); }
vec4 floats(uint texel) { return uintBitsToFloat(bits(texel)); }
)";

inline constexpr const char* result = R"(
layout(location = 0) out uint item;  // texel of its label
const float nearest_depth = 1e-15;
const uint unknown = 1u;
const float none = 3e38;
void put(uint label, float depth) {
    item = label;
    gl_FragDepth = nearest_depth / max(depth, nearest_depth);
}
)";

inline constexpr const char* face_fragment = R"(
flat in uint record;
uniform bool orthographic;
void main() {
    vec4 place = floats(record), slope = floats(record + 1u);
    vec2 offset = gl_FragCoord.xy - place.xy;
    float v = place.z + dot(slope.xy, offset);
    item = record + 2u;
    // Never 0, not even where rounding sees the horizon's far side: 0 is what was cleared.
    gl_FragDepth = clamp(orthographic ? nearest_depth / max(v, nearest_depth) : v, 1e-37, 1.0);
})";

inline constexpr const char* sphere_vertex = R"(
layout(location = 0) in vec4 rectangle;
layout(location = 1) in vec4 instance_reference;
layout(location = 2) in vec4 instance_base;
layout(location = 3) in vec4 instance_direction;
layout(location = 4) in vec3 instance_across;
layout(location = 5) in vec3 instance_down;
layout(location = 6) in uint instance_item;
uniform vec2 size;
flat out vec4 reference, base, direction;
flat out vec3 across, down;
flat out uint label;
void main() {
    reference = instance_reference;
    base = instance_base;
    direction = instance_direction;
    across = instance_across;
    down = instance_down;
    label = instance_item;
    vec2 corner = vec2((gl_VertexID & 1) == 0 ? rectangle.x : rectangle.z,
                       (gl_VertexID & 2) == 0 ? rectangle.y : rectangle.w);
    gl_Position = vec4(corner / size * 2.0 - 1.0, 0.0, 1.0);
})";

//   Half the chord is found from the ray's distance from the centre, |p|, not from the
//   discriminant of a quadratic equation.
//
//                  .--+--.
//      eye ------(----p---)----->
//                     c
inline constexpr const char* sphere_fragment = R"(
flat in vec4 reference, base, direction;
flat in vec3 across, down;
flat in uint label;
void main() {
    vec2 offset = gl_FragCoord.xy - reference.xy;
    vec3 aside = offset.x * across + offset.y * down;
    vec3 e = base.xyz + base.w * aside, f = direction.xyz + direction.w * aside;
    float ff = dot(f, f), middle = -dot(e, f) / ff;
    vec3 p = e + middle * f;
    float square = 1.0 - dot(p, p);
    float half_chord = sqrt(max(square, 0.0) / ff);
    float depth = reference.z + (middle - half_chord) * reference.w;
    if (!(depth > nearest_depth)) depth = reference.z + (middle + half_chord) * reference.w;
    if (!(square >= 0.0 && depth > nearest_depth)) discard;
    put(label, depth);
})";

inline constexpr const char* capped_vertex = R"(
layout(location = 0) in vec4 corners_low;
layout(location = 1) in vec4 corners_high;
layout(location = 2) in vec4 instance_reference;
layout(location = 3) in vec4 instance_base;
layout(location = 4) in vec4 instance_direction;
layout(location = 5) in vec3 instance_across;
layout(location = 6) in vec3 instance_down;
layout(location = 7) in vec4 instance_signs;
layout(location = 8) in vec4 instance_plane0;
layout(location = 9) in vec4 instance_plane1;
layout(location = 10) in uvec4 instance_items;
uniform vec2 size;
flat out vec4 reference, base, direction, signs, plane0, plane1;
flat out vec3 across, down;
flat out uvec4 items;
void main() {
    reference = instance_reference;
    base = instance_base;
    direction = instance_direction;
    across = instance_across;
    down = instance_down;
    signs = instance_signs;
    plane0 = instance_plane0;
    plane1 = instance_plane1;
    items = instance_items;
    vec4 two = (gl_VertexID & 2) == 0 ? corners_low : corners_high;
    vec2 corner = (gl_VertexID & 1) == 0 ? two.xy : two.zw;
    gl_Position = vec4(corner / size * 2.0 - 1.0, 0.0, 1.0);
})";

/// Follows `quadratic`.
inline constexpr const char* capped_fragment = R"(
flat in vec4 reference, base, direction, signs, plane0, plane1;
flat in vec3 across, down;
flat in uvec4 items;
void main() {
    vec2 offset = gl_FragCoord.xy - reference.xy;
    vec3 aside = offset.x * across + offset.y * down;
    vec3 e = base.xyz + base.w * aside, f = direction.xyz + direction.w * aside;
    // Along the ray, from the point nearest to the axis: p + s f.
    float middle = nearest_point(signs.xyz, e, f);
    vec3 p = e + middle * f;
    vec2 sides = quadratic_roots(signs.xyz, 0.0, signs.w, p, f);
    float at0 = dot(plane0.xyz, p) + plane0.w, along0 = dot(plane0.xyz, f);
    float at1 = dot(plane1.xyz, p) + plane1.w, along1 = dot(plane1.xyz, f);
    float cap0 = -at0 / along0, cap1 = -at1 / along1;
    vec3 on0 = p + cap0 * f, on1 = p + cap1 * f;
    float least = (nearest_depth - reference.z) / reference.w - middle;

    float nearest = none;
    uint found = 0u;
    vec2 in0 = at0 + sides * along0, in1 = at1 + sides * along1;
    if (sides.y > least && sides.y < nearest && in0.y <= 0.0 && in1.y <= 0.0 && items.x != 0u) {
        nearest = sides.y;
        found = items.x;
    }
    if (sides.x > least && sides.x < nearest && in0.x <= 0.0 && in1.x <= 0.0 && items.x != 0u) {
        nearest = sides.x;
        found = items.x;
    }
    if (cap0 > least && cap0 < nearest && items.y != 0u &&
        dot(signs.xyz * on0, on0) + signs.w <= 0.0 &&
        ((items.w & 1u) == 0u || at1 + cap0 * along1 <= 0.0)) {
        nearest = cap0;
        found = items.y;
    }
    if (cap1 > least && cap1 < nearest && items.z != 0u &&
        dot(signs.xyz * on1, on1) + signs.w <= 0.0 &&
        ((items.w & 2u) == 0u || at0 + cap1 * along0 <= 0.0)) {
        nearest = cap1;
        found = items.z;
    }
    if (found == 0u) discard;
    put(found, reference.z + (middle + nearest) * reference.w);
})";

/// A pixel's ray in the local frame of a record (see LocalFrame).
inline constexpr const char* local_ray = R"(
flat in uint record;
uniform vec3 across, down;
struct Ray {
    vec3 base, direction;
    float depth, size;  // depth where s = 0, and for a step of s
    float least;        // s of what is just in front of the eye
};
Ray local_ray() {
    vec4 place = floats(record), base = floats(record + 1u), direction = floats(record + 2u);
    vec2 offset = gl_FragCoord.xy - place.xy;
    vec3 aside = offset.x * across + offset.y * down;
    return Ray(base.xyz + base.w * aside, direction.xyz + direction.w * aside, place.z, place.w,
               (nearest_depth - place.z) / place.w);
}
)";

inline constexpr const char* unknown_fragment = R"(
void main() {
    Ray ray = local_ray();
    vec3 low = floats(record + 3u).xyz, high = floats(record + 4u).xyz;
    float first = ray.least, last = none;
    for (int i = 0; i < 3; ++i) {
        float along = ray.direction[i];
        if (along == 0.0) {
            if (ray.base[i] < low[i] || ray.base[i] > high[i]) last = -none;
        } else {
            float a = (low[i] - ray.base[i]) / along, b = (high[i] - ray.base[i]) / along;
            first = max(first, min(a, b));
            last = min(last, max(a, b));
        }
    }
    if (!(first <= last)) discard;
    put(unknown, ray.depth + first * ray.size);
})";

/// Roots of quadratic solids along rays. See CanonicalSolid. They are sought from the ray's point
/// nearest to the centre, or axis, so that the discriminant is no difference of large numbers.
inline constexpr const char* quadratic = R"(
// Of the ray e + s f: s.
float nearest_point(vec3 signs, vec3 e, vec3 f) {
    vec3 curved = abs(signs);
    float ff = dot(curved * f, f);
    return ff > 0.0 ? -dot(curved * e, f) / ff : 0.0;
}
// Both roots along p + s f, in order; `none`, or not a number, where there are none.
vec2 quadratic_roots(vec3 signs, float slope, float constant, vec3 p, vec3 f) {
    float a = dot(signs * f, f), b = dot(signs * f, p) + 0.5 * slope * f.z,
          c = dot(signs * p, p) + slope * p.z + constant;
    float square = b * b - a * c;
    float q = -(b + (b < 0.0 ? -1.0 : 1.0) * sqrt(max(square, 0.0)));
    vec2 roots = vec2(q / a, c / q);
    return square >= 0.0 ? vec2(min(roots.x, roots.y), max(roots.x, roots.y)) : vec2(none);
}
)";

/// Roots of all solids.
inline constexpr const char* solids = R"(
const uint torus_code = 0xffffffffu;
struct Solid {
    vec4 x, y, z;
    uint code;
    float slope, constant;
};
Solid solid_at(uint texel) {
    uvec4 form = bits(texel + 3u);
    return Solid(floats(texel), floats(texel + 1u), floats(texel + 2u), form.x,
                 uintBitsToFloat(form.y), uintBitsToFloat(form.z));
}
vec3 linear_part(Solid solid, vec3 q) {
    return vec3(dot(solid.x.xyz, q), dot(solid.y.xyz, q), dot(solid.z.xyz, q));
}
vec3 offset_of(Solid solid) { return vec3(solid.x.w, solid.y.w, solid.z.w); }
vec3 signs_of(uint code) {
    return vec3(ivec3(code & 3u, (code >> 2) & 3u, (code >> 4) & 3u)) - 1.0;
}

vec2 quadratic_roots(Solid solid, vec3 e, vec3 f) {
    vec3 signs = signs_of(solid.code);
    float middle = nearest_point(signs, e, f);
    vec2 roots = quadratic_roots(signs, solid.slope, solid.constant, e + middle * f, f);
    return vec2(roots.x < none ? roots.x + middle : none, roots.y < none ? roots.y + middle : none);
}
)";

/// `roots_of` where an object has no tori, and the value of a solid with the rounding it may have.
inline constexpr const char* without_tori = R"(
const int most_roots = 2;
vec4 roots_of(Solid solid, vec3 e, vec3 f) { return vec4(quadratic_roots(solid, e, f), none, none); }
float torus_value(Solid solid, vec3 p) { return none; }
)";

//  Along a ray, the quartic of the torus
//
//      (|p|^2 + 1 - r^2)^2 - 4 (x^2 + z^2)
//
//  has at most three extrema, the roots of a cubic; between them lies one root or none. Roots are
//  then found by the sign of the distance from the circle, which keeps its precision where the
//  quartic itself is a small difference of large numbers (thin rings).
inline constexpr const char* with_tori = R"(
const int most_roots = 4;
float torus_value(Solid solid, vec3 p) {
    float aside = length(p.xz) - 1.0;
    return aside * aside + p.y * p.y - solid.constant * solid.constant;
}

// Real roots of t^3 + a t + b, ascending; one alone three times.
vec3 depressed_cubic_roots(float a, float b) {
    float square = 0.25 * b * b + a * a * a / 27.0;
    vec3 t;
    if (square > 0.0) {
        float u = -0.5 * b - (b < 0.0 ? -1.0 : 1.0) * sqrt(square);
        float v = sign(u) * pow(abs(u), 1.0 / 3.0);
        t = vec3(v == 0.0 ? 0.0 : v - a / (3.0 * v));
    } else {
        float r = sqrt(max(-a / 3.0, 0.0));
        float angle = acos(clamp(r > 0.0 ? -0.5 * b / (r * r * r) : 0.0, -1.0, 1.0)) / 3.0;
        t = 2.0 * r * cos(angle + vec3(2.0943951, -2.0943951, 0.0));
    }
    // Functions of the shader's own are not exact enough.
    for (int i = 0; i < 2; ++i) {
        vec3 slope = 3.0 * t * t + a, step = (t * (t * t + a) + b) / slope;
        t -= vec3(abs(slope.x) > 1e-6 ? step.x : 0.0, abs(slope.y) > 1e-6 ? step.y : 0.0,
                  abs(slope.z) > 1e-6 ? step.z : 0.0);
    }
    float low = min(t.x, min(t.y, t.z)), high = max(t.x, max(t.y, t.z));
    return vec3(low, t.x + t.y + t.z - low - high, high);
}

float root_between(Solid solid, vec3 p, vec3 d, float from, float to) {
    float at_from = torus_value(solid, p + from * d), at_to = torus_value(solid, p + to * d);
    if ((at_from < 0.0) == (at_to < 0.0)) return none;
    // The secant, with the weight of an end halved that stays twice (the Illinois method).
    int stayed = 0;
    for (int i = 0; i < 16 && to - from > 1e-6; ++i) {
        float t = from + clamp(at_from / (at_from - at_to), 0.002, 0.998) * (to - from);
        float at = torus_value(solid, p + t * d);
        if ((at < 0.0) == (at_from < 0.0)) {
            from = t;
            at_from = at;
            if (stayed == 1) at_to *= 0.5;
            stayed = 1;
        } else {
            to = t;
            at_to = at;
            if (stayed == 2) at_from *= 0.5;
            stayed = 2;
        }
        if (abs(at) < 1e-7 * abs(solid.constant)) return t;
    }
    return from + clamp(at_from / (at_from - at_to), 0.0, 1.0) * (to - from);
}

vec4 torus_roots(Solid solid, vec3 e, vec3 f) {
    float per_step = length(f), r = solid.constant;
    vec3 d = f / per_step;
    float middle = -dot(e, d);
    vec3 p = e + middle * d;
    float shift = dot(p, d);
    p -= shift * d;
    middle -= shift;
    float pp = dot(p, p), reach = (1.0 + r) * (1.0 + r) * 1.00001 - pp;
    if (!(reach > 0.0)) return vec4(none);
    float far = sqrt(reach);
    vec3 extrema = clamp(depressed_cubic_roots(pp + 1.0 - r * r - 2.0 * (d.x * d.x + d.z * d.z),
                                               -2.0 * (p.x * d.x + p.z * d.z)), -far, far);
    vec4 t = vec4(root_between(solid, p, d, -far, extrema.x),
                  root_between(solid, p, d, extrema.x, extrema.y),
                  root_between(solid, p, d, extrema.y, extrema.z),
                  root_between(solid, p, d, extrema.z, far));
    return vec4(t.x < none ? (middle + t.x) / per_step : none,
                t.y < none ? (middle + t.y) / per_step : none,
                t.z < none ? (middle + t.z) / per_step : none,
                t.w < none ? (middle + t.w) / per_step : none);
}

vec4 roots_of(Solid solid, vec3 e, vec3 f) {
    if (solid.code == torus_code) return torus_roots(solid, e, f);
    return vec4(quadratic_roots(solid, e, f), none, none);
}
)";

inline constexpr const char* no_conditions = R"(
bool holds(uint test, vec3 q, float size, out bool doubtful) { doubtful = false; return true; }
)";

/// Conditions, as ConditionTest. Where a point lies on the boundary of a solid that is asked about,
/// as far as floats can tell, the condition holds, if it may, and is doubtful. `size` is that of
/// the numbers that q comes from.
inline constexpr const char* conditions = R"(
const uint test_holds = 0xffffffffu, test_fails = 0xfffffffeu;
const float rounding = 1e-6;
float one_norm(vec3 v) { return abs(v.x) + abs(v.y) + abs(v.z); }
bool holds(uint test, vec3 q, float size, out bool doubtful) {
    doubtful = false;
    while (test < test_fails) {
        uvec4 step = bits(test);
        Solid solid = solid_at(step.x);
        vec3 p = linear_part(solid, q) + offset_of(solid);
        // What p may be off by, in units of `rounding`.
        vec3 reach = size * vec3(one_norm(solid.x.xyz), one_norm(solid.y.xyz),
                                 one_norm(solid.z.xyz)) + abs(offset_of(solid));
        float value, slack;
        if (solid.code == torus_code) {
            value = torus_value(solid, p);
            slack = 2.0 * abs(solid.constant) * max(reach.x, max(reach.y, reach.z));
        } else {
            vec3 signs = signs_of(solid.code);
            value = dot(signs * p, p) + solid.slope * p.z + solid.constant;
            slack = 2.0 * dot(abs(signs * p), reach) + solid.slope * reach.z;
        }
        slack *= rounding;
        doubtful = doubtful || abs(value) <= slack;
        test = value <= (step.y == 0u ? slack : -slack) ? step.z : step.w;
    }
    return test == test_holds;
}
)";

/// Software renderers do not branch around what no pixel of a group needs, but they leave loops: so
/// pixels first look for the next root of any piece, then test it together.
inline constexpr const char* object_fragment = R"(
float first_root(vec4 roots, float after, float before) {
    float first = none;
    for (int i = 0; i < most_roots; ++i)
        if (roots[i] > after && roots[i] < before) first = min(first, roots[i]);
    return first;
}
void main() {
    Ray ray = local_ray();
    uvec2 pieces = bits(record + 3u).xy;
    uint next = pieces.x, end = pieces.x + pieces.y, found = 0u, tests = 0u;
    float nearest = none, s = none;
    vec4 roots = vec4(none);
    while (true) {
        while (s == none && next < end) {
            uvec4 piece = bits(next++);
            tests = piece.w;
            Solid solid = solid_at(piece.z);
            roots = roots_of(solid, linear_part(solid, ray.base) + offset_of(solid),
                             linear_part(solid, ray.direction));
            s = first_root(roots, ray.least, nearest);
        }
        if (s == none) break;
        vec3 along = s * ray.direction, size = abs(ray.base) + abs(along);
        bool doubtful;
        if (holds(tests, ray.base + along, max(size.x, max(size.y, size.z)), doubtful)) {
            nearest = s;
            found = doubtful ? unknown : next - 1u;
            s = none;
        } else {
            s = first_root(roots, s, nearest);
        }
    }
    if (nearest == none) discard;
    put(found, ray.depth + nearest * ray.size);
})";

}  // namespace povpreview::items::shaders
