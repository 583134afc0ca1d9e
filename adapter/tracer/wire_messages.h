// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "backend/oracle/geometry_facts.h"
#include "backend/oracle/samples.h"
#include "backend/oracle/scene_facts.h"
#include "backend/oracle/work_queue.h"

/// Between plain structures and the messages of wire.fbs. The frames come with their length in
/// front, ready to be written.
namespace povpreview::tracer {

std::vector<std::uint8_t> hello_frame(std::uint32_t version, const std::string& povray,
                                      unsigned threads);
std::vector<std::uint8_t> progress_frame(std::uint8_t stage, std::uint64_t done,
                                         std::uint64_t total);
std::vector<std::uint8_t> scene_frame(const SceneFacts& scene);
std::vector<std::uint8_t> geometry_frame(const GeometryChunk& chunk);
std::vector<std::uint8_t> texels_frame(const TexelChunk& chunk);
std::vector<std::uint8_t> answer_frame(const Slice& slice, std::uint8_t rung,
                                       const std::vector<Sample>& samples);
std::vector<std::uint8_t> rung_ready_frame(std::uint8_t rung);
std::vector<std::uint8_t> failure_frame(const std::string& message, const std::string& file,
                                        unsigned line);

/// One of the two.
struct Order {
    std::shared_ptr<Batch> batch;
    std::shared_ptr<FinishPart> finish;
};
/// The order in a frame's content; none, with the `fault` named, for anything but a sound one.
Order read_order(const std::vector<std::uint8_t>& content, std::size_t max_positions,
                 std::string& fault);

}  // namespace povpreview::tracer
