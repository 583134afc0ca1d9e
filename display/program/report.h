// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "display/program/curves.h"
#include "display/program/machine.h"
#include "display/program/options.h"
#include "display/program/summary.h"

namespace povpreview {

/// What the report shows of a scene beside its numbers. The folder holds the references and the
/// pictures that the curves name.
struct ReportScene {
    std::string name;
    std::filesystem::path folder;
    std::vector<std::pair<std::string, std::string>> plans;  ///< by method, tables as plain text
    std::vector<std::pair<std::string, std::vector<std::string>>> notes;  ///< by method
    std::vector<std::pair<std::string, bool>> complete;                   ///< by method
};

struct ReportContents {
    const CompareOptions& options;
    const std::vector<ReportScene>& scenes;
    const std::vector<std::string>& failures;  ///< a sentence each
    const std::vector<CurvePoint>& curves;
    const Summary& summary;
    const Machine& machine;
};

/// Writes report.html into the folder for results: one file that needs no other. First the summary,
/// wins and losses; then for each scene times, error curves, pictures of all methods at equal times
/// with crops and error maps; then the machine. Throws Error.
void write_report(const ReportContents& contents);

}  // namespace povpreview
