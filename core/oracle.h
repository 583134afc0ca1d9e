// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

/// The one interface that a ray tracer implements for the preview.
///
/// Pixel coordinates: x right, y down; pixel (i, j) covers [i, i+1) x [j, j+1) and its centre is
/// (i + .5, j + .5). Positions are real numbers; a sample is the light along one ray through one
/// position, with no filtering over the pixel.
namespace povpreview {

/// How much of a sample is computed. Cheaper kinds leave the other parts zero.
enum class RayKind : std::uint8_t {
    full,   ///< everything the renderer computes
    probe,  ///< surface and signature, no shading
    albedo  ///< surface and albedo of the first hit, or of what it mirrors (see Sample)
};

/// The parts of a full sample that its user wants; parts not wanted are not recorded, which costs
/// the tracer less. Colour and cost always come. Combine with `|`.
enum class Parts : std::uint8_t {
    colour = 0,
    surface = 1,    ///< surface, reflected surface, depth, normal
    shading = 2,    ///< albedo, illumination, remainder
    signature = 4,  ///< ray-tree signature
};
constexpr Parts operator|(Parts a, Parts b) {
    return static_cast<Parts>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}
constexpr bool contains(Parts all, Parts part) {
    return (static_cast<unsigned>(all) & static_cast<unsigned>(part)) != 0;
}
constexpr bool contains_all(Parts all, Parts parts) { return (all | parts) == all; }

/// How accurately a full ray is traced: a number from 0, the cheapest, up a ladder that the scene
/// defines (see ladder.h). The top is always target_rung: what the renderer itself would compute.
using Rung = std::uint8_t;
inline constexpr Rung target_rung = 0xff;

struct Request {
    glm::dvec2 position;  ///< pixel coordinates; need not lie inside the image
    RayKind kind = RayKind::full;
    Rung rung = target_rung;  ///< full rays; a rung that is not ready is waited for
};

/// The shape of a ray tree, a hash per level: two samples with equal hashes at a level met the same
/// surfaces and lights there. 0 where the level is empty.
struct Signature {
    std::uint32_t primary = 0;    ///< the surfaces that the eye ray meets
    std::uint32_t lights = 0;     ///< for each light: lit, blocked, partly lit or filtered
    std::uint32_t reflected = 0;  ///< everything behind reflection rays
    std::uint32_t refracted = 0;  ///< everything behind refraction rays
    bool operator==(const Signature&) const = default;
};

/// What one ray found. Colours are linear light, scene-referred and unclamped:
/// `colour = albedo * illumination + remainder`, with illumination accumulated as if the pigment
/// were white, so that it stays smooth under any texture.
///
/// On a mirror of one colour, whose own albedo tells nothing, albedo and illumination are those of
/// the surface that its first reflected ray meets, the illumination as much of it as is reflected.
/// Of what that ray meets in its turn they tell nothing.
struct Sample {
    glm::dvec2 position{};
    RayKind kind = RayKind::full;
    Rung rung = target_rung;    ///< full rays: traced at that asked for, or a higher one
    bool failed = false;        ///< the tracer could not answer; every other part is zero
    Parts parts{};              ///< full rays: those that were asked for; the others are zero
    glm::vec3 colour{};         ///< full rays
    float transmittance = 0;    ///< full rays: share of the background that shines through, 0..1
    std::uint32_t surface = 0;  ///< identity of the first surface (object and face); 0: none hit
    /// What the first ray meets that it reflects; 0: nothing. Albedo rays tell it only of mirrors
    /// of one colour.
    std::uint32_t reflected_surface = 0;
    static constexpr std::uint32_t no_reflection = 0xffffffff;  ///< it reflects none
    float depth = 0;           ///< distance from the eye to it in scene units; 0: none hit
    glm::vec3 normal{};        ///< its geometric normal in world space, towards the eye
    glm::vec3 albedo{};        ///< its pigment's colour, or that of what it mirrors
    glm::vec3 illumination{};  ///< light falling on it, as scattered to the eye by white
    glm::vec3 remainder{};     ///< light that does not pass through its pigment
    Signature signature{};
    std::uint32_t cost_ns = 0;  ///< time this ray took in the tracer, nanoseconds
};

/// An ordered pipe: requests go in, samples come out in the order of the requests.
///
/// A sample of the lowest rung or the target depends on its position and kind alone, never on what
/// was traced before, on the batches, or on the number of threads; one of a rung between them may.
/// Faults of the tracer (death, stall, garbage) are mended or reported behind this interface: every
/// request is answered in the end, if need be by a sample marked `failed`; what cannot be mended
/// throws `Error`.
class SampleOracle {
   public:
    virtual ~SampleOracle() = default;

    /// Queues requests and returns at once.
    virtual void submit(std::span<const Request> requests, Parts parts) = 0;

    /// Appends to `samples` the answers that have come, oldest request first. Waits for the first
    /// one at most `patience`; appends nothing when none came or none is due.
    virtual void collect(std::vector<Sample>& samples, std::chrono::nanoseconds patience) = 0;
};

}  // namespace povpreview
