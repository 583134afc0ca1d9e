// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/error.h"
#include "display/program/options.h"
#include "display/program/reference_list.h"

namespace povpreview {

/// Where a batch keeps what it remembers, in its folder of pictures.
inline std::filesystem::path records_folder(const std::filesystem::path& out) {
    return out / ".povpreview";
}

/// A batch file for Slurm: a job array that renders these items by `program`, which is this one,
/// run in `folder`; each element one of them, or every so manieth where there are more than Slurm's
/// arrays usually hold.
std::string slurm_batch(const ReferenceOptions& options, const std::vector<ReferenceItem>& items,
                        const std::filesystem::path& program, const std::filesystem::path& folder);

/// Writes the batch file into the folder of pictures and hands it to sbatch. Throws
/// Error(Exit::usage) where there is no sbatch, or it refuses; the file then lies there all the
/// same.
Exit submit_to_slurm(const ReferenceOptions& options, const std::vector<ReferenceItem>& items);

}  // namespace povpreview
