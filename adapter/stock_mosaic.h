// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace povpreview {

/// A run of the stock `povray` with its mosaic preview (+SP32 +EP1), as its display would have
/// shown it. Times are seconds since it was started.
///
/// Its display is off and the picture goes to a file, which is kinder to it than a window would be:
/// what counts as shown is what it has sent to its front end (see RenderState).
struct StockMosaic {
    /// The render state file's size from a moment on.
    struct Growth {
        double launch_s;
        std::size_t bytes;
    };
    std::vector<Growth> growth;
    /// The file's begin: the parse is over. Photons and a radiosity pretrace come after it.
    double parsed_s = 0;
    double ended_s = 0;
    std::vector<std::byte> state;  ///< the file in the end
    bool complete = false;         ///< false: stopped by `stop`

    /// How much of `state` there was so many seconds after the parse.
    std::size_t bytes_at(double time_s) const;
};

/// Runs it; messages and temporary files in `folder`. `stop` is asked some times a second, with the
/// seconds since the parse (0 before its end). Throws Error as render_by_stock_povray.
StockMosaic run_stock_mosaic(const std::vector<std::string>& povray_words,
                             const std::filesystem::path& folder,
                             const std::function<bool(double)>& stop);

}  // namespace povpreview
