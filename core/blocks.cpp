// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/blocks.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace povpreview {
namespace {

constexpr int uniform_size = 8;          ///< rview's psample, pixels
constexpr float most_difference = .15f;  ///< rview's maxdiff, share of the smaller value

/// Whether two colours differ enough to split: in any channel, by more than 15 % of the other.
bool differ(const glm::vec3& a, const glm::vec3& b) {
    for (int i = 0; i < 3; ++i) {
        if (a[i] - b[i] > most_difference * b[i] || b[i] - a[i] > most_difference * a[i])
            return true;
    }
    return false;
}

/// Where the blocks of a level of the tree begin along one side of the image, pixels.
std::vector<int> lattice(int side, int depth) {
    std::vector<int> starts;
    for (std::int64_t i = 0; i < std::int64_t{1} << depth; ++i) {
        const auto start = int(i * side >> depth);
        if (starts.empty() || starts.back() != start) starts.push_back(start);
    }
    return starts;
}

}  // namespace

Blocks::Blocks(int width, int height, std::uint32_t seed) : canvas_(width, height), random_(seed) {
    assert(width >= 1 && height >= 1);
    assert(std::max(width, height) <= std::numeric_limits<Coordinate>::max());
    nodes_.push_back({0, 0, Coordinate(width), Coordinate(height), 0, 0});
    ask(0);
}

void Blocks::ask(std::uint32_t node) {
    Node& n = nodes_[node];
    // Scaling 32 random bits favours no pixel by more than 2^-16, and is the same on every machine,
    // which the standard's distributions are not.
    const auto pick = [&](int from, int to) {
        return Coordinate(from + int((std::uint64_t(random_()) * std::uint64_t(to - from)) >> 32));
    };
    n.x = pick(n.x0, n.x1);
    n.y = pick(n.y0, n.y1);
    wanted_.push_back(node);
}

/// Makes four children around the middle:
///
///     0 | 1
///     --+--      y grows downwards
///     2 | 3
void Blocks::split(std::uint32_t node) {
    const Node parent = nodes_[node];
    const auto mx = Coordinate((parent.x0 + parent.x1) / 2);
    const auto my = Coordinate((parent.y0 + parent.y1) / 2);
    const auto first = static_cast<std::uint32_t>(nodes_.size());
    nodes_[node].children = first;
    nodes_.push_back({parent.x0, parent.y0, mx, my, 0, 0});
    nodes_.push_back({mx, parent.y0, parent.x1, my, 0, 0});
    nodes_.push_back({parent.x0, my, mx, parent.y1, 0, 0});
    nodes_.push_back({mx, my, parent.x1, parent.y1, 0, 0});
    const std::uint32_t heir = first + (parent.x >= mx ? 1 : 0) + (parent.y >= my ? 2 : 0);
    for (std::uint32_t child = first; child < first + 4; ++child) {
        if (child == heir) {
            nodes_[child].x = parent.x;
            nodes_[child].y = parent.y;
            nodes_[child].colour = parent.colour;
        } else if (!nodes_[child].empty()) {
            ask(child);
        }
    }
}

std::uint32_t Blocks::child_at(const Node& n, int x, int y) const {
    const int mx = (n.x0 + n.x1) / 2, my = (n.y0 + n.y1) / 2;
    return n.children + (x >= mx ? 1 : 0) + (y >= my ? 2 : 0);
}

std::uint32_t Blocks::find(int x, int y, std::size_t count) const {
    std::uint32_t node = 0;
    for (int depth = 0; depth < depth_; ++depth) {
        const Node& n = nodes_[node];
        if (n.children == 0 || n.children >= count) break;
        node = child_at(n, x, y);
    }
    return node;
}

void Blocks::split_all_leaves() {
    const auto count = static_cast<std::uint32_t>(nodes_.size());
    for (std::uint32_t node = 0; node < count; ++node) {
        const Node& n = nodes_[node];
        if (n.children == 0 && !n.empty() && !n.is_pixel()) split(node);
    }
}

void Blocks::split_where_different() {
    const std::size_t count = nodes_.size();
    const auto compare = [&](std::uint32_t a, std::uint32_t b) {
        if (a == b || !differ(nodes_[a].colour, nodes_[b].colour)) return;
        for (const std::uint32_t node : {a, b}) {
            if (nodes_[node].children == 0 && !nodes_[node].is_pixel()) split(node);
        }
    };
    const std::vector<int> columns = lattice(canvas_.width(), depth_);
    std::vector<std::uint32_t> above, row(columns.size());
    for (const int y : lattice(canvas_.height(), depth_)) {
        for (std::size_t i = 0; i < row.size(); ++i) row[i] = find(columns[i], y, count);
        for (std::size_t i = 0; i < above.size(); ++i) compare(above[i], row[i]);
        for (std::size_t i = 1; i < row.size(); ++i) compare(row[i - 1], row[i]);
        above = row;
    }
}

bool Blocks::start_pass() {
    const int side = std::max(canvas_.width(), canvas_.height());
    while (wanted_.empty()) {
        const int grid = 1 << depth_;
        if (grid >= side) {
            const std::size_t before = nodes_.size();
            split_all_leaves();
            all_asked_ = nodes_.size() == before;
            if (all_asked_) return false;
        } else if (side > uniform_size * grid) {
            split_all_leaves();
            ++depth_;
        } else {
            if (!outstanding_.empty()) return false;
            split_where_different();
            ++depth_;
        }
    }
    return true;
}

std::optional<Request> Blocks::next() {
    if (wanted_.empty() && (all_asked_ || !start_pass())) return std::nullopt;
    const std::uint32_t node = wanted_.front();
    wanted_.pop_front();
    outstanding_.push_back(node);
    return Request{pixel_centre(nodes_[node].x, nodes_[node].y)};
}

void Blocks::accept(const Sample& sample) {
    assert(!outstanding_.empty());
    std::uint32_t node = outstanding_.front();
    outstanding_.pop_front();
    samples_.push_back(sample.position);
    // The block may have been split while its answer was on the way. Its descendants were asked for
    // later, so it still stands for all of them; those that inherit its sample are told.
    const Node n = nodes_[node];
    canvas_.fill(n.x0, n.y0, n.x1, n.y1, sample.colour);
    nodes_[node].colour = sample.colour;
    while (nodes_[node].children != 0) {
        node = child_at(nodes_[node], n.x, n.y);
        nodes_[node].colour = sample.colour;
    }
}

bool Blocks::done() const {
    return samples_.size() == std::size_t(canvas_.width()) * std::size_t(canvas_.height());
}

Picture Blocks::picture(Overlay overlay) const {
    Picture picture = canvas_.picture();
    if (overlay == Overlay::samples) picture.samples = samples_;
    return picture;
}

Statistics Blocks::statistics() const {
    Statistics statistics;
    statistics.filled = samples_.size();
    return statistics;
}

}  // namespace povpreview
