// SPDX-License-Identifier: AGPL-3.0-or-later
#include "backend/oracle/field_forms.h"

#include <cmath>

// The order of POV-Ray's headers matters: frame.h first, povdebug.h last.
// clang-format off
#include "backend/frame.h"
#include "backend/scene/objects.h"
#include "backend/lighting/point.h"
#include "backend/shape/blob.h"
#include "backend/shape/super.h"
// clang-format on

#include "backend/oracle/form_builder.h"
#include "base/povdebug.h"

namespace povpreview::tracer {

namespace {

/// Components of one blob; each ray looks at all of them.
constexpr int max_components = 1000;

/// The shapes of a blob's components, as core/detail/drawable_scene.h numbers them.
enum Shape { ball, half_ball, cylinder };

/// Appends a component: from the blob's space to where its radius is 1, a cylinder's length too.
void add_component(const pov::Blob_Element& element, std::vector<double>& numbers) {
    LocalFrame frame = own_frame(element.Trans);
    const double radius = std::sqrt(element.rad2);
    Shape shape = ball;
    switch (element.Type) {
        case BLOB_BASE_HEMISPHERE:
            shape = half_ball;
            frame.row[2] = scaled(frame.row[2], -1);
            break;
        case BLOB_APEX_HEMISPHERE:
            shape = half_ball;
            frame.row[2] = shifted(frame.row[2], -element.len);
            break;
        case BLOB_CYLINDER:
            shape = cylinder;
            break;
        default:
            for (std::size_t i = 0; i < 3; ++i) frame.row[i] = shifted(frame.row[i], -element.O[i]);
    }
    for (std::size_t i = 0; i < 3; ++i)
        frame.row[i] =
            scaled(frame.row[i], 1 / (shape == cylinder && i == 2 ? element.len : radius));
    for (std::size_t column = 0; column < 4; ++column)
        for (const Row& row : frame.row) numbers.push_back(row[column]);
    numbers.insert(numbers.end(), {element.c[2], static_cast<double>(shape)});
}

}  // namespace

const char* add(const pov::Superellipsoid& ellipsoid, Builder& build) {
    if (!(ellipsoid.Power[pov::X] >= 1 && ellipsoid.Power[pov::Z] >= 1)) return "with dents";
    const std::uint32_t solid = build.solid(SolidKind::superellipsoid, own_frame(ellipsoid.Trans),
                                            {ellipsoid.Power[pov::X], ellipsoid.Power[pov::Z]});
    build.side(solid, {}, Condition::everywhere());
    build.inside(Condition::inside(solid), ellipsoid);
    return nullptr;
}

const char* add(const pov::Blob& blob, Builder& build) {
    if (blob.Data->Number_Of_Components > max_components) return "too many components";
    std::vector<double> numbers{blob.Data->Threshold};
    for (const pov::Blob_Element& element : blob.Data->Entry) add_component(element, numbers);
    const std::uint32_t solid =
        build.solid(SolidKind::blob, own_frame(blob.Trans), std::move(numbers));
    build.side(solid, {}, Condition::everywhere());
    build.inside(Condition::inside(solid), blob);
    return nullptr;
}

}  // namespace povpreview::tracer
