// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/detail/albedo_fetch.h"

#include <algorithm>

namespace povpreview {

namespace {

/// Edges between colours nearer than this (colour_distance()) tell nothing.
constexpr float least_jump = 4e-4f;

/// The dearest albedo rays, against full samples, that are worth having: where the albedo is known
/// to vary, and where nothing is known but that colours differ. A full sample does away with all of
/// a pixel's error.
constexpr double dearest_albedo = .32, dearest_look = .06;

/// Edges that must tell of a surface's texture before it is fetched as a whole.
constexpr std::uint32_t edges_for_whole = 4;

/// Edges within a surface that must tell of light, and to how many of them one may tell of a
/// texture, before its albedo is wanted no more.
constexpr std::uint32_t edges_to_give_up = 16, explained_to_give_up = 8;

/// What albedo rays may cost, against the full samples of the same time: at first the light on
/// surfaces is worth as much as their texture.
constexpr double albedo_share = 1;
/// Rays that may be earned in advance.
constexpr double most_credit = 1024;

}  // namespace

bool AlbedoFetch::affordable() const { return price_ <= dearest_albedo; }

void AlbedoFetch::set_price(double price) {
    price_ = price;
    if (!affordable()) return;
    asked_.resize(squares_.squares());
    fetched_.resize(squares_.pixels());
}

bool AlbedoFetch::tells(std::uint32_t p, std::uint32_t q, float jump, bool explained) {
    if (jump < least_jump || !affordable()) return false;
    if (std::max(p, q) < DetailMap::unknown) {
        if (items_.size() <= std::max(p, q)) items_.resize(std::max(p, q) + 1);
        for (std::uint32_t item : {p, q}) {
            ++(explained ? items_[item].explained : items_[item].unexplained);
            if (explained) items_[item].jumps += jump;
            if (p == q) break;
        }
        Item& item = items_[p];
        if (p == q && !item.whole && item.explained >= edges_for_whole &&
            item.explained > item.unexplained) {
            item.whole = true;
            whole_.push_back(p);
        }
    }
    return explained || (price_ <= dearest_look && !(p == q && is_no_texture(p)));
}

/// Whether many edges within an item have differed in light, and hardly any in albedo.
bool AlbedoFetch::is_no_texture(std::uint32_t item) const {
    return item < items_.size() && items_[item].unexplained >= edges_to_give_up &&
           items_[item].explained * explained_to_give_up < items_[item].unexplained;
}

void AlbedoFetch::want(std::size_t square) {
    if (!affordable() || asked_[square] || squares_.filling(square)) return;
    asked_[square] = true;
    wanted_.push_back(square);
}

void AlbedoFetch::full_asked() { credit_ = std::min(credit_ + albedo_share / price_, most_credit); }

std::optional<Pixel> AlbedoFetch::next(const DetailMap* detail) {
    if (credit_ < 1) return std::nullopt;
    auto pixel = next_wanted(detail);
    if (!pixel && detail) pixel = next_of_whole(*detail);
    if (!pixel) return std::nullopt;
    credit_ -= 1;
    fetched_[*pixel] = true;
    return pixel;
}

std::optional<Pixel> AlbedoFetch::next_wanted(const DetailMap* detail) {
    while (!wanted_.empty()) {
        while (scanned_ < BfSquares::side * BfSquares::side) {
            const auto pixel = squares_.pixel_in(wanted_.front(), scanned_++);
            if (pixel && is_open(*pixel, detail)) return pixel;
        }
        wanted_.pop_front();
        scanned_ = 0;
    }
    return std::nullopt;
}

std::optional<Pixel> AlbedoFetch::next_of_whole(const DetailMap& detail) {
    for (;;) {
        while (!rest_.empty()) {
            const Pixel pixel = rest_.back();
            rest_.pop_back();
            const std::size_t square = squares_.square_of(pixel);
            if (is_open(pixel, &detail) && !asked_[square] && !squares_.filling(square))
                return pixel;
        }
        if (whole_.empty()) return std::nullopt;
        begin_whole(detail);
    }
}

/// The surface whose texture is seen most; its pixels square by square.
void AlbedoFetch::begin_whole(const DetailMap& detail) {
    const auto seen = [&](std::uint32_t i) {
        return items_[i].jumps / static_cast<float>(items_[i].explained);
    };
    const auto most =
        std::max_element(whole_.begin(), whole_.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return seen(a) < seen(b); });
    const std::uint32_t item = *most;
    whole_.erase(most);
    for (Pixel pixel = 0; pixel < squares_.pixels(); ++pixel)
        if (detail.item(pixel) == item && is_open(pixel, &detail)) rest_.push_back(pixel);
    std::stable_sort(rest_.begin(), rest_.end(), [&](Pixel a, Pixel b) {
        return squares_.square_of(a) > squares_.square_of(b);
    });
}

void AlbedoFetch::number_again(const std::vector<std::uint32_t>& now) {
    std::vector<Item> items;
    for (std::size_t item = 0; item < items_.size(); ++item) {
        if (now[item] == ItemNumbers::several) continue;
        if (items.size() <= now[item]) items.resize(now[item] + 1);
        items[now[item]] = items_[item];
    }
    items_ = std::move(items);
    for (std::uint32_t& item : whole_) item = now[item];
    std::erase(whole_, ItemNumbers::several);
}

void AlbedoFetch::clear() {
    wanted_.clear();
    whole_.clear();
    rest_.clear();
    scanned_ = 0;
}

}  // namespace povpreview
