// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

// The order of POV-Ray's headers matters: frame.h first, povdebug.h last.
// clang-format off
#include "backend/frame.h"
// clang-format on

#include "backend/oracle/drawable_looks.h"

namespace pov {
struct Mesh_Triangle_Struct;
}

namespace povpreview::tracer {

/// What the textures of a surface say about it as a whole.
struct Look {
    /// Equal where textures (and interiors, if one sees into them) are the same by content: plain
    /// colours and finishes are compared by value, patterns by identity. Never 0.
    std::uint32_t material = 0;
    bool transparent = false;  ///< some light may pass through some part of it
    float mirror = 0;          ///< share of light that it reflects, 0..1; 0 if its normal is bumpy
};

/// A hash by value.
std::uint64_t content_of_finish(const pov::FINISH* finish);
bool is_mesh(const pov::ObjectBase& object);
/// Whether a surface with this texture alone has one colour all over, and reflects so much without
/// bending it that the previewer takes it for a mirror where it is flat.
bool plain_mirror(const pov::TEXTURE& top);

class SurfaceLooks {
   public:
    explicit SurfaceLooks(const LinearLight& linear) : drawable_(linear) {}

    /// `triangle` (may be null) has textures of its own.
    Look of(const pov::ObjectBase& object, const pov::Mesh_Triangle_Struct* triangle);
    /// What can be drawn of the materials that came up since this was last asked.
    std::vector<LookFacts> take_new() { return std::exchange(new_, {}); }
    DrawableLooks& drawable() { return drawable_; }

   private:
    using Textures = std::vector<const pov::TEXTURE*>;
    using Surface = std::pair<const pov::ObjectBase*, Textures>;

    Look look(const Surface& surface);

    std::map<Surface, Look> known_;
    std::unordered_map<std::uint64_t, std::uint32_t> materials_;  ///< number by hash of the content
    DrawableLooks drawable_;
    std::vector<LookFacts> new_;
};

}  // namespace povpreview::tracer
