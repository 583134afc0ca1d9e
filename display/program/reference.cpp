// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/reference.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdlib>

#include "core/error.h"
#include "display/atomic_file.h"
#include "display/program/engine.h"
#include "display/program/reference_record.h"
#include "display/progress_line.h"

namespace povpreview {
namespace {

namespace fs = std::filesystem;

/// What decides about the picture besides files: in other surroundings POV-Ray looks for files
/// elsewhere.
std::string made_by(const ReferenceJob& job, ContentHashes& hashes) {
    std::string text = fmt::format("povpreview {}\n", POVPREVIEW_VERSION);
    text += hashes.of(engine_program(job.engine)) + '\n';
    text += engine_command(job) + '\n';
    text += fmt::format("format {}\n", static_cast<int>(job.format));
    text += fs::current_path().string() + '\n';
    for (const char* name : {"POVINI", "POVINC", "HOME"}) {
        const char* value = std::getenv(name);
        text += fmt::format("{} {}\n", name, value ? value : "");
    }
    return text;
}

/// Whether the same failure must come again: not one of the machine, such as too little memory.
bool is_certain(const std::string& failure) {
    return failure.find("Parse Error") != std::string::npos;
}

/// Asks `stop`, and watches the clock.
class Patience {
   public:
    Patience(const ReferenceJob& job, const std::function<bool()>& stop)
        : timeout_s_(job.timeout_s), stop_(stop) {}
    bool ended() {
        stopped_ = stopped_ || stop_();
        return stopped_ || late();
    }
    bool stopped() const { return stopped_; }
    bool late() const { return timeout_s_ && seconds() >= *timeout_s_; }
    double seconds() const {
        return std::chrono::duration<double>(Clock::now() - started_).count();
    }

   private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point started_ = Clock::now();
    std::optional<double> timeout_s_;
    const std::function<bool()>& stop_;
    bool stopped_ = false;
};

EnginePicture render(const ReferenceJob& job, Patience& patience, FileWatch& watch) {
    std::optional<EnginePicture> picture = render_complete(
        job, [&] { return patience.ended(); }, watch);
    if (picture) return *std::move(picture);
    if (patience.stopped()) throw Error(Exit::interrupted, "interrupted while rendering", "", "");
    throw Error(Exit::scene, fmt::format("not finished after {:g} s", *job.timeout_s), "",
                "give it more time by --timeout");
}

void keep_record(const ReferenceJob& job, ReferenceRecord record, FileWatch& watch,
                 ContentHashes& hashes, std::string& remark) {
    const auto add = [&](const char* text) {
        remark += (remark.empty() ? "" : "; ") + std::string(text);
    };
    const auto accesses = watch.finish();
    if (!accesses) return add("this machine does not tell what files were read: not reusable");
    auto files = file_states(*accesses, hashes);
    if (!files) return add("a file changed while it was in use: will be rendered again");
    record.files = std::move(*files);
    record.write(job.record);
}

}  // namespace

ReferenceMade make_reference(const ReferenceJob& job, ContentHashes& hashes,
                             const std::function<bool()>& stop) {
    ReferenceRecord record;
    record.made_by = made_by(job, hashes);
    const auto known = ReferenceRecord::read(job.record);
    if (known && known->made_by == record.made_by && known->holds(job.picture, hashes)) {
        if (known->failure.empty()) return {.reused = true};
        throw Error(Exit::scene, known->failure, "", "nothing has changed since that failed");
    }

    // Whatever comes now, what lies there is not what the record says.
    std::error_code none;
    fs::remove(job.record, none);
    Patience patience(job, stop);
    FileWatch watch;
    std::string remark;
    EnginePicture made;
    try {
        made = render(job, patience, watch);
    } catch (const Error& error) {
        record.failure = error.what();
        if (error.exit() == Exit::scene && is_certain(record.failure))
            keep_record(job, record, watch, hashes, remark);
        throw;
    }
    const AnnotatedImage image =
        annotated_image(made.file,
                        {{"Software", (made.software.empty() ? "" : made.software + ", ") +
                                          "povpreview " POVPREVIEW_VERSION},
                         {"Command", engine_command(job)},
                         {"Title", job.povray.scene.filename().string()}},
                        job.picture);
    write_file(job.picture, image.bytes);
    if (image.not_finite > 0)
        remark = fmt::format("{} pixels are infinite or not a number", image.not_finite);
    record.picture = content_hash(image.bytes);
    const double seconds = patience.seconds();
    keep_record(job, record, watch, hashes, remark);
    return {false, seconds, remark};
}

Image stock_reference(const std::vector<std::string>& povray_words, const fs::path& folder,
                      const std::function<bool()>& interrupted, Antialiasing antialiasing) {
    const bool smooth = antialiasing == Antialiasing::on;
    const std::string name = smooth ? "reference-aa" : "reference";
    ReferenceJob job{.povray = read_povray_options(povray_words),
                     .antialias = smooth,
                     .picture = folder / (name + ".png"),
                     .record = folder / (name + ".record")};
    if (smooth)
        for (const char* word : {"+A0.3", "+AM1", "+R3", "-J"}) job.povray.words.emplace_back(word);
    ContentHashes hashes;
    ProgressLine line;
    make_reference(job, hashes, [&] {
        line.show("rendering the reference by the stock povray");
        return interrupted();
    });
    line.clear();
    return read_image(job.picture);
}

}  // namespace povpreview
