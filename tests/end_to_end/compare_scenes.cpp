// SPDX-License-Identifier: AGPL-3.0-or-later
//
// compare_scenes SCENE... : how far the tracer's samples are from stock POV-Ray's pixels, a line a
// scene. Question: which of the scenes that people have are exact, and how far off are the others
// (jitter, radiosity), whose image depends on order and threads in POV-Ray itself? Try it on those
// of the package povray-examples.
#include <cstdio>

#include "core/error.h"
#include "tests/end_to_end/image_of_samples.h"

int main(int argc, char** argv) {
    using namespace povpreview;
    const std::filesystem::path start = std::filesystem::current_path();
    int exact = 0, compared = 0;
    std::printf("%8s %10s %8s %7s  scene\n", "worst", "differing", "rmse", "failed");
    for (int i = 1; i < argc; ++i) {
        const std::filesystem::path scene = start / argv[i];
        try {
            const WorkFolder folder;
            // Scenes find their own files beside them.
            std::filesystem::current_path(scene.parent_path());
            const std::vector<std::string> words{scene, "+W160", "+H120", "+WT2"};
            const TracedImage image = trace_pixels(words, RayKind::full, Parts::colour, 1);
            const Difference difference = compare_with_stock(image, words, folder);
            std::printf("%8d %9.3f%% %8.5f %7zu  %s\n", difference.worst,
                        100.0 * static_cast<double>(difference.differing) /
                            static_cast<double>(image.samples.size()),
                        difference.root_mean_square, difference.failed, argv[i]);
            exact += difference.worst <= 1;
            ++compared;
        } catch (const Error& error) {
            std::printf("%36s  %s: %s\n", "-", argv[i], error.what());
        }
        std::fflush(stdout);
    }
    std::printf("%d of %d exact\n", exact, compared);
    return compared > 0 ? 0 : 1;
}
