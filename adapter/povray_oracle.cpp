// SPDX-License-Identifier: AGPL-3.0-or-later
#include "adapter/povray_oracle.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace povpreview {
namespace {

using namespace std::chrono_literals;

/// Deaths in a row without a single answer, and samples found to kill, after which it is no use.
constexpr int barren_deaths_limit = 8;
constexpr std::size_t killers_limit = 16;
/// Bytes taken from the socket in one go, about its own buffer, and goes between two looks at the
/// clock.
constexpr std::size_t receive_size = 256 * 1024;
constexpr int receives_in_a_row = 16;
/// Samples sent and not answered at most: the tracer takes no more than 2^22, and more would only
/// fill memory.
constexpr std::size_t outstanding_limit = std::size_t{1} << 20;

/// POV-Ray's message, with its place if it does not name it itself.
std::string message(const report::Failure& failure) {
    if (failure.file.empty() || failure.message.find("File '") != std::string::npos)
        return failure.message;
    return fmt::format("File '{}' line {}: {}", failure.file, failure.line, failure.message);
}

/// Whether POV-Ray complains of a file that it cannot find, or may not read.
bool names_missing_file(const std::string& message) {
    for (const char* words : {"Cannot open", "Could not open", "Cannot find", "Could not find"})
        if (message.find(words) != std::string::npos) return true;
    return false;
}

}  // namespace

PovrayOracle::PovrayOracle(Settings settings)
    : settings_(std::move(settings)), received_(receive_size) {
    start();
}

PovrayOracle::~PovrayOracle() = default;

void PovrayOracle::start() {
    process_.reset();
    state_ = State::greeting;
    reader_ = FrameReader();
    out_.clear();
    out_sent_ = 0;
    batches_.clear();
    first_batch_ = 1;
    set_outstanding(0);
    sent_end_ = queue_.begin();
    arrival_.begin();
    last_look_ = Clock::now();
    try {
        process_ = std::make_unique<TracerProcess>(
            settings_.program, settings_.arguments,
            TracerSetting{settings_.geometry, settings_.writes, settings_.finish_folder,
                          settings_.sandbox, settings_.watch});
    } catch (const Error& error) {
        broken_ = error;
        throw;
    }
}

const SceneDescription& PovrayOracle::wait_for_scene(
    const std::function<void(const report::Progress&)>& progress,
    const std::function<bool()>& interrupted) {
    progress_ = progress;
    while (!scene_) {
        if (interrupted && interrupted()) fail(Exit::interrupted, "interrupted", "");
        advance(Clock::now() + 50ms);
    }
    progress_ = nullptr;
    return *scene_;
}

void PovrayOracle::wait_for_geometry(const std::function<bool()>& interrupted) {
    wait_until([this] { return arrival_.geometry_complete(); }, "the scene's polygons",
               interrupted);
}

void PovrayOracle::wait_for_images(const std::function<bool()>& interrupted) {
    wait_until([this] { return arrival_.images_complete(); }, "the scene's images", interrupted);
}

void PovrayOracle::wait_until(const std::function<bool()>& come, const char* awaited,
                              const std::function<bool()>& interrupted) {
    awaited_ = awaited;
    silence_ = {};
    last_look_ = Clock::now();
    while (!come()) {
        if (interrupted && interrupted()) fail(Exit::interrupted, "interrupted", "");
        advance(Clock::now() + 50ms);
    }
    awaited_ = nullptr;
}

