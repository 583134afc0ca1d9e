// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

namespace povpreview::tracer {

/// Stands for "not during this sample" beside POV-Ray's own quality flags, in the copy of them that
/// belongs to a thread (TraceThreadData::qualityFlags), so that all that a thread traces with heeds
/// them, the rays that radiosity gathers included. POV-Ray itself sets none of them.
enum TraceFlags : unsigned {
    /// As if there were no photons. Before their maps are complete nobody may touch them.
    ignore_photons = 0x10000,
    /// Shadows leave room for light that photons will bring, but the maps are not touched.
    presume_photons = 0x20000,
    /// Two samples in each interval of media will do, however many they want.
    coarse_media = 0x40000,
    /// Radiosity is what its cache holds by now, and nothing is gathered for it.
    radiosity_so_far = 0x80000,

    no_photons_gathered = ignore_photons | presume_photons
};

}  // namespace povpreview::tracer
