// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace povpreview::stability {

/// A family of scenes with one thing that is hard about them, made harder by a parameter.
struct Series {
    const char* family;
    const char* name;
    const char* reason;  ///< what may go wrong here, in a line
    const char* parameter;
    std::vector<double> small;    ///< values in the short run
    std::vector<double> decades;  ///< further values in the full run
    const char* text;             ///< the scene, in which K is the parameter's value
    const char* size = "";        ///< WxH, where it is what is hard
};

/// A series at one value: what is run.
struct Case {
    const Series* series;
    double value;

    std::string name() const;  ///< "scale/whole_scene@1e-06"
    std::string scene() const;
    std::vector<std::string> words(bool full) const;  ///< POV-Ray's size options
};

// By family, each in a file of its own.
std::vector<Series> scale_series();
std::vector<Series> degenerate_series();
std::vector<Series> colour_series();
std::vector<Series> light_series();
std::vector<Series> camera_series();
std::vector<Series> load_series();
std::vector<Series> mirror_series();

const std::vector<Series>& all_series();
/// Those in the short or the full run whose name begins with one of the prefixes (all, if there are
/// none), in the order of families and values.
std::vector<Case> cases(bool full, const std::vector<std::string>& prefixes);

}  // namespace povpreview::stability
