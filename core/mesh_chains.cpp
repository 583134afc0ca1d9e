// SPDX-License-Identifier: AGPL-3.0-or-later
//
// The mesh previewer's dealings with edges that are known without tracing: when they become
// constraints of the mesh.
#include <algorithm>
#include <glm/geometric.hpp>

#include "core/mesh_previewer.h"

namespace povpreview {

namespace {

/// Vertices of chains inserted in one go, between two requests for samples: some milliseconds. In
/// smaller portions more of what one changes is changed again by the next.
constexpr std::size_t chain_batch = 512;

}  // namespace

void MeshPreviewer::accept_edges(std::vector<EdgeChain>&& chains) {
    if (!options_.constraints || !refining_) return;
    const auto outside = [&](glm::dvec2 p) {
        return !(p.x >= 0 && p.y >= 0 && p.x <= width_ && p.y <= height_);
    };
    std::erase_if(chains, [&](const EdgeChain& chain) {
        return chain.vertices.size() < 2 ||
               std::any_of(chain.vertices.begin(), chain.vertices.end(), outside) ||
               is_superfluous(chain);
    });
    chains_.insert(chains_.end(), std::make_move_iterator(chains.begin()),
                   std::make_move_iterator(chains.end()));
    // Of two that weigh the same, the one that came first.
    std::stable_sort(chains_.begin(), chains_.end(),
                     [](const EdgeChain& p, const EdgeChain& q) { return p.weight > q.weight; });
    std::reverse(chains_.begin(), chains_.end());
}

/// Where every pixel knows its item, borders between items need no constraints: they would take
/// one-sided samples and time of ours (office: twice as long to an error of .01).
bool MeshPreviewer::is_superfluous(const EdgeChain& chain) const {
    if (!detail_ || chain.kind != EdgeKind::geometric) return false;
    for (std::size_t i = 1; i < chain.vertices.size(); ++i)
        if (!items_known_along(chain.vertices[i - 1], chain.vertices[i])) return false;
    return true;
}

/// Whether the pixels on a segment, a few of them if it is long, know their items.
bool MeshPreviewer::items_known_along(glm::dvec2 from, glm::dvec2 to) const {
    constexpr double spacing = 4;  // pixels
    const int steps = 1 + static_cast<int>(glm::distance(from, to) / spacing);
    for (int i = 0; i <= steps; ++i) {
        const Pixel pixel = squares_.pixel_at(from + (to - from) * (double(i) / steps));
        if (detail_->item(pixel) == DetailMap::unknown) return false;
    }
    return true;
}

/// Inserts known chains, heaviest first, as far as the samples so far deserve. They need not wait
/// for the first answers: a side without a sample costs nothing.
void MeshPreviewer::insert_chains() {
    if (chains_.empty()) return;
    const double samples = static_cast<double>(std::max(squares_.requested(), grid_.size()));
    const double allowed = options_.chain_share * samples;
    if (static_cast<double>(chain_vertices_) >= allowed) return;
    ChainInsertion insertion = begin_insertion();
    const std::size_t before = chain_vertices_;
    while (!chains_.empty() && chain_vertices_ < before + chain_batch &&
           static_cast<double>(chain_vertices_) < allowed) {
        const EdgeChain& chain = chains_.back();
        insertion.insert(chain.vertices, {chain.kind, chain.light});
        chain_vertices_ += chain.vertices.size();
        chains_.pop_back();
    }
    finish_insertion(insertion);
}

ChainInsertion MeshPreviewer::begin_insertion() {
    vertices_before_insertion_ = mesh_.triangulation().vertex_ids();
    return ChainInsertion(mesh_, {width_, height_}, [this](VertexId vertex) {
        const SampleId sample = mesh_.first_sample(vertex);
        if (sample.valid())
            squares_.set_meshed(squares_.pixel_at(mesh_.sample(sample).position), false);
    });
}

void MeshPreviewer::finish_insertion(ChainInsertion& insertion) {
    queue_changed(insertion.finish(), vertices_before_insertion_);
}

}  // namespace povpreview
