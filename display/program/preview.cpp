// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/preview.h"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <optional>

#include "adapter/povray_options.h"
#include "core/error_measures.h"
#include "core/oracle_lanes.h"
#include "core/sample_memory.h"
#include "display/caption.h"
#include "display/image_file.h"
#include "display/offscreen.h"
#include "display/program/folder.h"
#include "display/program/interrupt.h"
#include "display/program/povray_image.h"
#include "display/program/schedule.h"
#include "display/program/session_file.h"
#include "display/program/strategy_run.h"
#include "display/progress_line.h"
#include "display/window.h"

namespace povpreview {
namespace {

using namespace std::chrono_literals;

/// Smooths the edges of triangles in pictures for people; Mesa in software offers no more.
constexpr int samples_per_pixel = 4;
/// A window is drawn so often while nothing is pressed, and at most this share of the time is
/// spent on it.
constexpr double frame_s = .1, drawing_share = .2;
constexpr double log_interval_s = .1;

std::string thousands(std::size_t number) {
    std::string digits = std::to_string(number);
    for (std::size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, ",");
    return digits;
}

/// One scene, one or two methods, and everyone who looks on.
class Preview {
   public:
    explicit Preview(const PreviewOptions& options)
        : options_(options), povray_(read_povray_options(options.povray)) {
        check_outputs();
    }

    Exit run() {
        for (const std::string& departure : povray_.departures)
            fmt::print(stderr, "povpreview: {}\n", departure);
        TracerWishes wishes = options_.tracer;
        if (options_.finish) wishes.finish_folder = scratch_.emplace().path();
        scene_.emplace(
            povray_, wishes, [&](const std::string& what) { line_.show(what); }, interrupted,
            foreknowledge());
        if (options_.finish) check_image(scene_->description().output);
        open_window();
        lanes_.emplace(samples());
        main_.emplace(options_.method, *scene_, lanes_->lane(0), accuracy(), !options_.samples);
        if (!options_.log.empty()) log_.emplace(options_.log);
        if (const std::string missing = Sandbox::missing(); log_ && !missing.empty())
            log_->write_event(scene_->time_s(), missing);
        // A run of so many samples shall come out the same each time, however fast all that is
        // found, and whatever rays take.
        if (options_.samples) scene_->wait_for_foreknowledge([this] { return stopped_early(); });
        try {
            while (work()) look();
        } catch (const Error&) {
            rescue();
            throw;
        }
        finish();
        return interrupted() ? Exit::interrupted : Exit::success;
    }

   private:
    // ---- before

    /// Refuses what could not be written in the end, before hours of work.
    void check_outputs() {
        if (!options_.output.empty()) {
            format_for(options_.output);
            check_folder(options_.output);
        }
        if (!options_.snapshots.empty()) make_folder(options_.snapshots, "--snapshots");
        if (!options_.reference.empty()) reference_ = read_image(options_.reference);
    }

    static void check_folder(const std::filesystem::path& file) {
        const std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
        if (access(folder.c_str(), W_OK | X_OK) != 0)
            throw Error(Exit::usage, std::string("cannot write there: ") + std::strerror(errno),
                        folder.string(), "give --output a file in a folder that you may write");
    }

    void open_window() {
        if (options_.headless) return;
        try {
            const SceneDescription& scene = scene_->description();
            window_.emplace(scene.width, scene.height, "povpreview: " + povray_.scene.string());
            window_->set_overlay(options_.overlay);
            if (options_.beside != "none") window_->press('b');
        } catch (const Error& error) {
            say_without_window(error.what());
        }
    }

    void say_without_window(const std::string& why) {
        line_.clear();
        fmt::print(stderr, "povpreview: {}; going on without a window\n", why);
    }

    /// Where samples come from: the tracer, by way of a memory where they are to be kept.
    SampleOracle& samples() {
        if (!options_.finish && options_.session.empty()) return scene_->oracle();
        const SceneDescription& scene = scene_->description();
        memory_.emplace(scene_->oracle(), scene.width, scene.height);
        if (!options_.session.empty()) open_session();
        return *memory_;
    }

