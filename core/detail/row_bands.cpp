// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/detail/row_bands.h"

#include <algorithm>
#include <atomic>
#include <system_error>
#include <thread>
#include <vector>

namespace povpreview {

namespace {

int processors() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

}  // namespace

void for_each_band(int top, int bottom, int rows, const std::function<void(int, int, int)>& work) {
    const int bands = std::max(0, (bottom - top + rows - 1) / rows);
    std::atomic<int> next{0};
    const auto take_bands = [&] {
        for (int band = next++; band < bands; band = next++) {
            const int first = top + band * rows;
            work(band, first, std::min(first + rows, bottom));
        }
    };
    // Fewer rows are done before another thread has begun.
    constexpr int rows_a_thread = 128;
    const int threads = std::min({bands, processors(), 1 + (bottom - top) / rows_a_thread});
    std::vector<std::jthread> others;
    try {
        for (int i = 1; i < threads; ++i) others.emplace_back(take_bands);
    } catch (const std::system_error&) {  // no more threads are to be had: those that are will do
    }
    take_bands();
}

int rows_for_threads(int rows) {
    constexpr int bands_a_thread = 4;
    return std::max(1, rows / (bands_a_thread * processors()));
}

void draw_bands(ItemCanvas& canvas, int rows, const std::function<void(ItemCanvas&)>& draw) {
    const PixelBox area = canvas.area();
    std::vector<ItemCanvas> bands;
    for (int top = area.top; top < area.bottom; top += rows)
        bands.push_back(canvas.band(top, top + rows));
    for_each_band(area.top, area.bottom, rows,
                  [&](int band, int, int) { draw(bands[std::size_t(band)]); });
    for (ItemCanvas& band : bands) canvas.take_ties(std::move(band));
}

}  // namespace povpreview
