// SPDX-License-Identifier: AGPL-3.0-or-later
#include "backend/oracle/scene_contents.h"

#include <unordered_set>

// The order of POV-Ray's headers matters: frame.h first, povdebug.h last.
// clang-format off
#include "backend/frame.h"
#include "backend/interior/interior.h"
#include "backend/lighting/subsurface.h"
#include "backend/pattern/pattern.h"
#include "backend/scene/objects.h"
#include "backend/texture/texture.h"
// clang-format on

#include "backend/oracle/object_kinds.h"
#include "base/povdebug.h"

namespace povpreview::tracer {

namespace {

/// In the order of pov::PATTERN_IDS.
const char* const pattern_names[] = {
    "none",          "plain",        "average",  "uv_mapping", "image_map", "waves",
    "ripples",       "wrinkles",     "bumps",    "quilted",    "facets",    "dents",
    "checker",       "object",       "brick",    "cubic",      "square",    "triangular",
    "hexagon",       "bozo",         "cells",    "marble",     "wood",      "spotted",
    "agate",         "granite",      "gradient", "onion",      "leopard",   "julia",
    "julia",         "julia",        "julia",    "mandel",     "mandel",    "mandel",
    "mandel",        "magnet",       "magnet",   "magnet",     "magnet",    "radial",
    "crackle",       "spiral1",      "spiral2",  "planar",     "spherical", "boxed",
    "cylindrical",   "density_file", "function", "slope",      "aoi",       "pigment_pattern",
    "image_pattern", "pavement",     "tiling"};
static_assert(sizeof(pattern_names) / sizeof(*pattern_names) == pov::TILING_PATTERN + 1);

const char* pattern_name(unsigned type) {
    return type < sizeof(pattern_names) / sizeof(*pattern_names) ? pattern_names[type] : "other";
}

class Walk {
   public:
    explicit Walk(SceneFacts& facts) : facts_(facts) {}

    void object(const pov::ObjectBase& object) {
        ++facts_.objects[object_kind(object)];
        texture(object.Texture);
        texture(object.Interior_Texture);
        feature(object.Interior_Texture != nullptr, "interior_texture");
        feature(!object.Clip.empty(), "clipped");
        feature((object.Flags & UV_FLAG) != 0, "uv_mapping");
        feature((object.Flags & NO_SHADOW_FLAG) != 0 &&
                    dynamic_cast<const pov::LightSource*>(&object) == nullptr,
                "no_shadow");
        if (object.interior != nullptr) interior(*object.interior);
        if ((object.Type & IS_COMPOUND_OBJECT) == 0) return;
        for (const pov::ObjectPtr child : static_cast<const pov::CompoundObject&>(object).children)
            if (child != nullptr) this->object(*child);
    }

   private:
    void feature(bool present, const char* name) {
        if (present) facts_.features.insert(name);
    }

    void interior(const pov::Interior& interior) {
        if (!seen_.insert(&interior).second) return;
        feature(interior.IOR != 0 && interior.IOR != 1, "refraction");
        feature(interior.Disp_NElems > 0 && interior.Dispersion != 1, "dispersion");
        feature(!interior.media.empty(), "media");
    }

    /// Textures are shared between objects; each is counted once.
    void texture(const pov::TEXTURE* first) {
        for (const pov::TEXTURE* texture = first; texture != nullptr;
             texture = reinterpret_cast<const pov::TEXTURE*>(texture->Next)) {
            if (!seen_.insert(texture).second) return;
            feature(texture->Next != nullptr, "layered_texture");
            if (texture->Type == pov::PLAIN_PATTERN) {
                layer(*texture);
                continue;
            }
            feature(true, "texture_map");
            ++facts_.textures[std::string("texture:") + pattern_name(texture->Type)];
            for (const pov::TEXTURE* material = texture->Materials; material != nullptr;
                 material = material->Next_Material)
                this->texture(material);
            if (texture->Blend_Map == nullptr) continue;
            for (int i = 0; i < texture->Blend_Map->Number_Of_Entries; ++i)
                this->texture(texture->Blend_Map->Blend_Map_Entries[i].Vals.Texture);
        }
    }

    void layer(const pov::TEXTURE& layer) {
        if (layer.Pigment != nullptr) pigment(*layer.Pigment);
        feature(layer.Tnormal != nullptr, "perturbed_normal");
        if (layer.Finish == nullptr) return;
        const pov::FINISH& finish = *layer.Finish;
        feature(!finish.Reflection_Max.isZero() || !finish.Reflection_Min.isZero(), "reflection");
        feature(finish.Phong > 0 || finish.Specular > 0, "highlight");
        feature(finish.Irid > 0, "iridescence");
        feature(finish.Crand > 0, "grain");
        feature(finish.DiffuseBack > 0, "translucency");
        feature(!finish.Emission.isZero(), "emission");
    }

    void pigment(const pov::PIGMENT& pigment) {
        const bool image = pigment.Type == pov::BITMAP_PATTERN;
        if (seen_.insert(&pigment).second) ++facts_.textures[pattern_name(pigment.Type)];
        feature((pigment.Flags & HAS_FILTER) != 0, "transparency");
        feature(image, "image_map");
        feature(pigment.Type > pov::BITMAP_PATTERN || image, "texture");
    }

    SceneFacts& facts_;
    std::unordered_set<const void*> seen_;
};

}  // namespace

void add_contents(SceneFacts& facts, const std::vector<pov::ObjectPtr>& objects) {
    Walk walk(facts);
    for (const pov::ObjectPtr object : objects)
        if (object != nullptr) walk.object(*object);
}

}  // namespace povpreview::tracer
