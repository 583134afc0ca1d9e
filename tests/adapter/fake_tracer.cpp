// SPDX-License-Identifier: AGPL-3.0-or-later
//
// A tracer that speaks the wire and is wrong on demand. Its arguments:
//   slice=N        samples per answer (default 16)
//   shuffle        answers the slices of all orders it has in an order of chance (seed 1)
//   delay_us=N     time that a slice takes
//   die_after=N    dies (SIGKILL to itself) when it has answered N samples
//   once=FILE      a life begun after FILE exists has no faults; the first life makes it
//   die_at=X,Y     dies over any sample in that pixel
//   fail_at=X,Y    reports a sample in that pixel as failed
//   nan_at=X,Y     gives a sample in that pixel a depth that is no number
//   fault=NAME     does NAME instead of the (die_after + 1)th sample's slice: stall, stop, half,
//                  garbage, huge, batch, count, twice, missing, outside, failure, silent_exit,
//                  scene_again, hello_again, early_answer ...
//   geometry=NAME  sends geometry after the scene: two chunks, or NAME is twice (after its end),
//                  early (before the scene), wrong (an index out of range), half (dies within it)
//   texels=NAME    sends the texels of both chunks' images after the geometry, in parts; or NAME is
//                  image (of another image), order (the second part first), many (one too many),
//                  more (after all of them), half (dies within them), early (before the last
//                  geometry)
//   target_after=N the target rung is ready when N samples of other rungs have been answered
//   parse=NAME     ends before the scene: error, exit, kill, refuse, hang, slow, bad_version,
//                  no_hello, bad_size, tiny
//   finish=NAME    when it has all pixels of the picture it tells of progress, writes them as text
//   into
//                  the file "image" of its finish folder, a line each, and leaves; or NAME is die
//                  (before the file), failure, hang, nothing (leaves without the file)
//   stubborn       ignores SIGTERM and the end of the wire
//   chatty         writes a megabyte to its standard error before the scene
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <fstream>
#include <limits>
#include <map>
#include <random>
#include <string>

#include "adapter/wire.h"
#include "tests/adapter/fake_world.h"
#include "tests/adapter/frames.h"

namespace povpreview::fake {
namespace {

class FakeTracer {
   public:
    FakeTracer(int wire, int argc, char** argv);
    int run();

   private:
    bool has(const std::string& name) const { return options_.count(name) > 0; }
    std::string text(const std::string& name) const {
        const auto i = options_.find(name);
        return i == options_.end() ? "" : i->second;
    }
    long number(const std::string& name, long otherwise) const {
        return has(name) ? std::atol(text(name).c_str()) : otherwise;
    }
    bool in_pixel(const std::string& name, const glm::dvec2& p) const {
        double x = 0, y = 0;
        return std::sscanf(text(name).c_str(), "%lf,%lf", &x, &y) == 2 && std::floor(p.x) == x &&
               std::floor(p.y) == y;
    }

    void send(const Bytes& bytes) const;
    bool read_orders(bool wait);
    void parse();
    void send_geometry() const;
    void send_texels() const;
    bool is_held(const Order& order) const {
        return order.kind == RayKind::full && order.rung == target_rung && !target_ready_;
    }
    void make_target_ready();
    void answer_one();
    void take_image(const Order::Image& part);
    Slice slice(const Order& order, std::uint32_t first, std::uint32_t count) const;
    void commit_fault(Slice& right);
    [[noreturn]] static void die() {
        std::raise(SIGKILL);
        std::abort();
    }
    [[noreturn]] static void hang() {
        while (true) pause();
    }

