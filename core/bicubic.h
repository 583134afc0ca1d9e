// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "core/cubic_lattice.h"
#include "core/pixel_canvas.h"
#include "core/previewer.h"

namespace povpreview {

/// Low resolution with bicubic interpolation: pixel centres on a lattice of 32 pixels, whose
/// spacing is halved again and again down to single pixels. The lattice starts at the upper left
/// pixel and always has the last column and row too, so that each one contains the one before: a
/// level traces only what is new (about three quarters of it), and every pixel is traced once, at
/// its centre.
///
/// Between the points, cubics with Catmull and Rom's tangents, which go through the samples. While
/// a level is being traced, its missing points are interpolated from the level before. A pixel with
/// a sample shows the sample itself.
class Bicubic final : public Previewer {
   public:
    /// What is interpolated. Of a disc over a turned checker at 640 x 480, L1 of encoded colour at
    /// 1 / 5 / 25 % of the samples: encoded .060 / .030 / .011, linear .068 / .035 / .012.
    enum class Colour { linear, encoded };

    Bicubic(int width, int height, Colour colour = Colour::encoded);

    std::string_view name() const override { return "bicubic"; }
    Parts parts() const override { return Parts::colour; }
    std::optional<Request> next() override;
    void accept(const Sample& sample) override;
    bool done() const override;
    Picture picture(Overlay overlay) const override;
    Statistics statistics() const override;

   private:
    struct Point {
        int x, y, spacing;
    };

    void start_level(int spacing);
    /// Moves the cursor to the next point not on the level before; starts levels as needed.
    void advance();
    bool on_lattice(int x, int y, int spacing) const;
    /// The lattice with this spacing, missing points interpolated from the one before.
    Lattice lattice(int spacing) const;

    Colour colour_;
    PixelCanvas canvas_;                ///< the samples, linear
    std::vector<glm::vec3> values_;     ///< the samples as they are interpolated
    std::vector<std::uint8_t> known_;   ///< 1 where a pixel has its sample
    std::vector<int> columns_, rows_;   ///< of the level being asked for
    int spacing_ = 0;                   ///< of the level being asked for, pixels; 0: all asked for
    std::size_t column_ = 0, row_ = 0;  ///< the cursor
    std::deque<Point> outstanding_;
    int answered_spacing_;  ///< of the level that was answered last, pixels
    std::vector<glm::vec2> samples_;
};

}  // namespace povpreview
