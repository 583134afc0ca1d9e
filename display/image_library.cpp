// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/image_library.h"

#include <dlfcn.h>

#include <filesystem>

#include "core/error.h"
#include "display/address_space.h"

namespace povpreview {
namespace {

/// In the folder of this program, or where it was built.
std::filesystem::path module_path() {
    const std::filesystem::path built = POVPREVIEW_IMAGE_MODULE;
    std::error_code ignored;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", ignored);
    const auto beside = program.parent_path() / built.filename();
    return std::filesystem::exists(beside, ignored) ? beside : built;
}

const ImageLibrary* load() {
    const std::filesystem::path path = module_path();
    require_address_space(address_space::images, "the image library");
    // Never unloaded: the libraries behind it have threads and exit handlers of their own.
    void* module = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    using Entry = const ImageLibrary* (*)();
    const auto entry =
        module ? reinterpret_cast<Entry>(dlsym(module, "povpreview_image_library")) : nullptr;
    if (!entry)
        throw Error(Exit::usage, std::string("the image library cannot be loaded: ") + dlerror(),
                    path.string(), "build povpreview anew, by ./run");
    return entry();
}

}  // namespace

const ImageLibrary& image_library() {
    static const ImageLibrary* const loaded = load();
    return *loaded;
}

}  // namespace povpreview
