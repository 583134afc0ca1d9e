// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <deque>
#include <functional>
#include <random>
#include <vector>

#include "core/oracle.h"
#include "core/sample_memory.h"

namespace povpreview {

/// An image and its surfaces as functions of position.
struct FunctionImage {
    std::function<glm::vec3(glm::dvec2)> colour;
    std::function<std::uint32_t(glm::dvec2)> surface = [](glm::dvec2) { return 1u; };
    std::function<bool(glm::dvec2)> fails = [](glm::dvec2) { return false; };
    /// What the light on the first surface is multiplied by.
    std::function<glm::vec3(glm::dvec2)> albedo = [](glm::dvec2) { return glm::vec3(1); };

    /// What is seen in the first surface (Sample::reflected_surface).
    std::function<std::uint32_t(glm::dvec2)> reflected = [](glm::dvec2) {
        return Sample::no_reflection;
    };

    /// What rays cost; 0: not known, and so not worth a guess.
    std::uint32_t full_ns = 0, albedo_ns = 0;

    /// The rungs below the target, which is the above.
    struct LowerRung {
        std::function<glm::vec3(glm::dvec2)> colour;
        std::uint32_t full_ns = 0;
    };
    std::vector<LowerRung> lower{};

    Sample sample(const Request& request) const {
        Sample sample;
        sample.position = request.position;
        sample.kind = request.kind;
        sample.rung = request.rung;
        sample.parts = Parts::surface | Parts::shading | Parts::signature;
        const bool low = request.kind == RayKind::full && request.rung < lower.size();
        sample.cost_ns = request.kind == RayKind::full ? full_ns : albedo_ns;
        if (low) sample.cost_ns = lower[request.rung].full_ns;
        sample.failed = fails(request.position);
        if (sample.failed) return sample;
        sample.surface = surface(request.position);
        sample.signature.primary = sample.surface;
        if (request.kind != RayKind::albedo) sample.reflected_surface = reflected(request.position);
        if (request.kind != RayKind::probe) sample.albedo = albedo(request.position);
        if (request.kind != RayKind::full) return sample;
        sample.colour =
            low ? lower[request.rung].colour(request.position) : colour(request.position);
        for (int k = 0; k < 3; ++k)
            if (sample.albedo[k] > 0)
                sample.illumination[k] = sample.colour[k] / sample.albedo[k];
            else
                sample.remainder[k] = sample.colour[k];
        return sample;
    }
};

/// A tracer made of functions. Answers come in order but in groups: all that are due, or as many as
/// a seeded generator says, none at times, so that tests can show that grouping does not matter.
class FunctionOracle : public SampleOracle {
   public:
    explicit FunctionOracle(FunctionImage image, std::uint32_t grouping_seed = 0)
        : image_(std::move(image)), random_(grouping_seed), grouped_(grouping_seed != 0) {}

    void submit(std::span<const Request> requests, Parts parts) override {
        for (const Request& request : requests) queue_.push_back({request, parts});
        asked.insert(asked.end(), requests.begin(), requests.end());
    }
    void collect(std::vector<Sample>& samples, std::chrono::nanoseconds) override {
        std::size_t count = queue_.size();
        if (grouped_) count = std::min<std::size_t>(count, random_() % (1u << random_() % 10));
        for (; count > 0; --count) {
            const Request& next = queue_.front().request;
            if (!target_ready && next.kind == RayKind::full && next.rung == target_rung) return;
            samples.push_back(answer(queue_.front()));
            queue_.pop_front();
        }
    }

    std::vector<Request> asked;  ///< every request, in order
    bool target_ready = true;    ///< else full rays of the target, and all behind them, wait

   private:
    struct Order {
        Request request;
        Parts parts;
    };
    /// Only with the parts that were asked for, as a tracer answers.
    Sample answer(const Order& order) const {
        return with_parts(image_.sample(order.request), order.parts);
    }

    FunctionImage image_;
    std::deque<Order> queue_;
    std::mt19937 random_;
    bool grouped_;
};

namespace images {

/// A bright disc before a smooth ground.
inline FunctionImage disc(glm::dvec2 centre, double radius) {
    const auto inside = [=](glm::dvec2 p) {
        const glm::dvec2 d = p - centre;
        return d.x * d.x + d.y * d.y < radius * radius;
    };
    return {[=](glm::dvec2 p) {
                const auto shade = static_cast<float>(.1 + .05 * p.x / (1 + centre.x));
                return inside(p) ? glm::vec3(.9f, .6f, shade * 2) : glm::vec3(shade, shade, .3f);
            },
            [=](glm::dvec2 p) { return inside(p) ? 2u : 1u; }};
}

inline FunctionImage checker(double cell) {
    return {[=](glm::dvec2 p) {
        const auto odd = static_cast<long>(std::floor(p.x / cell) + std::floor(p.y / cell)) & 1;
        return odd ? glm::vec3(.8f, .7f, .6f) : glm::vec3(.05f);
    }};
}

inline FunctionImage constant(glm::vec3 colour) {
    return {[=](glm::dvec2) { return colour; }};
}

/// A disc casts no shadow over a checkered floor, under a sky: textures, edges and smooth parts.
inline FunctionImage still_life(double w, double h) {
    const FunctionImage ball = disc({w * .4, h * .55}, h * .25);
    const FunctionImage floor = checker(h * .06);
    const auto surface = [=](glm::dvec2 p) {
        if (ball.surface(p) == 2) return 3u;
        return p.y + .15 * p.x > h * .5 ? 2u : 1u;
    };
    return {[=](glm::dvec2 p) {
                switch (surface(p)) {
                    case 3: {
                        const glm::dvec2 d = (p - glm::dvec2(w * .4, h * .55)) / (h * .25);
                        const double light = std::max(0., .3 - .6 * d.x - .5 * d.y);
                        return glm::vec3(glm::dvec3(.7, .2, .1) * (.1 + light));
                    }
                    case 2:
                        return floor.colour(p) * static_cast<float>(.3 + .7 * p.y / h);
                    default:
                        return glm::vec3(.3f, .4f, static_cast<float>(.9 - .5 * p.y / h));
                }
            },
            surface};
}

}  // namespace images
}  // namespace povpreview
