// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/bicubic.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "core/colour_table.h"

namespace povpreview {
namespace {

constexpr int first_spacing = 32;  ///< pixels; the first blocks of the mosaic, for comparison

/// 0, spacing, 2 spacing, ... and the last pixel.
std::vector<int> lattice_points(int side, int spacing) {
    std::vector<int> points;
    for (int p = 0; p < side - 1; p += spacing) points.push_back(p);
    points.push_back(side - 1);
    return points;
}

}  // namespace

Bicubic::Bicubic(int width, int height, Colour colour)
    : colour_(colour),
      canvas_(width, height),
      values_(std::size_t(width) * std::size_t(height)),
      known_(values_.size(), 0),
      answered_spacing_(first_spacing) {
    assert(width >= 1 && height >= 1);
    start_level(first_spacing);
}

bool Bicubic::on_lattice(int x, int y, int spacing) const {
    return (x % spacing == 0 || x == canvas_.width() - 1) &&
           (y % spacing == 0 || y == canvas_.height() - 1);
}

void Bicubic::start_level(int spacing) {
    spacing_ = spacing;
    column_ = row_ = 0;
    if (spacing_ == 0) return;
    columns_ = lattice_points(canvas_.width(), spacing_);
    rows_ = lattice_points(canvas_.height(), spacing_);
}

void Bicubic::advance() {
    do {
        if (++column_ == columns_.size()) column_ = 0, ++row_;
        if (row_ == rows_.size()) start_level(spacing_ / 2);
    } while (spacing_ > 0 && spacing_ < first_spacing &&
             on_lattice(columns_[column_], rows_[row_], 2 * spacing_));
}

std::optional<Request> Bicubic::next() {
    if (spacing_ == 0) return std::nullopt;
    const Point point{columns_[column_], rows_[row_], spacing_};
    outstanding_.push_back(point);
    advance();
    return Request{pixel_centre(point.x, point.y)};
}

void Bicubic::accept(const Sample& sample) {
    assert(!outstanding_.empty());
    const Point p = outstanding_.front();
    outstanding_.pop_front();
    const std::size_t i = canvas_.index(p.x, p.y);
    canvas_.at(p.x, p.y) = sample.colour;
    for (int k = 0; k < 3; ++k) {
        // What is not a number stays where it is, and does not spread to its surroundings.
        const float c = std::isfinite(sample.colour[k]) ? sample.colour[k] : 0;
        values_[i][k] = colour_ == Colour::encoded ? encode_srgb(c) : c;
    }
    known_[i] = 1;
    answered_spacing_ = p.spacing;
    samples_.push_back(sample.position);
}

bool Bicubic::done() const { return samples_.size() == known_.size(); }

Lattice Bicubic::lattice(int spacing) const {
    Lattice lattice{
        lattice_points(canvas_.width(), spacing), lattice_points(canvas_.height(), spacing), {}};
    const std::size_t wide = lattice.columns.size();
    if (spacing == answered_spacing_ && spacing < first_spacing) {
        lattice.values = interpolate(this->lattice(2 * spacing), lattice.columns, lattice.rows);
    } else {
        lattice.values.resize(wide * lattice.rows.size());
    }
    for (std::size_t j = 0; j < lattice.rows.size(); ++j) {
        for (std::size_t i = 0; i < wide; ++i) {
            const std::size_t pixel = canvas_.index(lattice.columns[i], lattice.rows[j]);
            glm::vec3& value = lattice.values[j * wide + i];
            if (known_[pixel]) {
                value = values_[pixel];
            } else if (spacing == first_spacing) {
                // Nothing to interpolate from yet: the point above stands in, or the one before.
                if (j > 0) {
                    value = lattice.values[(j - 1) * wide + i];
                } else if (i > 0) {
                    value = lattice.values[i - 1];
                }
            }
        }
    }
    return lattice;
}

Picture Bicubic::picture(Overlay overlay) const {
    Picture picture = canvas_.picture();
    if (overlay == Overlay::samples) picture.samples = samples_;
    if (done()) return picture;
    Lattice finest = lattice(answered_spacing_);
    std::vector<glm::vec3> smooth = answered_spacing_ == 1
                                        ? std::move(finest.values)
                                        : interpolate(finest, lattice_points(canvas_.width(), 1),
                                                      lattice_points(canvas_.height(), 1));
    if (colour_ == Colour::encoded)
        for (glm::vec3& colour : smooth) colour = decode_quickly(colour);
    for (std::size_t i = 0; i < smooth.size(); ++i) {
        if (!known_[i]) picture.pixels[i] = smooth[i];
    }
    return picture;
}

Statistics Bicubic::statistics() const {
    Statistics statistics;
    statistics.filled = samples_.size();
    return statistics;
}

}  // namespace povpreview
