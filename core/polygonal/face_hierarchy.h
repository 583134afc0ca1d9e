// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <utility>
#include <vector>

#include "core/polygonal/flat_faces.h"

namespace povpreview {

/// A box with sides along the axes, by centre and half its size.
struct FaceBox {
    glm::vec3 centre, half;
};

/// Half of space: where dot(normal, p) + offset >= 0.
struct HalfSpace {
    HalfSpace(const glm::dvec3& inward, const glm::dvec3& on)
        : normal(inward), absolute(glm::abs(inward)), offset(-glm::dot(inward, on)) {}

    bool misses(const FaceBox& box) const {
        return glm::dot(normal, glm::dvec3(box.centre)) + offset +
                   glm::dot(absolute, glm::dvec3(box.half)) <
               0;
    }

    glm::dvec3 normal, absolute;
    double offset;
};

/// Boxes around boxes around the faces of a scene (a bounding volume hierarchy): finds the few
/// faces in some region without looking at all of them.
class FaceHierarchy {
   public:
    explicit FaceHierarchy(const FlatFaces& faces);

    /// Calls visit(face) for every face whose box the region may touch. `misses(box)` says that it
    /// certainly does not; `visit` returns false to end the search.
    template <class Misses, class Visit>
    void search(const Misses& misses, const Visit& visit) const;

    /// Calls visit(f, g) once for every two faces whose boxes touch.
    template <class Visit>
    void for_each_pair(const Visit& visit) const;

   private:
    struct Node {
        FaceBox box;
        std::uint32_t first;  ///< of its faces in order_, or of its two children
        std::uint32_t count;  ///< of its faces; 0: it has children
    };
    using Pair = std::pair<std::uint32_t, std::uint32_t>;

    void build(std::uint32_t faces);
    std::uint32_t split(std::uint32_t begin, std::uint32_t end);
    template <class Visit>
    void visit_leaves(const Node& a, const Node& b, const Visit& visit) const;

    std::vector<Node> nodes_;           // the root first; children side by side
    std::vector<std::uint32_t> order_;  // faces, those of a node side by side
    std::vector<FaceBox> boxes_;        // by face
};

inline bool touch(const FaceBox& a, const FaceBox& b) {
    for (int k = 0; k < 3; ++k)
        if (std::abs(a.centre[k] - b.centre[k]) > a.half[k] + b.half[k]) return false;
    return true;
}

template <class Misses, class Visit>
void FaceHierarchy::search(const Misses& misses, const Visit& visit) const {
    if (nodes_.empty()) return;
    std::uint32_t stack[64];  // more than the deepest tree has levels, see build()
    std::size_t waiting = 0;
    stack[waiting++] = 0;
    while (waiting > 0) {
        const Node& node = nodes_[stack[--waiting]];
        if (misses(node.box)) continue;
        if (node.count == 0) {
            stack[waiting++] = node.first + 1;
            stack[waiting++] = node.first;
            continue;
        }
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
            if (!misses(boxes_[order_[i]]) && !visit(order_[i])) return;
    }
}

template <class Visit>
void FaceHierarchy::for_each_pair(const Visit& visit) const {
    if (nodes_.empty()) return;
    std::vector<Pair> open{{0, 0}};
    while (!open.empty()) {
        const auto [i, j] = open.back();
        open.pop_back();
        const Node &a = nodes_[i], &b = nodes_[j];
        if (!touch(a.box, b.box)) continue;
        if (a.count > 0 && b.count > 0) {
            visit_leaves(a, b, visit);
        } else if (i == j) {
            open.insert(open.end(), {Pair{a.first, a.first}, Pair{a.first, a.first + 1},
                                     Pair{a.first + 1, a.first + 1}});
        } else if (a.count > 0 || (b.count == 0 && b.box.half.x > a.box.half.x)) {
            open.insert(open.end(), {Pair{i, b.first}, Pair{i, b.first + 1}});
        } else {
            open.insert(open.end(), {Pair{a.first, j}, Pair{a.first + 1, j}});
        }
    }
}

template <class Visit>
void FaceHierarchy::visit_leaves(const Node& a, const Node& b, const Visit& visit) const {
    for (std::uint32_t i = a.first; i < a.first + a.count; ++i)
        for (std::uint32_t j = &a == &b ? i + 1 : b.first; j < b.first + b.count; ++j)
            if (touch(boxes_[order_[i]], boxes_[order_[j]])) visit(order_[i], order_[j]);
}

}  // namespace povpreview
