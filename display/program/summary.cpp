// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "display/program/json_text.h"

namespace povpreview {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// The runs of each method on one scene.
using Runs = std::vector<std::vector<const CurvePoint*>>;

Runs runs_of(const std::vector<CurvePoint>& curves, const std::string& scene,
             const std::string& method) {
    int repeats = 0;
    for (const CurvePoint& point : curves)
        if (point.scene == scene && point.method == method)
            repeats = std::max(repeats, point.repeat);
    Runs runs;
    for (int repeat = 1; repeat <= repeats; ++repeat) {
        auto run = run_of(curves, scene, method, repeat);
        if (!run.empty()) runs.push_back(std::move(run));
    }
    return runs;
}

Reached when_reached(const Runs& runs, const Axis& axis, const Measure& measure, double level) {
    Reached result{.scene = {}, .method = {}, .measure = &measure, .axis = &axis, .level = level};
    std::vector<double> values;
    for (const auto& run : runs) {
        const auto at = crossing(run, axis, measure, level);
        values.push_back(at.value_or(never));
        ++result.repeats;
        if (!at) continue;
        ++result.reached;
        result.least = std::min(result.least.value_or(never), *at);
        result.greatest = std::max(result.greatest.value_or(0), *at);
    }
    if (values.empty()) return result;
    const double middle = median(values);
    if (std::isfinite(middle)) result.median = middle;
    return result;
}

void add_scene(Summary& summary, const std::vector<CurvePoint>& curves, const std::string& scene,
               const std::vector<std::string>& methods) {
    std::vector<Runs> runs;
    for (const std::string& method : methods) runs.push_back(runs_of(curves, scene, method));
    for (const Measure& measure : measures())
        for (const Axis& axis : axes())
            for (const double level : measure.levels) {
                std::optional<double> first;
                for (std::size_t m = 0; m < methods.size(); ++m) {
                    Reached reached = when_reached(runs[m], axis, measure, level);
                    reached.scene = scene;
                    reached.method = methods[m];
                    if (m == 0) first = reached.median;
                    if (first && reached.median) reached.ratio = *reached.median / *first;
                    summary.reached.push_back(std::move(reached));
                }
            }
}

void add_totals(Summary& summary, const std::vector<CurvePoint>& curves, const std::string& scene,
                const std::string& method) {
    const Runs runs = runs_of(curves, scene, method);
    if (runs.empty()) return;
    const auto middle = [&](const auto& of) {
        std::vector<double> values;
        for (const auto& run : runs) values.push_back(of(*run.back()));
        return median(values);
    };
    const auto standing = [&](auto member) {
        return middle([&](const CurvePoint& p) { return double(p.standing.*member); });
    };
    const auto cost = [&](std::size_t kind) {
        return middle([&](const CurvePoint& p) { return p.standing.cost_s[kind]; });
    };
    summary.totals.push_back({.scene = scene,
                              .method = method,
                              .time_s = standing(&Standing::time_s),
                              .launch_s = standing(&Standing::launch_s),
                              .full = standing(&Standing::full),
                              .probe = standing(&Standing::probe),
                              .albedo = standing(&Standing::albedo),
                              .full_s = cost(0),
                              .probe_s = cost(1),
                              .albedo_s = cost(2),
                              .memory_mb = middle([](const CurvePoint& p) { return p.memory_mb; }),
                              .l1 = middle([](const CurvePoint& p) { return p.plain.l1; })});
}

const Reached* find(const Summary& summary, const std::string& scene, const std::string& method,
                    const Measure& measure, const Axis& axis, double level) {
    for (const Reached& r : summary.reached)
        if (r.scene == scene && r.method == method && r.measure == &measure && r.axis == &axis &&
            r.level == level)
            return &r;
    return nullptr;
}

MeanRatio mean_ratio(const Summary& summary, const std::vector<std::string>& scenes,
                     const std::string& first, const std::string& method, const Measure& measure,
                     const Axis& axis, double level) {
    MeanRatio mean{.method = method, .measure = &measure, .axis = &axis, .level = level};
    double sum = 0;
    for (const std::string& scene : scenes) {
        const Reached* ours = find(summary, scene, first, measure, axis, level);
        const Reached* theirs = find(summary, scene, method, measure, axis, level);
        const bool we = ours && ours->median, they = theirs && theirs->median;
        if (!we && !they) continue;
        const double ratio = we && they ? *theirs->median / *ours->median : we ? never : 0;
        if (we && they) {
            ++mean.scenes;
            sum += std::log(ratio);
        }
        ++(ratio > tie ? mean.wins : ratio < 1 / tie ? mean.losses : mean.ties);
    }
    if (mean.scenes > 0) mean.geometric_mean = std::exp(sum / mean.scenes);
    return mean;
}

}  // namespace

double median(std::vector<double> values) {
    assert(!values.empty());
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 ? values[half] : (values[half - 1] + values[half]) / 2;
}

