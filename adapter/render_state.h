// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace povpreview {

/// What POV-Ray shows while it renders, read from its render state file (`NAME.pov-state`, beside
/// the output): the file to which POV-Ray 3.7 appends, at once, every message about pixels that it
/// sends to its display, those of the mosaic preview too. So the file's size at a moment tells what
/// a display would show then, without a display.
///
///     512 bytes "POV-Ray Render State File"    then, big-endian, again and again:
///     "POVRAYMS"  version  size  "RAWS"  object of `size` bytes
///     object: "OBJE"  number of entries, then each entry: key  type  length  value
///
/// Lengths are in bytes, those of vectors ("VIN4", "VFL4") in numbers of 4 bytes.
class RenderState {
   public:
    /// A black picture. Sizes in pixels.
    RenderState(int width, int height);

    /// Takes in the next bytes of the file, from its begin on, in any portions. Messages not yet
    /// complete wait for the rest. Throws Error(Exit::tracer) for what is no render state file.
    void append(std::span<const std::byte> bytes);

    /// Row by row; in the scene's working gamma, unclamped.
    const std::vector<glm::vec3>& pixels() const { return pixels_; }
    /// Samples traced for it: pixels for which a colour has come, blocks counted once.
    std::size_t samples() const { return samples_; }

   private:
    bool take_message();
    void draw_object(std::span<const std::byte> object);

    int width_, height_;
    std::vector<glm::vec3> pixels_;
    std::size_t samples_ = 0;
    bool begun_ = false;  // the file's head has been read
    std::vector<std::byte> waiting_;
    std::size_t read_ = 0;  // of waiting_
};

}  // namespace povpreview
