// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <fstream>

#include "core/previewer.h"

namespace povpreview {

/// How far a run has come; one line of the log, one row of a curve.
struct Standing {
    double time_s = 0;                            ///< since the end of the parse
    double launch_s = 0;                          ///< since the program was started
    std::size_t full = 0, probe = 0, albedo = 0;  ///< rays answered
    /// What they cost the tracer, by RayKind: seconds of one thread.
    std::array<double, 3> cost_s{};
    double busy = 0;  ///< share of the time since the parse that the tracer had work
    Statistics statistics;
};

/// Writes progress as JSON lines, each at once to the file, so that nothing is lost.
class ProgressLog {
   public:
    /// Throws Error(Exit::usage) if the file cannot be written.
    explicit ProgressLog(const std::filesystem::path& file);
    /// Throws Error(Exit::usage) if the disk is full.
    void write(const Standing& standing);
    /// An event worth keeping, such as a fault of the tracer that was mended.
    void write_event(double time_s, const std::string& text);
    /// What is done for the scene and what is left out.
    void write_plan(double time_s, const std::vector<Stage>& stages);

   private:
    void put(const std::string& line);
    std::filesystem::path file_;
    std::ofstream stream_;
};

}  // namespace povpreview
