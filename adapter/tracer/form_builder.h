// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <utility>
#include <vector>

// The order of POV-Ray's headers matters: frame.h first, povdebug.h last.
// clang-format off
#include "backend/frame.h"
// clang-format on

#include "backend/oracle/closed_forms.h"

/// What the closed forms of all kinds of objects are put together with.
namespace povpreview::tracer {

using Row = std::array<double, 4>;

/// From the world to the object's own space.
inline LocalFrame own_frame(const pov::TRANSFORM* transform) {
    LocalFrame frame;
    for (std::size_t i = 0; i < 3; ++i) {
        if (transform == nullptr) {
            frame.row[i][i] = 1;
            continue;
        }
        for (std::size_t j = 0; j < 4; ++j) frame.row[i][j] = transform->inverse[j][i];
    }
    return frame;
}

inline Row shifted(Row row, double by) {
    row[3] += by;
    return row;
}

inline Row scaled(Row row, double by) {
    for (double& value : row) value *= by;
    return row;
}

/// The half space z <= 0 where z is what the row says; x and y are along it.
inline LocalFrame frame_of_half_space(const Row& z) {
    const Point normal{z[0], z[1], z[2]};
    const Point axis =
        std::fabs(normal.x) <= std::fabs(normal.y) && std::fabs(normal.x) <= std::fabs(normal.z)
            ? Point{1, 0, 0}
        : std::fabs(normal.y) <= std::fabs(normal.z) ? Point{0, 1, 0}
                                                     : Point{0, 0, 1};
    const Point u = cross(normal, axis), v = cross(normal, u);
    const double size = length(normal);
    const auto along = [](const Point& p) {
        const double one = 1 / length(p);
        return Row{one * p.x, one * p.y, one * p.z, 0};
    };
    return {{along(u), along(v), scaled(z, 1 / size)}};
}

/// Makes the solids and sides of one primitive.
class Builder {
   public:
    Builder(std::vector<ClosedSolid>& solids, ClosedForm& form) : solids_(solids), form_(form) {}

    std::uint32_t solid(SolidKind kind, const LocalFrame& frame, std::vector<double> numbers = {}) {
        for (const Row& row : frame.row)
            for (const double value : row) sound_ = sound_ && std::isfinite(value);
        for (const double value : numbers) sound_ = sound_ && std::isfinite(value);
        solids_.push_back({kind, frame, std::move(numbers)});
        return static_cast<std::uint32_t>(solids_.size() - 1);
    }
    std::uint32_t half_space(const Row& z) {
        return solid(SolidKind::half_space, frame_of_half_space(z));
    }
    void side(std::uint32_t solid, FaceNumber number, const Condition& where) {
        form_.sides.push_back({solid, number, where});
    }
    void inside(const Condition& inside) { form_.inside = inside; }
    /// Or the outside, if the object's flag says so.
    void inside(const Condition& inside, const pov::ObjectBase& object) {
        form_.inside = Test_Flag(&object, INVERTED_FLAG) ? !inside : inside;
    }
    bool sound() const { return sound_; }

   private:
    std::vector<ClosedSolid>& solids_;
    ClosedForm& form_;
    bool sound_ = true;
};

}  // namespace povpreview::tracer