std::filesystem::path PovrayOracle::finish(
    std::span<const PixelLight> pixels,
    const std::function<void(const report::Progress&)>& progress,
    const std::function<bool()>& interrupted) {
    const std::filesystem::path image = settings_.finish_folder / "image";
    progress_ = progress;
    for (const bool last_try : {false, true}) {
        awaited_ = nullptr;  // POV-Ray may parse as long as it likes
        while (state_ != State::serving) {
            if (interrupted && interrupted()) fail(Exit::interrupted, "interrupted", "");
            advance(Clock::now() + 50ms);
        }
        send_image(pixels);
        wait_until([this] { return state_ == State::ended; }, "POV-Ray's image", interrupted);
        const std::string end = process_->stop();
        std::error_code gone;
        if (process_->exit_status() == 0 && std::filesystem::exists(image, gone)) break;
        const std::string words = process_->last_words();
        if (last_try)
            fail(Exit::tracer,
                 fmt::format("the tracer {} while it made POV-Ray's image{}{}", end,
                             words.empty() ? "" : "; its last words were:\n", words),
                 "see whether plain povray renders the scene");
        remember(fmt::format("the tracer {} while it made POV-Ray's image; started again", end));
        ++statistics_.restarts;
        start();
    }
    progress_ = nullptr;
    return image;
}

void PovrayOracle::send_image(std::span<const PixelLight> pixels) {
    for (std::size_t first = 0; first < pixels.size(); first += wire_max_batch) {
        const std::size_t count = std::min<std::size_t>(wire_max_batch, pixels.size() - first);
        append_image(out_, static_cast<std::uint32_t>(first), pixels.subspan(first, count),
                     first + count == pixels.size());
    }
    state_ = State::finishing;
    flush();
}

void PovrayOracle::submit(std::span<const Request> requests, Parts parts) {
    if (broken_) throw *broken_;
    for (const Request& request : requests) {
        // Only full rays have parts to choose; the same parts for the others keeps batches whole.
        queue_.push(request, request.kind == RayKind::full ? parts : Parts::colour);
        if (is_killer(request)) answer_failed(queue_.end() - 1);
    }
    send_waiting();
}

void PovrayOracle::collect(std::vector<Sample>& samples, std::chrono::nanoseconds patience) {
    if (broken_) throw *broken_;
    const Clock::time_point deadline = Clock::now() + patience;
    receive();
    while (!queue_.empty() && !queue_.answered(queue_.begin()))
        if (!advance(deadline)) break;
    queue_.take(samples);
}

void PovrayOracle::listen(std::chrono::nanoseconds patience) {
    const Clock::time_point deadline = Clock::now() + patience;
    while (advance(deadline)) {
    }
}

/// Waits for bytes and handles them. Returns false when the deadline is over or a signal came.
bool PovrayOracle::advance(Clock::time_point deadline) {
    if (broken_) throw *broken_;
    const Clock::time_point now = Clock::now();
    const bool late = now >= deadline;
    const bool undisturbed = process_->wait(late ? 0ns : deadline - now, out_sent_ < out_.size());
    flush();
    if (receive()) return true;
    check_stall(now, deadline);
    return undisturbed && !late;
}

/// Handles what has come, a few MiB at most. Returns whether anything came.
bool PovrayOracle::receive() {
    try {
        for (int i = 0; i < receives_in_a_row; ++i) {
            const auto [what, size] = process_->receive(received_);
            if (what == TracerProcess::Received::nothing_yet) return i > 0;
            if (what == TracerProcess::Received::end) {
                if (state_ == State::finishing)
                    state_ = State::ended;
                else
                    restart();
                return false;
            }
            silence_ = {};
            last_look_ = Clock::now();
            reader_.feed(std::span(received_).first(size), [this](auto frame) { handle(frame); });
        }
    } catch (const WireFault& fault) {
        fail(Exit::tracer, fmt::format("the tracer sent {}", fault.what()),
             "build the tracer that belongs to this version of povpreview");
    }
    return true;
}

