// SPDX-License-Identifier: AGPL-3.0-or-later
//
// stability [--full] [--jobs N] [--keep DIR] [CASE...]
//
// Does the preview stand whatever a scene does? Runs the cases of the families (scale.cpp and the
// files beside it), each in a process of its own, and prints a table: the parameter that makes a
// case hard, the mean error against the stock render from 1, 5, 25 and 100 % of the pixels, the
// worst difference of the completed picture, samples that contradicted what was drawn without
// tracing, seconds of sampling, the peak of memory, and the first check that failed (see check.h).
// --full takes 320x240 in place of 64x48, and every decade of every parameter. CASE is the
// beginning of a name, such as scale/ or light/count. Pictures are written to --keep.
#include <fmt/format.h>
#include <stdlib.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "core/error.h"
#include "display/program/folder.h"
#include "tests/end_to_end/real_tracer.h"
#include "tests/stability/check.h"

namespace povpreview::stability {
namespace {

struct Options {
    bool full = false;
    unsigned jobs = 8;
    std::filesystem::path keep;
    std::string one;
    std::vector<std::string> prefixes;
};

int check_one(const Options& options) {
    for (const Case& one : cases(true, {options.one}))
        if (one.name() == options.one) {
            std::fputs(to_line(check(one, options.full, options.keep)).c_str(), stdout);
            return 0;
        }
    throw Error(Exit::usage, "there is no such case", options.one, "see series.h");
}

void print_row(const Case& one, const Outcome& o) {
    const std::string name = one.name();
    const std::string verdict = !o.fault.empty() ? "FAILED: " + o.fault
                                : o.note.empty() ? "well"
                                                 : "well (" + o.note + ")";
    fmt::print("{:<34} {:<36} {:.4f} {:.4f} {:.4f} {:.4f} {:.3f} {:6} {:6.2f} {:5}  {}\n",
               name.substr(0, name.find('@')),
               fmt::format("{} = {:g}", one.series->parameter, one.value), o.l1[0], o.l1[1],
               o.l1[2], o.l1[3], o.worst, o.contradicted, o.seconds, o.peak_kib / 1024, verdict);
    std::fflush(stdout);
}

int check_all(const Options& options) {
    const std::vector<Case> all = cases(options.full, options.prefixes);
    if (!options.keep.empty()) make_folder(options.keep, "--keep");
    const Limits limits{options.full ? 600. : 60., 2048L * 1024, options.jobs};
    fmt::print("{:<34} {:<36} {:>6} {:>6} {:>6} {:>6} {:>5} {:>6} {:>6} {:>5}  {}\n", "case",
               "condition", "1%", "5%", "25%", "100%", "worst", "contra", "s", "MiB", "verdict");
    int failed = 0;
    check_apart(all, options.full, options.keep, limits,
                [&](const Case& one, const Outcome& outcome) {
                    print_row(one, outcome);
                    failed += !outcome.fault.empty();
                });
    fmt::print("{} cases, {} failed\n", all.size(), failed);
    return failed > 0 || all.empty() ? 1 : 0;
}

}  // namespace
}  // namespace povpreview::stability

int main(int argc, char** argv) {
    using namespace povpreview;
    stability::Options options;
    CLI::App app("Does the preview stand whatever a scene does? See tests/stability/main.cpp.");
    app.add_flag("--full", options.full, "320x240, and every decade");
    app.add_option("--jobs", options.jobs, "Cases at a time")->check(CLI::PositiveNumber);
    app.add_option("--keep", options.keep, "Write the pictures there");
    app.add_option("--one", options.one, "Check this case in this process");
    app.add_option("cases", options.prefixes, "Beginnings of names of cases");
    CLI11_PARSE(app, argc, argv);
    try {
        // What TracedScene goes by.
        setenv("POVPREVIEW_TRACER", real_tracer().c_str(), 0);
        return options.one.empty() ? stability::check_all(options) : stability::check_one(options);
    } catch (const std::exception& error) {
        fmt::print(stderr, "stability: {}\n", error.what());
        return 2;
    }
}
