// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

// The order of POV-Ray's headers matters: frame.h first, povdebug.h last.
// clang-format off
#include "backend/frame.h"
// clang-format on

#include "backend/oracle/geometry_facts.h"
#include "backend/oracle/linear_light.h"

namespace pov {
class ImageData;
}

namespace povpreview::tracer {

/// Tells what of a material's albedo, as SampleRecorder has it, can be drawn without tracing, and
/// which images that takes.
class DrawableLooks {
   public:
    /// Texels of all images together; what would exceed it is left to be traced.
    static constexpr std::size_t max_texels = 8000000;

    explicit DrawableLooks(const LinearLight& linear) : linear_(linear) {}

    /// The look of a surface with these textures; what its number is, the caller says.
    LookFacts look(const pov::ObjectBase& object, const std::vector<const pov::TEXTURE*>& textures);

    /// By number.
    const std::vector<const pov::ImageData*>& images() const { return images_; }
    /// How many images there were too many texels in.
    unsigned too_large() const { return too_large_; }

   private:
    LookFacts look_of_layers(const pov::TEXTURE& top, const pov::ObjectBase& object);
    bool draws_image(const pov::PIGMENT& pigment, const pov::ObjectBase& object, LookFacts& look);
    bool add_image(const pov::ImageData& image, std::uint32_t& number);

    LinearLight linear_;
    std::vector<const pov::ImageData*> images_;
    /// By what POV-Ray read; nothing if it is too large.
    std::map<const void*, std::pair<bool, std::uint32_t>> number_of_;
    std::size_t texels_ = 0;
    unsigned too_large_ = 0;
};

/// One opaque colour all over: layers of one colour each, the lowest opaque.
bool is_one_colour(const pov::TEXTURE& top);

/// Texels [first, first + count) of an image, row by row from the top, as POV-Ray looks them up.
TexelChunk texels_of(const pov::ImageData& image, std::uint32_t first, std::uint32_t count);
ImageSize size_of(const pov::ImageData& image);

}  // namespace povpreview::tracer
