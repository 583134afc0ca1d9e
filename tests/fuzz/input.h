// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <span>

namespace povpreview::fuzz {

/// Bytes read as numbers; zeros when they are used up.
class Input {
   public:
    explicit Input(std::span<const std::byte> bytes) : bytes_(bytes) {}

    bool empty() const { return bytes_.empty(); }
    std::uint8_t byte() {
        if (bytes_.empty()) return 0;
        const auto first = static_cast<std::uint8_t>(bytes_.front());
        bytes_ = bytes_.subspan(1);
        return first;
    }
    /// 0 .. below - 1. REQUIRES: below at least 1, at most 65536.
    std::size_t whole(std::size_t below) {
        const std::size_t high = below > 256 ? byte() : 0;
        return (high * 256 + byte()) % below;
    }

    /// Any number at all; most often a small one of few digits, so that things meet and line up.
    double number() {
        static constexpr std::array hard{0.,
                                         -0.,
                                         1e-9,
                                         1e-300,
                                         5e-324,
                                         1e9,
                                         1e300,
                                         std::numeric_limits<double>::infinity(),
                                         -std::numeric_limits<double>::infinity(),
                                         std::numeric_limits<double>::quiet_NaN()};
        const std::uint8_t how = byte();
        if (how < 200) return (static_cast<int>(byte()) - 128) / 16.;
        if (how < 230) return (static_cast<int>(byte()) - 128) / 16. + (how - 215) * 1e-12;
        if (how < 230 + hard.size()) return hard[how - 230u];
        double any = 0;
        std::array<std::uint8_t, sizeof any> raw{};
        for (std::uint8_t& part : raw) part = byte();
        std::memcpy(&any, raw.data(), sizeof any);
        return any;
    }
    glm::dvec3 point() {
        const double x = number(), y = number();
        return {x, y, number()};
    }
    /// In [0, size] x [0, size]: on a grid of quarters, next to it, or anywhere.
    glm::dvec2 inside(double size) {
        const auto along = [&] {
            const std::uint8_t how = byte();
            double x = byte() / 255. * size;
            if (how < 160) x = double(int(x * 4)) / 4;
            if (how >= 100 && how < 160) x += (how - 130) * 1e-13;
            return x < 0 ? 0 : x > size ? size : x;
        };
        const double x = along();
        return {x, along()};
    }

   private:
    std::span<const std::byte> bytes_;
};

}  // namespace povpreview::fuzz
