// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

namespace povpreview::tracer {

/// Where in space something holds: a program for a machine with a stack of truth values, as
/// core/detail/drawable_scene.h has it, or everywhere, or nowhere.
class Condition {
   public:
    /// Longer programs, or such that need more of a stack, are no use to those who run them at
    /// every pixel.
    static constexpr std::size_t max_steps = 256;
    static constexpr int max_depth = 32;

    static Condition everywhere() { return Condition(Extent::everywhere); }
    static Condition nowhere() { return Condition(Extent::nowhere); }
    static Condition inside(std::uint32_t solid);

    friend Condition operator!(const Condition& a);
    friend Condition operator&(const Condition& a, const Condition& b);
    friend Condition operator|(const Condition& a, const Condition& b);

    bool is_nowhere() const { return extent_ == Extent::nowhere; }
    bool too_long() const { return steps_.size() > max_steps || depth_ > max_depth; }
    /// Empty where it holds everywhere. REQUIRES: !is_nowhere().
    const std::vector<std::int32_t>& steps() const { return steps_; }

   private:
    enum class Extent : std::uint8_t { everywhere, nowhere, somewhere };
    enum Step : std::int32_t { step_not = -1, step_and = -2, step_or = -3 };

    explicit Condition(Extent extent) : extent_(extent) {}
    static Condition joined(const Condition& a, const Condition& b, Step step);

    Extent extent_;
    std::vector<std::int32_t> steps_;
    int depth_ = 0;  ///< of the stack
};

}  // namespace povpreview::tracer
