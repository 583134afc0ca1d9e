// SPDX-License-Identifier: AGPL-3.0-or-later
//
// The mesh previewer's first samples: where they are, and what they tell of what the rest will
// cost.
#include <algorithm>
#include <cmath>

#include "core/mesh_previewer.h"

namespace povpreview {

namespace {

/// An albedo ray against a full sample, where what rays cost is not looked at; half of the scenes
/// have it for .6, a quarter for .25.
constexpr double usual_albedo_price = .25;

}  // namespace

/// A regular grid from border to border, asked for in levels from coarse to fine, so that even its
/// first answers are spread over the image.
std::vector<Pixel> MeshPreviewer::first_grid() {
    const std::vector<int> columns = grid_lines(width_), rows = grid_lines(height_);
    std::vector<Pixel> grid;
    std::vector<bool> taken(squares_.pixels());
    std::size_t step = 1;
    while (step < std::max(columns.size(), rows.size())) step *= 2;
    for (; step >= 1; step /= 2) {
        early_samples_ = grid.size();
        for (std::size_t j = 0; j < rows.size(); ++j)
            for (std::size_t i = 0; i < columns.size(); ++i) {
                if ((i % step && i + 1 != columns.size()) || (j % step && j + 1 != rows.size()))
                    continue;
                const auto p = static_cast<Pixel>(rows[j] * width_ + columns[i]);
                if (!taken[p]) grid.push_back(p);
                taken[p] = true;
            }
    }
    return grid;
}

/// Where the grid's lines are along one side of the image. Should the lattice take over, its first
/// squares have their corners on every other of them.
std::vector<int> MeshPreviewer::grid_lines(int pixels) const {
    const double cell = std::max(2., options_.grid_cell * std::max(width_, height_));
    std::vector<int> lines;
    if (options_.lattice) {
        for (int at = 0; at < pixels - 1; at += lattice_side() / 2) lines.push_back(at);
        lines.push_back(pixels - 1);
        return lines;
    }
    const int cells = std::max(1, static_cast<int>(std::lround(pixels / cell)));
    for (int i = 0; i <= cells; ++i) lines.push_back(i * (pixels - 1) / cells);
    return lines;
}

/// Of the lattice's first squares, pixels: twice a cell of the grid, as powers of two go.
int MeshPreviewer::lattice_side() const {
    const double cell = options_.grid_cell * std::max(width_, height_);
    return 2 << std::max(1l, std::lround(std::log2(std::max(cell, 1.))));
}

/// The first samples tell what the rest will cost.
void MeshPreviewer::learn_cost(const Sample& sample) {
    if (cost_known()) return;
    grid_costs_.push_back(options_.by_cost ? sample.cost_ns : 0);
    if (grid_costs_.size() == early_samples_ && suit_lattice()) start_lattice();
    if (!cost_known()) return;
    const double full_ns =
        climb_.has_rungs() ? climb_.cost_ns(climb_.current()) : usual_cost(grid_costs_);
    plan_ = plan_at(full_ns);
    albedo_fetch_.set_price(options_.by_cost ? albedo_price_at(full_ns) : usual_albedo_price);
    if (suit_lattice()) start_lattice();
    // Nothing is spared for the sake of a lower rung's cost; the target's is learnt later.
    if (climb_.at_target()) return;
    plan_.edges = true;
    plan_.vertex_budget = plan_at(0).vertex_budget;
}

CostPlan MeshPreviewer::plan_at(double full_ns) const {
    return plan_by_cost(full_ns, squares_.pixels(), options_.threads);
}

double MeshPreviewer::albedo_price_at(double full_ns) const {
    return albedo_price(usual_cost(trial_costs_), full_ns, options_.threads);
}

bool MeshPreviewer::seem_cheap() const { return plan_at(usual_cost(grid_costs_)).lattice; }

/// Where there are rungs, the target's cost decides; see reach_target().
bool MeshPreviewer::suit_lattice() const {
    return options_.lattice && !lattice_ && !climb_.has_rungs() && seem_cheap();
}

}  // namespace povpreview
