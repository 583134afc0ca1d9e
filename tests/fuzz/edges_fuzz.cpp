// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Shadow volumes and all edges of any polygonal scene, their chains, and the mesh with those in it.
#include <cmath>

#include "core/edge_chains.h"
#include "core/mesh_previewer.h"
#include "core/polygonal/edge_finding.h"
#include "tests/fuzz/scene_input.h"
#include "tests/fuzz/targets.h"

namespace povpreview::fuzz {
namespace {

bool inside(const glm::dvec2& p, const PolygonScene& scene) {
    return p.x >= 0 && p.y >= 0 && p.x <= scene.width && p.y <= scene.height;
}

/// Every sample is asked for and answered, and the mesh stays as it must.
void insert(std::vector<EdgeChain>&& chains, const PolygonScene& scene) {
    MeshPreviewer previewer(scene.width, scene.height);
    previewer.accept_edges(std::move(chains));
    for (int i = 0; auto request = previewer.next(); ++i) {
        Sample sample;
        sample.position = request->position;
        sample.kind = request->kind;
        sample.colour = glm::vec3(float(i % 3) / 2, .5F, 0);
        previewer.accept(sample);
        if (i % 64 > 0) continue;
        const std::string fault = previewer.validate();
        promise(fault.empty(), fault);
    }
    promise(previewer.done(), "the preview ends before it is complete");
}

}  // namespace

void edges(std::span<const std::byte> bytes) {
    Input input(bytes);
    const EdgeFinding options{.mirror_depth = static_cast<int>(input.whole(3))};
    const PolygonScene scene = polygon_scene(input);
    std::vector<ImageEdge> all;
    find_edges(scene, options, [&](std::vector<ImageEdge>&& pieces, std::uint64_t) {
        all.insert(all.end(), pieces.begin(), pieces.end());
        return true;
    });
    for (const ImageEdge& piece : all) {
        promise(inside(piece.from, scene) && inside(piece.to, scene), "a piece leaves the image");
        promise(piece.from != piece.to, "a piece has no length");
        promise(piece.importance >= 0 && piece.importance <= 1, "an importance out of its range");
        promise(piece.kind != EdgeKind::shadow || piece.light < scene.lights.size(),
                "a shadow of no light");
    }
    std::vector<EdgeChain> chains = chain_edges(std::move(all), {scene.width, scene.height});
    for (const EdgeChain& chain : chains) {
        promise(chain.vertices.size() >= 2, "a chain of one point");
        for (const glm::dvec2& p : chain.vertices)
            promise(inside(p, scene), "a chain leaves the image");
    }
    insert(std::move(chains), scene);
}

}  // namespace povpreview::fuzz
