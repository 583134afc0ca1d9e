// SPDX-License-Identifier: AGPL-3.0-or-later
//
// compare_items [-v] SCENE... : how the item buffer agrees with what albedo rays say at every pixel
// of 320x240, a line a scene. Question: may what is drawn without rays stand for what rays would
// find, and what does it cost against them? Try it on tests/bench/detail_scenes.txt. With -v also
// the first pixels that do not agree.
//
//     known      pixels whose surface is known
//     inner      of the known ones whose eight neighbours show what they do: the same surface
//     at edges   of all known ones, those that show a neighbouring pixel's surface instead
//     beyond     ... and those that show neither
//     albedo     pixels whose albedo is drawn; of these, right within .01: agree
//     plain      pixels said to be of one colour all over; of these, of their surface's, or in a
//                mirror of the surface's that is seen in it: agree
//     mirror     pixels of which it is known what a mirror shows there, of probes; of these, of
//     inner
//                ones as above, right: agree; and those at edges and beyond that are not: off
//     ms         painting took, of all processors together; of full samples, of albedo rays: as a
//                share of the time that a thread takes to trace as many
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <glm/geometric.hpp>
#include <map>
#include <string>

#include "adapter/geometry.h"
#include "adapter/povray_options.h"
#include "adapter/straight_camera.h"
#include "core/detail/item_painter.h"
#include "core/error.h"
#include "tests/end_to_end/real_tracer.h"

namespace {

using namespace povpreview;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point since) {
    return std::chrono::duration<double>(Clock::now() - since).count();
}

double share(std::size_t part, std::size_t all) {
    return all == 0 ? 0 : static_cast<double>(part) / static_cast<double>(all);
}

struct Agreement {
    std::size_t pixels = 0, known = 0;
    std::size_t inner = 0, inner_right = 0;
    std::size_t at_edges = 0, beyond = 0;
    std::size_t images = 0, images_right = 0;
    std::size_t plain = 0, plain_right = 0;
    std::size_t mirrored = 0, mirrored_inner = 0, mirrored_inner_right = 0, mirrored_off = 0;
    bool reaches(double target) const {
        return (inner == 0 || share(inner_right, inner) >= target) &&
               (mirrored_inner == 0 || share(mirrored_inner_right, mirrored_inner) >= target);
    }
};

struct Line {
    Agreement agreement;
    double painting = 0, of_full = 0, of_albedo = 0;
};

/// Painted and traced side by side; `probes` are empty if there are no mirrors.
class Comparison {
   public:
    Comparison(const ItemBuffer& painted, const std::vector<Sample>& traced,
               const std::vector<Sample>& probes, int verbosity)
        : painted_(painted), traced_(traced), probes_(probes), left_to_tell_(verbosity) {}

    Agreement compare() {
        for (int y = 0; y < painted_.height; ++y)
            for (int x = 0; x < painted_.width; ++x) {
                compare(x, y);
                if (!probes_.empty()) compare_mirrored(x, y);
            }
        return result_;
    }

   private:
    const Sample& traced(int x, int y) const {
        return traced_[static_cast<std::size_t>(y * painted_.width + x)];
    }

    void compare(int x, int y) {
        const Sample& sample = traced(x, y);
        if (sample.failed) return;
        ++result_.pixels;
        const auto at = static_cast<std::size_t>(y * painted_.width + x);
        const std::uint32_t surface = painted_.surfaces[at];
        if (surface == ItemBuffer::unknown) return;
        ++result_.known;
        bool inner = true, near = false;
        for (int j = std::max(y - 1, 0); j <= std::min(y + 1, painted_.height - 1); ++j)
            for (int i = std::max(x - 1, 0); i <= std::min(x + 1, painted_.width - 1); ++i) {
                inner = inner && traced(i, j).surface == sample.surface;
                near = near || traced(i, j).surface == surface;
            }
        const bool right = surface == sample.surface;
        result_.inner += inner;
        result_.inner_right += inner && right;
        if (right) return compare_albedo(x, y, painted_.kinds[at]);
        ++(near ? result_.at_edges : result_.beyond);
        if (!near || inner) tell(x, y, surface);
    }

