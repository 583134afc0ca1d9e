// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "core/picture.h"
#include "core/pixel_memory.h"

namespace povpreview {

/// A pixel's number: row by row from the top.
using Pixel = std::uint32_t;

/// What is known pixel by pixel, and the regular grid of squares laid over it: where samples stand
/// so densely that interpolation is of no use, all pixels of the square are traced ("BF-squares",
/// brute force, paper section 2). Each pixel's sample is traced once, at the pixel's centre.
class BfSquares {
   public:
    /// Side of a square in pixels.
    static constexpr int side = 8;

    enum class State : std::uint8_t {
        unsampled = 0,  // as PixelMemory is at first
        requested,
        meshed,  ///< known, and a vertex of the mesh shows it
        known,   ///< known to the pixel alone
        failed   ///< answered without a value
    };

    BfSquares(int width, int height);

    State state(Pixel pixel) const { return states_[pixel]; }
    bool has_colour(Pixel pixel) const {
        return states_[pixel] == State::meshed || states_[pixel] == State::known;
    }
    const glm::vec3& colour(Pixel pixel) const { return colours_[number(pixel)]; }
    /// The number of a pixel that has been answered, from 0 in the order in which they were.
    /// REQUIRES: it has been answered, or failed.
    std::uint32_t number(Pixel pixel) const { return numbers_[pixel]; }
    Pixel pixel_at(glm::dvec2 position) const;  ///< clamped to the image
    glm::dvec2 centre(Pixel pixel) const;

    /// Marks an unsampled pixel as asked for.
    void request(Pixel pixel);
    /// Takes the answer for a requested pixel.
    void answer(Pixel pixel, const glm::vec3& colour);
    void fail(Pixel pixel);
    /// Takes another colour for a pixel that has been answered, or failed.
    void replace(Pixel pixel, const glm::vec3& colour);
    /// Has a pixel that has been answered fail after all.
    void spoil(Pixel pixel);
    /// Says whether a vertex of the mesh shows a known pixel.
    void set_meshed(Pixel pixel, bool meshed);

    std::size_t pixels() const { return states_.size(); }
    std::size_t requested() const { return requested_; }  ///< ever, answered or not
    std::size_t known() const { return known_; }          ///< meshed or not
    std::size_t answered() const { return known_ + failed_; }

    // Squares are numbered row by row.
    std::size_t squares() const { return counts_.size(); }
    int columns() const { return columns_; }
    std::size_t square_of(Pixel pixel) const;
    /// Pixels of the square asked for so far.
    int count(std::size_t square) const { return counts_[square]; }
    /// Pixels in the square, fewer at the right and lower border.
    int area(std::size_t square) const;
    /// The n-th pixel of a whole square; nothing where that lies outside of the image.
    std::optional<Pixel> pixel_in(std::size_t square, int n) const;
    /// Calls visit(pixel) for each that has a colour; quick as long as those are few.
    template <class Visit>
    void for_each_known(const Visit& visit) const {
        for (std::size_t square = 0; square < squares(); ++square)
            for (int i = 0; count(square) > 0 && i < side * side; ++i)
                if (const auto pixel = pixel_in(square, i); pixel && has_colour(*pixel))
                    visit(*pixel);
    }
    /// Whether the square has been given to `fill`.
    bool filling(std::size_t square) const { return filling_[square]; }

    /// Has the rest of a square traced, after those given before it.
    void fill(std::size_t square);
    /// The next unsampled pixel of the squares to be filled.
    std::optional<Pixel> next_to_fill();

    /// Adds to a picture the known pixels of squares being filled, and those elsewhere that no
    /// vertex shows. A failed pixel takes the mean of the pixels around it.
    void draw(Picture& picture) const;

   private:
    glm::ivec2 origin(std::size_t square) const;
    bool mean_around(Pixel pixel, glm::vec3& mean) const;

    int width_, height_, columns_, rows_;
    // As they came, not as they lie: few samples touch little memory then.
    PixelMemory<glm::vec3> colours_;      // by number
    PixelMemory<std::uint32_t> numbers_;  // of pixels answered
    PixelMemory<State> states_;
    std::vector<std::uint8_t> counts_;
    std::vector<std::uint8_t> filling_;
    std::deque<std::size_t> queue_;  // squares being filled, oldest first
    int scanned_ = 0;                // pixels of the first of them that need no request
    std::size_t requested_ = 0, known_ = 0, failed_ = 0;
};

}  // namespace povpreview
