// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <string>

#include "tests/stability/series.h"

namespace povpreview::stability {

/// The shares of the pixels sampled at which a case is looked at.
constexpr std::array shares{.01, .05, .25, 1.};

/// From one share to the next the error may grow by so much: a first few samples may hit by luck,
/// and samples just beside an edge move it to their side.
constexpr double growth_factor = 1.25, growth_step = .015;

/// A step of 8 bit: what a pixel of a completed picture may be off.
constexpr double pixel_step = 1.01 / 255;

/// Pixels that differ from the stock render's are rendered again by it, each alone: all of them, or
/// some of too many.
constexpr std::size_t all_alone = 400, some_alone = 20;

/// How a case went.
struct Outcome {
    std::array<double, shares.size()> l1{};  ///< against the stock render, display-encoded
    double worst = 0;                        ///< difference of any channel of the completed picture
    std::size_t contradicted = 0;  ///< samples that contradicted what was drawn without tracing
    double seconds = 0;            ///< of sampling, from parse to completion
    long peak_kib = 0;             ///< of the largest process
    std::string fault;             ///< the first check that failed; empty where all is well
    std::string note;              ///< what else there is to say
};

/// Previews the case by `mesh` in this process and checks it at each share: mesh and heap valid,
/// all pixels finite, the error not growing; and the completed picture against the stock render,
/// where that differs against what stock makes of the pixel alone.
/// Pictures are written to `keep`, unless that is empty.
Outcome check(const Case& one, bool full, const std::filesystem::path& keep);

/// check() in a process of its own (`program --one NAME`), so that death, hanging (`limit_s`) and
/// hunger (`limit_kib`) are outcomes too. Several at a time: most of their time they wait for
/// POV-Ray to start and end.
struct Limits {
    double limit_s;
    long limit_kib;
    unsigned jobs;
};
/// `report` is called for each, in their order, as soon as it and all before it are known.
void check_apart(const std::vector<Case>& all, bool full, const std::filesystem::path& keep,
                 const Limits& limits,
                 const std::function<void(const Case&, const Outcome&)>& report);

/// An outcome as a line for check_apart() to read.
std::string to_line(const Outcome& outcome);

}  // namespace povpreview::stability
