// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "core/previewer.h"

namespace povpreview {

/// What a person asked for by keys.
///
///     m        edges of the triangulation    on and off
///     e        constrained edges alone       on and off
///     s        positions of samples          on and off
///     b        the baseline beside it        on and off
///     p        save the picture ("print")
///     q, Esc   end
struct Controls {
    static constexpr char escape = 27;

    Overlay overlay = Overlay::none;
    bool beside = false;
    bool save = false;  ///< until the caller has saved and takes it back
    bool closed = false;

    /// Whether the key means something; capitals mean the same.
    bool press(char key);
};

}  // namespace povpreview
