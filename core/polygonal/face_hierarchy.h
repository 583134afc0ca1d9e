// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "core/polygonal/flat_faces.h"

namespace povpreview {

/// A box with sides along the axes, by centre and half its size.
struct FaceBox {
    glm::vec3 centre, half;
};

/// Several half spaces at once: a region that boxes lie in, or miss. Computed in single precision,
/// with such margins that no box is missed that touches the region.
class Region {
   public:
    /// Those that exclude most come first. REQUIRES: at most eight.
    void add(const glm::dvec3& inward, const glm::dvec3& on) { set(used_++, inward, on); }
    /// Adds one that holds all space until it is moved to end at a point.
    void add_movable(const glm::dvec3& inward) {
        movable_ = used_++;
        normal_ = inward;
    }
    void move_to(const glm::dvec3& on) { set(movable_, normal_, on); }

    bool misses(const FaceBox& box) const { return first_.miss(box) || second_.miss(box); }

   private:
    /// Four half spaces, computed with side by side.
    struct Four {
        using Lanes [[gnu::vector_size(16)]] = float;
        Lanes x{}, y{}, z{}, offset{};
        Lanes across_x{}, across_y{}, across_z{};  // half a box's size along the plane's normal

        bool miss(const FaceBox& box) const {
            const Lanes inside = offset + x * box.centre.x + y * box.centre.y + z * box.centre.z +
                                 across_x * box.half.x + across_y * box.half.y +
                                 across_z * box.half.z;
            const auto outside = std::bit_cast<std::array<std::uint64_t, 2>>(inside < 0);
            return (outside[0] | outside[1]) != 0;
        }
    };

    void set(int number, const glm::dvec3& inward, const glm::dvec3& on) {
        constexpr double margin = 8 * std::numeric_limits<float>::epsilon();
        const double length = glm::length(inward);
        if (!(length > 0)) return;  // no direction: the whole space
        const glm::dvec3 n = inward / length;
        Four& four = number < 4 ? first_ : second_;
        const int lane = number % 4;
        four.x[lane] = static_cast<float>(n.x);
        four.y[lane] = static_cast<float>(n.y);
        four.z[lane] = static_cast<float>(n.z);
        four.across_x[lane] = std::abs(four.x[lane]);
        four.across_y[lane] = std::abs(four.y[lane]);
        four.across_z[lane] = std::abs(four.z[lane]);
        four.offset[lane] = static_cast<float>(-glm::dot(n, on) + margin * glm::length(on));
    }

    int used_ = 0, movable_ = 0;
    glm::dvec3 normal_{0};  // of the movable one
    Four first_, second_;
};

/// Boxes around boxes around the faces of a scene (a bounding volume hierarchy): finds the few
/// faces in some region without looking at all of them.
class FaceHierarchy {
   public:
    explicit FaceHierarchy(const FlatFaces& faces);

    /// Calls visit(face) for every face whose box the region may touch, roughly in order along
    /// `direction`; `misses(box)` says that it certainly does not, and may say so of more boxes as
    /// the search goes on. `visit` returns false to end it.
    template <class Misses, class Visit>
    void search(const Misses& misses, const glm::vec3& direction, const Visit& visit) const;

    /// Calls visit(f, g) once for every two faces whose boxes touch, until it returns false.
    template <class Visit>
    void for_each_pair(const Visit& visit) const;

    /// Boxes looked at in all so far, and faces visited, as what they take in boxes: a measure of
    /// work that is the same on every machine.
    std::uint64_t effort() const { return effort_; }

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
    bool visit_leaves(const Node& a, const Node& b, const Visit& visit) const;

    std::vector<Node> nodes_;           // the root first; children side by side
    std::vector<std::uint32_t> order_;  // faces, those of a node side by side
    std::vector<FaceBox> boxes_;        // of the faces, in this order
    static constexpr int visit_effort = 8;
    mutable std::uint64_t effort_ = 0;
};

inline bool touch(const FaceBox& a, const FaceBox& b) {
    for (int k = 0; k < 3; ++k)
        if (std::abs(a.centre[k] - b.centre[k]) > a.half[k] + b.half[k]) return false;
    return true;
}

template <class Misses, class Visit>
void FaceHierarchy::search(const Misses& misses, const glm::vec3& direction,
                           const Visit& visit) const {
    if (nodes_.empty() || misses(nodes_[0].box)) return;
    std::uint32_t stack[64];  // more than the deepest tree has levels, see build()
    std::size_t waiting = 0;
    for (const Node* node = &nodes_[0];;) {
        effort_ += node->count == 0 ? 2 : node->count;
        if (node->count == 0) {
            const Node *near = &nodes_[node->first], *far = near + 1;
            if (glm::dot(near->box.centre - far->box.centre, direction) > 0) std::swap(near, far);
            const bool to_near = !misses(near->box), to_far = !misses(far->box);
            if (to_near) {
                if (to_far) stack[waiting++] = static_cast<std::uint32_t>(far - nodes_.data());
                node = near;
                continue;
            }
            if (to_far) {
                node = far;
                continue;
            }
        } else {
            for (std::uint32_t i = node->first; i < node->first + node->count; ++i) {
                if (misses(boxes_[i])) continue;
                effort_ += visit_effort;
                if (!visit(order_[i])) return;
            }
        }
        // What waits was not missed when it was met, but may be by now.
        do {
            if (waiting == 0) return;
            node = &nodes_[stack[--waiting]];
        } while (misses(node->box));
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
        ++effort_;
        if (!touch(a.box, b.box)) continue;
        if (a.count > 0 && b.count > 0) {
            if (!visit_leaves(a, b, visit)) return;
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
bool FaceHierarchy::visit_leaves(const Node& a, const Node& b, const Visit& visit) const {
    effort_ += a.count * b.count;
    for (std::uint32_t i = a.first; i < a.first + a.count; ++i)
        for (std::uint32_t j = &a == &b ? i + 1 : b.first; j < b.first + b.count; ++j)
            if (touch(boxes_[i], boxes_[j]) && !visit(order_[i], order_[j])) return false;
    return true;
}

}  // namespace povpreview
