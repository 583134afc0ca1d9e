// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/ladder.h"

#include <charconv>

#include "core/error.h"

namespace povpreview {

Rung rung_named(const Ladder& ladder, const std::string& text) {
    const std::size_t target = ladder.rungs.size() - 1;
    std::size_t place = ladder.rungs.size();
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, place);
    if (error != std::errc() || rest != end) place = ladder.rungs.size();
    std::string names;
    for (std::size_t i = 0; i < ladder.rungs.size(); ++i) {
        if (ladder.rungs[i].name == text) place = i;
        names += (i == 0 ? "" : ", ") + ladder.rungs[i].name;
    }
    if (place > target)
        throw Error(Exit::usage, "this scene has no accuracy '" + text + "'", "--accuracy",
                    "give one of " + names + ", or its number from 0");
    return place == target ? target_rung : static_cast<Rung>(place);
}

}  // namespace povpreview
