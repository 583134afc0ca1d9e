// SPDX-License-Identifier: AGPL-3.0-or-later
#include "backend/oracle/drawable_looks.h"

#include <algorithm>
#include <cmath>
#include <optional>

// The order of POV-Ray's headers matters: frame.h first, povdebug.h last.
// clang-format off
#include "backend/frame.h"
#include "backend/pattern/pattern.h"
#include "backend/scene/objects.h"
#include "backend/support/imageutil.h"
#include "backend/texture/pigment.h"
#include "backend/texture/texture.h"
#include "base/image/image.h"
// clang-format on

#include "backend/oracle/drawable_patterns.h"
#include "backend/oracle/half_float.h"
#include "backend/oracle/surface_looks.h"
#include "backend/oracle/texture_parts.h"
#include "base/povdebug.h"

namespace povpreview::tracer {

namespace {

/// As wire::Mapping and wire::Interpolation.
enum Mapping : std::uint8_t { planar, spherical, cylindrical, toroidal, uv };
enum Interpolation : std::uint8_t { none, bilinear, bicubic, normalised_distance };

bool is_plain(const pov::TEXTURE& layer) {
    return layer.Type == pov::PLAIN_PATTERN && layer.Pigment != nullptr &&
           layer.Pigment->Type == pov::PLAIN_PATTERN;
}

/// What albedo is not a factor of: highlights and mirrors that take on the pigment's colour, light
/// below the surface.
bool colours_more_than_albedo(const pov::FINISH& finish) {
    const auto any = [](const pov::RGBColour& c) {
        return c.red() != 0 || c.green() != 0 || c.blue() != 0;
    };
    const bool mirror = any(finish.Reflection_Max) || any(finish.Reflection_Min),
               highlight = finish.Specular != 0 || finish.Phong != 0;
    return (finish.Metallic != 0 && highlight) || (finish.Reflect_Metallic != 0 && mirror) ||
           finish.UseSubsurface;
}

/// All that light meets in a texture, whatever pattern chooses, if it is the same everywhere but
/// for opaque pigments.
struct Surroundings {
    std::uint64_t finish = 0;
    const void* normal = nullptr;
    bool known = false;
};
bool only_pigments_vary(const pov::TEXTURE* top, Surroundings& around, int depth = 0) {
    constexpr int deepest = 30;
    if (top == nullptr || depth > deepest) return false;
    if (top->Type != pov::PLAIN_PATTERN) {
        if (next_layer(top) != nullptr) return false;
        bool all = true, any = false;
        for_each_choice(*top, [&](const pov::TEXTURE* choice) {
            any = true;
            all = all && only_pigments_vary(choice, around, depth + 1);
        });
        return any && all;
    }
    for (const pov::TEXTURE* layer = top; layer != nullptr; layer = next_layer(layer)) {
        if (layer->Type != pov::PLAIN_PATTERN || layer->Pigment == nullptr ||
            layer->Finish == nullptr || colours_more_than_albedo(*layer->Finish))
            return false;
        const bool lowest = next_layer(layer) == nullptr;
        if (lowest && (layer->Pigment->Flags & HAS_FILTER) != 0) return false;
        const Surroundings here{content_of_finish(layer->Finish), layer->Tnormal, true};
        if (around.known && (around.finish != here.finish || around.normal != here.normal))
            return false;
        around = here;
    }
    return true;
}

/// An image's `Gradient` says which axis is along its rows (above 0) and which along its columns
/// (below); of several the last counts.
LocalFrame turned_to_image(const LocalFrame& map, const pov::ImageData& image) {
    LocalFrame turned;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (image.Gradient[axis] > 0) turned.row[0] = map.row[axis];
        if (image.Gradient[axis] < 0) turned.row[1] = map.row[axis];
    }
    return turned;
}

}  // namespace

bool is_one_colour(const pov::TEXTURE& top) {
    for (const pov::TEXTURE* layer = &top; layer != nullptr; layer = next_layer(layer)) {
        if (!is_plain(*layer)) return false;
        if (next_layer(layer) == nullptr && (layer->Pigment->Flags & HAS_FILTER) != 0) return false;
    }
    return true;
}

LookFacts DrawableLooks::look(const pov::ObjectBase& object,
                              const std::vector<const pov::TEXTURE*>& textures) {
    // Without a texture of its own it takes those of others; with two, each has its side.
    if (textures.empty() || Test_Flag(&object, CUTAWAY_TEXTURES_FLAG)) return {};
    for (const pov::TEXTURE* texture : textures)
        if (texture == nullptr || texture != textures.front()) return {};
    return look_of_layers(*textures.front(), object);
}

