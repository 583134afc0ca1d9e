// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

namespace povpreview::tracer {

/// A failure that reaches POV-Ray's front end without having passed its MessageFactory. For the
/// front end, whose headers do not go together with those of the back end.
void note_error(const std::string& text);

}  // namespace povpreview::tracer
