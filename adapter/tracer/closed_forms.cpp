// SPDX-License-Identifier: AGPL-3.0-or-later
#include "backend/oracle/closed_forms.h"

#include <array>
#include <cmath>

// The order of POV-Ray's headers matters: frame.h first, povdebug.h last.
// clang-format off
#include "backend/frame.h"
#include "backend/scene/objects.h"
#include "backend/shape/blob.h"
#include "backend/shape/boxes.h"
#include "backend/shape/cones.h"
#include "backend/shape/discs.h"
#include "backend/shape/lathe.h"
#include "backend/shape/planes.h"
#include "backend/shape/prism.h"
#include "backend/shape/quadrics.h"
#include "backend/shape/sor.h"
#include "backend/shape/spheres.h"
#include "backend/shape/super.h"
#include "backend/shape/torus.h"
#include "backend/shape/truetype.h"
// clang-format on

#include "backend/oracle/field_forms.h"
#include "backend/oracle/form_builder.h"
#include "backend/oracle/profile_forms.h"
#include "base/povdebug.h"

namespace povpreview::tracer {

namespace {

/// What POV-Ray calls the parts of a cone (cones.cpp).
constexpr int base_of_cone = 1, cap_of_cone = 2, side_of_cone = 3;

const char* add(const pov::Sphere& sphere, Builder& build) {
    const double radius = std::fabs(sphere.Radius);
    // POV-Ray does not see smaller ones (its EPSILON).
    if (sphere.Trans == nullptr && radius * radius <= EPSILON) {
        build.inside(Condition::nowhere(), sphere);
        return nullptr;
    }
    LocalFrame frame = own_frame(sphere.Trans);
    for (std::size_t i = 0; i < 3; ++i)
        frame.row[i] = scaled(shifted(frame.row[i], -sphere.Center[i]), 1 / radius);
    const std::uint32_t solid = build.solid(SolidKind::sphere, frame);
    build.side(solid, {}, Condition::everywhere());
    build.inside(Condition::inside(solid), sphere);
    return nullptr;
}

/// In its own space a cone has its apex at the origin and ends at heights dist and 1 above it, with
/// radii as large; a cylinder has radius 1 between heights 0 and 1.
const char* add(const pov::Cone& cone, Builder& build) {
    const bool cylinder = Test_Flag(&cone, CYLINDER_FLAG) != 0;
    const double low = cylinder ? 0 : cone.dist;
    const LocalFrame frame = own_frame(cone.Trans);
    const Row& z = frame.row[2];
    const std::uint32_t side = build.solid(cylinder ? SolidKind::cylinder : SolidKind::cone, frame),
                        cap = build.half_space(shifted(z, -1)),
                        base = build.half_space(shifted(scaled(z, -1), low));
    const Condition in_side = Condition::inside(side), under_cap = Condition::inside(cap),
                    over_base = Condition::inside(base);
    build.side(side, {side_of_cone, 0}, under_cap & over_base);
    if (Test_Flag(&cone, CLOSED_FLAG)) {
        build.side(cap, {cap_of_cone, 0}, in_side);
        if (cylinder || low != 0) build.side(base, {base_of_cone, 0}, in_side);
    }
    build.inside(in_side & under_cap & over_base, cone);
    return nullptr;
}

const char* add(const pov::Torus& torus, Builder& build) {
    // Its surface would have an inner part, which its inside knows nothing of.
    if (!(torus.MinorRadius <= torus.MajorRadius)) return "a torus that meets itself";
    LocalFrame frame = own_frame(torus.Trans);
    for (Row& row : frame.row) row = scaled(row, 1 / torus.MajorRadius);
    const std::uint32_t solid =
        build.solid(SolidKind::torus, frame, {torus.MinorRadius / torus.MajorRadius});
    build.side(solid, {}, Condition::everywhere());
    build.inside(Condition::inside(solid), torus);
    return nullptr;
}

/// POV-Ray keeps the equation in world space; to invert it changes the signs, its flag says
/// nothing.
const char* add(const pov::Quadric& quadric, Builder& build) {
    const auto &s = quadric.Square_Terms, &m = quadric.Mixed_Terms, &t = quadric.Terms;
    const std::uint32_t solid =
        build.solid(SolidKind::quadric, own_frame(nullptr),
                    {s[0], s[1], s[2], m[0], m[1], m[2], t[0], t[1], t[2], quadric.Constant});
    build.side(solid, {}, Condition::everywhere());
    build.inside(Condition::inside(solid));
    return nullptr;
}

/// To invert it POV-Ray changes the signs.
const char* add(const pov::Plane& plane, Builder& build) {
    const auto& n = plane.Normal_Vector;
    const LocalFrame frame = own_frame(plane.Trans);
    Row z{0, 0, 0, plane.Distance};
    for (std::size_t j = 0; j < 4; ++j)
        for (std::size_t i = 0; i < 3; ++i) z[j] += n[i] * frame.row[i][j];
    const std::uint32_t solid = build.half_space(z);
    build.side(solid, {}, Condition::everywhere());
    build.inside(Condition::inside(solid));
    return nullptr;
}

const char* add(const pov::Box& box, Builder& build) {
    const LocalFrame frame = own_frame(box.Trans);
    // In the order of POV-Ray's SIDE_X_0 = 1, SIDE_X_1, SIDE_Y_0 ...
    std::array<std::uint32_t, 6> sides{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Row& row = frame.row[axis];
        sides[2 * axis] = build.half_space(shifted(scaled(row, -1), box.bounds[0][axis]));
        sides[2 * axis + 1] = build.half_space(shifted(row, -box.bounds[1][axis]));
    }
    Condition inside = Condition::everywhere();
    for (std::size_t i = 0; i < 6; ++i) {
        inside = inside & Condition::inside(sides[i]);
        Condition where = Condition::everywhere();
        for (std::size_t j = 0; j < 6; ++j)
            if (j / 2 != i / 2) where = where & Condition::inside(sides[j]);
        build.side(sides[i], {static_cast<int>(i) + 1, 0}, where);
    }
    build.inside(inside, box);
    return nullptr;
}

const char* add(const pov::Disc& disc, Builder& build) {
    LocalFrame frame = own_frame(disc.Trans);
    const std::uint32_t plane = build.half_space(frame.row[2]);
    const auto circle = [&](double squared_radius) {
        LocalFrame scaled_frame = frame;
        for (std::size_t i = 0; i < 2; ++i)
            scaled_frame.row[i] = scaled(frame.row[i], 1 / std::sqrt(squared_radius));
        return Condition::inside(build.solid(SolidKind::cylinder, scaled_frame));
    };
    Condition where = circle(disc.oradius2);
    if (disc.iradius2 > 0) where = where & !circle(disc.iradius2);
    build.side(plane, {}, where);
    build.inside(Condition::inside(plane), disc);
    return nullptr;
}

/// Calls add() for the first of the classes that the object is.
template <typename Class, typename... Others>
const char* add_as(const pov::ObjectBase& object, Builder& build) {
    if (const auto* known = dynamic_cast<const Class*>(&object)) return add(*known, build);
    if constexpr (sizeof...(Others) > 0)
        return add_as<Others...>(object, build);
    else
        return no_closed_form;
}

}  // namespace

const char* closed_form(const pov::ObjectBase& object, std::vector<ClosedSolid>& solids,
                        ClosedForm& form) {
    Builder build(solids, form);
    const char* reason =
        add_as<pov::Sphere, pov::Cone, pov::Box, pov::Plane, pov::Torus, pov::Quadric, pov::Disc,
               pov::TrueType, pov::Prism, pov::Superellipsoid, pov::Blob, pov::Lathe, pov::Sor>(
            object, build);
    if (reason == nullptr && !build.sound()) return "numbers that are not finite";
    return reason;
}

}  // namespace povpreview::tracer