    void open_session() {
        const SceneDescription& scene = scene_->description();
        const SessionIdentity identity{
            scene_->oracle().tracer().povray, scene.width, scene.height, scene.alpha,
            povray_.sample_words(),           scene.files};
        std::error_code gone;
        if (options_.resume && std::filesystem::exists(options_.session, gone)) {
            std::size_t count = 0;
            session_.emplace(
                SessionFile::resume(options_.session, identity, [&](const Sample& sample) {
                    memory_->recall(sample);
                    ++count;
                }));
            say(fmt::format("going on with {} samples of {}", thousands(count),
                            options_.session.string()));
        } else {
            session_.emplace(SessionFile::begin(options_.session, identity));
        }
        memory_->tell([this](const Sample& sample) { session_->add(sample); });
    }

    void say(const std::string& text) {
        line_.clear();
        fmt::print(stderr, "povpreview: {}\n", text);
    }

    Foreknowledge foreknowledge() const {
        MethodNeeds needs = method_needs(options_.method);
        if (options_.beside != "none") {
            const MethodNeeds beside = method_needs(beside_method());
            needs.edges |= beside.edges;
            needs.items |= beside.items;
        }
        return foreknowledge_for(needs, options_.mirror_depth);
    }

    /// How fast a rung of the ladder is climbed depends on what samples cost; a run of so many
    /// samples shall come out the same each time.
    std::optional<Rung> accuracy() const {
        if (options_.samples && options_.accuracy.empty()) return target_rung;
        return scene_->accuracy(options_.accuracy);
    }

    bool stopped_early() const { return interrupted() || (window_ && window_->controls().closed); }

    // ---- the loop

    /// One round of sampling; false when it is time to end.
    bool work() {
        if (stopped_early()) return false;
        if (image_made_) return window_.has_value();  // there is no tracer any more
        if (options_.time && scene_->time_s() >= *options_.time) return false;
        if (options_.samples && main_->samples() >= *options_.samples) return false;
        if (options_.samples) main_->session().limit_full(*options_.samples);
        going_ = main_->advance(2ms);
        if (beside_wanted()) {
            if (!beside_)
                beside_.emplace(beside_method(), *scene_, lanes_->lane(1), accuracy(),
                                !options_.samples);
            beside_->session().limit_full(main_->samples());
            going_ |= beside_->advance(0ms) && beside_->samples() < main_->samples();
        }
        if (session_) keep_session();
        if (!going_ && options_.finish) make_image();
        // A finished picture stays in its window until that is closed.
        return going_ || window_;
    }

    void keep_session() {
        session_->write_some();
        if (session_->trouble().empty()) return;
        say(session_->trouble());
        memory_->tell(nullptr);
        session_.reset();
    }

    std::string beside_method() const {
        return options_.beside.empty() ? "blocks" : options_.beside;
    }

    /// The second method is traced only where it is shown, and only when it can be: both share a
    /// pipe, and it would block that for the first with samples that must wait.
    bool beside_wanted() const {
        if (options_.beside == "none") return false;
        if (!scene_->preparation().empty() && !accuracy()) return false;
        if (window_) return window_->controls().beside;
        return !options_.beside.empty() || !options_.snapshots.empty();
    }

    void look() {
        const double now = scene_->time_s();
        if (main_->samples() == 0) return;
        show_progress(now);
        if (log_ && now >= next_log_) {
            write_log();
            next_log_ = now + log_interval_s;
        }
        // Off the clock: what is shown at a moment is what an undisturbed preview shows then.
        if (!options_.snapshots.empty() && going_ && schedule_.due(now))
            scene_->off_the_clock([&] { write_snapshot(); });
        if (window_) look_at_window(now);
    }

