// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "adapter/povray_options.h"

namespace povpreview {

/// One picture of a batch.
struct ReferenceItem {
    /// Where it is to lie, below the folder of all and without an ending: the scene's name, behind
    /// it "-" and the section, and the frame's number; before it as many of the scene's folders as
    /// tell scenes of one name apart.
    std::string name;
    PovrayOptions povray;
    std::optional<int> frame;
    std::string problem;  ///< why it cannot be rendered, or empty
};

/// All pictures that a command line asks for: of every scene, for every section of the INI file
/// `sections` (empty: none), every frame of the animation. Each is rendered on one thread unless
/// the words say otherwise: then a picture does not depend on the machine, and several side by side
/// use more of it. A scene that is not there is an item with a problem. Throws Error(Exit::usage)
/// where there is no scene at all, the sections cannot be read, or two pictures would have one
/// name.
std::vector<ReferenceItem> reference_items(const std::vector<std::string>& words,
                                           const std::filesystem::path& sections);

}  // namespace povpreview
