// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "core/bf_squares.h"
#include "core/bucket_queue.h"
#include "core/detail/detail_map.h"
#include "core/halved_triangles.h"
#include "core/picture.h"
#include "core/pixel_memory.h"
#include "core/rung_shift.h"

namespace povpreview {

/// For scenes whose samples are so cheap that the work on a triangulation tells: right triangles
/// with samples at their corners, all on pixel centres. The two on the hypotenuse that promises
/// most are halved by a sample in its middle (see halved_triangles.h), and so on down to the
/// pixels, until each has its sample. Squares that the image's border cuts have the corners beyond
/// it drawn in.
///
/// Between the corners, pixels are interpolated linearly in encoded colour. A pixel whose item is
/// known takes only corners on that item; one whose albedo is known interpolates the light on it
/// (paper, section 2).
class AdaptiveLattice {
   public:
    /// Over the pixels of a picture, `squares`, which must outlive it; those that are known already
    /// are taken as they are. `first_side`: of the first squares, in pixels.
    /// REQUIRES: first_side is a power of two, at least 2.
    AdaptiveLattice(const BfSquares& squares, int width, int height, int first_side);

    /// A pixel that is to be asked for at once; nothing while answers must be waited for, or when
    /// all pixels are asked for. What is known of the pixels, `detail`, may be null.
    std::optional<Pixel> next(const DetailMap* detail);
    /// Takes the light of a pixel, after `squares`; again where it was traced more accurately.
    void accept(Pixel pixel, const RungLight& light);
    /// More has become known of the pixels: what diamonds promise is reckoned anew.
    void accept_detail(const DetailMap& detail);
    /// The same around a pixel that was found to show something else than was thought.
    void accept_doubt(Pixel pixel, const DetailMap& detail);

    /// Adds to a picture, in which the known pixels stand, those that lie between them. `anchors`:
    /// for each item a pixel whose sample stands for it where no corner does, or none.
    void draw(Picture& picture, const DetailMap* detail, std::span<const Pixel> anchors) const;
    static constexpr Pixel no_anchor = 0xffffffff;

   private:
    enum class State : std::uint8_t {
        open = 0,  ///< its diamond may be halved
        asked,     ///< its sample is on its way
        corner     ///< of triangles
    };
    /// A point whose sample is on its way.
    struct Coming {
        LatticePoint point;
        std::size_t complete_after;  ///< answers, from the beginning
    };
    struct Light {
        glm::vec3 illumination, remainder;
    };
    struct Part {
        Pixel pixel;
        float share;
    };
    using Parts3 = std::array<Part, 3>;
    /// The corners of a diamond's triangles, as far as those are there.
    struct Corners {
        std::array<Pixel, 4> pixels;
        int count = 0;
        std::span<const Pixel> all() const { return std::span(pixels).first(std::size_t(count)); }
    };
    /// A triangle and all that it is a part of, largest first.
    using Path = std::vector<HalvedTriangle>;

    LatticePoint drawn_in(LatticePoint point) const;
    Pixel pixel_at(LatticePoint point) const;
    bool is_root(LatticePoint point) const;
    bool is_in(LatticePoint centre) const;
    State& state(LatticePoint point);
    State state(LatticePoint point) const;

    void ask(LatticePoint point);
    void take_complete(const DetailMap* detail);
    void take(LatticePoint corner, const DetailMap* detail);
    template <class Visit>
    void for_each_square(const Visit& visit) const;
    template <class Visit>
    void for_each_leaf(Path& path, const Visit& visit) const;
    std::optional<LatticePoint> open_centre_at(Pixel pixel) const;
    void weigh(LatticePoint centre, const DetailMap* detail);
    Corners corners(const Diamond& diamond) const;
    float weight(const Diamond& diamond, const DetailMap* detail) const;
    int orphans(const Diamond& diamond, const Corners& corners, const DetailMap& detail) const;
    float contrast(std::span<const Pixel> corners, const DetailMap* detail) const;
    std::optional<glm::vec3> shown(Pixel pixel) const;
    float jump(Pixel p, Pixel q) const;
    const Light* light_at(Pixel pixel) const;

    Parts3 parts(const HalvedTriangle& triangle, int x, int y) const;
    std::optional<Parts3> parts_on(std::uint32_t item, const Path& path, int x, int y,
                                   const DetailMap& detail, std::span<const Pixel> anchors) const;
    std::optional<LatticePoint> better_diagonal(const HalvedTriangle& triangle) const;
    void draw(Path& path, const DetailMap* detail, std::span<const Pixel> anchors,
              Picture& picture) const;
    void draw(const Path& path, int x, int y, const DetailMap* detail,
              std::span<const Pixel> anchors, Picture& picture) const;
    bool mix(std::span<const Part> parts, glm::vec3& encoded) const;
    bool mix_light(std::span<const Part> parts, const glm::vec3& albedo, glm::vec3& linear) const;

    const BfSquares& squares_;
    int width_, height_, first_side_;
    int right_, below_;                     // the last points, at or beyond the image's border
    PixelMemory<glm::vec3> encoded_;        // by BfSquares::number(): the samples, unclamped
    PixelMemory<std::uint32_t> lights_of_;  // by the same: 1 + number in lights_; 0: not known
    std::vector<Light> lights_;
    PixelMemory<State> states_;       // by point
    std::size_t roots_left_ = 0;      // corners of the first squares that are on their way
    std::deque<LatticePoint> asked_;  // to be asked for next, oldest first
    std::deque<Coming> coming_;       // oldest first
    BucketQueue<LatticePoint> open_;  // centres of diamonds not halved yet, some of them twice
};

}  // namespace povpreview
