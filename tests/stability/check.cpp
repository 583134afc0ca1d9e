// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/stability/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <future>
#include <glm/common.hpp>

#include "adapter/povray_options.h"
#include "adapter/stock_povray.h"
#include "core/colour.h"
#include "core/error.h"
#include "core/error_measures.h"
#include "core/mesh_previewer.h"
#include "display/image_file.h"
#include "display/offscreen.h"
#include "display/program/reference.h"
#include "display/program/strategy_run.h"
#include "tests/end_to_end/real_tracer.h"

namespace povpreview::stability {
namespace {

bool never() { return false; }

bool finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// One preview, and the stock render beside it.
class Check {
   public:
    Check(const Case& one, bool full, std::filesystem::path keep)
        : case_(one), keep_(std::move(keep)), words_(one.words(full)) {
        words_.push_back(folder_.write("scene.pov", case_.scene()));
        reference_ = std::async(std::launch::async,
                                [this] { return stock_reference(words_, folder_.path(), never); });
    }

    Outcome run() {
        try {
            preview();
        } catch (const Error& error) {
            blame(error.what());
        }
        return outcome_;
    }

   private:
    void preview() {
        TracedScene scene(
            read_povray_options(words_), TracerWishes{}, [](const std::string&) {}, never,
            foreknowledge_for(method_needs("mesh"), 1));
        StrategyRun run("mesh", scene, scene.oracle(), target_rung, false);
        scene.wait_for_foreknowledge(never);
        const double pixels = double(scene.description().width) * scene.description().height;
        for (std::size_t i = 0; i < shares.size(); ++i) {
            const bool last = i + 1 == shares.size();
            if (!last)
                run.session().limit_full(std::max<std::size_t>(1, std::size_t(shares[i] * pixels)));
            else
                run.session().limit_full(std::numeric_limits<std::size_t>::max());
            while (run.advance(std::chrono::milliseconds(20))) {
            }
            look(run, scene, i);
        }
        outcome_.seconds = scene.time_s();
        outcome_.contradicted = run.previewer().statistics().contradicted;
        if (!run.previewer().done()) blame("it ended before it was complete");
        for (const std::string& fault : scene.oracle().faults()) note(fault);
    }

    /// Validates and measures what there is at a share, off the clock.
    void look(StrategyRun& run, TracedScene& scene, std::size_t i) {
        scene.off_the_clock([&] {
            const auto& mesh = dynamic_cast<const MeshPreviewer&>(run.previewer());
            if (const std::string fault = mesh.validate(); !fault.empty())
                blame(fmt::format("at {:g} %: {}", shares[i] * 100, fault));
            const Image image = offscreen().render(
                mesh.picture(Overlay::none), scene.description().width, scene.description().height);
            const auto lost = std::count_if(image.pixels.begin(), image.pixels.end(),
                                            [](const glm::vec3& pixel) { return !finite(pixel); });
            if (lost > 0)
                blame(fmt::format("at {:g} %: {} pixels not finite", shares[i] * 100, lost));
            if (!keep_.empty()) keep_picture(image, i);
            measure(image, i);
        });
    }

    void measure(const Image& image, std::size_t i) {
        const Image& reference = stock();
        outcome_.l1[i] = measure_error(image.pixels, reference.pixels).l1;
        if (i > 0 && outcome_.l1[i] > growth_factor * outcome_.l1[i - 1] + growth_step)
            blame(fmt::format("the error grew from {:.4f} at {:g} % to {:.4f} at {:g} %",
                              outcome_.l1[i - 1], shares[i - 1] * 100, outcome_.l1[i],
                              shares[i] * 100));
        if (i + 1 < shares.size()) return;
        std::vector<glm::ivec2> off;
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                const double d = difference(image, reference, {x, y});
                outcome_.worst = std::max(outcome_.worst, d);
                if (d > pixel_step) off.emplace_back(x, y);
            }
        if (off.empty()) return;
        judge_alone(image, off);
    }

    /// What the stock povray makes of a pixel may depend on what it traced before: an object that
    /// threw the last shadow is tested first, by rules that let it shadow itself. A sample is what
    /// it makes of the pixel when it renders that alone.
    void judge_alone(const Image& image, const std::vector<glm::ivec2>& off) {
        const std::size_t step =
            off.size() <= all_alone ? 1 : (off.size() + some_alone - 1) / some_alone;
        std::size_t asked = 0;
        for (std::size_t i = 0; i < off.size(); i += step, ++asked) {
            const glm::ivec2 pixel = off[i];
            const double d = difference(image, stock_alone(pixel), pixel);
            if (d > pixel_step)
                return blame(fmt::format(
                    "of {} pixels that are not the stock render's, {}, {} is off by {:.3f} where "
                    "stock renders it alone, too",
                    off.size(), pixel.x, pixel.y, d));
        }
        note(fmt::format("{} pixels off; the {} asked for are as stock renders each alone",
                         off.size(), asked));
    }

    /// Black but for the pixel.
    Image stock_alone(glm::ivec2 pixel) const {
        const std::string output = folder_.path() / "alone.png";
        std::vector<std::string> arguments =
            read_povray_options(words_).stock_arguments({.output = output});
        for (const char* column : {"+SC", "+EC"})
            arguments.push_back(column + std::to_string(pixel.x + 1));
        for (const char* row : {"+SR", "+ER"})
            arguments.push_back(row + std::to_string(pixel.y + 1));
        render_by_stock_povray(arguments, folder_.path() / "alone.log", never);
        return read_image(output);
    }

    /// The worst channel of a pixel, between a picture and a reference, which is display-encoded.
    static double difference(const Image& image, const Image& reference, glm::ivec2 pixel) {
        const std::size_t p =
            std::size_t(pixel.y) * std::size_t(image.width) + std::size_t(pixel.x);
        const glm::vec3 d = glm::abs(display_encoded(image.pixels[p]) - reference.pixels[p]);
        return std::max({d.x, d.y, d.z});
    }

    void keep_picture(const Image& image, std::size_t i) {
        std::string name = case_.name();
        std::replace(name.begin(), name.end(), '/', '-');
        write_image(image, keep_ / fmt::format("{}-{:03.0f}.png", name, shares[i] * 100),
                    FileFormat::png8);
        if (i == 0) {
            Image linear = stock();
            for (glm::vec3& pixel : linear.pixels)
                for (int c = 0; c < 3; ++c) pixel[c] = decode_srgb(pixel[c]);
            write_image(linear, keep_ / (name + "-stock.png"), FileFormat::png8);
        }
    }

    const Image& stock() {
        if (reference_.valid()) stock_ = reference_.get();
        return stock_;
    }
    Offscreen& offscreen() {
        if (!offscreen_) offscreen_.emplace(open_offscreen(Backend::automatic));
        return *offscreen_;
    }
    void blame(const std::string& fault) {
        if (outcome_.fault.empty()) outcome_.fault = fault;
    }
    void note(const std::string& text) {
        outcome_.note += (outcome_.note.empty() ? "" : "; ") + text;
    }

    const Case& case_;
    std::filesystem::path keep_;
    WorkFolder folder_;
    std::vector<std::string> words_;
    std::future<Image> reference_;
    Image stock_;
    std::optional<Offscreen> offscreen_;
    Outcome outcome_;
};

}  // namespace

Outcome check(const Case& one, bool full, const std::filesystem::path& keep) {
    return Check(one, full, keep).run();
}

}  // namespace povpreview::stability
