// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "display/program/progress_log.h"

namespace povpreview {

/// One point of a method's error curve.
struct CurvePoint {
    std::string method;
    Standing standing;
    double l1 = 0, rmse = 0;  ///< of display-encoded colour in [0, 1]
};

/// Writes `method,time_s,launch_s,full,probe,albedo,l1,rmse`, all or nothing. Throws Error.
void write_curves(const std::vector<CurvePoint>& curves, const std::filesystem::path& file);

/// The time from which on the method's L1 error stays at or below `level`, interpolated between its
/// points on logarithmic axes; nothing if it never does.
std::optional<double> time_to_error(const std::vector<CurvePoint>& curves,
                                    const std::string& method, double level);

/// Time of each method to each of five errors, and its ratio to the first method's; a text table.
std::string time_to_error_table(const std::vector<CurvePoint>& curves,
                                const std::vector<std::string>& methods);

}  // namespace povpreview
