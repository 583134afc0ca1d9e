// SPDX-License-Identifier: AGPL-3.0-or-later
//
// What the mesh previewer does for a scene and what it leaves out, for those who ask why.
#include <algorithm>
#include <cstdio>

#include "core/mesh_previewer.h"

namespace povpreview {

namespace {

template <class... Values>
std::string text(const char* format, Values... values) {
    char line[160];
    std::snprintf(line, sizeof line, format, values...);
    return line;
}

}  // namespace

void MeshPreviewer::account(Pending::Use use, const Sample& sample) {
    Account& account = accounts_[static_cast<std::size_t>(use)];
    ++account.rays;
    account.nanoseconds += sample.cost_ns;
}

std::vector<Stage> MeshPreviewer::stages() const {
    if (!cost_known()) return {};
    return {triangulation_stage(), outline_stage(), edge_stage(),
            albedo_stage(),        filling_stage(), rising_stage()};
}

Stage MeshPreviewer::stage(std::string name, bool runs, std::string why,
                           std::initializer_list<Pending::Use> uses) const {
    Stage stage{.name = std::move(name), .runs = runs, .why = std::move(why)};
    for (Pending::Use use : uses) {
        const Account& account = accounts_[static_cast<std::size_t>(use)];
        stage.rays += account.rays;
        stage.tracer_s += double(account.nanoseconds) * 1e-9;
    }
    return stage;
}

double MeshPreviewer::vertex_share() const {
    return std::max(plan_.vertex_budget, double(grid_.size()) / double(squares_.pixels()));
}

Stage MeshPreviewer::triangulation_stage() const {
    if (lattice_) {
        Stage first = stage(refinement_stage_name, false,
                            text("a lattice serves samples of %.3g us as well: only the first %zu "
                                 "are vertices",
                                 plan_.sample_ns * 1e-3, grid_.size()),
                            {Pending::Use::vertex, Pending::Use::side});
        first.expected = double(grid_.size()) / double(squares_.pixels());
        return first;
    }
    Stage result =
        stage(refinement_stage_name, true,
              text(options_.by_cost ? "up to %.0f vertices, as samples of %.3g us deserve"
                                    : "up to %.0f vertices, whatever samples cost",
                   vertex_share() * double(squares_.pixels()), plan_.sample_ns * 1e-3),
              {Pending::Use::vertex, Pending::Use::side});
    result.expected = vertex_share();
    return result;
}

Stage MeshPreviewer::outline_stage() const {
    const double all_s = plan_.all_ns(squares_.pixels()) * 1e-9;
    const std::string why = !options_.constraints ? "the method is without constraints"
                            : plan_.outlines
                                ? text("all pixels take %.3g s of one thread", all_s)
                                : text("all pixels take only %.3g s of one thread", all_s);
    Stage result = stage("outlines by probes", options_.constraints && plan_.outlines, why,
                         {Pending::Use::probe});
    result.expected =
        result.runs ? options_.outline_floor + options_.outline_share * options_.outline_until : 0;
    return result;
}

Stage MeshPreviewer::edge_stage() const {
    const double all_s = plan_.all_ns(squares_.pixels()) * 1e-9;
    const bool runs = options_.constraints && !lattice_ && (plan_.edges || !detail_);
    const std::string why = !options_.constraints ? "the method is without constraints"
                            : plan_.edges ? text("all pixels take %.3g s of one thread", all_s)
                            : lattice_    ? "a lattice has no use for them"
                            : runs ? "the borders of surfaces are not known from an item buffer"
                                   : text(
                                         "all pixels take only %.3g s of one thread, and the "
                                         "borders of surfaces are known",
                                         all_s);
    Stage result = stage(edge_stage_name, runs, why, {});
    result.expected = 0;
    return result;
}

Stage MeshPreviewer::albedo_stage() const {
    const double price = albedo_fetch_.price();
    const bool runs = options_.detail && !lattice_ && albedo_fetch_.affordable();
    const std::string why =
        lattice_           ? "a lattice has no use for them"
        : !options_.detail ? "the method or the camera is without a DetailMap"
        : runs ? text("one costs %.2g of a full sample; where samples tell of a texture", price)
               : text("one costs %.2g of a full sample", price);
    Stage result = stage("albedo rays", runs, why, {Pending::Use::albedo});
    if (!result.runs) result.expected = 0;
    return result;
}

/// What was traced below the target, traced again.
Stage MeshPreviewer::rising_stage() const {
    std::string why = "nothing in the scene makes samples dear that could be left out";
    if (climb_.has_rungs()) {
        why.clear();
        for (const RungStanding& rung : climb_.standings())
            why += (why.empty() ? "" : ", ") + rung.name +
                   (rung.cost_ns > 0 ? text(" %.3g us", rung.cost_ns * 1e-3) : "") +
                   (rung.dropped ? " (gains nothing)" : "");
    }
    Stage result = stage("rising accuracy", climb_.has_rungs(), why, {Pending::Use::retrace});
    result.expected = 0;
    return result;
}

Stage MeshPreviewer::filling_stage() const {
    Stage result = lattice_
                       ? stage(lattice_stage_name, true, "samples are cheap", {Pending::Use::fill})
                       : stage("filling", true, "every pixel gets its own sample in the end",
                               {Pending::Use::fill});
    result.expected = 1 - (lattice_ ? *triangulation_stage().expected : vertex_share());
    return result;
}

}  // namespace povpreview
