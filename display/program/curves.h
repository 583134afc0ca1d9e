// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/error_meter.h"
#include "display/program/progress_log.h"

namespace povpreview {

/// One point of a method's error curve.
struct CurvePoint {
    std::string scene, method;
    int repeat = 1;  ///< which run of this method on this scene, from 1
    int moment = 0;  ///< of GeometricSchedule; the end has the number after the last one
    Standing standing;
    double memory_mb = 0;  ///< most so far, tracer and preview; 0 where it is not known
    ImageErrors plain;     ///< against the reference without anti-aliasing
    ImageErrors smooth;    ///< smoothed, against the one with it
    std::string picture;   ///< its file in the scene's folder; empty if it was not written

    std::size_t rays() const { return standing.full + standing.probe + standing.albedo; }
};

/// Writes all columns of all points, all or nothing; the first line names them. Throws Error.
void write_curves(const std::vector<CurvePoint>& curves, const std::filesystem::path& file);

/// An error measure for which less is better, and levels of it that are worth reaching.
struct Measure {
    const char* name;  ///< its column
    const char* title;
    double (*of)(const CurvePoint&);
    std::vector<double> levels;  ///< falling
};
const std::vector<Measure>& measures();

/// What errors fall over.
struct Axis {
    const char* name;  ///< its column, or "rays" for the sum of full, probe and albedo
    const char* title;
    double (*of)(const CurvePoint&);
};
const std::vector<Axis>& axes();

/// Errors below what any display shows count as this, so that logarithms stay finite.
inline constexpr double least_error = 1e-6;

/// Where on the axis the error comes to stay at or below `level`, interpolated between the points
/// of the curve on logarithmic axes; nothing if it never does. `curve` is one run, in order.
std::optional<double> crossing(const std::vector<const CurvePoint*>& curve, const Axis& axis,
                               const Measure& measure, double level);

/// The points of one run.
std::vector<const CurvePoint*> run_of(const std::vector<CurvePoint>& curves,
                                      const std::string& scene, const std::string& method,
                                      int repeat);

/// At most `count` moments of the schedule to show a comparison by: evenly spaced from the method's
/// first picture on which something can be made out (L1 .05) to the one that can hardly be told
/// from the finished one (L1 .005), or its last.
std::vector<int> telling_moments(const std::vector<const CurvePoint*>& method, int count);

}  // namespace povpreview
