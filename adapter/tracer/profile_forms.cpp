// SPDX-License-Identifier: AGPL-3.0-or-later
#include "backend/oracle/profile_forms.h"

#include <algorithm>
#include <cmath>

// The order of POV-Ray's headers matters: frame.h first, povdebug.h last.
// clang-format off
#include "backend/frame.h"
#include "backend/bounding/bcyl.h"
#include "backend/scene/objects.h"
#include "backend/shape/lathe.h"
#include "backend/shape/prism.h"
#include "backend/shape/sor.h"
#include "backend/shape/truetype.h"
// clang-format on

#include "backend/oracle/form_builder.h"
#include "backend/oracle/prism_parts.h"
#include "base/povdebug.h"

namespace povpreview::tracer {

namespace {

/// What POV-Ray calls the parts of a surface of revolution, and the least squared radius of ends
/// that it shows (sor.cpp).
constexpr int base_of_sor = 1, cap_of_sor = 2, curve_of_sor = 3;
constexpr double least_end = 1e-4;

/// Segments of one outline; each ray looks at all of them.
constexpr std::size_t max_segments = 2000;

struct ControlPoint {
    double u = 0, v = 0;
};
/// Of a cubic Bézier curve.
using Segment = std::array<ControlPoint, 4>;

ControlPoint between(const ControlPoint& a, const ControlPoint& b, double share) {
    return {a.u + share * (b.u - a.u), a.v + share * (b.v - a.v)};
}
Segment line(const ControlPoint& a, const ControlPoint& b) {
    return {a, between(a, b, 1. / 3), between(a, b, 2. / 3), b};
}
Segment parabola(const ControlPoint& a, const ControlPoint& middle, const ControlPoint& b) {
    return {a, between(a, middle, 2. / 3), between(b, middle, 2. / 3), b};
}

/// POV-Ray's A t^3 + B t^2 + C t + D.
template <typename Spline>
Segment cubic(const Spline& s) {
    const auto point = [&s](double a, double b, double c) {
        return ControlPoint{a * s.A[pov::X] + b * s.B[pov::X] + c * s.C[pov::X] + s.D[pov::X],
                            a * s.A[pov::Y] + b * s.B[pov::Y] + c * s.C[pov::Y] + s.D[pov::Y]};
    };
    return {point(0, 0, 0), point(0, 0, 1. / 3), point(0, 1. / 3, 2. / 3), point(1, 1, 1)};
}

/// Those of a prism or lathe. Where one ends and another begins but for rounding, both do so to the
/// bit, so that no ray slips through between them.
template <typename Entry>
std::vector<Segment> segments_of(const Entry* entries, int count) {
    std::vector<Segment> segments;
    double size = 0;
    for (int i = 0; i < count; ++i) {
        segments.push_back(cubic(entries[i]));
        for (const ControlPoint& p : segments.back())
            size = std::max({size, std::fabs(p.u), std::fabs(p.v)});
    }
    const double rounding = 1e-12 * size;
    std::size_t first = 0;  // of a closed curve
    for (std::size_t i = 0; i < segments.size(); ++i) {
        ControlPoint& end = segments[i].back();
        for (const std::size_t next : {i + 1, first}) {
            if (next >= segments.size()) continue;
            const ControlPoint& begin = segments[next].front();
            if (std::fabs(end.u - begin.u) > rounding || std::fabs(end.v - begin.v) > rounding)
                continue;
            end = begin;
            if (next == first) first = i + 1;
            break;
        }
    }
    return segments;
}

std::vector<double> numbers_of(const Segment& segment) {
    std::vector<double> numbers;
    for (const ControlPoint& p : segment) numbers.insert(numbers.end(), {p.u, p.v});
    return numbers;
}
std::vector<double> numbers_of(const std::vector<Segment>& segments) {
    std::vector<double> numbers;
    for (const Segment& segment : segments)
        for (const ControlPoint& p : segment) numbers.insert(numbers.end(), {p.u, p.v});
    return numbers;
}

/// As POV-Ray walks along it (TrueType::GlyphIntersect): its first point counts as one on the
/// curve.
void add_contour(const std::vector<pov::TrueType::OutlinePoint>& points,
                 std::vector<Segment>& segments) {
    const auto at = [&points](std::size_t i) { return ControlPoint{points[i].x, points[i].y}; };
    ControlPoint from = at(0);
    for (std::size_t i = 1; i < points.size(); ++i) {
        ControlPoint to = at(i);
        if (points[i].on_curve) {
            if (to.u != from.u || to.v != from.v) segments.push_back(line(from, to));
        } else {
            const ControlPoint middle = to;
            const bool last = i + 1 == points.size();
            to = at(last ? 0 : i + 1);
            if (!last && !points[i + 1].on_curve) to = between(middle, to, .5);
            segments.push_back(parabola(from, middle, to));
        }
        from = to;
    }
}

/// Of the height between two, the square of the radius A h^3 + B h^2 + C h + D.
Segment squared_radii(const pov::SOR_SPLINE_ENTRY& s, double low, double high) {
    // The polynomial's polar form at (low, ..., high, ...).
    const auto polar = [&s](double a, double b, double c) {
        return s.A * a * b * c + s.B * (a * b + b * c + c * a) / 3 + s.C * (a + b + c) / 3 + s.D;
    };
    const double third = (high - low) / 3;
    return {ControlPoint{polar(low, low, low), low},
            ControlPoint{polar(low, low, high), low + third},
            ControlPoint{polar(low, high, high), high - third},
            ControlPoint{polar(high, high, high), high}};
}

/// Row 2 is along the axis, here y.
LocalFrame around_y(const LocalFrame& own) { return {{own.row[0], own.row[2], own.row[1]}}; }

}  // namespace

const char* add(const pov::Prism& prism, Builder& build) {
    if (Test_Flag(&prism, DEGENERATE_FLAG)) {
        build.inside(Condition::nowhere(), prism);
        return nullptr;
    }
    if (prism.Number > static_cast<int>(max_segments)) return "too many corners";
    const LocalFrame frame = around_y(own_frame(prism.Trans));
    const bool conic = prism.Sweep_Type == CONIC_SWEEP;
    const SolidKind kind = conic ? SolidKind::conic_prism : SolidKind::prism;
    const std::vector<Segment> segments = segments_of(prism.Spline->Entry, prism.Number);
    const std::uint32_t outline = build.solid(kind, frame, numbers_of(segments)),
                        cap = build.half_space(shifted(frame.row[2], -prism.Height2)),
                        base = build.half_space(shifted(scaled(frame.row[2], -1), prism.Height1));
    const Condition in_outline = Condition::inside(outline), under_cap = Condition::inside(cap),
                    over_base = Condition::inside(base);
    for (std::size_t i = 0; i < segments.size(); ++i)
        build.side(build.solid(kind, frame, numbers_of(segments[i])),
                   {spline_hit, static_cast<int>(i)}, under_cap & over_base);
    if (Test_Flag(&prism, CLOSED_FLAG)) {
        if (!conic || std::fabs(prism.Height2) > EPSILON) build.side(cap, {cap_hit, 0}, in_outline);
        if (!conic || std::fabs(prism.Height1) > EPSILON)
            build.side(base, {base_hit, 0}, in_outline);
    }
    build.inside(in_outline & under_cap & over_base, prism);
    return nullptr;
}

const char* add(const pov::TrueType& letter, Builder& build) {
    std::vector<Segment> segments;
    for (const auto& contour : letter.Outlines()) add_contour(contour, segments);
    if (segments.empty()) {  // a blank
        build.inside(Condition::nowhere(), letter);
        return nullptr;
    }
    if (segments.size() > max_segments) return "too many corners";
    const LocalFrame frame = own_frame(letter.Trans);
    const std::uint32_t outline = build.solid(SolidKind::prism, frame, numbers_of(segments)),
                        front = build.half_space(scaled(frame.row[2], -1)),
                        back = build.half_space(shifted(frame.row[2], -letter.depth));
    const Condition in_outline = Condition::inside(outline), after = Condition::inside(front),
                    before = Condition::inside(back);
    build.side(outline, {}, after & before);
    build.side(front, {}, in_outline);
    build.side(back, {}, in_outline);
    build.inside(in_outline & after & before, letter);
    return nullptr;
}

const char* add(const pov::Lathe& lathe, Builder& build) {
    if (lathe.Number > static_cast<int>(max_segments)) return "too many corners";
    const std::vector<Segment> segments = segments_of(lathe.Spline->Entry, lathe.Number);
    // What POV-Ray takes for inside of such is not what its surface surrounds.
    if (lathe.Radius1 < -1e-9 * lathe.Radius2) return "a curve that crosses its axis";
    const std::uint32_t solid =
        build.solid(SolidKind::lathe, around_y(own_frame(lathe.Trans)), numbers_of(segments));
    build.side(solid, {}, Condition::everywhere());
    Condition inside = Condition::inside(solid);
    if (lathe.Radius1 > 0) {  // nothing nearer to the axis is inside, even if the curve is open
        LocalFrame hole = around_y(own_frame(lathe.Trans));
        for (std::size_t i = 0; i < 2; ++i) hole.row[i] = scaled(hole.row[i], 1 / lathe.Radius1);
        inside = inside & !Condition::inside(build.solid(SolidKind::cylinder, hole));
    }
    build.inside(inside, lathe);
    return nullptr;
}

const char* add(const pov::Sor& sor, Builder& build) {
    if (sor.Number > static_cast<int>(max_segments)) return "too many corners";
    std::vector<Segment> segments;
    for (int i = 0; i < sor.Number; ++i) {
        const pov::BCYL& bounds = *sor.Spline->BCyl;
        segments.push_back(squared_radii(sor.Spline->Entry[i], bounds.height[bounds.entry[i].h1],
                                         bounds.height[bounds.entry[i].h2]));
        if (i > 0) segments[segments.size() - 2].back() = segments.back().front();
    }
    const LocalFrame frame = around_y(own_frame(sor.Trans));
    const std::uint32_t sides = build.solid(SolidKind::surface_of_revolution, frame,
                                            numbers_of(segments)),
                        cap = build.half_space(shifted(frame.row[2], -sor.Height2)),
                        base = build.half_space(shifted(scaled(frame.row[2], -1), sor.Height1));
    build.side(sides, {curve_of_sor, 0}, Condition::everywhere());
    const auto add_end = [&](std::uint32_t end, int number, double squared_radius) {
        if (!Test_Flag(&sor, CLOSED_FLAG) || !(squared_radius > least_end)) return;
        LocalFrame round = frame;
        for (std::size_t i = 0; i < 2; ++i)
            round.row[i] = scaled(frame.row[i], 1 / std::sqrt(squared_radius));
        build.side(end, {number, 0}, Condition::inside(build.solid(SolidKind::cylinder, round)));
    };
    add_end(base, base_of_sor, sor.Base_Radius_Squared);
    add_end(cap, cap_of_sor, sor.Cap_Radius_Squared);
    build.inside(Condition::inside(sides) & Condition::inside(cap) & Condition::inside(base), sor);
    return nullptr;
}

}  // namespace povpreview::tracer
