// SPDX-License-Identifier: AGPL-3.0-or-later
//
// time_to_l1 REFERENCE.png SECONDS METHOD... -- [POV-Ray options] SCENE.pov
//
// Asks: how soon does each method come to an error (L1 against the reference, by povray without
// anti-aliasing) in large pictures, where `povpreview compare` takes minutes to measure all that it
// measures? Runs each method for so many seconds and prints the seconds of the first one to each of
// five errors, and how many times as long the others took; "-": not reached. See dear.sh.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
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

constexpr double levels[] = {.1, .05, .02, .01, .005};
constexpr double never = std::numeric_limits<double>::infinity();

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

void print(const char* name, const std::vector<std::vector<double>>& times) {
    std::printf("%-16s", name);
    for (std::size_t i = 0; i < std::size(levels); ++i) {
        const double first = times.front()[i];
        if (first == never)
            std::printf(" | -");
        else
            std::printf(" | %.3f", first);
        for (std::size_t m = 1; m < times.size(); ++m)
            if (first == never || times[m][i] == never)
                std::printf(" %s", times[m][i] == never ? "-" : "ahead");
            else
                std::printf(" %.2f", times[m][i] / first);
    }
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
        std::vector<std::vector<double>> times;
        for (char** method = argv + 3; method < end_of_methods; ++method)
            times.push_back(
                reached(run(*method, scene, std::atof(argv[2])), scene.reference, offscreen));
        print(std::filesystem::path(scene.words.back()).stem().c_str(), times);
    } catch (const povpreview::Error& error) {
        std::fprintf(stderr, "time_to_l1: %s\n", error.what());
        return static_cast<int>(error.exit());
    }
}
