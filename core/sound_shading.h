// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "core/colour.h"
#include "core/oracle.h"

namespace povpreview {

/// Whether a sample's shading came, which may not have been wanted yet when the sample was asked
/// for, and can be reckoned with.
inline bool has_sound_shading(const Sample& sample) {
    return contains(sample.parts, Parts::shading) && sample.surface != 0 && finite(sample.albedo) &&
           finite(sample.illumination) && finite(sample.remainder);
}

}  // namespace povpreview
