// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/polygonal/face_hierarchy.h"

#include <glm/common.hpp>
#include <limits>
#include <numeric>

namespace povpreview {
namespace {

constexpr std::uint32_t leaf_size = 4;

/// A box in single precision around points in double precision, larger by what computing with it
/// may be wrong by.
FaceBox box_around(const glm::dvec3& low, const glm::dvec3& high) {
    constexpr float margin = 8 * std::numeric_limits<float>::epsilon();
    const glm::dvec3 middle = low / 2. + high / 2.;
    const glm::vec3 centre(middle);
    const glm::vec3 half(glm::max(high - glm::dvec3(centre), glm::dvec3(centre) - low));
    return {centre, half + margin * (glm::abs(centre) + half)};
}

struct Bounds {
    glm::dvec3 low{INFINITY}, high{-INFINITY};

    void add(const FaceBox& box) {
        low = glm::min(low, glm::dvec3(box.centre) - glm::dvec3(box.half));
        high = glm::max(high, glm::dvec3(box.centre) + glm::dvec3(box.half));
    }
    /// Half of the surface, to which the chance is proportional that a line meets the box.
    double surface() const {
        const glm::dvec3 d = glm::max(high - low, glm::dvec3(0));
        return d.x * d.y + d.y * d.z + d.z * d.x;
    }
};

/// Boxes sorted into so many slots along an axis; a cut between two of them parts the faces.
struct Slots {
    static constexpr int count = 16;
    int axis;
    double from, scale;
    Bounds bounds[count];
    std::uint32_t faces[count] = {};

    int slot(const FaceBox& box) const {
        return std::clamp(static_cast<int>((box.centre[axis] - from) * scale), 0, count - 1);
    }
    void add(const FaceBox& box) {
        bounds[slot(box)].add(box);
        ++faces[slot(box)];
    }
    static void gather(Bounds& to, const Bounds& from) {
        to.low = glm::min(to.low, from.low);
        to.high = glm::max(to.high, from.high);
    }
    struct Cut {
        int slot = -1;  ///< the last one on the left; -1: all lies on one side
        double cost = INFINITY;
    };
    /// The cut that makes searches of the two sides cheapest.
    Cut best_cut() const {
        double right_cost[count];
        Bounds right;
        std::uint32_t right_faces = 0;
        for (int i = count - 1; i > 0; --i) {
            gather(right, bounds[i]);
            right_faces += faces[i];
            right_cost[i] = right_faces ? right.surface() * right_faces : -1;
        }
        Bounds left;
        std::uint32_t left_faces = 0;
        Cut best;
        for (int i = 0; i + 1 < count; ++i) {
            gather(left, bounds[i]);
            left_faces += faces[i];
            if (left_faces == 0 || right_cost[i + 1] < 0) continue;
            const double cost = left.surface() * left_faces + right_cost[i + 1];
            if (cost < best.cost) best = {i, cost};
        }
        return best;
    }
};

}  // namespace

FaceHierarchy::FaceHierarchy(const FlatFaces& faces) {
    if (faces.size() == 0) return;
    boxes_.reserve(faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i) {
        glm::dvec3 low(INFINITY), high(-INFINITY);
        for (const std::uint32_t corner : faces.corners(i)) {
            low = glm::min(low, faces.point(corner));
            high = glm::max(high, faces.point(corner));
        }
        boxes_.push_back(box_around(low, high));
    }
    order_.resize(faces.size());
    std::iota(order_.begin(), order_.end(), 0u);
    build(static_cast<std::uint32_t>(faces.size()));
    std::vector<FaceBox> ordered;
    ordered.reserve(boxes_.size());
    for (const std::uint32_t face : order_) ordered.push_back(boxes_[face]);
    boxes_.swap(ordered);
}

void FaceHierarchy::build(std::uint32_t faces) {
    struct Task {
        std::uint32_t node, begin, end;
        int depth;
    };
    nodes_.resize(1);
    std::vector<Task> open{{0, 0, faces, 0}};
    while (!open.empty()) {
        const auto [node, begin, end, depth] = open.back();
        open.pop_back();
        Bounds bounds;
        for (std::uint32_t i = begin; i < end; ++i) bounds.add(boxes_[order_[i]]);
        nodes_[node] = {box_around(bounds.low, bounds.high), begin, end - begin};
        if (end - begin <= leaf_size) continue;
        // Unbalanced cuts may serve the search, but the search's stack is finite.
        constexpr int free_levels = 24;
        std::uint32_t middle = begin + (end - begin) / 2;
        if (depth < free_levels) middle = split(begin, end);
        const auto children = static_cast<std::uint32_t>(nodes_.size());
        nodes_[node].first = children;
        nodes_[node].count = 0;
        nodes_.resize(nodes_.size() + 2);
        open.push_back({children, begin, middle, depth + 1});
        open.push_back({children + 1, middle, end, depth + 1});
    }
}

/// Parts the faces of a node in two; where no cut does, in the middle of the list.
std::uint32_t FaceHierarchy::split(std::uint32_t begin, std::uint32_t end) {
    glm::dvec3 low(INFINITY), high(-INFINITY);
    for (std::uint32_t i = begin; i < end; ++i) {
        low = glm::min(low, glm::dvec3(boxes_[order_[i]].centre));
        high = glm::max(high, glm::dvec3(boxes_[order_[i]].centre));
    }
    const glm::dvec3 size = high - low;
    Slots best_slots{0, 0, 0, {}, {}};
    Slots::Cut best;
    for (int axis = 0; axis < 3; ++axis) {
        if (!(size[axis] > 0)) continue;
        Slots slots{axis, low[axis], Slots::count / size[axis], {}, {}};
        for (std::uint32_t i = begin; i < end; ++i) slots.add(boxes_[order_[i]]);
        const Slots::Cut cut = slots.best_cut();
        if (cut.cost < best.cost) best = cut, best_slots = slots;
    }
    if (best.slot < 0) return begin + (end - begin) / 2;
    const auto right = std::partition(
        order_.begin() + begin, order_.begin() + end,
        [&](std::uint32_t face) { return best_slots.slot(boxes_[face]) <= best.slot; });
    return static_cast<std::uint32_t>(right - order_.begin());
}

}  // namespace povpreview