void PovrayOracle::handle(std::span<const std::byte> frame) {
    const Report any = decode_report(frame);
    if (const auto* hello = std::get_if<report::Hello>(&any)) return handle_hello(*hello);
    if (const auto* failure = std::get_if<report::Failure>(&any)) handle_failure(*failure);
    if (state_ == State::greeting) throw WireFault("another message before its greeting");
    if (const auto* answer = std::get_if<report::Answer>(&any)) return handle_answer(*answer);
    if (const auto* scene = std::get_if<SceneDescription>(&any)) return handle_scene(*scene);
    if (const auto* chunk = std::get_if<report::GeometryChunk>(&any)) {
        if (state_ < State::serving) throw WireFault("geometry before the scene");
        return arrival_.accept(*chunk);
    }
    if (const auto* part = std::get_if<report::Texels>(&any)) return arrival_.accept(*part);
    if (const auto* ready = std::get_if<report::RungReady>(&any)) return handle_ready(*ready);
    preparation_ = std::get<report::Progress>(any);
    if (progress_) progress_(preparation_);
}

void PovrayOracle::handle_hello(const report::Hello& hello) {
    if (state_ != State::greeting) throw WireFault("its greeting again");
    if (hello.version != wire_version)
        throw WireFault(fmt::format("a greeting in version {} of the protocol instead of {}",
                                    hello.version, wire_version));
    hello_ = hello;
    state_ = State::parsing;
}

void PovrayOracle::handle_scene(SceneDescription scene) {
    if (state_ != State::parsing) throw WireFault("a second scene");
    if (!image_size_fits(scene.width, scene.height))
        fail(Exit::usage,
             fmt::format("an image of {} x {} pixels is too large", scene.width, scene.height),
             fmt::format("set a size of at most {} each way and {} in all with +W and +H",
                         max_image_side, max_image_pixels));
    if (!scene_)
        scene_at_ = Clock::now();
    else if (scene.width != scene_->width || scene.height != scene_->height)
        fail(Exit::scene, "the scene was changed while it was traced, to another image size",
             "start again");
    scene_ = std::move(scene);
    ready_.resize(scene_->ladder.rungs.size());
    for (std::size_t i = 0; i < ready_.size(); ++i) ready_[i] += scene_->ladder.rungs[i].ready;
    state_ = State::serving;
    send_waiting();
}

void PovrayOracle::handle_ready(const report::RungReady& ready) {
    if (state_ < State::serving) throw WireFault("a rung before the scene");
    if (ready.rung >= ready_.size())
        throw WireFault(fmt::format("rung {} of a ladder of {}", ready.rung, ready_.size()));
    ++ready_[ready.rung];
}

void PovrayOracle::handle_failure(const report::Failure& failure) {
    const std::string text = message(failure);
    if (text.find("command-line option") != std::string::npos)  // POV-Ray does not say which
        fail(Exit::usage, fmt::format("{} in: {}", text, fmt::join(settings_.arguments, " ")),
             "check the options meant for POV-Ray");
    const bool confined = settings_.sandbox && names_missing_file(text);
    const bool wrote = text.find("prohibit write access") != std::string::npos;
    // Photons and radiosity, which may be of files that are missing, come beside the first samples.
    fail(state_ >= State::serving && target_ready() ? Exit::tracer : Exit::scene,
         text.empty() ? "POV-Ray failed without a message" : text,
         wrote ? "give --allow-writing if you trust the scene"
         : confined
             ? "files are looked for, and may be read, in the folder of the scene, the working "
               "folder and the libraries: add a folder by +L"
             : "");
}

void PovrayOracle::handle_answer(const report::Answer& answer) {
    if (answer.batch() < first_batch_ || answer.batch() - first_batch_ >= batches_.size())
        throw WireFault(
            fmt::format("an answer to batch {}, which is not outstanding", answer.batch()));
    Batch& batch = batches_[answer.batch() - first_batch_];
    answer.check_asked(batch.count, batch.kind);
    for (std::uint32_t i = 0; i < answer.count(); ++i) {
        const Sequence sequence = batch.sequence(answer.first() + i);
        if (queue_.answered(sequence))
            throw WireFault(fmt::format("the answer to sample {} of batch {} twice",
                                        answer.first() + i, answer.batch()));
        SampleQueue::Slot& slot = queue_[sequence];
        answer.read(i, slot.sample);
        slot.answered = true;
        statistics_.failed += slot.sample.failed;
    }
    statistics_.rays[static_cast<std::size_t>(batch.kind.kind)] += answer.count();
    barren_deaths_ = 0;
    batch.answered += answer.count();
    while (!batches_.empty() && batches_.front().answered == batches_.front().count) {
        batches_.pop_front();
        ++first_batch_;
    }
    set_outstanding(outstanding_ - answer.count());
    send_waiting();
}

