// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>

// The order of POV-Ray's headers matters: frame.h first, povdebug.h last.
// clang-format off
#include "backend/frame.h"
#include "backend/scene/view.h"
#include "backend/interior/media.h"
#include "backend/lighting/photons.h"
#include "backend/lighting/radiosity.h"
#include "backend/render/tracepixel.h"
// clang-format on

#include "backend/oracle/linear_light.h"

namespace povpreview::tracer {

/// What POV-Ray's own render task traces its samples with when it makes the image after a preview.
///
/// A sample that the preview has is not traced again. All others depend on their position alone, as
/// the preview's do (see OracleTask), so that the image does not depend on which were known.
/// Without a previewer it is TracePixel.
class FinishingPixel : public pov::TracePixel {
   public:
    FinishingPixel(pov::ViewData* view, pov::TraceThreadData* data, unsigned max_level, DBL bailout,
                   unsigned quality, pov::Trace::CooperateFunctor& cooperate,
                   pov::MediaFunction& media, pov::RadiosityFunction& radiosity);

    /// As TracePixel's; hides it.
    void operator()(DBL x, DBL y, DBL width, DBL height, pov::Colour& colour);

   private:
    pov::MediaFunction& media_;
    pov::RadiosityFunction& radiosity_;
};

/// How samples of the view in work become linear light; set before the first of them is finished.
void set_finishing_light(std::shared_ptr<const LinearLight> linear);

}  // namespace povpreview::tracer
