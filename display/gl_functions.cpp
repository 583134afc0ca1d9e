// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/gl_functions.h"

#include <string>

#include "core/error.h"

namespace povpreview {

GlProc GlFunctions::required(GlProc proc, const char* name, const char* place) {
    if (!proc)
        throw Error(Exit::usage, std::string("the OpenGL library has no function ") + name, place,
                    "install a driver with OpenGL 3.3, such as Debian's libgl1-mesa-dri");
    return proc;
}

}  // namespace povpreview