Summary summarise(const std::vector<CurvePoint>& curves, const std::vector<std::string>& scenes,
                  const std::vector<std::string>& methods) {
    Summary summary;
    for (const std::string& scene : scenes) {
        add_scene(summary, curves, scene, methods);
        for (const std::string& method : methods) add_totals(summary, curves, scene, method);
    }
    for (const Measure& measure : measures())
        for (const Axis& axis : axes())
            for (const double level : measure.levels)
                for (std::size_t m = 1; m < methods.size(); ++m)
                    summary.means.push_back(mean_ratio(summary, scenes, methods.front(), methods[m],
                                                       measure, axis, level));
    return summary;
}

std::string json(const Summary& summary, const std::string& about) {
    std::string text = "{\n\"about\": " + about + ",\n\"reached\": [";
    const char* separator = "\n";
    for (const Reached& r : summary.reached) {
        text += fmt::format(
            "{}{{\"scene\": {}, \"method\": {}, \"measure\": \"{}\", \"axis\": \"{}\", \"level\": "
            "{}, "
            "\"repeats\": {}, \"reached\": {}, \"median\": {}, \"least\": {}, \"greatest\": {}, "
            "\"ratio\": {}}}",
            separator, json_string(r.scene), json_string(r.method), r.measure->name, r.axis->name,
            r.level, r.repeats, r.reached, json_number(r.median), json_number(r.least),
            json_number(r.greatest), json_number(r.ratio));
        separator = ",\n";
    }
    text += "\n],\n\"means\": [";
    separator = "\n";
    for (const MeanRatio& m : summary.means) {
        text += fmt::format(
            "{}{{\"method\": {}, \"measure\": \"{}\", \"axis\": \"{}\", \"level\": {}, \"scenes\": "
            "{}, "
            "\"geometric_mean\": {}, \"wins\": {}, \"losses\": {}, \"ties\": {}}}",
            separator, json_string(m.method), m.measure->name, m.axis->name, m.level, m.scenes,
            json_number(m.geometric_mean), m.wins, m.losses, m.ties);
        separator = ",\n";
    }
    text += "\n],\n\"totals\": [";
    separator = "\n";
    for (const Totals& t : summary.totals) {
        text += fmt::format(
            "{}{{\"scene\": {}, \"method\": {}, \"time_s\": {:.6g}, \"launch_s\": {:.6g}, "
            "\"full\": "
            "{:.9g}, \"probe\": {:.9g}, \"albedo\": {:.9g}, \"full_s\": {:.6g}, \"probe_s\": "
            "{:.6g}, "
            "\"albedo_s\": {:.6g}, \"memory_mb\": {:.6g}, \"l1\": {:.6g}}}",
            separator, json_string(t.scene), json_string(t.method), t.time_s, t.launch_s, t.full,
            t.probe, t.albedo, t.full_s, t.probe_s, t.albedo_s, t.memory_mb, t.l1);
        separator = ",\n";
    }
    return text + "\n]\n}\n";
}

std::string text_table(const Summary& summary, const std::vector<std::string>& scenes,
                       const std::vector<std::string>& methods) {
    constexpr std::size_t narrowest = 9;
    const Measure& measure = measures().front();
    const Axis& axis = axes().front();
    std::size_t name_width = std::string("geometric mean").size();
    for (const std::string& scene : scenes) name_width = std::max(name_width, scene.size());
    const auto width = [&](const std::string& method) {
        return std::max(narrowest, method.size());
    };

    std::string text =
        fmt::format("{:<{}} {:>6} {:>11}", "scene", name_width, "L1", methods.front() + " s");
    for (std::size_t m = 1; m < methods.size(); ++m)
        text += fmt::format(" {:>{}}", methods[m], width(methods[m]));
    for (const std::string& scene : scenes)
        for (const double level : measure.levels) {
            const Reached* first = find(summary, scene, methods.front(), measure, axis, level);
            text += fmt::format("\n{:<{}} {:>6}", scene, name_width, level);
            text += first && first->median ? fmt::format(" {:>11.3f}", *first->median)
                                           : fmt::format(" {:>11}", "-");
            for (std::size_t m = 1; m < methods.size(); ++m) {
                const Reached* r = find(summary, scene, methods[m], measure, axis, level);
                const std::string cell = r && r->ratio    ? fmt::format("{:.2f}x", *r->ratio)
                                         : r && r->median ? fmt::format("{:.3f} s", *r->median)
                                                          : "-";
                text += fmt::format(" {:>{}}", cell, width(methods[m]));
            }
        }
    if (scenes.size() < 2) return text + '\n';
    for (const double level : measure.levels) {
        text += fmt::format("\n{:<{}} {:>6} {:>11}", "geometric mean", name_width, level, "");
        for (std::size_t m = 1; m < methods.size(); ++m)
            for (const MeanRatio& mean : summary.means)
                if (mean.method == methods[m] && mean.measure == &measure && mean.axis == &axis &&
                    mean.level == level)
                    text += fmt::format(" {:>{}}",
                                        mean.geometric_mean
                                            ? fmt::format("{:.2f}x", *mean.geometric_mean)
                                            : std::string("-"),
                                        width(methods[m]));
    }
    return text + '\n';
}

}  // namespace povpreview
