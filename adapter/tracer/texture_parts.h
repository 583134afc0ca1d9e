// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

// The order of POV-Ray's headers matters: frame.h first, povdebug.h last.
// clang-format off
#include "backend/frame.h"
// clang-format on

/// What POV-Ray's textures are made of.
namespace povpreview::tracer {

/// The layer below; null under the lowest.
inline const pov::TEXTURE* next_layer(const pov::TEXTURE* texture) {
    return reinterpret_cast<const pov::TEXTURE*>(texture->Next);
}

/// Calls `see` for the textures that a texture pattern chooses from.
template <typename See>
void for_each_choice(const pov::TEXTURE& texture, See see) {
    for (const pov::TEXTURE* m = texture.Materials; m != nullptr; m = m->Next_Material) see(m);
    if (texture.Blend_Map == nullptr) return;
    for (int i = 0; i < texture.Blend_Map->Number_Of_Entries; ++i)
        see(texture.Blend_Map->Blend_Map_Entries[i].Vals.Texture);
}

}  // namespace povpreview::tracer
