// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

// The order of POV-Ray's headers matters: frame.h first, povdebug.h last.
// clang-format off
#include "backend/frame.h"
#include "backend/colour/colour.h"
#include "base/image/colourspace.h"
// clang-format on

#include "backend/oracle/samples.h"

namespace pov {
class SceneData;
}

namespace povpreview::tracer {

/// Turns colours in a scene's working gamma into linear light, such that encoding them by the sRGB
/// curve gives what POV-Ray itself writes into a PNG.
///
/// With `assumed_gamma`, or `#version 3.7` and later, POV-Ray decodes by that gamma and encodes by
/// sRGB. Older scenes have no notion of gamma: POV-Ray writes their numbers as they are, so here
/// they are taken as sRGB-encoded.
class LinearLight {
   public:
    /// `version` is the language version of the command line, 0 if none: 3.7 or later there turns
    /// gamma handling on for old scenes too (RenderFrontend::CreateView).
    LinearLight(const pov::SceneData& scene, float version);

    float operator()(float working) const;
    Rgb operator()(const pov::RGBColour& working) const;
    /// The inverse.
    float working(float linear) const;

    /// Exponent that decodes the working colours, approximately.
    float gamma() const;

   private:
    pov_base::SimpleGammaCurvePtr curve_;
};

}  // namespace povpreview::tracer
