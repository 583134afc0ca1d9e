// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "core/oracle.h"

/// Samples as bytes, in the machine's own byte order, with nothing but the parts they have.
namespace povpreview {

void encode_sample(std::string& bytes, const Sample& sample);

/// Tells of all samples in `bytes`; false if they are no samples, or do not end with one.
bool decode_samples(std::string_view bytes, const std::function<void(const Sample&)>& each);

}  // namespace povpreview
