// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Writes the fuzzer's seeds, one file for each kind of report, into the folder given. To be run
// again when wire.fbs changes: make_fuzz_corpus tests/fuzz/corpus/wire
#include <fstream>
#include <iostream>
#include <string>

#include "adapter/wire.h"
#include "tests/adapter/fake_world.h"
#include "tests/adapter/frames.h"

using namespace povpreview;

namespace {

fake::Bytes answer(RayKind kind, Parts parts) {
    fake::Slice slice{.batch = 1,
                      .first = 0,
                      .count = 3,
                      .samples = {},
                      .kind = kind,
                      .parts = parts,
                      .failed = {}};
    for (int i = 0; i < 3; ++i) slice.samples.push_back(fake::sample_at({20 + i, 20}));
    if (kind == RayKind::probe) slice.failed = {1};
    return fake::answer_frame(slice);
}

void write(const std::string& path, unsigned char chunk, const fake::Bytes& stream) {
    std::ofstream file(path, std::ios::binary);
    file.put(static_cast<char>(chunk));
    file.write(reinterpret_cast<const char*>(stream.data()),
               static_cast<std::streamsize>(stream.size()));
    if (!file) std::cerr << "cannot write " << path << '\n';
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "usage: make_fuzz_corpus FOLDER\n";
        return 2;
    }
    const std::string folder = std::string(argv[1]) + "/";
    const Parts everything = Parts::surface | Parts::shading | Parts::signature;
    const std::pair<const char*, fake::Bytes> reports[] = {
        {"hello", fake::hello_frame(wire_version)},
        {"progress", fake::progress_frame(2, 5, 9)},
        {"scene", fake::scene_frame(64, 48)},
        {"scene-unprepared", fake::scene_frame(64, 48, false)},
        {"rung-ready", fake::rung_ready_frame(2)},
        {"geometry", fake::geometry_frame(fake::small_geometry(), true)},
        {"texels", fake::texels_frame(0, 0, fake::small_texels())},
        {"failure", fake::failure_frame("Parse Error: no", "x.pov", 3)},
        {"answer-colour", answer(RayKind::full, Parts::colour)},
        {"answer-everything", answer(RayKind::full, everything)},
        {"answer-probe-with-failure", answer(RayKind::probe, Parts::colour)},
        {"answer-albedo", answer(RayKind::albedo, Parts::colour)}};
    fake::Bytes session;
    for (const auto& [name, frame] : reports) {
        write(folder + name, 255, frame);
        session.insert(session.end(), frame.begin(), frame.end());
    }
    write(folder + "session-in-small-chunks", 2, session);
    session.resize(session.size() - 50);
    write(folder + "session-broken-off", 99, session);
}
