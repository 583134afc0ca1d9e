// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/engine.h"

#include <fmt/format.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>

#include "adapter/povray_oracle.h"
#include "adapter/stock_povray.h"
#include "core/error.h"
#include "display/program/tracer_program.h"

namespace povpreview {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

/// A folder of its own, gone at the end.
class TemporaryFolder {
   public:
    TemporaryFolder() {
        std::string name = (fs::temp_directory_path() / "povpreview-XXXXXX").string();
        if (!mkdtemp(name.data()))
            throw Error(Exit::usage, "cannot make a folder for a while", name,
                        "name another place by the environment variable TMPDIR");
        path_ = name;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    const fs::path& path() const { return path_; }

   private:
    fs::path path_;
};

StockPicture stock_picture(const ReferenceJob& job, const std::string& output) {
    StockPicture result{.output = output, .antialias = job.antialias, .frame = job.frame};
    if (job.format == FileFormat::png8) result.type = StockPicture::Type::png8;
    if (job.format == FileFormat::exr_half) result.type = StockPicture::Type::exr;
    return result;
}

fs::path log_of(const ReferenceJob& job) { return fs::path(job.record).replace_extension(".log"); }

/// The only file in a folder: of an animation's frame POV-Ray puts the number in the name.
std::vector<unsigned char> only_file(const fs::path& folder) {
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        std::ifstream stream(entry.path(), std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }
    return {};
}

std::optional<EnginePicture> render_by_stock(const ReferenceJob& job,
                                             const std::function<bool()>& stop, FileWatch& watch) {
    const auto run = [&](const std::string& output) {
        return render_by_stock_povray(job.povray.stock_arguments(stock_picture(job, output)),
                                      log_of(job), stop, &watch);
    };
    std::optional<std::vector<unsigned char>> file;
    if (job.format == FileFormat::exr_half) {
        // POV-Ray has to seek in these. Where it may write, its own configuration says: mostly
        // /tmp.
        const TemporaryFolder folder;
        file = run(folder.path() / "picture.exr");
        if (file) file = only_file(folder.path());
    } else {
        file = run("-");
    }
    if (!file) return std::nullopt;
    return EnginePicture{std::move(*file), ""};
}

/// Samples at all pixels' centres, or nothing if stopped.
std::optional<Image> all_pixels(PovrayOracle& oracle, const SceneDescription& scene,
                                const std::function<bool()>& stop) {
    constexpr int band_rows = 16;  // ordered at once; the next is ordered before this one has come
    Image image(scene.width, scene.height);
    std::vector<Sample> samples;
    std::size_t ordered = 0, come = 0;
    for (int row = 0; come < image.pixels.size();) {
        const std::size_t band = std::size_t(band_rows) * scene.width;
        while (row < scene.height && ordered - come <= band) {
            std::vector<Request> requests;
            for (const int end = std::min(row + band_rows, scene.height); row < end; ++row)
                for (int x = 0; x < scene.width; ++x) requests.push_back({{x + .5, row + .5}});
            oracle.submit(requests, Parts::colour);
            ordered += requests.size();
        }
        samples.clear();
        oracle.collect(samples, 20ms);
        for (const Sample& sample : samples) {
            if (sample.failed)
                throw Error(Exit::scene,
                            oracle.faults().empty() ? "a sample failed" : oracle.faults().front(),
                            "", "render it by --engine stock");
            image.pixels[come++] = sample.colour;
        }
        if (stop()) return std::nullopt;
    }
    return image;
}

std::optional<EnginePicture> render_by_tracer(const ReferenceJob& job,
                                              const std::function<bool()>& stop, FileWatch& watch) {
    try {
        PovrayOracle oracle({.program = tracer_program(),
                             .arguments = job.povray.tracer_arguments({.frame = job.frame}),
                             .geometry = false,
                             .watch = &watch});
        const SceneDescription& scene = oracle.wait_for_scene(nullptr, stop);
        if (scene.antialias && job.antialias)
            throw Error(Exit::scene, "the tracer does not anti-alias", "",
                        "leave +A away or render by --engine stock");
        const std::optional<Image> image = all_pixels(oracle, scene, stop);
        if (!image) return std::nullopt;
        return EnginePicture{encoded_image(*image, job.format),
                             "POV-Ray " + oracle.tracer().povray + " as povpreview's tracer"};
    } catch (const Error& error) {
        if (error.exit() == Exit::interrupted) return std::nullopt;
        throw;
    }
}

}  // namespace

std::optional<EnginePicture> render_complete(const ReferenceJob& job,
                                             const std::function<bool()>& stop, FileWatch& watch) {
    return job.engine == Engine::stock ? render_by_stock(job, stop, watch)
                                       : render_by_tracer(job, stop, watch);
}

fs::path engine_program(Engine engine) {
    if (engine == Engine::tracer) return tracer_program();
    const char* path = std::getenv("PATH");
    std::istringstream folders(path ? path : "/usr/local/bin:/usr/bin:/bin");
    for (std::string folder; std::getline(folders, folder, ':');) {
        const fs::path file = fs::path(folder.empty() ? "." : folder) / "povray";
        if (access(file.c_str(), X_OK) == 0) return file;
    }
    throw Error(Exit::usage, "there is no such program", "povray",
                "install Debian's package povray");
}

std::string engine_command(const ReferenceJob& job) {
    const std::vector<std::string> words = job.engine == Engine::stock
                                               ? job.povray.stock_arguments(stock_picture(job, "-"))
                                               : job.povray.tracer_arguments({.frame = job.frame});
    return fmt::format("{} {}", job.engine == Engine::stock ? "povray" : "povpreview-tracer",
                       fmt::join(words, " "));
}

}  // namespace povpreview
