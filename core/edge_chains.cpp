// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/edge_chains.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <span>
#include <tuple>

#include "core/edge_graph.h"
#include "core/polyline.h"

namespace povpreview {

namespace {

using Link = EdgeGraph::Link;

constexpr std::uint32_t none = 0xffffffff;

/// Where many links meet, none of them is the straight continuation of another: the effort of
/// pairing them would grow with the square of their number.
constexpr std::size_t most_paired = 16;
/// Cosine of the greatest turn, 15 degrees, at which a chain runs on through a junction.
constexpr double straight_on = .966;

/// Cuts a segment down to the rectangle (Liang and Barsky 1984); false where none of it is inside.
bool clip(glm::dvec2& from, glm::dvec2& to, glm::dvec2 size) {
    const glm::dvec2 a = from, d = to - from;
    double enter = 0, leave = 1;
    for (int k = 0; k < 2; ++k) {
        if (d[k] == 0) {
            if (a[k] < 0 || a[k] > size[k]) return false;
            continue;
        }
        const double low = -a[k] / d[k], high = (size[k] - a[k]) / d[k];
        enter = std::max(enter, std::min(low, high));
        leave = std::min(leave, std::max(low, high));
    }
    if (enter > leave) return false;
    if (enter > 0) from = glm::clamp(a + enter * d, glm::dvec2(0), size);
    if (leave < 1) to = glm::clamp(a + leave * d, glm::dvec2(0), size);
    return true;
}

/// A point close to the image's border is put on it: outside the outermost pixels' centres there is
/// nothing to tell apart.
glm::dvec2 onto_border(glm::dvec2 p, glm::dvec2 size) {
    for (int k = 0; k < 2; ++k) {
        if (p[k] < chain_snap) p[k] = 0;
        if (p[k] > size[k] - chain_snap) p[k] = size[k];
    }
    return p;
}

bool along_border(const ImageEdge& e, glm::dvec2 size) {
    for (int k = 0; k < 2; ++k)
        if (e.from[k] == e.to[k] && (e.from[k] == 0 || e.from[k] == size[k])) return true;
    return false;
}

bool is_finite(const ImageEdge& e) {
    return std::isfinite(e.from.x) && std::isfinite(e.from.y) && std::isfinite(e.to.x) &&
           std::isfinite(e.to.y) && std::isfinite(e.importance);
}

double weight(const ImageEdge& e) { return e.importance * glm::distance(e.from, e.to); }

/// Drops what is of no use and puts the rest in order, heaviest first.
void tidy(std::vector<ImageEdge>& pieces, glm::dvec2 size) {
    std::erase_if(pieces, [&](ImageEdge& e) {
        if (!is_finite(e) || !(e.importance >= 0) || !clip(e.from, e.to, size)) return true;
        e.from = onto_border(e.from, size);
        e.to = onto_border(e.to, size);
        return along_border(e, size);
    });
    const auto key = [](const ImageEdge& e) {
        return std::tuple(-weight(e), e.kind, e.light, e.from.x, e.from.y, e.to.x, e.to.y);
    };
    std::sort(pieces.begin(), pieces.end(),
              [&](const ImageEdge& p, const ImageEdge& q) { return key(p) < key(q); });
    double room = size.x * size.y;  // pixels of length
    const auto first_left_out = std::find_if(pieces.begin(), pieces.end(), [&](const ImageEdge& e) {
        return (room -= glm::distance(e.from, e.to)) < 0;
    });
    pieces.erase(first_left_out, pieces.end());
}

/// Which links follow each other in a chain.
class Strokes {
   public:
    explicit Strokes(const EdgeGraph& graph)
        : graph_(graph), mates_(2 * graph.links.size(), none), taken_(graph.links.size()) {
        std::vector<std::uint32_t> first(graph.nodes.size() + 1, 0);
        for (const Link& link : graph.links) ++first[link.a + 1], ++first[link.b + 1];
        for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
        std::vector<std::uint32_t> ends(2 * graph.links.size()), fill(first.begin(), first.end());
        for (std::uint32_t e = 0; e < ends.size(); ++e) ends[fill[node(e)]++] = e;
        for (std::size_t n = 0; n + 1 < first.size(); ++n)
            pair_at({ends.data() + first[n], ends.data() + first[n + 1]});
    }

