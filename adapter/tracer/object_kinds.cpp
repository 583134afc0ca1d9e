// SPDX-License-Identifier: AGPL-3.0-or-later
#include "backend/oracle/object_kinds.h"

// The order of POV-Ray's headers matters: frame.h first, povdebug.h last.
// clang-format off
#include "backend/frame.h"
#include "backend/scene/objects.h"
#include "backend/shape/bezier.h"
#include "backend/shape/blob.h"
#include "backend/shape/boxes.h"
#include "backend/shape/cones.h"
#include "backend/shape/csg.h"
#include "backend/shape/discs.h"
#include "backend/shape/fpmetric.h"
#include "backend/shape/fractal.h"
#include "backend/shape/hfield.h"
#include "backend/shape/isosurf.h"
#include "backend/shape/lathe.h"
#include "backend/shape/mesh.h"
#include "backend/shape/ovus.h"
#include "backend/shape/planes.h"
#include "backend/shape/poly.h"
#include "backend/shape/polygon.h"
#include "backend/shape/prism.h"
#include "backend/shape/quadrics.h"
#include "backend/shape/sor.h"
#include "backend/shape/spheres.h"
#include "backend/shape/sphsweep.h"
#include "backend/shape/super.h"
#include "backend/shape/torus.h"
#include "backend/shape/triangle.h"
#include "backend/shape/truetype.h"
// clang-format on

#include "base/povdebug.h"

namespace povpreview::tracer {

namespace {

template <typename Class>
bool is_a(const pov::ObjectBase& object) {
    return dynamic_cast<const Class*>(&object) != nullptr;
}

struct Kind {
    bool (*matches)(const pov::ObjectBase&);
    const char* name;
};

/// Derived classes before those they derive from.
const Kind kinds[] = {
    {is_a<pov::LightSource>, "light_source"},
    {is_a<pov::CSGMerge>, "merge"},
    {is_a<pov::CSGUnion>, "union"},
    {is_a<pov::SmoothTriangle>, "smooth_triangle"},
    {is_a<pov::Triangle>, "triangle"},
    {is_a<pov::Sphere>, "sphere"},
    {is_a<pov::Box>, "box"},
    {is_a<pov::Plane>, "plane"},
    {is_a<pov::Mesh>, "mesh"},
    {is_a<pov::HField>, "height_field"},
    {is_a<pov::BicubicPatch>, "bicubic_patch"},
    {is_a<pov::Blob>, "blob"},
    {is_a<pov::Disc>, "disc"},
    {is_a<pov::Fractal>, "julia_fractal"},
    {is_a<pov::IsoSurface>, "isosurface"},
    {is_a<pov::Lathe>, "lathe"},
    {is_a<pov::Ovus>, "ovus"},
    {is_a<pov::Parametric>, "parametric"},
    {is_a<pov::Poly>, "poly"},
    {is_a<pov::Polygon>, "polygon"},
    {is_a<pov::Prism>, "prism"},
    {is_a<pov::Quadric>, "quadric"},
    {is_a<pov::Sor>, "sor"},
    {is_a<pov::SphereSweep>, "sphere_sweep"},
    {is_a<pov::Superellipsoid>, "superellipsoid"},
    {is_a<pov::Torus>, "torus"},
    {is_a<pov::TrueType>, "text"},
};

}  // namespace

const char* object_kind(const pov::ObjectBase& object) {
    if (is_a<pov::CSGIntersection>(object))
        return (object.Type & CSG_DIFFERENCE_OBJECT) != 0 ? "difference" : "intersection";
    if (is_a<pov::Cone>(object)) return (object.Flags & CYLINDER_FLAG) != 0 ? "cylinder" : "cone";
    for (const Kind& kind : kinds)
        if (kind.matches(object)) return kind.name;
    return "other";
}

}  // namespace povpreview::tracer
