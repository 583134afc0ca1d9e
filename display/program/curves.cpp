// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/curves.h"

#include <fmt/format.h>

#include <cmath>

#include "display/atomic_file.h"

namespace povpreview {
namespace {

constexpr double levels[] = {.1, .05, .02, .01, .005};

/// Errors below what any display shows count as this, so that logarithms stay finite.
constexpr double least_error = 1e-6;

double interpolate(const CurvePoint& before, const CurvePoint& after, double level) {
    const double e0 = std::log(std::max(before.l1, least_error));
    const double e1 = std::log(std::max(after.l1, least_error));
    const double t0 = std::log(before.standing.time_s), t1 = std::log(after.standing.time_s);
    const double share = e0 > e1 ? (e0 - std::log(level)) / (e0 - e1) : 1;
    return std::exp(t0 + share * (t1 - t0));
}

}  // namespace

void write_curves(const std::vector<CurvePoint>& curves, const std::filesystem::path& file) {
    std::string text = "method,time_s,launch_s,full,probe,albedo,l1,rmse\n";
    for (const CurvePoint& point : curves) {
        const Standing& p = point.standing;
        text += fmt::format("{},{:.4f},{:.4f},{},{},{},{:.7f},{:.7f}\n", point.method, p.time_s,
                            p.launch_s, p.full, p.probe, p.albedo, point.l1, point.rmse);
    }
    write_text(file, text);
}

std::optional<double> time_to_error(const std::vector<CurvePoint>& curves,
                                    const std::string& method, double level) {
    const CurvePoint *above = nullptr, *reached = nullptr;
    for (const CurvePoint& point : curves) {
        if (point.method != method) continue;
        if (point.l1 > level) {
            above = &point;
            reached = nullptr;
        } else if (!reached) {
            reached = &point;
        }
    }
    if (!reached) return {};
    return above ? interpolate(*above, *reached, level) : reached->standing.time_s;
}

std::string time_to_error_table(const std::vector<CurvePoint>& curves,
                                const std::vector<std::string>& methods) {
    std::string text = fmt::format("{:<10}", "L1 error");
    for (const std::string& method : methods) text += fmt::format("{:>18}", method);
    for (const double level : levels) {
        text += fmt::format("\n{:<10}", level);
        const auto first = time_to_error(curves, methods.front(), level);
        for (const std::string& method : methods) {
            const auto time = time_to_error(curves, method, level);
            if (!time)
                text += fmt::format("{:>18}", "-");
            else if (!first || method == methods.front())
                text += fmt::format("{:>16.3f} s", *time);
            else
                text +=
                    fmt::format("{:>18}", fmt::format("{:.3f} s {:>6.2f}x", *time, *time / *first));
        }
    }
    return text + '\n';
}

}  // namespace povpreview
