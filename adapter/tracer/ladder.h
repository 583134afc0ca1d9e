// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <vector>

#include "backend/oracle/scene_facts.h"

namespace povpreview::tracer {

/// How a rung is traced, from the cheapest to the truth.
enum class RungKind {
    /// Lights are points, media take two samples an interval, nothing is out of focus; no
    /// radiosity, photons or subsurface scattering.
    sketch,
    /// All but what is being prepared: no photons, and of radiosity what its pretrace has found so
    /// far, which depends on the moment.
    unprepared,
    /// What POV-Ray renders.
    target
};

/// The rungs that a scene's features (SceneFacts::features) make, cheapest first; the last one is
/// the target, and the only one of a scene in which nothing is dear.
std::vector<RungKind> rungs_of(const std::set<std::string>& features);

/// Whether the target needs photons or a radiosity pretrace.
bool needs_preparation(const std::set<std::string>& features);

/// `features`: of the scene, before anything is prepared.
std::vector<RungFacts> describe_rungs(const std::vector<RungKind>& rungs,
                                      const std::set<std::string>& features);

}  // namespace povpreview::tracer
