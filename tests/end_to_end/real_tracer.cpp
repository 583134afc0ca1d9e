// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/end_to_end/real_tracer.h"

#include <stdlib.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <numeric>
#include <random>

#include "adapter/povray_options.h"
#include "core/error.h"

namespace povpreview {

namespace fs = std::filesystem;

std::string real_tracer() {
    if (const char* named = std::getenv("POVPREVIEW_TRACER")) return named;
    return fs::exists(TRACER_BESIDE) ? TRACER_BESIDE : "";
}

WorkFolder::WorkFolder() {
    std::string name = (fs::temp_directory_path() / "povpreview-test-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
        throw Error(Exit::usage, "cannot make a folder", name, "is the disk full?");
    path_ = name;
}

WorkFolder::~WorkFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

fs::path WorkFolder::write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name) << text;
    return path_ / name;
}

TracedImage trace_pixels(const std::vector<std::string>& words, RayKind kind, Parts parts,
                         unsigned seed, Rung rung, std::chrono::seconds limit) {
    const PovrayOptions options = read_povray_options(words);
    PovrayOracle oracle({.program = real_tracer(), .arguments = options.tracer_arguments()});
    const SceneDescription& scene = oracle.wait_for_scene(nullptr, nullptr);
    TracedImage image{scene.width, scene.height, {}};
    const std::size_t count = static_cast<std::size_t>(image.width) * image.height;

    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::shuffle(order.begin(), order.end(), std::mt19937(seed));
    std::vector<Request> requests;
    for (const std::size_t pixel : order)
        requests.push_back({{static_cast<double>(pixel % image.width) + .5,
                             static_cast<double>(pixel / image.width) + .5},
                            kind,
                            rung});
    oracle.submit(requests, parts);

    const auto deadline = std::chrono::steady_clock::now() + limit;
    std::vector<Sample> answers;
    while (answers.size() < count) {
        oracle.collect(answers, std::chrono::milliseconds(20));
        if (std::chrono::steady_clock::now() > deadline)
            throw Error(Exit::tracer, "samples stay out", options.scene, "");
    }
    image.samples.resize(count);
    for (std::size_t i = 0; i < count; ++i) image.samples[order[i]] = answers[i];
    return image;
}

}  // namespace povpreview
