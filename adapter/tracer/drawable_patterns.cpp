// SPDX-License-Identifier: AGPL-3.0-or-later
#include "backend/oracle/drawable_patterns.h"

#include <cmath>

// The order of POV-Ray's headers matters: frame.h first, povdebug.h last.
// clang-format off
#include "backend/frame.h"
#include "backend/pattern/pattern.h"
#include "backend/pattern/warps.h"
#include "backend/texture/pigment.h"
#include "backend/texture/texture.h"
// clang-format on

#include "backend/oracle/texture_parts.h"
#include "base/povdebug.h"

namespace povpreview::tracer {

namespace {

/// As wire::PatternKind.
enum Kind : std::uint8_t { checker, brick, hexagon };

/// The colour of a pigment that is of one all over, if it is opaque.
std::optional<pov::Colour> colour_of(const pov::PIGMENT* pigment) {
    if (pigment == nullptr || pigment->Type != pov::PLAIN_PATTERN ||
        pigment->colour.filter() != 0 || pigment->colour.transm() != 0)
        return std::nullopt;
    return pigment->colour;
}
std::optional<pov::Colour> colour_of(const pov::TEXTURE* texture) {
    if (texture == nullptr || texture->Type != pov::PLAIN_PATTERN || next_layer(texture) != nullptr)
        return std::nullopt;
    return colour_of(texture->Pigment);
}
std::optional<pov::Colour> colour_of(const pov::BLEND_MAP_ENTRY& entry, int type) {
    switch (type) {
        case COLOUR_TYPE: {
            const pov::Colour colour(entry.Vals.colour);
            if (colour.filter() != 0 || colour.transm() != 0) return std::nullopt;
            return colour;
        }
        case PIGMENT_TYPE:
            return colour_of(entry.Vals.Pigment);
        case TEXTURE_TYPE:
            return colour_of(entry.Vals.Texture);
        default:
            return std::nullopt;
    }
}

/// The pattern of a pigment or a block texture.
std::optional<DrawablePattern> pattern_of(const pov::TPATTERN& from, const LinearLight& linear) {
    DrawablePattern result;
    PatternFacts& to = result.pattern;
    int count = 2;
    switch (from.Type) {
        case pov::CHECKER_PATTERN:
            to.kind = checker;
            break;
        case pov::BRICK_PATTERN: {
            to.kind = brick;
            const auto& bricks = from.Vals.Brick;
            to.brick_size = {bricks.Size[0], bricks.Size[1], bricks.Size[2]};
            to.mortar = bricks.Mortar;
            const Point& size = to.brick_size;
            if (!(size.x > 0 && size.y > 0 && size.z > 0) || !is_finite(size) ||
                !std::isfinite(to.mortar))
                return std::nullopt;
            break;
        }
        case pov::HEXAGON_PATTERN:
            to.kind = hexagon;
            count = 3;
            break;
        default:
            return std::nullopt;
    }
    // A frequency or a wave would make other numbers of those that choose the colours.
    const pov::BLEND_MAP* choices = from.Blend_Map;
    if (from.Frequency != 0 || from.Wave_Type != RAMP_WAVE || choices == nullptr ||
        choices->Number_Of_Entries != count)
        return std::nullopt;
    for (int i = 0; i < count; ++i) {
        const pov::BLEND_MAP_ENTRY& entry = choices->Blend_Map_Entries[i];
        const std::optional<pov::Colour> colour = colour_of(entry, choices->Type);
        if (!colour || entry.value != static_cast<float>(i)) return std::nullopt;
        const Rgb light = linear(pov::RGBColour(*colour));
        if (!std::isfinite(light.r + light.g + light.b)) return std::nullopt;
        to.colours[static_cast<std::size_t>(i)] = {light.r, light.g, light.b};
    }
    const std::optional<LocalFrame> map = map_of(from);
    if (!map) return std::nullopt;
    result.to_pattern = *map;
    for (const auto& row : map->row)
        for (const double value : row)
            if (!std::isfinite(value)) return std::nullopt;
    return result;
}

}  // namespace

std::optional<LocalFrame> map_of(const pov::TPATTERN& pattern) {
    LocalFrame map;
    for (std::size_t i = 0; i < 3; ++i) map.row[i][i] = 1;
    for (const pov::WARP* warp = pattern.Warps; warp != nullptr; warp = warp->Next_Warp) {
        if (warp->Warp_Type == NO_WARP) continue;
        if (warp->Warp_Type != TRANSFORM_WARP) return std::nullopt;
        const auto& m = static_cast<const pov::TRANS*>(warp)->Trans.inverse;
        LocalFrame next;
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 4; ++j) {
                next.row[i][j] = j == 3 ? m[3][i] : 0;
                for (std::size_t k = 0; k < 3; ++k) next.row[i][j] += m[k][i] * map.row[k][j];
            }
        map = next;
    }
    return map;
}

std::optional<DrawablePattern> pattern_of(const pov::TEXTURE& top, const LinearLight& linear) {
    if (next_layer(&top) != nullptr) return std::nullopt;
    if (top.Type != pov::PLAIN_PATTERN)
        return pattern_of(static_cast<const pov::TPATTERN&>(top), linear);
    // At low quality POV-Ray takes the quick colour instead.
    constexpr float none = -1;
    const pov::PIGMENT* pigment = top.Pigment;
    if (pigment == nullptr || pigment->Quick_Colour.red() != none ||
        pigment->Quick_Colour.green() != none || pigment->Quick_Colour.blue() != none)
        return std::nullopt;
    return pattern_of(static_cast<const pov::TPATTERN&>(*pigment), linear);
}

}  // namespace povpreview::tracer
