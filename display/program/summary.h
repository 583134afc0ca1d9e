// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "display/program/curves.h"

namespace povpreview {

/// When one method came to one error of one scene.
struct Reached {
    std::string scene, method;
    const Measure* measure;
    const Axis* axis;
    double level;
    int repeats = 0, reached = 0;  ///< runs, and those of them that came to it
    /// Over all runs; nothing where half of them or more never came to it. Then least and greatest
    /// of those that did.
    std::optional<double> median{};
    std::optional<double> least{}, greatest{};
    std::optional<double> ratio{};  ///< median over the first method's
};

/// A method against the first one, over all scenes.
struct MeanRatio {
    std::string method;
    const Measure* measure;
    const Axis* axis;
    double level;
    int scenes = 0;                          ///< where both came to the level
    std::optional<double> geometric_mean{};  ///< of their ratios; above 1: the first method leads
    /// Scenes where the first method was faster by more than a twentieth, or alone came to it;
    /// where it was slower by as much, or did not come to it alone; and the rest of those where one
    /// did.
    int wins = 0, losses = 0, ties = 0;
};

/// A method's last points of one scene, medians over its runs.
struct Totals {
    std::string scene, method;
    double time_s, launch_s, full, probe, albedo, full_s, probe_s, albedo_s, memory_mb, l1;
};

struct Summary {
    std::vector<Reached> reached;
    std::vector<MeanRatio> means;
    std::vector<Totals> totals;
};

/// A ratio is told from 1 when it is off by more than this.
inline constexpr double tie = 1.05;

/// Of the methods in this order; the first is the one that the others are held against.
Summary summarise(const std::vector<CurvePoint>& curves, const std::vector<std::string>& scenes,
                  const std::vector<std::string>& methods);

/// The middle of the values, or the mean of the two in the middle. REQUIRES: there are any.
double median(std::vector<double> values);

/// For machines; every record on a line of its own. `about` is a JSON object.
std::string json(const Summary& summary, const std::string& about);

/// For the terminal: seconds of the first method to each L1 error, and how many times as long the
/// others took; for each scene, then the geometric means.
std::string text_table(const Summary& summary, const std::vector<std::string>& scenes,
                       const std::vector<std::string>& methods);

}  // namespace povpreview
