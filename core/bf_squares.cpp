// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/bf_squares.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace povpreview {

BfSquares::BfSquares(int width, int height)
    : width_(width),
      height_(height),
      columns_((width + side - 1) / side),
      rows_((height + side - 1) / side),
      colours_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)),
      numbers_(colours_.size()),
      states_(colours_.size()),
      counts_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)),
      filling_(counts_.size()) {
    static_assert(side * side <= 255, "counts are bytes");
}

Pixel BfSquares::pixel_at(glm::dvec2 position) const {
    const int x = std::clamp(static_cast<int>(std::floor(position.x)), 0, width_ - 1);
    const int y = std::clamp(static_cast<int>(std::floor(position.y)), 0, height_ - 1);
    return static_cast<Pixel>(y) * static_cast<Pixel>(width_) + static_cast<Pixel>(x);
}

glm::dvec2 BfSquares::centre(Pixel pixel) const {
    const auto width = static_cast<Pixel>(width_);
    return {pixel % width + .5, pixel / width + .5};
}

std::size_t BfSquares::square_of(Pixel pixel) const {
    const auto width = static_cast<Pixel>(width_);
    return pixel / width / side * static_cast<std::size_t>(columns_) + pixel % width / side;
}

glm::ivec2 BfSquares::origin(std::size_t square) const {
    const auto columns = static_cast<std::size_t>(columns_);
    return {static_cast<int>(square % columns) * side, static_cast<int>(square / columns) * side};
}

int BfSquares::area(std::size_t square) const {
    const glm::ivec2 low = origin(square);
    return std::min(side, width_ - low.x) * std::min(side, height_ - low.y);
}

void BfSquares::request(Pixel pixel) {
    assert(states_[pixel] == State::unsampled);
    states_[pixel] = State::requested;
    ++counts_[square_of(pixel)];
    ++requested_;
}

void BfSquares::answer(Pixel pixel, const glm::vec3& colour) {
    assert(states_[pixel] == State::requested);
    states_[pixel] = State::known;
    numbers_[pixel] = static_cast<std::uint32_t>(answered());
    colours_[number(pixel)] = colour;
    ++known_;
}

void BfSquares::fail(Pixel pixel) {
    assert(states_[pixel] == State::requested);
    states_[pixel] = State::failed;
    numbers_[pixel] = static_cast<std::uint32_t>(answered());
    ++failed_;
}

void BfSquares::replace(Pixel pixel, const glm::vec3& colour) {
    assert(has_colour(pixel) || states_[pixel] == State::failed);
    colours_[number(pixel)] = colour;
    if (states_[pixel] != State::failed) return;
    states_[pixel] = State::known;
    --failed_;
    ++known_;
}

void BfSquares::spoil(Pixel pixel) {
    if (states_[pixel] == State::failed) return;
    assert(has_colour(pixel));
    states_[pixel] = State::failed;
    --known_;
    ++failed_;
}

void BfSquares::fill(std::size_t square) {
    if (filling_[square]) return;
    filling_[square] = true;
    queue_.push_back(square);
}

void BfSquares::set_meshed(Pixel pixel, bool meshed) {
    assert(has_colour(pixel));
    states_[pixel] = meshed ? State::meshed : State::known;
}

std::optional<Pixel> BfSquares::pixel_in(std::size_t square, int n) const {
    const glm::ivec2 low = origin(square);
    const int x = low.x + n % side, y = low.y + n / side;
    if (x >= width_ || y >= height_) return std::nullopt;
    return static_cast<Pixel>(y) * static_cast<Pixel>(width_) + static_cast<Pixel>(x);
}

std::optional<Pixel> BfSquares::next_to_fill() {
    while (!queue_.empty()) {
        for (; scanned_ < side * side; ++scanned_) {
            const auto pixel = pixel_in(queue_.front(), scanned_);
            if (pixel && states_[*pixel] == State::unsampled) return pixel;
        }
        queue_.pop_front();
        scanned_ = 0;
    }
    return std::nullopt;
}

bool BfSquares::mean_around(Pixel pixel, glm::vec3& mean) const {
    const int x = static_cast<int>(pixel) % width_, y = static_cast<int>(pixel) / width_;
    glm::vec3 sum(0);
    int count = 0;
    for (int j = std::max(0, y - 1); j <= std::min(height_ - 1, y + 1); ++j)
        for (int i = std::max(0, x - 1); i <= std::min(width_ - 1, x + 1); ++i) {
            const auto neighbour = static_cast<Pixel>(j * width_ + i);
            if (!has_colour(neighbour)) continue;
            sum += colour(neighbour);
            ++count;
        }
    if (count == 0) return false;
    mean = sum / static_cast<float>(count);
    return true;
}

void BfSquares::draw(Picture& picture) const {
    picture.pixels.resize(states_.size());
    picture.known.resize(states_.size());
    for (Pixel pixel = 0; pixel < states_.size(); ++pixel) {
        if (has_colour(pixel)) picture.pixels[pixel] = colour(pixel);
        // A failed pixel without known ones around it leaves its place to the triangles.
        switch (states_[pixel]) {
            case State::meshed:
                picture.known[pixel] = filling_[square_of(pixel)];
                break;
            case State::known:
                picture.known[pixel] = 1;
                break;
            case State::failed:
                picture.known[pixel] = mean_around(pixel, picture.pixels[pixel]);
                break;
            default:
                break;
        }
    }
}

}  // namespace povpreview
