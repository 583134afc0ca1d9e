// SPDX-License-Identifier: AGPL-3.0-or-later
#include "backend/oracle/surface_looks.h"

#include <algorithm>
#include <cstring>

// The order of POV-Ray's headers matters: frame.h first, povdebug.h last.
// clang-format off
#include "backend/frame.h"
#include "backend/scene/objects.h"
#include "backend/lighting/point.h"
#include "backend/shape/blob.h"
#include "backend/shape/mesh.h"
#include "backend/support/imageutil.h"
#include "backend/texture/texture.h"
// clang-format on

#include "backend/oracle/hash.h"
#include "backend/oracle/texture_parts.h"
#include "base/povdebug.h"

namespace povpreview::tracer {

namespace {

/// Light passes only where it passes through all layers.
bool is_transparent(const pov::TEXTURE* texture) {
    for (; texture != nullptr; texture = next_layer(texture)) {
        if (texture->Type == pov::PLAIN_PATTERN) {
            if ((texture->Pigment->Flags & HAS_FILTER) == 0) return false;
            continue;
        }
        bool choice = false;
        for_each_choice(*texture,
                        [&choice](const pov::TEXTURE* t) { choice = choice || is_transparent(t); });
        // A material map that is used once leaves everything outside of it empty.
        const bool once = texture->Type == pov::BITMAP_PATTERN && texture->Vals.image != nullptr &&
                          texture->Vals.image->Once_Flag;
        if (!choice && !once) return false;
    }
    return true;
}

float grey(const pov::RGBColour& c) {
    return static_cast<float>((c.red() + c.green() + c.blue()) / 3);
}

float reflection(const pov::FINISH& finish) {
    return std::clamp((grey(finish.Reflection_Max) + grey(finish.Reflection_Min)) / 2, 0.0f, 1.0f);
}

/// The strongest reflection in a texture; negative where something makes the normal bumpy.
float mirror_of(const pov::TEXTURE* texture) {
    constexpr float bumpy = -1;
    float strongest = 0;
    for (; texture != nullptr; texture = next_layer(texture)) {
        if (texture->Type == pov::PLAIN_PATTERN) {
            if (texture->Tnormal != nullptr) return bumpy;
            if (texture->Finish != nullptr)
                strongest = std::max(strongest, reflection(*texture->Finish));
            continue;
        }
        bool any_bumpy = false;
        for_each_choice(*texture, [&](const pov::TEXTURE* choice) {
            const float mirror = mirror_of(choice);
            any_bumpy = any_bumpy || mirror < 0;
            strongest = std::max(strongest, mirror);
        });
        if (any_bumpy) return bumpy;
    }
    return strongest;
}

/// The least that a finish reflects from anywhere. After Fresnel that is next to nothing.
float least_reflection(const pov::FINISH& finish) {
    if (finish.Reflection_Type != 0) return 0;
    return std::min(grey(finish.Reflection_Max), grey(finish.Reflection_Min));
}

/// The least that a texture reflects anywhere.
float least_mirror_of(const pov::TEXTURE* texture) {
    float strongest = 0;
    for (; texture != nullptr; texture = next_layer(texture)) {
        float least = 1;
        bool any = false;
        const auto choose = [&](float reflected) {
            any = true;
            least = std::min(least, reflected);
        };
        if (texture->Type != pov::PLAIN_PATTERN)
            for_each_choice(*texture,
                            [&](const pov::TEXTURE* choice) { choose(least_mirror_of(choice)); });
        else if (texture->Finish != nullptr)
            choose(least_reflection(*texture->Finish));
        if (any) strongest = std::max(strongest, least);
    }
    return std::clamp(strongest, 0.0f, 1.0f);
}

// ---- content

std::uint64_t bits(double value) {
    if (value == 0) return 0;  // of either sign
    std::uint64_t result;
    std::memcpy(&result, &value, sizeof result);
    return result;
}
template <typename Pointed>
std::uint64_t bits(const Pointed* pointer) {
    return reinterpret_cast<std::uintptr_t>(pointer);
}

std::uint64_t add(std::uint64_t hash, const pov::RGBColour& c) {
    return mix(mix(mix(hash, bits(c.red())), bits(c.green())), bits(c.blue()));
}

std::uint64_t content(const pov::PIGMENT* pigment) {
    if (pigment == nullptr || pigment->Type != pov::PLAIN_PATTERN) return bits(pigment);
    const std::uint64_t hash = add(1, pov::RGBColour(pigment->colour));
    return mix(mix(hash, bits(pigment->colour.filter())), bits(pigment->colour.transm()));
}

}  // namespace

std::uint64_t content_of_finish(const pov::FINISH* finish) {
    if (finish == nullptr) return 0;
    const pov::FINISH& f = *finish;
    std::uint64_t hash = 2;
    for (const double value :
         {f.Diffuse, f.DiffuseBack, f.Brilliance, f.Specular, f.Roughness, f.Phong, f.Phong_Size,
          f.Irid, f.Irid_Film_Thickness, f.Irid_Turb, f.Reflect_Exp, f.Crand, f.Metallic,
          f.Reflection_Falloff, f.Reflect_Metallic})
        hash = mix(hash, bits(value));
    for (const pov::RGBColour& colour : {f.Ambient, f.Emission, f.Reflection_Max, f.Reflection_Min,
                                         f.SubsurfaceTranslucency, f.SubsurfaceAnisotropy})
        hash = add(hash, colour);
    return mix(mix(hash, static_cast<std::uint64_t>(f.Reflection_Type)),
               static_cast<std::uint64_t>(2 * f.Conserve_Energy + f.UseSubsurface));
}

namespace {

std::uint64_t content(const pov::TEXTURE* texture) {
    std::uint64_t hash = 3;
    for (; texture != nullptr; texture = next_layer(texture))
        if (texture->Type == pov::PLAIN_PATTERN)
            hash =
                mix(mix(mix(hash, content(texture->Pigment)), content_of_finish(texture->Finish)),
                    bits(texture->Tnormal));
        else
            hash = mix(hash, bits(texture));
    return hash;
}

std::uint64_t content(const pov::Interior* interior) {
    if (interior == nullptr) return 0;
    if (!interior->media.empty() || interior->subsurface != nullptr) return bits(interior);
    std::uint64_t hash = 4;
    for (const double value :
         {interior->IOR, interior->Dispersion, interior->Caustics, interior->Old_Refract,
          interior->Fade_Distance, interior->Fade_Power})
        hash = mix(hash, bits(value));
    return add(hash, interior->Fade_Colour);
}

}  // namespace

bool is_mesh(const pov::ObjectBase& object) {
    return dynamic_cast<const pov::Mesh*>(&object) != nullptr;
}

bool plain_mirror(const pov::TEXTURE& top) {
    constexpr float least_mirror = .2f;  // as in the previewer, core/detail/mirrored_items.h
    return is_one_colour(top) && least_mirror_of(&top) >= least_mirror && mirror_of(&top) > 0;
}

Look SurfaceLooks::of(const pov::ObjectBase& object, const pov::MESH_TRIANGLE* triangle) {
    Surface surface{&object, {}};
    if (triangle != nullptr) {
        pov::TEXTURE* const* textures = static_cast<const pov::Mesh&>(object).Textures;
        if (triangle->ThreeTex)
            surface.second = {textures[triangle->Texture], textures[triangle->Texture2],
                              textures[triangle->Texture3]};
        else
            surface.second = {textures[triangle->Texture]};
    }
    const auto found = known_.find(surface);
    if (found != known_.end()) return found->second;
    return known_[surface] = look(surface);
}

Look SurfaceLooks::look(const Surface& surface) {
    const pov::ObjectBase& object = *surface.first;
    Textures textures = surface.second;
    if (textures.empty() && object.Texture != nullptr) textures = {object.Texture};
    if (const auto* blob = dynamic_cast<const pov::Blob*>(&object))
        for (int i = 0; i < blob->Data->Number_Of_Components; ++i)
            if (blob->Element_Texture[i] != nullptr) textures.push_back(blob->Element_Texture[i]);
    if (object.Interior_Texture != nullptr) textures.push_back(object.Interior_Texture);
    Look look;
    // Without a texture of its own it takes those of the objects that it cuts.
    look.transparent = textures.empty();
    std::uint64_t hash = textures.empty() ? bits(&object) : 0;
    bool bumpy = false;
    for (const pov::TEXTURE* texture : textures) {
        look.transparent = look.transparent || is_transparent(texture);
        const float mirror = mirror_of(texture);
        bumpy = bumpy || mirror < 0;
        look.mirror = std::max(look.mirror, mirror);
        hash = mix(hash, content(texture));
    }
    if (bumpy) look.mirror = 0;
    if (look.transparent) hash = mix(hash, content(object.interior));
    // Of objects with coordinates of their own, those of meshes are known.
    if ((object.Flags & UV_FLAG) != 0)
        hash = mix(mix(hash, bits(object.UV_Trans)), is_mesh(object) ? 1 : 2);
    const auto [found, is_new] =
        materials_.try_emplace(hash, static_cast<std::uint32_t>(materials_.size() + 1));
    look.material = found->second;
    if (is_new) {
        new_.push_back(drawable_.look(object, textures));
        new_.back().material = look.material;
        float& mirror = new_.back().mirror = textures.empty() || bumpy ? 0.0f : 1.0f;
        for (const pov::TEXTURE* texture : textures)
            mirror = std::min(mirror, least_mirror_of(texture));
    }
    return look;
}

}  // namespace povpreview::tracer
