// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace povpreview {

/// One scene of a command line that may name several.
struct NamedScene {
    std::string name;                ///< of the scene file without its ending; unique in the list
    std::vector<std::string> words;  ///< POV-Ray's for this scene alone
};

/// Gives each scene that the words name its own command line: all words that are no scenes, and
/// its folder as the last library path, so that it finds what lies beside it from anywhere. Words
/// that name no scene at all are one (an INI file may name it). Throws Error(Exit::usage).
std::vector<NamedScene> scene_list(const std::vector<std::string>& povray_words);

}  // namespace povpreview
