// SPDX-License-Identifier: AGPL-3.0-or-later
#include "backend/oracle/linear_light.h"

#include <cmath>

// The order of POV-Ray's headers matters: frame.h first, povdebug.h last.
// clang-format off
#include "backend/frame.h"
#include "backend/scene/scene.h"
#include "base/povmsgid.h"
// clang-format on

#include "base/povdebug.h"

namespace povpreview::tracer {

LinearLight::LinearLight(const pov::SceneData& scene, float version) {
    if (scene.gammaMode == kPOVList_GammaMode_None) {
        if (version < 3.7f) curve_ = pov_base::SRGBGammaCurve::Get();
    } else if (!pov_base::GammaCurve::IsNeutral(scene.workingGamma)) {
        curve_ = scene.workingGamma;
    }
}

float LinearLight::operator()(float working) const {
    if (!curve_) return working;
    // Powers are for positive numbers; POV-Ray clips the others when it writes, the previewer may
    // still interpolate them.
    return std::copysign(curve_->Decode(std::fabs(working)), working);
}

Rgb LinearLight::operator()(const pov::RGBColour& working) const {
    return {(*this)(working.red()), (*this)(working.green()), (*this)(working.blue())};
}

float LinearLight::working(float linear) const {
    if (!curve_) return linear;
    return std::copysign(curve_->Encode(std::fabs(linear)), linear);
}

float LinearLight::gamma() const { return curve_ ? curve_->ApproximateDecodingGamma() : 1.0f; }

}  // namespace povpreview::tracer
