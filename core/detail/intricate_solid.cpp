// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/detail/intricate_solid.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace povpreview {

namespace {

std::span<const double> numbers_of(const DrawableScene& scene, const Solid& solid) {
    return std::span(scene.numbers).subspan(solid.first_number, solid.numbers);
}

}  // namespace

bool is_intricate(Solid::Kind kind) {
    switch (kind) {
        case Solid::Kind::superellipsoid:
        case Solid::Kind::prism:
        case Solid::Kind::conic_prism:
        case Solid::Kind::lathe:
        case Solid::Kind::surface_of_revolution:
        case Solid::Kind::blob:
            return true;
        default:
            return false;
    }
}

bool is_sound(const DrawableScene& scene, const Solid& solid) {
    if (std::size_t{solid.first_number} + solid.numbers > scene.numbers.size()) return false;
    const std::span<const double> numbers = numbers_of(scene, solid);
    if (!std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); }))
        return false;
    switch (solid.kind) {
        case Solid::Kind::superellipsoid:
            // Below 1 it would have dents.
            return solid.coefficients[0] >= 1 && solid.coefficients[1] >= 1;
        case Solid::Kind::prism:
        case Solid::Kind::conic_prism:
        case Solid::Kind::lathe:
        case Solid::Kind::surface_of_revolution:
            return !numbers.empty() && numbers.size() % outline_numbers_a_segment == 0;
        case Solid::Kind::blob:
            return numbers.size() % blob_numbers_a_component == 1;
        default:
            return false;
    }
}

std::unique_ptr<IntricateSolid> prepared(const DrawableScene& scene, const Solid& solid) {
    const std::span<const double> numbers = numbers_of(scene, solid);
    switch (solid.kind) {
        case Solid::Kind::prism:
            return prepared_prism(numbers, false);
        case Solid::Kind::conic_prism:
            return prepared_prism(numbers, true);
        case Solid::Kind::lathe:
            return prepared_lathe(numbers, false);
        case Solid::Kind::surface_of_revolution:
            return prepared_lathe(numbers, true);
        case Solid::Kind::blob:
            return prepared_blob(numbers);
        default:
            return prepared_superellipsoid(solid.coefficients[0], solid.coefficients[1]);
    }
}

}  // namespace povpreview
