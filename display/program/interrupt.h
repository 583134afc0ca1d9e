// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

namespace povpreview {

/// From now on Ctrl-C (and SIGTERM) only sets a flag; a second one ends the program at once.
void catch_interrupts();
/// The flag.
bool interrupted();

}  // namespace povpreview
