// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

/// The tracer's end of the wire, linked into POV-Ray (see patches/). These files are copied to
/// source/backend/oracle/ of POV-Ray's tree and built there with POV-Ray's own settings.
///
/// What crosses between the threads of the tracer, in plain numbers: this header and those that
/// include nothing but it know neither POV-Ray nor the wire format.
namespace povpreview::tracer {

/// As wire::RayKind and core/oracle.h.
enum class RayKind : std::uint8_t { full, probe, albedo };

/// The rung of the finished render; those below it are numbered from 0, the cheapest.
constexpr std::uint8_t target_rung = 0xff;

/// Which vectors an answer carries; as wire::Parts, plus the colour that only full rays have.
struct Parts {
    bool light = false;
    bool surface = false;
    bool shading = false;
    bool signature = false;
};

struct Position {
    double x, y;  ///< pixel coordinates; (.5, .5) is the centre of the first pixel
};

struct Rgb {
    float r = 0, g = 0, b = 0;
};

/// As Sample::no_reflection of core/oracle.h.
constexpr std::uint32_t no_reflection = 0xffffffff;

/// One sample in linear light; the fields are those of core/oracle.h.
struct Sample {
    bool failed = false;
    Rgb light;
    float transmittance = 0;
    std::uint32_t surface = 0, reflected_surface = 0;
    float depth = 0;
    Rgb normal;
    Rgb albedo, illumination, remainder;
    std::uint32_t primary = 0, lights = 0, reflected = 0, refracted = 0;
    std::uint32_t cost_ns = 0;
};

/// An order for samples.
struct Batch {
    std::uint64_t number = 0;
    RayKind kind = RayKind::full;
    std::uint8_t rung = target_rung;  ///< of full rays
    Parts parts;
    std::vector<Position> positions;

    bool wants_target() const { return kind == RayKind::full && rung == target_rung; }
};

/// A chunk of the finished picture; as wire::Image.
struct FinishPart {
    struct Light {
        Rgb colour;
        float transmittance;
    };
    std::uint32_t first = 0;
    std::vector<Light> light;
    bool last = false;
};

}  // namespace povpreview::tracer
