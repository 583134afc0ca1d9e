// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "backend/oracle/samples.h"

namespace povpreview::tracer {

/// The samples at the pixel centres of a completed preview, from which POV-Ray's image is made.
///
/// Filled by the thread that reads orders, read by those that trace, never at the same time: the
/// WorkQueue is closed between.
class KnownPixels {
   public:
    /// Before the scene is announced: the picture's size.
    void set_size(unsigned width, unsigned height);

    /// False if some of it lies outside of the picture.
    bool add(const FinishPart& part);

    /// What is known at a position in POV-Ray's pixel coordinates, in which (x, y) in whole numbers
    /// is the centre of a pixel; null if that is no pixel's centre, or not known.
    const FinishPart::Light* find(double x, double y) const;

   private:
    unsigned width_ = 0, height_ = 0;
    std::vector<FinishPart::Light> light_;  ///< empty until something is known
};

}  // namespace povpreview::tracer
