// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/picture.h"
#include "display/image.h"
#include "display/program/options.h"
#include "display/program/progress_log.h"
#include "display/progress_line.h"

namespace povpreview {

/// The stock povray's own mosaic preview as a method to compare with.
inline constexpr const char* stock_mosaic_name = "stock-mosaic";

/// What a method had at one moment of the schedule; its error is measured after the run.
struct Moment {
    int number = 0;    ///< of GeometricSchedule; the end has the number after the last
    std::string name;  ///< begins the names of its pictures
    Standing standing;
    std::size_t memory = 0;  ///< bytes, most so far: the tracer's and ours; 0 where not known
    Picture picture;
};

struct MethodRun {
    std::vector<Moment> moments;
    bool complete = false;           ///< every pixel shows its own sample
    std::string plan;                ///< plan_table() in the end; empty where a method has none
    std::vector<std::string> notes;  ///< what was known without tracing, what was mended
};

/// What all runs on a scene share.
struct ComparedScene {
    std::string name;
    std::vector<std::string> words;     ///< POV-Ray's
    std::filesystem::path folder;       ///< for pictures and messages
    Image reference, smooth_reference;  ///< display-encoded; without and with anti-aliasing
};

/// Runs one of method_names() from a fresh tracer, or stock_mosaic_name, until it is complete or
/// `options` end it, or an interrupt. Throws Error.
MethodRun run_method(const std::string& method, const ComparedScene& scene,
                     const CompareOptions& options, ProgressLine& line);

}  // namespace povpreview