    struct Piece {
        std::uint64_t batch;
        std::uint32_t first, count;
    };
    int wire_;
    std::map<std::string, std::string> options_;
    Bytes in_;
    std::map<std::uint64_t, Order> orders_;
    std::deque<Piece> pieces_, held_;
    bool target_ready_ = true;
    std::mt19937 random_{1};
    long answered_ = 0;
    std::vector<PixelLight> pixels_;
};

FakeTracer::FakeTracer(int wire, int argc, char** argv) : wire_(wire) {
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        const std::size_t equals = word.find('=');
        options_[word.substr(0, equals)] =
            equals == std::string::npos ? "" : word.substr(equals + 1);
    }
    if (!has("once")) return;
    if (std::ifstream(text("once"))) {
        if (has("geometry")) options_["geometry"] = "";
        if (has("texels")) options_["texels"] = "";
        for (const char* fault : {"die_after", "die_at", "fault", "parse", "finish"})
            options_.erase(fault);
    }
    std::ofstream(text("once")) << "lived\n";
}

void FakeTracer::send(const Bytes& bytes) const {
    for (std::size_t sent = 0; sent < bytes.size();) {
        const ssize_t n = ::send(wire_, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
        if (n <= 0) {
            if (has("stubborn")) hang();
            std::exit(0);
        }
        sent += static_cast<std::size_t>(n);
    }
}

/// Returns false at the end of the wire.
bool FakeTracer::read_orders(bool wait) {
    static std::array<std::byte, 1 << 16> buffer;
    const ssize_t n = recv(wire_, buffer.data(), buffer.size(), wait ? 0 : MSG_DONTWAIT);
    if (n == 0) return false;
    if (n > 0) in_.insert(in_.end(), buffer.begin(), buffer.begin() + n);
    std::size_t at = 0;
    while (in_.size() - at >= 4) {
        std::uint32_t size = 0;
        std::memcpy(&size, in_.data() + at, 4);
        if (in_.size() - at - 4 < size) break;
        const auto begin = in_.begin() + static_cast<std::ptrdiff_t>(at) + 4;
        Order order = decode_order(Bytes(begin, begin + size));
        at += 4 + size;
        if (order.image) {
            take_image(*order.image);
            continue;
        }
        const auto count = static_cast<std::uint32_t>(order.positions.size());
        const auto step = static_cast<std::uint32_t>(number("slice", 16));
        for (std::uint32_t i = 0; i < count; i += step)
            (is_held(order) ? held_ : pieces_)
                .push_back({order.batch, i, std::min(step, count - i)});
        orders_[order.batch] = std::move(order);
    }
    in_.erase(in_.begin(), in_.begin() + static_cast<std::ptrdiff_t>(at));
    return true;
}

void FakeTracer::parse() {
    const std::string how = text("parse");
    if (has("chatty"))
        for (int i = 0; i < 16384; ++i) std::fprintf(stderr, "%063d\n", i);
    if (how == "refuse") {
        std::fprintf(stderr, "Failed to parse command-line option\n");
        std::exit(1);
    }
    if (how == "no_hello") send(progress_frame(0, 0, 0));
    send(hello_frame(how == "bad_version" ? 99 : wire_version));
    for (std::uint64_t i = 0; i < 3; ++i) send(progress_frame(0, i, 3));
    if (how == "error") {
        send(failure_frame("File 'x.pov' line 7: Parse Error: Expected 'object', sphere found",
                           "x.pov", 7));
        std::exit(1);
    }
    if (how == "exit") std::exit(5);
    if (how == "kill") die();
    if (how == "hang") hang();
    if (how == "slow") usleep(400'000);
    if (how == "bad_size") send(scene_frame(0, 48));
    if (text("geometry") == "early") send(geometry_frame(small_geometry(), true));
    target_ready_ = !has("target_after");
    send(how == "tiny" ? scene_frame(1, 1) : scene_frame(width, height, target_ready_));
    if (has("geometry")) send_geometry();
}

void FakeTracer::make_target_ready() {
    target_ready_ = true;
    send(rung_ready_frame(2));
    pieces_.insert(pieces_.end(), held_.begin(), held_.end());
    held_.clear();
}

void FakeTracer::send_geometry() const {
    const std::string how = text("geometry");
    Geometry geometry = small_geometry();
    send(geometry_frame(geometry, false));
    if (how == "half") die();
    if (text("texels") == "early") send(texels_frame(0, 0, small_texels()));
    if (how == "wrong") geometry.corners.back() = 1000;
    send(geometry_frame(geometry, true));
    if (how == "twice") send(geometry_frame(geometry, true));
    if (has("texels")) send_texels();
}

void FakeTracer::send_texels() const {
    const std::string how = text("texels");
    const std::vector<Texel> all = small_texels(), start(all.begin(), all.begin() + 4),
                             end(all.begin() + 4, all.end());
    send(texels_frame(how == "image" ? 1 : 0, how == "order" ? 4 : 0, start));
    if (how == "half") die();
    send(texels_frame(0, 4, how == "many" ? start : end));
    send(texels_frame(1, 0, all));
    if (how == "more") send(texels_frame(1, 6, end));
}

Slice FakeTracer::slice(const Order& order, std::uint32_t first, std::uint32_t count) const {
    Slice s{.batch = order.batch,
            .first = first,
            .count = count,
            .samples = {},
            .kind = order.kind,
            .parts = order.parts,
            .failed = {},
            .rung = order.rung};
    for (std::uint32_t i = 0; i < count; ++i) {
        const glm::dvec2 p = order.positions[first + i];
        if (in_pixel("die_at", p)) die();
        if (in_pixel("fail_at", p)) s.failed.push_back(i);
        s.samples.push_back(sample_at(p));
        s.samples.back().colour *= rung_scale(order.rung);
        if (in_pixel("nan_at", p)) s.samples.back().depth = std::numeric_limits<float>::quiet_NaN();
    }
    return s;
}

void FakeTracer::commit_fault(Slice& right) {
    const std::string fault = text("fault");
    if (fault == "stall") hang();
    if (fault == "stop") std::raise(SIGSTOP);
    if (fault == "silent_exit") std::exit(0);
    if (fault == "half") {
        Bytes frame = answer_frame(right);
        frame.resize(frame.size() / 2);
        send(frame);
        std::exit(0);
    }
    if (fault == "garbage") {
        Bytes frame(4096, std::byte{0x5a});
        frame[0] = std::byte{0xfc}, frame[1] = std::byte{0x0f};
        frame[2] = frame[3] = std::byte{0};
        send(frame);
    }
    if (fault == "huge") send(Bytes(4, std::byte{0x7f}));
    if (fault == "batch") right.batch += 1000;
    if (fault == "count") right.count += 1;
    if (fault == "twice") send(answer_frame(right));
    if (fault == "missing") {
        right.kind = RayKind::albedo;
        right.samples.resize(right.count);
    }
    if (fault == "outside") right.first = 60000;
    if (fault == "failure") {
        send(failure_frame("Fatal error in renderer: Out of memory", "", 0));
        std::exit(1);
    }
    if (fault == "scene_again") send(scene_frame(width, height));
    if (fault == "hello_again") send(hello_frame(wire_version));
}

void FakeTracer::answer_one() {
    if (has("shuffle")) std::swap(pieces_.front(), pieces_[random_() % pieces_.size()]);
    const Piece piece = pieces_.front();
    pieces_.pop_front();
    Slice right = slice(orders_.at(piece.batch), piece.first, piece.count);
    const long fatal = number("die_after", std::numeric_limits<long>::max() / 2);
    if (answered_ + piece.count > fatal) {
        if (!has("fault")) die();
        commit_fault(right);
    } else if (has("fault") && !has("die_after")) {
        commit_fault(right);
    }
    if (has("delay_us")) usleep(static_cast<useconds_t>(number("delay_us", 0)));
    send(answer_frame(right));
    answered_ += piece.count;
    if (!target_ready_ && answered_ >= number("target_after", 0)) make_target_ready();
}

void FakeTracer::take_image(const Order::Image& part) {
    if (part.first != pixels_.size()) std::exit(4);
    pixels_.insert(pixels_.end(), part.pixels.begin(), part.pixels.end());
    if (!part.last) return;
    const std::string how = text("finish");
    for (std::uint64_t i = 0; i < 3; ++i)
        send(progress_frame(static_cast<std::uint8_t>(report::Stage::finishing), i, 3));
    if (how == "die") die();
    if (how == "hang") hang();
    if (how == "failure") {
        send(failure_frame("Fatal error in renderer: Out of memory", "", 0));
        std::exit(1);
    }
    if (how == "nothing") std::exit(0);
    const char* folder = std::getenv("POVPREVIEW_FINISH");
    std::ofstream file(std::string(folder ? folder : ".") + "/image");
    for (const PixelLight& p : pixels_)
        file << p.known << ' ' << p.colour.x << ' ' << p.transmittance << '\n';
    file.close();
    std::exit(0);
}

int FakeTracer::run() {
    if (has("stubborn")) std::signal(SIGTERM, SIG_IGN);
    parse();
    while (read_orders(pieces_.empty()))
        if (!pieces_.empty()) answer_one();
    if (has("stubborn")) hang();
    return 0;
}

}  // namespace
}  // namespace povpreview::fake

int main(int argc, char** argv) {
    const char* wire = std::getenv("POVPREVIEW_WIRE");
    if (!wire) {
        std::fprintf(stderr, "fake_tracer: POVPREVIEW_WIRE is not set\n");
        return 2;
    }
    return povpreview::fake::FakeTracer(std::atoi(wire), argc, argv).run();
}
