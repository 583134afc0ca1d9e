// SPDX-License-Identifier: AGPL-3.0-or-later
#include "adapter/frame_range.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "core/error.h"

namespace povpreview {
namespace {

constexpr int most_frames = 1'000'000;

double number(const std::string& text) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    while (*end == ' ' || *end == '\t' || *end == '\r') ++end;
    if (end == text.c_str() || *end != 0 || !(std::abs(value) <= 1e9))
        throw Error(Exit::usage, fmt::format("'{}' is no number of a frame", text), "",
                    "give whole numbers, as in +KFI1 +KFF20");
    return value;
}

/// The frame that a subset begins or ends with: `value` itself, or that share of all.
int subset_frame(double value, int count) {
    return static_cast<int>(value == 0 || value >= 1 ? value : count * value);
}

}  // namespace

void FrameRange::take(const PovrayWord& word) {
    using Kind = PovrayWord::Kind;
    const auto whole = [&] { return static_cast<int>(number(word.value)); };
    if (word.kind == Kind::initial_frame) initial_ = whole();
    if (word.kind == Kind::final_frame) final_ = whole();
    if (word.kind == Kind::frame_step) step_ = std::max(1, whole());
    if (word.kind == Kind::subset_start) subset_start_ = std::max(0., number(word.value));
    if (word.kind == Kind::subset_end) subset_end_ = std::max(0., number(word.value));
    if (word.kind == Kind::cyclic) cyclic_ = is_on(word.value);
}

bool FrameRange::animated() const {
    const int initial = initial_.value_or(0), final = final_.value_or(0);
    return !(initial == 0 && final == 0) && !(initial == 1 && final == 1);
}

/// A cyclic animation has one frame more, the first again, which is not rendered.
int FrameRange::last() const { return final_.value_or(1) + (cyclic_ ? 1 : 0); }

std::vector<int> FrameRange::frames() const {
    if (!animated()) return {};
    const int initial = std::max(0, initial_.value_or(1));
    const int count = last() - initial + 1;
    const int first =
        subset_start_ ? std::max(initial, subset_frame(*subset_start_, count)) : initial;
    const int end = subset_end_ ? subset_frame(*subset_end_, count) : final_.value_or(1);
    if (end < first)
        throw Error(Exit::usage,
                    fmt::format("the animation has no frames from {} to {}", first, end), "",
                    "see Initial_Frame, Final_Frame and the like in the options and INI files");
    if ((end - first) / step_ >= most_frames)
        throw Error(Exit::usage, fmt::format("there are {} frames", (end - first) / step_ + 1), "",
                    fmt::format("render at most {} at once, by +SF and +EF", most_frames));
    std::vector<int> result;
    for (int frame = first; frame <= end; frame += step_) result.push_back(frame);
    return result;
}

int FrameRange::digits() const {
    return static_cast<int>(std::to_string(std::max(0, last())).size());
}

}  // namespace povpreview
