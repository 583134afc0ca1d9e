// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

/// For POV-Ray's front end and base, whose headers do not go together with those of the back end.
namespace povpreview::tracer {

/// As enabled().
bool serves_previewer();

/// Whether the scene may write files: POVPREVIEW_WRITE is in the environment.
bool may_write();

/// A failure that reaches POV-Ray's front end without having passed its MessageFactory.
void note_error(const std::string& text);

/// A file that was opened for reading.
void note_read(const std::string& file);

/// Where the image that POV-Ray would call `wanted` is really to be written: the previewer gives it
/// its name.
std::string image_file(const std::string& wanted);

}  // namespace povpreview::tracer
