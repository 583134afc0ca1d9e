// SPDX-License-Identifier: AGPL-3.0-or-later
//
// time_to_l1 REFERENCE.png SECONDS METHOD... -- [POV-Ray options] SCENE.pov
//
// Asks: how soon does each method come to an error (L1 against the reference, by povray without
// anti-aliasing), where `povpreview compare` takes minutes to measure all that it measures? Runs
// each method for so many seconds and prints comma-separated values, a line a method: the seconds
// from the end of the parse to its first picture and to each of five errors; empty: not reached.
// survey.py runs it on many scenes.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/error_measures.h"
#include "display/image_file.h"
#include "display/offscreen.h"
#include "display/program/interrupt.h"
#include "display/program/method_run.h"

namespace {

using namespace povpreview;

constexpr double never = std::numeric_limits<double>::infinity();
/// The first is what any picture has come to.
constexpr double levels[] = {never, .1, .05, .02, .01, .005};
/// Samples that make a first picture: as many as are traced in a few milliseconds.
constexpr std::size_t first_picture = 42;

std::vector<Moment> run(const std::string& method, const ComparedScene& scene, double seconds) {
    CompareOptions options;
    options.time = seconds;
    ProgressLine line;
    return run_method(method, scene, options, line).moments;
}

/// When the error fell to each level for good, between two looks on logarithmic axes.
std::vector<double> reached(const std::vector<Moment>& moments, const Image& reference,
                            Offscreen& offscreen) {
    std::vector<double> times(std::size(levels), never);
    double error_before = 1, time_before = moments.front().standing.time_s;
    for (const Moment& moment : moments) {
        if (moment.standing.full < first_picture) continue;
        const double time = moment.standing.time_s;
        const Image image = offscreen.render(moment.picture, reference.width, reference.height);
        const double error = std::max(1e-6, measure_error(image.pixels, reference.pixels).l1);
        for (std::size_t i = 0; i < times.size(); ++i) {
            if (error > levels[i]) {
                times[i] = never;
            } else if (times[i] == never) {
                const double part = error_before > levels[i] ? std::log(error_before / levels[i]) /
                                                                   std::log(error_before / error)
                                                             : 1;
                times[i] = time_before * std::pow(time / time_before, part);
            }
        }
        error_before = error;
        time_before = time;
    }
    return times;
}

void print(const char* method, const std::vector<double>& times) {
    std::printf("%s", method);
    for (const double time : times)
        if (time == never)
            std::printf(",");
        else
            std::printf(",%.6g", time);
    std::printf("\n");
}

}  // namespace

int main(int argc, char** argv) {
    const auto end_of_methods = std::find_if(
        argv, argv + argc, [](const char* word) { return std::strcmp(word, "--") == 0; });
    if (end_of_methods - argv < 4 || argv + argc - end_of_methods < 2) {
        std::fprintf(stderr,
                     "time_to_l1 REFERENCE.png SECONDS METHOD... -- [POV-Ray options] SCENE.pov\n");
        return 2;
    }
    catch_interrupts();
    try {
        ComparedScene scene;
        scene.words.assign(end_of_methods + 1, argv + argc);
        scene.reference = read_image(argv[1]);
        Offscreen offscreen(open_offscreen());
        std::printf("method,first,.1,.05,.02,.01,.005\n");
        for (char** method = argv + 3; method < end_of_methods; ++method)
            print(*method,
                  reached(run(*method, scene, std::atof(argv[2])), scene.reference, offscreen));
    } catch (const povpreview::Error& error) {
        std::fprintf(stderr, "time_to_l1: %s\n", error.what());
        return static_cast<int>(error.exit());
    }
}
