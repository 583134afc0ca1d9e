// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "adapter/frame_range.h"

namespace povpreview {

/// Which picture the patched POV-Ray is to trace.
struct TracerPicture {
    bool finish = false;         ///< it also writes its own image file in the end
    std::optional<int> frame{};  ///< of the animation; the still picture if not given
};

/// The file that the stock POV-Ray is to write.
struct StockPicture {
    enum class Type { png16, png8, exr };  ///< EXR in 16-bit float, and never to standard output
    std::string output;                    ///< "-": standard output
    Type type = Type::png16;
    bool antialias = false;         ///< as the user's words say, or not at all
    std::optional<int> frame = {};  ///< of the animation that the words describe
};

/// POV-Ray's part of a command line, read as far as we must know it; all the rest is passed on as
/// it is. POV-Ray applies povray.ini first, then the words from left to right, and later ones win,
/// so what we force comes last.
struct PovrayOptions {
    std::vector<std::string> words;  ///< as POV-Ray is to get them: file names with blanks quoted
    std::filesystem::path scene;     ///< where the scene file was found
    /// What a tracer must be able to read: the folders of the scene and of the libraries, the
    /// working folder, and the INI files.
    std::vector<std::filesystem::path> readable;
    /// What povpreview does otherwise than these words ask of POV-Ray, a sentence each.
    std::vector<std::string> departures;
    FrameRange frames;
    bool antialias = false;
    int threads = 0;  ///< asked for; 0: as many as POV-Ray likes

    /// For the patched POV-Ray: the user's words; no files but, to finish, its image; no window.
    std::vector<std::string> tracer_arguments(const TracerPicture& picture = {}) const;
    /// The words on which samples may depend; with the files that they name they say whether
    /// samples of an earlier run can be used.
    std::vector<std::string> sample_words() const;
    /// For the stock POV-Ray: the same picture, complete; a PNG in sRGB encoding; no alpha;
    /// messages only if it fails.
    std::vector<std::string> stock_arguments(const StockPicture& picture) const;
};

/// Reads POV-Ray's words: `scene.pov`, `+Iscene.pov`, `file.ini[section]`, `+W640`, `Width=640`,
/// `+Lfolder` and the like. Looks for the scene where POV-Ray does, also in INI files and library
/// paths. Throws Error(Exit::usage) where there is no scene, more than one, no such file, or where
/// `+W` or `+H` is no size that can be shown (see scene.h), or the number of a frame is none.
PovrayOptions read_povray_options(const std::vector<std::string>& words);

}  // namespace povpreview
