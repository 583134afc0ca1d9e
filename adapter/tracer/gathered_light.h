// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <shared_mutex>
#include <unordered_map>

#include "backend/oracle/point.h"
#include "backend/oracle/samples.h"

namespace povpreview::tracer {

/// The light that radiosity has gathered so far for what the eye sees, and from it a guess for
/// places that its cache does not reach: the mean of what faces the same way nearby; the less is
/// there, the more of what is farther around, and in the end of all. Any thread may add to it or
/// read it.
///
/// Light is kept in cells of space, on levels of a quarter of the side each, apart for each of the
/// six directions along the axes; between the middles of cells, and between directions, it is
/// interpolated.
class GatheredLight {
   public:
    /// Light gathered at a place, a surface's normal of length 1 there, and how far away usually is
    /// what it comes from: that of the first decides how large cells are.
    void add(const Point& place, const Point& normal, double distance, const Rgb& light);
    /// Black if there is none yet.
    Rgb guess(const Point& place, const Point& normal) const;

   private:
    struct Cell {
        Rgb sum;
        float weight = 0;

        void add(const Cell& other, float share);
    };
    double cells_per_unit(int level) const;
    Cell around(const Point& place, const Point& normal, int level) const;

    mutable std::shared_mutex mutex_;
    double extent_ = 0;  // side of the cells of the first level; 0: nothing has been added
    Cell all_;
    std::unordered_map<std::uint64_t, Cell> cells_;
};

inline GatheredLight& gathered_light() {
    static GatheredLight light;
    return light;
}

}  // namespace povpreview::tracer
