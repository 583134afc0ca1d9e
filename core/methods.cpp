// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/methods.h"

#include <cassert>

#include "core/bicubic.h"
#include "core/blocks.h"
#include "core/mesh_previewer.h"
#include "core/mosaic.h"

namespace povpreview {
namespace {

struct Method {
    const char* name;
    std::unique_ptr<Previewer> (*make)(int width, int height);
};

constexpr Method methods[] = {
    {"mesh",
     [](int w, int h) -> std::unique_ptr<Previewer> {
         return std::make_unique<MeshPreviewer>(w, h);
     }},
    {"delaunay",
     [](int w, int h) -> std::unique_ptr<Previewer> {
         return std::make_unique<MeshPreviewer>(w, h, MeshOptions{.constraints = false});
     }},
    {"blocks",
     [](int w, int h) -> std::unique_ptr<Previewer> { return std::make_unique<Blocks>(w, h); }},
    {"mosaic",
     [](int w, int h) -> std::unique_ptr<Previewer> { return std::make_unique<Mosaic>(w, h); }},
    {"bicubic",
     [](int w, int h) -> std::unique_ptr<Previewer> { return std::make_unique<Bicubic>(w, h); }},
};

}  // namespace

std::vector<std::string> method_names() {
    std::vector<std::string> names;
    for (const Method& method : methods) names.emplace_back(method.name);
    return names;
}

bool method_wants_edges(std::string_view name) { return make_previewer(name, 1, 1)->wants_edges(); }

std::unique_ptr<Previewer> make_previewer(std::string_view name, int width, int height) {
    for (const Method& method : methods)
        if (name == method.name) return method.make(width, height);
    assert(!"the name is one of method_names()");
    return nullptr;
}

}  // namespace povpreview
