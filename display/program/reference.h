// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "adapter/povray_options.h"
#include "display/image.h"
#include "display/program/content_hash.h"
#include "display/program/options.h"

namespace povpreview {

/// Off: one sample per pixel. On: POV-Ray's default (+A0.3 +AM1 +R3), without jitter.
enum class Antialiasing { off, on };

/// A complete render that is to be had as a file.
struct ReferenceJob {
    PovrayOptions povray;
    std::optional<int> frame = {};  ///< of the animation; none: the still picture
    Engine engine = Engine::stock;
    FileFormat format = FileFormat::png16;
    bool antialias = false;                ///< as POV-Ray's options say, or not at all
    std::filesystem::path picture;         ///< the file; its folder must be there
    std::filesystem::path record;          ///< where to keep what it was made from
    std::optional<double> timeout_s = {};  ///< give it up after so many seconds
};

struct ReferenceMade {
    bool reused = false;
    double seconds = 0;       ///< that rendering took
    std::string remark = {};  ///< what a user should know besides, or empty
};

/// Renders a reference, or does nothing where the one that lies there was made from the same: by
/// the same program with the same options and surroundings (folder, POVINI, POVINC, HOME), every
/// file that was opened then holding what it held, every file that was looked for in vain still not
/// there, and the picture itself as it was written. The picture is written all or nothing, with the
/// command and the versions in it.
///
/// `stop` is asked some times a second whether to give up. Throws Error: Exit::scene with POV-Ray's
/// message (at once, if the same failed before) or after `timeout_s`; Exit::interrupted;
/// Exit::usage where a file cannot be written or a program is not there.
ReferenceMade make_reference(const ReferenceJob& job, ContentHashes& hashes,
                             const std::function<bool()>& stop);

/// A complete render by the stock povray in `folder`/reference.png, or reference-aa.png if
/// anti-aliased; see make_reference(). Returns its encoded values in [0, 1]. Throws Error.
Image stock_reference(const std::vector<std::string>& povray_words,
                      const std::filesystem::path& folder, const std::function<bool()>& interrupted,
                      Antialiasing antialiasing = Antialiasing::off);

}  // namespace povpreview