    /// Calls f(nodes, links) for every chain; closed where its first node is its last.
    template <class F>
    void for_each(const F& f) {
        // Open chains from their ends; then what is left are rings.
        for (std::uint32_t e = 0; e < mates_.size(); ++e)
            if (mates_[e] == none && !taken_[e / 2]) follow(e, f);
        for (std::uint32_t e = 0; e < mates_.size(); ++e)
            if (!taken_[e / 2]) follow(corner_of_ring(e), f);
    }

   private:
    // A link has two ends: number 2 l at its node a, 2 l + 1 at its node b.
    const Link& link(std::uint32_t end) const { return graph_.links[end / 2]; }
    std::uint32_t node(std::uint32_t end) const { return end % 2 ? link(end).b : link(end).a; }
    static std::uint32_t other(std::uint32_t end) { return end ^ 1; }
    glm::dvec2 direction(std::uint32_t end) const {
        return glm::normalize(graph_.nodes[node(other(end))] - graph_.nodes[node(end)]);
    }

    void pair_at(std::span<const std::uint32_t> ends) {
        const auto alike = [&](std::uint32_t e, std::uint32_t f) {
            return link(e).kind == link(f).kind && link(e).light == link(f).light;
        };
        const auto join = [&](std::uint32_t e, std::uint32_t f) { mates_[e] = f, mates_[f] = e; };
        if (ends.size() == 2 && alike(ends[0], ends[1])) return join(ends[0], ends[1]);
        if (ends.size() > most_paired) return;
        std::vector<std::tuple<double, std::uint32_t, std::uint32_t>> turns;
        for (std::size_t i = 0; i < ends.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                const double turn = glm::dot(direction(ends[i]), direction(ends[j]));
                if (alike(ends[i], ends[j]) && turn < -straight_on)
                    turns.emplace_back(turn, ends[j], ends[i]);
            }
        std::sort(turns.begin(), turns.end());
        for (const auto& [turn, e, f] : turns)
            if (mates_[e] == none && mates_[f] == none) join(e, f);
    }

    /// Of a ring, the end from which it sets out at its sharpest corner, which so stays a vertex.
    std::uint32_t corner_of_ring(std::uint32_t start) const {
        std::uint32_t best = start;
        double sharpest = -1;
        for (std::uint32_t e = start;;) {
            const double turn = glm::dot(direction(e), direction(mates_[e]));
            if (turn > sharpest) sharpest = turn, best = e;
            e = mates_[other(e)];
            if (e == start) return best;
        }
    }

    template <class F>
    void follow(std::uint32_t end, const F& f) {
        nodes_.assign(1, node(end));
        links_.clear();
        while (end != none && !taken_[end / 2]) {
            taken_[end / 2] = true;
            links_.push_back(end / 2);
            nodes_.push_back(node(other(end)));
            end = mates_[other(end)];
        }
        f(nodes_, links_);
    }

    const EdgeGraph& graph_;
    std::vector<std::uint32_t> mates_;  // of ends
    std::vector<bool> taken_;           // links
    std::vector<std::uint32_t> nodes_, links_;
};

}  // namespace

std::vector<EdgeChain> chain_edges(std::vector<ImageEdge> pieces, glm::ivec2 size) {
    tidy(pieces, size);
    const EdgeGraph graph = build_edge_graph(pieces, size, chain_snap);
    std::vector<EdgeChain> chains;
    Strokes(graph).for_each([&](const auto& nodes, const auto& links) {
        EdgeChain chain;
        chain.kind = graph.links[links.front()].kind;
        chain.light = graph.links[links.front()].light;
        for (std::uint32_t l : links) {
            const Link& link = graph.links[l];
            chain.weight += link.importance * static_cast<float>(glm::distance(
                                                  graph.nodes[link.a], graph.nodes[link.b]));
        }
        const bool closed = nodes.front() == nodes.back();
        Polyline line;
        for (std::uint32_t n : nodes) line.push_back(graph.nodes[n]);
        if (closed) line.pop_back();
        chain.vertices = simplify(line, chain_flatness, closed);
        if (closed) chain.vertices.push_back(chain.vertices.front());
        chains.push_back(std::move(chain));
    });
    std::stable_sort(chains.begin(), chains.end(),
                     [](const EdgeChain& p, const EdgeChain& q) { return p.weight > q.weight; });
    return chains;
}

}  // namespace povpreview
