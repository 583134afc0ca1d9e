// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "display/atomic_file.h"

namespace povpreview {
namespace {

constexpr double recognisable = .05, good_enough = .005;  // L1

std::string columns(const ImageErrors& e) {
    return fmt::format("{:.8g},{:.8g},{:.5g},{:.6g},{:.6g},{:.8g}", e.l1, e.rmse, e.psnr, e.ssim,
                       e.flip, e.edge_l1);
}

/// A name as a field: quoted where it would break the line.
std::string field(const std::string& name) {
    if (name.find_first_of(",\"\n") == std::string::npos) return name;
    std::string quoted = "\"";
    for (const char c : name) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + '"';
}

double interpolate(const Axis& axis, const Measure& measure, const CurvePoint& before,
                   const CurvePoint& after, double level) {
    const double e0 = std::log(std::max(measure.of(before), least_error));
    const double e1 = std::log(std::max(measure.of(after), least_error));
    const double x0 = std::log(axis.of(before)), x1 = std::log(axis.of(after));
    const double share = e0 > e1 ? (e0 - std::log(level)) / (e0 - e1) : 1;
    return std::exp(x0 + share * (x1 - x0));
}

}  // namespace

void write_curves(const std::vector<CurvePoint>& curves, const std::filesystem::path& file) {
    std::string text =
        "scene,method,repeat,moment,time_s,launch_s,full,probe,albedo,full_s,probe_s,albedo_s,"
        "memory_mb,l1,rmse,psnr,ssim,flip,edge_l1,"
        "aa_l1,aa_rmse,aa_psnr,aa_ssim,aa_flip,aa_edge_l1\n";
    for (const CurvePoint& point : curves) {
        const Standing& p = point.standing;
        text +=
            fmt::format("{},{},{},{},{:.6f},{:.6f},{},{},{},{:.7g},{:.7g},{:.7g},{:.6g},{},{}\n",
                        field(point.scene), point.method, point.repeat, point.moment, p.time_s,
                        p.launch_s, p.full, p.probe, p.albedo, p.cost_s[0], p.cost_s[1],
                        p.cost_s[2], point.memory_mb, columns(point.plain), columns(point.smooth));
    }
    write_text(file, text);
}

const std::vector<Measure>& measures() {
    static const std::vector<Measure> all{
        {"l1", "L1", [](const CurvePoint& p) { return p.plain.l1; }, {.1, .05, .02, .01, .005}},
        {"rmse", "RMSE", [](const CurvePoint& p) { return p.plain.rmse; }, {.1, .05, .02}},
        {"flip", "FLIP", [](const CurvePoint& p) { return p.plain.flip; }, {.2, .1, .05, .02}},
        {"edge_l1",
         "L1 near edges",
         [](const CurvePoint& p) { return p.plain.edge_l1; },
         {.1, .05, .02}},
        {"aa_l1",
         "L1, anti-aliased",
         [](const CurvePoint& p) { return p.smooth.l1; },
         {.05, .02, .01}},
        {"aa_flip",
         "FLIP, anti-aliased",
         [](const CurvePoint& p) { return p.smooth.flip; },
         {.1, .05}},
    };
    return all;
}

const std::vector<Axis>& axes() {
    static const std::vector<Axis> all{
        {"time_s", "seconds since the parse",
         [](const CurvePoint& p) { return p.standing.time_s; }},
        {"launch_s", "seconds since launch",
         [](const CurvePoint& p) { return p.standing.launch_s; }},
        {"rays", "rays of all kinds", [](const CurvePoint& p) { return double(p.rays()); }},
    };
    return all;
}

std::optional<double> crossing(const std::vector<const CurvePoint*>& curve, const Axis& axis,
                               const Measure& measure, double level) {
    const CurvePoint *above = nullptr, *reached = nullptr;
    for (const CurvePoint* point : curve) {
        if (axis.of(*point) <= 0) continue;
        if (measure.of(*point) > level) {
            above = point;
            reached = nullptr;
        } else if (!reached) {
            reached = point;
        }
    }
    if (!reached) return {};
    return above ? interpolate(axis, measure, *above, *reached, level) : axis.of(*reached);
}

std::vector<const CurvePoint*> run_of(const std::vector<CurvePoint>& curves,
                                      const std::string& scene, const std::string& method,
                                      int repeat) {
    std::vector<const CurvePoint*> run;
    for (const CurvePoint& point : curves)
        if (point.scene == scene && point.method == method && point.repeat == repeat)
            run.push_back(&point);
    return run;
}

std::vector<int> telling_moments(const std::vector<const CurvePoint*>& method, int count) {
    std::vector<int> moments;
    if (method.empty()) return moments;
    const auto reaches = [&](double level) {
        for (const CurvePoint* point : method)
            if (point->plain.l1 <= level) return point->moment;
        return method.back()->moment;
    };
    const int first = reaches(recognisable), last = reaches(good_enough);
    for (int i = 0; i < count; ++i) {
        const int moment = first + (last - first) * i / (count - 1);
        if (moments.empty() || moments.back() != moment) moments.push_back(moment);
    }
    return moments;
}

}  // namespace povpreview
