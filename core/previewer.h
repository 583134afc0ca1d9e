// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "core/detail/drawn_detail.h"
#include "core/image_edge.h"
#include "core/oracle.h"
#include "core/picture.h"
#include "core/rung_climb.h"
#include "core/stage.h"

namespace povpreview {

/// What to copy into a Picture besides colours.
enum class Overlay { none, mesh, edges, samples };

/// Counts for the log.
struct Statistics {
    std::size_t vertices = 0;     ///< of the triangulation
    std::size_t constraints = 0;  ///< constrained edges in it
    std::size_t filled = 0;       ///< pixels that show their own full sample
    /// The constrained edges by EdgeKind.
    std::array<std::size_t, edge_kinds> constraints_by_kind{};
    // Of the DetailMap: pixels whose item is known, and whose albedo; samples that contradicted it.
    std::size_t items = 0, albedos = 0, contradicted = 0;
    /// Of the ladder of accuracy, cheapest first; empty where there is only the target.
    std::vector<RungStanding> rungs{};
    std::size_t below_target = 0;  ///< samples shown that are still to be traced at the target
};

/// A way to choose samples and to make a picture of them. A pure state machine: it says which
/// sample it wants next and is told the answers in the same order; it knows neither clock, nor
/// tracer, nor display, and equal answers make equal pictures.
class Previewer {
   public:
    virtual ~Previewer() = default;

    virtual std::string_view name() const = 0;
    /// The parts of full samples that it uses of those it asks for now.
    virtual Parts parts() const = 0;

    /// The next sample wanted; nothing while it must wait for answers, or when it is done.
    virtual std::optional<Request> next() = 0;
    /// The answer to the oldest request not yet answered.
    virtual void accept(const Sample& sample) = 0;
    /// Whether it has a use for discontinuity edges known without tracing, or still has; else none
    /// need be found.
    virtual bool wants_edges() const { return false; }
    /// Such edges, heaviest first. May come at any time and more than once, best after the items:
    /// those make some edges superfluous.
    virtual void accept_edges(std::vector<EdgeChain>&&) {}
    /// Whether it has a use for what is seen in each pixel, known without tracing, or still has.
    virtual bool wants_items() const { return false; }
    /// That, of the size of the picture. May come at any time, and again when more is known of it.
    virtual void accept_items(const DrawnDetail&) {}
    /// A rung of its ladder is ready that was not, or its samples have become better.
    virtual void accept_ready(Rung) {}
    /// It has nothing to ask for, no answer outstanding, and waits for a rung to become ready.
    virtual bool waits() const { return false; }
    /// Every pixel shows a full sample of its own centre, and no answer is outstanding.
    virtual bool done() const = 0;

    /// The picture as it stands. May be called at any time after the first answer.
    virtual Picture picture(Overlay overlay) const = 0;
    virtual Statistics statistics() const = 0;
    /// What it does for this scene and what it leaves out, as soon as the first samples have told
    /// what rays cost; empty before that, and for methods that have no such choice.
    virtual std::vector<Stage> stages() const { return {}; }
};

}  // namespace povpreview
