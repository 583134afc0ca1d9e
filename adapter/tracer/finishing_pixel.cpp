// SPDX-License-Identifier: AGPL-3.0-or-later
#include "backend/oracle/finishing_pixel.h"

#include "backend/oracle/oracle.h"
#include "backend/oracle/seed.h"
#include "base/povdebug.h"

namespace povpreview::tracer {

namespace {

std::shared_ptr<const LinearLight> finishing_light;

}  // namespace

void set_finishing_light(std::shared_ptr<const LinearLight> linear) {
    finishing_light = std::move(linear);
}

FinishingPixel::FinishingPixel(pov::ViewData* view, pov::TraceThreadData* data, unsigned max_level,
                               DBL bailout, unsigned quality,
                               pov::Trace::CooperateFunctor& cooperate, pov::MediaFunction& media,
                               pov::RadiosityFunction& radiosity)
    : TracePixel(view, data, max_level, bailout, quality, cooperate, media, radiosity),
      media_(media),
      radiosity_(radiosity) {}

void FinishingPixel::operator()(DBL x, DBL y, DBL width, DBL height, pov::Colour& colour) {
    if (!enabled()) return TracePixel::operator()(x, y, width, height, colour);
    if (const FinishPart::Light* known = Oracle::instance().known().find(x, y)) {
        const LinearLight& linear = *finishing_light;
        const Rgb& light = known->colour;
        colour = pov::Colour(linear.working(light.r), linear.working(light.g),
                             linear.working(light.b), 0, known->transmittance);
        return;
    }
    const std::size_t seed = seed_of({x + 0.5, y + 0.5});
    Reseed(seed);
    media_.Reseed(seed);
    radiosity_.Freeze();
    radiosity_.Reseed(seed);
    TracePixel::operator()(x, y, width, height, colour);
}

}  // namespace povpreview::tracer