    void show_progress(double now) {
        const Standing standing = main_->standing();
        const std::string preparing = scene_->preparation();
        const std::string refining = preparing.empty() ? "refining" : preparing + "; refining";
        line_.show(Progress{.state = going_ ? refining : "complete",
                            .samples = standing.full,
                            .pixels = pixel_count(),
                            .samples_per_second = now > 0 ? double(standing.full) / now : 0,
                            .elapsed = std::chrono::duration<double>(now)});
    }

    void look_at_window(double now) {
        if (window_->take_save_request()) try_to_save();
        if (now >= next_frame_) {
            const Overlay overlay = window_->controls().overlay;
            window_->show(main_->previewer().picture(overlay), caption(*main_));
            if (beside_wanted() && beside_ && beside_->samples() > 0)
                window_->show_beside(beside_->previewer().picture(overlay), caption(*beside_));
        }
        update_window(going_ ? 0ms : 50ms);
        const double spent = scene_->time_s() - now;
        if (now >= next_frame_) next_frame_ = now + std::max(frame_s, spent / drawing_share);
    }

    void update_window(std::chrono::milliseconds patience) {
        window_->update(patience);
        if (!window_->lost()) return;
        window_.reset();
        say_without_window("the display is gone");
    }

    // ---- what is written

    std::size_t pixel_count() const {
        return std::size_t(scene_->description().width) * std::size_t(scene_->description().height);
    }

    std::string caption(StrategyRun& run) const {
        const Standing standing = run.standing();
        std::string text = fmt::format(
            "{}  {:.2f} s\n{} samples, {:.2f} % of pixels", run.previewer().name(), standing.time_s,
            thousands(standing.full), 100. * double(standing.full) / double(pixel_count()));
        if (standing.probe > 0) text += fmt::format(", {} probes", thousands(standing.probe));
        return text;
    }

    Offscreen& offscreen() {
        if (!offscreen_) offscreen_.emplace(open_offscreen(options_.backend));
        return *offscreen_;
    }

    Image draw(StrategyRun& run) {
        const SceneDescription& scene = scene_->description();
        const glm::ivec2 size = options_.size.value_or(glm::ivec2(scene.width, scene.height));
        const Picture picture = run.previewer().picture(options_.overlay);
        return offscreen().render(picture, size.x, size.y, samples_per_pixel, options_.overlay,
                                  Range::display);
    }

    /// The error as the compare command would print it: one sample per pixel, no overlay.
    std::string error_of(StrategyRun& run) {
        const SceneDescription& scene = scene_->description();
        if (reference_.width != scene.width || reference_.height != scene.height) return "";
        const Picture picture = run.previewer().picture(Overlay::none);
        const Image image = offscreen().render(picture, scene.width, scene.height);
        return fmt::format("\nL1 error {:.4f}", measure_error(image.pixels, reference_.pixels).l1);
    }

    void write_snapshot() {
        std::vector<Panel> panels;
        std::array<Image, 2> images;
        std::array<StrategyRun*, 2> runs{&*main_, beside_ ? &*beside_ : nullptr};
        for (std::size_t i = 0; i < 2; ++i) {
            if (!runs[i] || runs[i]->samples() == 0) continue;
            const std::string text = caption(*runs[i]) + error_of(*runs[i]);
            images[i] = draw(*runs[i]);
            panels.push_back({images[i], text});
        }
        const std::string name =
            fmt::format("{:03d}-{:.2f}s.png", ++snapshots_, main_->standing().time_s);
        write_image(compose(panels), options_.snapshots / name, FileFormat::png8);
    }

    /// The standing comes last: whoever reads the end of the log wants the counts.
    void write_log() {
        if (!plan_logged_ && scene_->items_finished()) {
            const std::vector<Stage> stages = main_->stages();
            plan_logged_ = !stages.empty();
            log_->write_plan(scene_->time_s(), stages);
        }
        if (const auto report = scene_->take_edge_report())
            log_->write_event(scene_->time_s(), *report);
        if (const auto report = scene_->take_item_report())
            log_->write_event(scene_->time_s(), *report);
        const auto& faults = scene_->oracle().faults();
        for (; faults_logged_ < faults.size(); ++faults_logged_)
            log_->write_event(scene_->time_s(), faults[faults_logged_]);
        log_->write(main_->standing());
    }