// ---- sending

/// Sends what has not been sent, or as much of it as the search for a killer allows.
void PovrayOracle::send_waiting() {
    if (state_ != State::serving) return;
    while (sent_end_ < queue_.end()) {
        if (outstanding_ >= (crash_search_.searching() ? 1 : outstanding_limit)) break;
        const Sequence end = crash_search_.searching()
                                 ? crash_search_.next(sent_end_, queue_.end())
                                 : std::min(queue_.end(), sent_end_ + wire_max_batch);
        send_range(std::exchange(sent_end_, end), end);
    }
    flush();
}

/// Sends the unanswered ones among [begin, end), a batch for each kind, rung and choice of parts.
/// REQUIRES: end - begin <= wire_max_batch.
void PovrayOracle::send_range(Sequence begin, Sequence end) {
    constexpr std::size_t kinds = 3, all_parts = 8, groups_of_rung = kinds * all_parts;
    std::array<std::vector<std::uint32_t>, wire_max_rungs * groups_of_rung> groups;
    const auto group_of = [](const SampleQueue::Slot& slot) {
        // The target stands behind all others, as it does in numbers.
        return std::min<std::size_t>(slot.sample.rung, wire_max_rungs - 1) * groups_of_rung +
               static_cast<std::size_t>(slot.sample.kind) * all_parts +
               static_cast<std::size_t>(slot.sample.parts);
    };
    for (Sequence s = begin; s < end; ++s)
        if (!queue_.answered(s))
            groups[group_of(queue_[s])].push_back(static_cast<std::uint32_t>(s - begin));
    for (std::size_t g = 0; g < groups.size(); ++g) {
        if (groups[g].empty()) continue;
        const SampleQueue::Slot& slot = queue_[begin + groups[g].front()];
        Batch batch{.kind = {slot.sample.kind, slot.sample.rung, slot.sample.parts},
                    .first = begin,
                    .count = static_cast<std::uint32_t>(groups[g].size()),
                    .answered = 0,
                    .offsets = {}};
        if (groups[g].back() != batch.count - 1) batch.offsets = std::move(groups[g]);
        send_batch(std::move(batch));
    }
}

void PovrayOracle::send_batch(Batch batch) {
    positions_.clear();
    for (std::uint32_t i = 0; i < batch.count; ++i)
        positions_.push_back(queue_[batch.sequence(i)].sample.position);
    append_trace(out_, first_batch_ + batches_.size(), batch.kind, positions_);
    set_outstanding(outstanding_ + batch.count);
    batches_.push_back(std::move(batch));
}

void PovrayOracle::flush() {
    out_sent_ += process_->send(std::span(out_).subspan(out_sent_));
    if (out_sent_ == out_.size()) {
        out_.clear();
        out_sent_ = 0;
    }
}

// ---- faults

/// The tracer has died: reaps it and starts it again, unless that is no use.
void PovrayOracle::restart() {
    const bool broken_off = reader_.inside_frame();
    const std::string end = process_->stop();
    const std::string words = process_->last_words();
    const std::string said = words.empty() ? "" : "; its last words were:\n" + words;
    const bool serving = state_ == State::serving;
    const std::string how =
        fmt::format("the tracer {}{}{}", end, serving ? "" : " before the scene was ready",
                    broken_off ? " in the middle of a message" : "");
    // POV-Ray that refuses its options says so and leaves with 1, sometimes before the wire is
    // there to say it on. A scene that was read once may be read again.
    const bool refused = !serving && process_->exit_status() == 1 && !words.empty();
    if (refused || !scene_) fail(refused ? Exit::scene : Exit::tracer, how + said, "");
    if (++barren_deaths_ >= barren_deaths_limit)
        fail(Exit::tracer,
             fmt::format("{}, {} times in a row without an answer{}", how, barren_deaths_, said),
             "see whether plain povray renders the scene");

    const std::size_t lost = outstanding_;
    std::optional<Sequence> killer;
    if (lost > 0) killer = crash_search_.died(queue_.first_gap(), sent_end_, lost);
    remember(fmt::format("{}; started again, {} samples sent again", how, lost - (killer ? 1 : 0)));
    if (killer) leave_out(*killer);
    ++statistics_.restarts;
    start();
}

