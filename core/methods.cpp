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
    std::unique_ptr<Previewer> (*make)(const ImageFrame& frame);
};

std::unique_ptr<Previewer> make_mesh(const ImageFrame& frame, MeshOptions options) {
    options.detail = options.detail && frame.sharp &&
                     std::int64_t{frame.width} * frame.height <= most_item_pixels;
    options.by_cost = frame.by_cost;
    options.threads = frame.threads;
    return std::make_unique<MeshPreviewer>(frame.width, frame.height, options, frame.ladder);
}

template <class Baseline>
std::unique_ptr<Previewer> make(const ImageFrame& frame) {
    return std::make_unique<Baseline>(frame.width, frame.height);
}

constexpr Method methods[] = {
    {"mesh", [](const ImageFrame& frame) { return make_mesh(frame, {}); }},
    {"constrained",
     [](const ImageFrame& frame) { return make_mesh(frame, {.detail = false, .lattice = false}); }},
    {"delaunay",
     [](const ImageFrame& frame) {
         return make_mesh(frame, {.constraints = false, .detail = false, .lattice = false});
     }},
    {"blocks", make<Blocks>},
    {"mosaic", make<Mosaic>},
    {"bicubic", make<Bicubic>},
};

}  // namespace

std::vector<std::string> method_names() {
    std::vector<std::string> names;
    for (const Method& method : methods) names.emplace_back(method.name);
    return names;
}

MethodNeeds method_needs(std::string_view name) {
    const auto previewer = make_previewer(name, {1, 1});
    return {previewer->wants_edges(), previewer->wants_items()};
}

std::unique_ptr<Previewer> make_previewer(std::string_view name, const ImageFrame& frame) {
    for (const Method& method : methods)
        if (name == method.name) return method.make(frame);
    assert(!"the name is one of method_names()");
    return nullptr;
}

}  // namespace povpreview
