// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "adapter/povray_oracle.h"

namespace povpreview {

/// The patched POV-Ray: POVPREVIEW_TRACER, or the one beside this build; empty if there is none.
std::string real_tracer();

/// A folder of its own, gone at the end.
class WorkFolder {
   public:
    WorkFolder();
    ~WorkFolder();
    WorkFolder(const WorkFolder&) = delete;
    WorkFolder& operator=(const WorkFolder&) = delete;

    std::filesystem::path write(const std::string& name, const std::string& text) const;
    const std::filesystem::path& path() const { return path_; }

   private:
    std::filesystem::path path_;
};

/// All samples of an image's pixel centres, row by row, ordered from a fresh tracer in an order
/// that `seed` shuffles. Throws Error as PovrayOracle does, and if samples stay out for `limit`.
struct TracedImage {
    int width = 0, height = 0;
    std::vector<Sample> samples;
};
TracedImage trace_pixels(const std::vector<std::string>& words, RayKind kind, Parts parts,
                         unsigned seed, Rung rung = target_rung,
                         std::chrono::seconds limit = std::chrono::seconds(120));

}  // namespace povpreview