LookFacts DrawableLooks::look_of_layers(const pov::TEXTURE& top, const pov::ObjectBase& object) {
    LookFacts look;
    if (is_one_colour(top)) {
        look.kind = LookKind::plain;
        return look;
    }
    const bool single = top.Type == pov::PLAIN_PATTERN && next_layer(&top) == nullptr &&
                        top.Pigment != nullptr && top.Finish != nullptr;
    if (single && top.Pigment->Type == pov::BITMAP_PATTERN &&
        !colours_more_than_albedo(*top.Finish) && draws_image(*top.Pigment, object, look))
        return look;
    Surroundings around;
    if (!only_pigments_vary(&top, around)) return look;
    look.kind = LookKind::traced;
    if (Test_Flag(&object, UV_FLAG)) return look;
    if (const auto drawable = pattern_of(top, linear_)) {
        look.kind = LookKind::pattern;
        look.pattern = drawable->pattern;
        look.to_map = drawable->to_pattern;
    }
    return look;
}

bool DrawableLooks::draws_image(const pov::PIGMENT& pigment, const pov::ObjectBase& object,
                                LookFacts& look) {
    const pov::ImageData* image = pigment.Vals.image;
    const bool own_coordinates = Test_Flag(&object, UV_FLAG);
    if (image == nullptr || image->data == nullptr || !is_image_opaque(image) ||
        image->AllFilter != 0 || image->AllTransmit != 0 || image->Offset[0] != 0 ||
        image->Offset[1] != 0 || (own_coordinates && !is_mesh(object)))
        return false;
    const std::optional<LocalFrame> map = map_of(pigment);
    if (!map) return false;
    look.to_map = *map;
    switch (image->Map_Type) {
        case pov::SPHERICAL_MAP:
            look.mapping = spherical;
            break;
        case pov::CYLINDRICAL_MAP:
            look.mapping = cylindrical;
            break;
        case pov::TORUS_MAP:
            // Ours has its large radius at 1.
            if (!(image->Gradient[0] > 0)) return false;
            look.mapping = toroidal;
            for (auto& row : look.to_map.row)
                for (double& value : row) value /= image->Gradient[0];
            break;
        default:
            look.mapping = own_coordinates ? uv : planar;
            look.to_map = turned_to_image(*map, *image);
    }
    if (own_coordinates && look.mapping != uv) return false;
    for (const auto& row : look.to_map.row)
        for (const double value : row)
            if (!std::isfinite(value)) return false;
    look.interpolation = image->Interpolation_Type == pov::BILINEAR          ? bilinear
                         : image->Interpolation_Type == pov::BICUBIC         ? bicubic
                         : image->Interpolation_Type == pov::NORMALIZED_DIST ? normalised_distance
                                                                             : none;
    look.once = image->Once_Flag;
    if (!add_image(*image, look.image)) return false;
    look.kind = LookKind::image;
    return true;
}

bool DrawableLooks::add_image(const pov::ImageData& image, std::uint32_t& number) {
    const auto [found, is_new] = number_of_.try_emplace(image.data);
    if (is_new) {
        const std::size_t texels = std::size_t{size_of(image).width} * size_of(image).height;
        const bool fits = texels > 0 && texels <= max_texels - texels_;
        found->second = {fits, static_cast<std::uint32_t>(images_.size())};
        too_large_ += !fits;
        if (fits) {
            images_.push_back(&image);
            texels_ += texels;
        }
    }
    number = found->second.second;
    return found->second.first;
}

ImageSize size_of(const pov::ImageData& image) {
    return {static_cast<std::uint32_t>(std::max(0, image.iwidth)),
            static_cast<std::uint32_t>(std::max(0, image.iheight))};
}

TexelChunk texels_of(const pov::ImageData& image, std::uint32_t first, std::uint32_t count) {
    TexelChunk chunk;
    chunk.first = first;
    chunk.halves.reserve(4 * std::size_t{count});
    const std::uint32_t width = size_of(image).width;
    for (std::uint32_t i = first; i < first + count; ++i) {
        pov::Colour colour;
        image.data->GetRGBFTValue(i % width, i / width, colour, false);
        for (const float value : {colour.red(), colour.green(), colour.blue(), colour.opacity()})
            chunk.halves.push_back(half_float(value));
    }
    return chunk;
}

}  // namespace povpreview::tracer
