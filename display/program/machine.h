// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace povpreview {

/// What figures were measured on and with: names and values, for people.
using Machine = std::vector<std::pair<std::string, std::string>>;

/// This machine and the programs that take part. `threads`: asked for, or 0; `drawing`: what draws.
Machine this_machine(int threads, const std::string& drawing);

/// As a JSON object.
std::string json(const Machine& machine);

/// From now on this process and all that it starts run on the first `count` of the cores that it
/// may use now. Throws Error(Exit::usage) if there are fewer.
void keep_to_cores(int count);

}  // namespace povpreview
