// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "core/bf_squares.h"
#include "core/detail/detail_map.h"

namespace povpreview {

/// Decides which albedo rays are worth their cost, square by square.
///
/// An edge of the mesh whose ends differ in colour but not in light tells of a texture: the albedo
/// along it is wanted before all other. A surface of which many edges tell so is fetched as a
/// whole, the more its texture is seen the sooner (paper, section 2: when the density of samples
/// over its projection passes a threshold); one that is hardly lit never tells anything.
class AlbedoFetch {
   public:
    explicit AlbedoFetch(const BfSquares& squares) : squares_(squares) {}

    /// What an albedo ray costs against a full sample; until it is known none is worth it.
    void set_price(double price);
    double price() const { return price_; }
    /// Whether such rays are worth having anywhere; else nothing is ever wanted, nor allocated.
    bool affordable() const;

    /// An edge that is refined, between two items (which may be one), `jump` its colour_distance();
    /// `explained`: the light hardly differs. Returns whether the albedo along it is wanted.
    bool tells(std::uint32_t p, std::uint32_t q, float jump, bool explained);
    /// Wants what is not known of a square before anything else.
    void want(std::size_t square);
    /// A full sample was asked for: albedo rays may cost as much.
    void full_asked();

    /// The pixel to fetch next, if any, none of them twice; `detail`, what is known so far, may be
    /// null.
    std::optional<Pixel> next(const DetailMap* detail);
    /// Items have got other numbers: by former number, what it is now, see ItemNumbers::add().
    void number_again(const std::vector<std::uint32_t>& now);
    /// Forgets all that is wanted.
    void clear();

   private:
    struct Item {
        std::uint32_t explained = 0, unexplained = 0;  ///< edges
        float jumps = 0;                               ///< sum of those explained
        bool whole = false;                            ///< is fetched as a whole, or was
    };
    bool is_no_texture(std::uint32_t item) const;
    std::optional<Pixel> next_wanted(const DetailMap* detail);
    std::optional<Pixel> next_of_whole(const DetailMap& detail);
    void begin_whole(const DetailMap& detail);
    bool is_open(Pixel pixel, const DetailMap* detail) const {
        return !fetched_[pixel] && (!detail || detail->wants_albedo(pixel));
    }

    const BfSquares& squares_;
    double price_ = 1e9;
    double credit_ = 0;                 ///< albedo rays that may be asked for now
    std::vector<std::uint8_t> asked_;   // by square
    std::vector<bool> fetched_;         // by pixel: asked for, answered or not
    std::deque<std::size_t> wanted_;    // squares
    int scanned_ = 0;                   // pixels of the first of them that need no request
    std::vector<Item> items_;           // by item
    std::vector<std::uint32_t> whole_;  // items to be fetched as a whole
    std::vector<Pixel> rest_;           // of the one that is being fetched, last first
};

}  // namespace povpreview