    void compare_mirrored(int x, int y) {
        const auto at = static_cast<std::size_t>(y * painted_.width + x);
        const std::uint32_t surface = painted_.surfaces[at], mirrored = painted_.mirrored[at];
        const Sample& sample = probes_[at];
        if (sample.failed || mirrored == ItemBuffer::unknown || surface != sample.surface ||
            !std::binary_search(painted_.mirrors.begin(), painted_.mirrors.end(), surface))
            return;
        ++result_.mirrored;
        bool inner = true;
        for (int j = std::max(y - 1, 0); j <= std::min(y + 1, painted_.height - 1); ++j)
            for (int i = std::max(x - 1, 0); i <= std::min(x + 1, painted_.width - 1); ++i) {
                const Sample& near = probes_[static_cast<std::size_t>(j * painted_.width + i)];
                inner = inner && near.surface == sample.surface &&
                        near.reflected_surface == sample.reflected_surface;
            }
        const bool right = mirrored == sample.reflected_surface;
        result_.mirrored_inner += inner;
        result_.mirrored_inner_right += inner && right;
        result_.mirrored_off += !right;
        if (!right && left_to_tell_-- > 0)
            std::printf("        (%d, %d): mirror %08x shows %08x, said %08x%s\n", x, y, surface,
                        sample.reflected_surface, mirrored, inner ? "" : ", at an edge");
    }

    void compare_albedo(int x, int y, Look::Kind kind) {
        const Sample& sample = traced(x, y);
        const auto at = static_cast<std::size_t>(y * painted_.width + x);
        if (kind == Look::Kind::image || kind == Look::Kind::pattern) {
            ++result_.images;
            const float off = glm::distance(painted_.albedos[at], sample.albedo);
            result_.images_right += off <= .01f;
            if (!(off <= .01f)) tell(x, y, sample.surface, off);
        } else if (kind == Look::Kind::plain && sample.surface != 0) {
            ++result_.plain;
            const std::pair seen{sample.surface, sample.reflected_surface};
            const auto first = plain_.try_emplace(seen, sample.albedo).first->second;
            const float off = glm::distance(first, sample.albedo);
            result_.plain_right += off <= .001f;
            if (!(off <= .001f)) tell(x, y, sample.surface, off);
        }
    }

    void tell(int x, int y, std::uint32_t said, float off = 0) {
        if (left_to_tell_-- <= 0) return;
        std::printf("        (%d, %d): hit %08x, said %08x, albedo off by %g\n", x, y,
                    traced(x, y).surface, said, off);
    }

    const ItemBuffer& painted_;
    const std::vector<Sample>& traced_;
    const std::vector<Sample>& probes_;
    int left_to_tell_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, glm::vec3> plain_;
    Agreement result_;
};

/// Samples at the centres of every n-th pixel in both directions; fewer when it takes too long.
std::vector<Sample> trace(PovrayOracle& oracle, const DrawableScene& scene, RayKind kind,
                          int every) {
    constexpr double patience = 40;  // seconds
    std::vector<Request> requests;
    for (int y = every / 2; y < scene.polygons.height; y += every)
        for (int x = every / 2; x < scene.polygons.width; x += every)
            requests.push_back({{x + .5, y + .5}, kind});
    std::vector<Sample> samples;
    oracle.submit(requests, kind == RayKind::full ? Parts::colour : Parts::surface);
    const Clock::time_point start = Clock::now();
    while (samples.size() < requests.size() && seconds_since(start) < patience)
        oracle.collect(samples, std::chrono::milliseconds(20));
    return samples;
}

/// Thread-seconds that a sample takes.
double mean_cost(const std::vector<Sample>& samples) {
    double sum = 0;
    for (const Sample& sample : samples) sum += 1e-9 * sample.cost_ns;
    return sum / static_cast<double>(samples.size());
}

std::optional<DrawableScene> scene_of(PovrayOracle& oracle, const char* name) {
    const SceneDescription& description = oracle.wait_for_scene(nullptr, nullptr);
    const Clock::time_point start = Clock::now();
    const auto too_long = [&] { return seconds_since(start) > 60; };
    oracle.wait_for_geometry(too_long);
    oracle.wait_for_images(too_long);
    auto geometry = oracle.take_geometry();
    auto scene = geometry ? drawable_scene(*geometry, description) : std::nullopt;
    if (!scene) {
        std::printf("%s: %s\n", name, why_not_straight(description.camera).c_str());
        return std::nullopt;
    }
    if (auto images = oracle.take_images()) scene->images = std::move(*images);
    return scene;
}

