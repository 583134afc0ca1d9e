// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/tracer_program.h"

#include <cstdlib>
#include <filesystem>

#include "core/error.h"

namespace povpreview {

std::string tracer_program() {
    namespace fs = std::filesystem;
    if (const char* named = std::getenv("POVPREVIEW_TRACER"); named && *named) return named;
    const fs::path beside = fs::read_symlink("/proc/self/exe").parent_path() / "povpreview-tracer";
    if (!fs::exists(beside))
        throw Error(Exit::usage, "the tracer is not there", beside.string(),
                    "build it by ./run, or name it by the environment variable POVPREVIEW_TRACER");
    return beside.string();
}

}  // namespace povpreview