void PovrayOracle::leave_out(Sequence killer) {
    answer_failed(killer);
    const Sample& sample = queue_[killer].sample;
    killers_.push_back({sample.position, sample.kind});
    const std::string place = fmt::format("({}, {})", sample.position.x, sample.position.y);
    if (killers_.size() >= killers_limit)
        fail(Exit::tracer,
             fmt::format("the tracer dies over {} samples, the last one at {}", killers_.size(),
                         place),
             "see whether plain povray renders the scene");
    remember(fmt::format("the sample at {} kills the tracer and is left out", place));
}

void PovrayOracle::answer_failed(Sequence sequence) {
    SampleQueue::Slot& slot = queue_[sequence];
    slot.sample.failed = true;
    slot.answered = true;
    ++statistics_.rays[static_cast<std::size_t>(slot.sample.kind)];
    ++statistics_.failed;
}

bool PovrayOracle::is_killer(const Request& request) const {
    return std::any_of(killers_.begin(), killers_.end(), [&](const Request& k) {
        return k.position == request.position && k.kind == request.kind;
    });
}

/// Counts the time that samples are outstanding.
void PovrayOracle::set_outstanding(std::size_t count) {
    if (outstanding_ == 0 && count > 0) {
        busy_since_ = Clock::now();
        silence_ = {};
    }
    if (outstanding_ > 0 && count == 0) busy_ += Clock::now() - busy_since_;
    outstanding_ = count;
}

/// Adds up the silence. What we were away for (drawing, or stopped by Ctrl-Z) counts only up to a
/// second each time, so that it is not laid to the tracer's charge.
void PovrayOracle::check_stall(Clock::time_point before, Clock::time_point deadline) {
    const Clock::time_point now = Clock::now();
    const Clock::duration away = before - last_look_, waited = now - before;
    const Clock::duration patience = std::max(deadline - before, Clock::duration{});
    silence_ +=
        std::min<Clock::duration>(away, 1s) + std::min<Clock::duration>(waited, patience + 1s);
    last_look_ = now;
    if (outstanding_ == 0 && !awaited_) silence_ = {};
    if (silence_ > settings_.stall_timeout)
        fail(Exit::tracer,
             fmt::format("the tracer has said nothing for {:.3g} seconds while {} were due",
                         std::chrono::duration<double>(silence_).count(),
                         outstanding_ > 0 ? fmt::format("{} samples", outstanding_) : awaited_),
             "give it more time with --stall-timeout if single samples are that slow");
}

void PovrayOracle::remember(std::string fault) {
    constexpr std::size_t kept = 100;
    if (faults_.size() < kept) faults_.push_back(std::move(fault));
}

void PovrayOracle::fail(Exit exit, const std::string& cause, const std::string& remedy) {
    process_->stop();
    broken_.emplace(exit, cause, exit == Exit::tracer ? settings_.program : "", remedy);
    throw *broken_;
}

TracerStatistics PovrayOracle::statistics() const {
    TracerStatistics result = statistics_;
    const Clock::time_point now = Clock::now();
    const Clock::duration busy = busy_ + (outstanding_ > 0 ? now - busy_since_ : Clock::duration{});
    const std::chrono::duration<double> since_scene = now - scene_at_;
    if (scene_ && since_scene.count() > 0)
        result.busy = std::min(1., std::chrono::duration<double>(busy) / since_scene);
    return result;
}

}  // namespace povpreview