    /// The preview becomes the render. What goes wrong here is said, and the picture still saved.
    void make_image() {
        const auto interrupted_or_shown = [this] {
            if (window_) update_window(0ms);
            return stopped_early();
        };
        if (session_) session_->write_all();
        if (log_) write_log();
        try {
            const std::filesystem::path image = scene_->oracle().finish(
                memory_->pixels(),
                [this](const report::Progress& progress) { line_.show(sentence(progress)); },
                interrupted_or_shown);
            save_povray_image(image, scene_->description().output);
            say("made " + scene_->description().output);
            if (log_)
                log_->write_event(scene_->time_s(),
                                  "POV-Ray's image is made: " + scene_->description().output);
        } catch (const Error& error) {
            if (error.exit() != Exit::interrupted) failure_ = error;
            image_failed_ = true;
        }
        image_made_ = true;
    }

    /// Where the picture goes when nothing was said: beside nobody's own render.
    std::filesystem::path output() const {
        if (!options_.output.empty()) return options_.output;
        return povray_.scene.stem().string() + "-preview.png";
    }

    void save() {
        write(draw(*main_));
        line_.clear();
        fmt::print(stderr, "povpreview: saved {}\n", output().string());
    }

    /// Where that cannot be written any more (the disk is full, the folder gone), the picture goes
    /// where temporary files go, and the Error says so.
    void write(const Image& image) const {
        try {
            write_image(image, output());
        } catch (const Error& error) {
            const std::filesystem::path elsewhere =
                std::filesystem::temp_directory_path() /
                fmt::format("povpreview-{}-{}", getpid(), output().filename().string());
            write_image(image, elsewhere);
            throw Error(error.exit(), error.what(), "",
                        "the picture is in " + elsewhere.string() + " instead");
        }
    }

    /// Saves while something else goes on: a failure is told, and no more.
    void try_to_save() {
        try {
            save();
        } catch (const Error& error) {
            line_.clear();
            fmt::print(stderr, "povpreview: {}\n", error.what());
        }
    }

    /// What was traced is not lost with the tracer, nor with the log.
    void rescue() {
        if (main_ && main_->samples() > 0) try_to_save();
    }

    void finish() {
        line_.clear();
        if (main_->samples() == 0) return;
        if (log_) write_log();
        if (!options_.snapshots.empty()) write_snapshot();
        // Asked for, or cut short, or nothing else to show for it.
        const bool nothing_shown = !window_ && options_.snapshots.empty() && !image_made_;
        if (!options_.output.empty() || interrupted() || nothing_shown || image_failed_) save();
        if (session_ && interrupted()) {
            session_->write_all();
            say(fmt::format("--session {} --resume goes on from here", session_->file().string()));
        }
        for (const std::string& fault : scene_->oracle().faults())
            fmt::print(stderr, "povpreview: {}\n", fault);
        if (failure_) throw *failure_;
    }

    const PreviewOptions& options_;
    PovrayOptions povray_;
    Image reference_;
    ProgressLine line_;
    std::optional<Window> window_;
    std::optional<ScratchFolder> scratch_;
    std::optional<TracedScene> scene_;
    std::optional<SampleMemory> memory_;
    std::optional<SessionFile> session_;
    std::optional<OracleLanes> lanes_;
    std::optional<StrategyRun> main_, beside_;
    std::optional<Offscreen> offscreen_;
    std::optional<ProgressLog> log_;
    GeometricSchedule schedule_;
    bool going_ = true, image_made_ = false, image_failed_ = false;
    std::optional<Error> failure_;  // of POV-Ray's image
    double next_log_ = 0, next_frame_ = 0;
    int snapshots_ = 0;
    std::size_t faults_logged_ = 0;
    bool plan_logged_ = false;
};

}  // namespace

Exit preview(const PreviewOptions& options) { return Preview(options).run(); }

}  // namespace povpreview
