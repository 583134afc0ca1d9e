// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/povray_image.h"

#include <stdlib.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <vector>

#include "core/error.h"
#include "display/atomic_file.h"

namespace povpreview {

namespace fs = std::filesystem;

ScratchFolder::ScratchFolder() {
    std::error_code error;
    fs::path above = fs::temp_directory_path(error);
    if (error) above = "/tmp";
    std::string name = (above / "povpreview-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
        throw Error(Exit::usage,
                    std::string("cannot make a folder here (") + std::strerror(errno) + ")",
                    above.string(), "set TMPDIR to a folder that you may write");
    path_ = name;
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

void check_image(const std::string& name) {
    if (name.empty())
        throw Error(Exit::usage, "POV-Ray's options say that no image is made", "-F",
                    "leave out -F, or --finish");
    if (name == "stdout" || name == "stderr")
        throw Error(Exit::usage, "the image cannot go to " + name, "+O-", "name a file by +O");
    std::error_code error;
    const fs::path folder = fs::absolute(name, error).parent_path();
    if (fs::is_directory(name, error) || access(folder.c_str(), W_OK) != 0)
        throw Error(Exit::usage, "POV-Ray's image cannot be written", name,
                    "give +O a file in a folder that you may write");
}

void save_povray_image(const fs::path& from, const fs::path& to) {
    std::ifstream stream(from, std::ios::binary);
    const std::vector<char> bytes((std::istreambuf_iterator<char>(stream)),
                                  std::istreambuf_iterator<char>());
    if (!stream || bytes.empty())
        throw Error(Exit::usage, "cannot read POV-Ray's image", from.string(), "is the disk full?");
    write_file(to, {reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()});
}

}  // namespace povpreview