std::optional<Line> compare(const std::filesystem::path& path, const char* name, bool verbose) {
    std::filesystem::current_path(path.parent_path());  // scenes find their own files beside them
    const PovrayOptions options = read_povray_options({path, "+W320", "+H240", "+WT2", "-A"});
    PovrayOracle oracle({.program = real_tracer(), .arguments = options.tracer_arguments()});
    const std::optional<DrawableScene> scene = scene_of(oracle, name);
    if (!scene) return std::nullopt;

    const std::vector<Sample> albedos = trace(oracle, *scene, RayKind::albedo, 1);
    const std::vector<Sample> full = trace(oracle, *scene, RayKind::full, 4);
    Line line;
    const std::clock_t start = std::clock();
    const ItemBuffer painted = paint_items(*scene);
    line.painting = double(std::clock() - start) / CLOCKS_PER_SEC;
    std::vector<Sample> probes;
    if (!painted.mirrors.empty()) probes = trace(oracle, *scene, RayKind::probe, 1);
    if (albedos.size() < painted.surfaces.size() || full.empty() ||
        (!probes.empty() && probes.size() < albedos.size()))
        throw Error(Exit::tracer, "rays take too long", name, "");
    const auto pixels = static_cast<double>(painted.surfaces.size());
    line.of_full = line.painting / (mean_cost(full) * pixels);
    line.of_albedo = line.painting / (mean_cost(albedos) * pixels);
    line.agreement = Comparison(painted, albedos, probes, verbose ? 10 : 0).compare();
    return line;
}

/// A column of so many digits behind the point; a dash for a share of nothing.
std::string percent(std::size_t part, std::size_t all, int digits) {
    char text[32] = "-";
    if (all > 0) std::snprintf(text, sizeof text, "%.*f%%", digits, 100 * share(part, all));
    return text;
}

void print_heading() {
    std::printf("%8s %9s %9s %9s %8s %9s %8s %9s %8s %9s %5s %8s %8s %8s  scene\n", "known",
                "inner", "at edges", "beyond", "albedo", "agree", "plain", "agree", "mirror",
                "agree", "off", "ms", "of full", "of alb.");
}

void print(const Line& line, const char* name) {
    const Agreement& a = line.agreement;
    std::printf("%8s %9s %9s %9s %8s %9s %8s %9s", percent(a.known, a.pixels, 2).c_str(),
                percent(a.inner_right, a.inner, 3).c_str(), percent(a.at_edges, a.known, 3).c_str(),
                percent(a.beyond, a.known, 3).c_str(), percent(a.images, a.pixels, 2).c_str(),
                percent(a.images_right, a.images, 3).c_str(), percent(a.plain, a.pixels, 2).c_str(),
                percent(a.plain_right, a.plain, 3).c_str());
    std::printf(" %8s %9s %5zu", percent(a.mirrored, a.pixels, 2).c_str(),
                percent(a.mirrored_inner_right, a.mirrored_inner, 3).c_str(), a.mirrored_off);
    std::printf(" %8.1f %7.2f%% %7.1f%%  %s\n", 1000 * line.painting, 100 * line.of_full,
                100 * line.of_albedo, name);
    std::fflush(stdout);
}

void add(Line& total, const Line& line) {
    const Agreement& a = line.agreement;
    Agreement& sum = total.agreement;
    for (auto part :
         {&Agreement::pixels, &Agreement::known, &Agreement::inner, &Agreement::inner_right,
          &Agreement::at_edges, &Agreement::beyond, &Agreement::images, &Agreement::images_right,
          &Agreement::plain, &Agreement::plain_right, &Agreement::mirrored,
          &Agreement::mirrored_inner, &Agreement::mirrored_inner_right, &Agreement::mirrored_off})
        sum.*part += a.*part;
    total.painting += line.painting;
    total.of_full += line.of_full;
    total.of_albedo += line.of_albedo;
}

}  // namespace

int main(int argc, char** argv) {
    const std::filesystem::path start = std::filesystem::current_path();
    const bool verbose = argc > 1 && std::strcmp(argv[1], "-v") == 0;
    constexpr double target = .999;
    Line total;
    int scenes = 0, at_target = 0;
    print_heading();
    for (int i = verbose ? 2 : 1; i < argc; ++i) {
        try {
            const auto line = compare(start / argv[i], argv[i], verbose);
            if (!line) continue;
            print(*line, argv[i]);
            add(total, *line);
            ++scenes;
            at_target += line->agreement.reaches(target);
        } catch (const Error& error) {
            std::printf("%s: %s\n", argv[i], error.what());
        }
    }
    if (scenes == 0) return 1;
    // Of times the means of the shares, of pixels the shares of all.
    for (double Line::*mean : {&Line::painting, &Line::of_full, &Line::of_albedo})
        total.*mean /= scenes;
    print(total, "all of them");
    std::printf("%d scenes, %d with %.1f%% or more of the inner pixels right\n", scenes, at_target,
                100 * target);
}
