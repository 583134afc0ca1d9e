// SPDX-License-Identifier: AGPL-3.0-or-later
#include "backend/oracle/wire_messages.h"

#include "backend/oracle/wire_frame.h"

namespace povpreview::tracer {

namespace {

using flatbuffers::FlatBufferBuilder;
using flatbuffers::Offset;
using Frame = WireFrame;

wire::Vec3f vec3f(const Rgb& c) { return {c.r, c.g, c.b}; }

std::vector<Offset<wire::Count>> counts(FlatBufferBuilder& builder,
                                        const std::map<std::string, unsigned>& by_kind) {
    std::vector<Offset<wire::Count>> result;
    for (const auto& [kind, count] : by_kind)
        result.push_back(wire::CreateCountDirect(builder, kind.c_str(), count));
    return result;
}

Offset<wire::Camera> camera(FlatBufferBuilder& builder, const CameraFacts& facts) {
    const wire::Vec3d location = vec3d(facts.location), direction = vec3d(facts.direction),
                      right = vec3d(facts.right), up = vec3d(facts.up), sky = vec3d(facts.sky),
                      look_at = vec3d(facts.look_at);
    return wire::CreateCamera(builder, static_cast<wire::CameraKind>(facts.kind), &location,
                              &direction, &right, &up, &sky, &look_at, facts.angle, facts.aperture,
                              facts.focal_distance, facts.blur_samples, facts.perturbed);
}

Offset<wire::LightSource> light(FlatBufferBuilder& builder, const LightFacts& facts) {
    const wire::Vec3d position = vec3d(facts.position), points_at = vec3d(facts.points_at);
    const wire::Vec3f colour = vec3f(facts.colour);
    return wire::CreateLightSource(builder, static_cast<wire::LightKind>(facts.kind), &position,
                                   &points_at, &colour, facts.parallel, facts.shadowless,
                                   facts.jitter, facts.area_rows, facts.area_columns,
                                   facts.in_group);
}

/// A vector of the wire made of one part of each sample; absent if not wanted.
template <typename Part, typename Make>
Offset<flatbuffers::Vector<const Part*>> parts(FlatBufferBuilder& builder, bool wanted,
                                               const std::vector<Sample>& samples, Make make) {
    if (!wanted) return 0;
    std::vector<Part> made;
    made.reserve(samples.size());
    for (const Sample& sample : samples) made.push_back(make(sample));
    return builder.CreateVectorOfStructs(made);
}

}  // namespace

Frame hello_frame(std::uint32_t version, const std::string& povray, unsigned threads) {
    FlatBufferBuilder builder;
    return wire_frame(builder, wire::Report_Hello,
                      wire::CreateHelloDirect(builder, version, povray.c_str(), threads));
}

Frame progress_frame(std::uint8_t stage, std::uint64_t done, std::uint64_t total) {
    FlatBufferBuilder builder;
    return wire_frame(builder, wire::Report_Progress,
                      wire::CreateProgress(builder, static_cast<wire::Stage>(stage), done, total));
}

Frame scene_frame(const SceneFacts& scene) {
    FlatBufferBuilder builder(4096);
    std::vector<Offset<wire::LightSource>> lights;
    for (const LightFacts& facts : scene.lights) lights.push_back(light(builder, facts));
    const auto features = builder.CreateVectorOfStrings(
        std::vector<std::string>(scene.features.begin(), scene.features.end()));
    const auto textures = builder.CreateVector(counts(builder, scene.textures));
    const auto objects = builder.CreateVector(counts(builder, scene.objects));
    std::vector<Offset<wire::Rung>> rungs;
    for (const RungFacts& rung : scene.rungs)
        rungs.push_back(wire::CreateRungDirect(builder, rung.name.c_str(), rung.ready));
    const auto rung_vector = builder.CreateVector(rungs);
    const wire::Vec3f background = vec3f(scene.background);
    const auto output = builder.CreateString(scene.output);
    const auto files = builder.CreateVectorOfStrings(scene.files);
    const auto message = wire::CreateScene(
        builder, scene.width, scene.height, scene.working_gamma, scene.antialias,
        camera(builder, scene.camera), builder.CreateVector(lights), features, textures, objects,
        &background, scene.alpha, output, files, rung_vector, scene.first_look);
    return wire_frame(builder, wire::Report_Scene, message);
}

Frame answer_frame(const Slice& slice, std::uint8_t rung, const std::vector<Sample>& samples) {
    FlatBufferBuilder builder(samples.size() * 112 + 256);
    const Parts wanted = slice.batch->parts;
    const auto light = parts<wire::Light>(builder, wanted.light, samples, [](const Sample& s) {
        return wire::Light(vec3f(s.light), s.transmittance);
    });
    const auto surface =
        parts<wire::Surface>(builder, wanted.surface, samples, [](const Sample& s) {
            return wire::Surface(s.surface, s.reflected_surface, s.depth, vec3f(s.normal));
        });
    const auto shading =
        parts<wire::Shading>(builder, wanted.shading, samples, [](const Sample& s) {
            return wire::Shading(vec3f(s.albedo), vec3f(s.illumination), vec3f(s.remainder));
        });
    const auto signature =
        parts<wire::Signature>(builder, wanted.signature, samples, [](const Sample& s) {
            return wire::Signature(s.primary, s.lights, s.reflected, s.refracted);
        });
    std::vector<std::uint32_t> costs, failed;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        costs.push_back(samples[i].cost_ns);
        if (samples[i].failed) failed.push_back(static_cast<std::uint32_t>(i));
    }
    const auto cost_vector = builder.CreateVector(costs);
    const Offset<flatbuffers::Vector<std::uint32_t>> failed_vector =
        failed.empty() ? Offset<flatbuffers::Vector<std::uint32_t>>(0)
                       : builder.CreateVector(failed);
    const auto message =
        wire::CreateAnswer(builder, slice.batch->number, static_cast<std::uint32_t>(slice.first),
                           static_cast<std::uint32_t>(slice.count), light, surface, shading,
                           signature, cost_vector, failed_vector, rung);
    return wire_frame(builder, wire::Report_Answer, message);
}

Frame rung_ready_frame(std::uint8_t rung) {
    FlatBufferBuilder builder;
    return wire_frame(builder, wire::Report_RungReady, wire::CreateRungReady(builder, rung));
}

Frame failure_frame(const std::string& message, const std::string& file, unsigned line) {
    FlatBufferBuilder builder;
    return wire_frame(builder, wire::Report_Failure,
                      wire::CreateFailureDirect(builder, message.c_str(), file.c_str(), line));
}

namespace {

std::shared_ptr<Batch> read_trace(const wire::Trace& trace, std::size_t max_positions,
                                  std::string& fault) {
    if (trace.kind() > wire::RayKind_MAX) {
        fault = "an order for rays of unknown kind";
        return nullptr;
    }
    auto batch = std::make_shared<Batch>();
    batch->number = trace.batch();
    batch->kind = static_cast<RayKind>(trace.kind());
    batch->rung = trace.rung();
    const auto asked = static_cast<unsigned>(trace.parts());
    const bool full = batch->kind == RayKind::full, probe = batch->kind == RayKind::probe;
    batch->parts.light = full;
    batch->parts.surface = !full || (asked & wire::Parts_surface) != 0;
    batch->parts.shading = !probe && (!full || (asked & wire::Parts_shading) != 0);
    batch->parts.signature = probe || (full && (asked & wire::Parts_signature) != 0);
    if (const auto* positions = trace.positions()) {
        if (positions->size() > max_positions) {
            fault = "an order of too many samples";
            return nullptr;
        }
        batch->positions.reserve(positions->size());
        for (const wire::Vec2d* position : *positions)
            batch->positions.push_back({position->x(), position->y()});
    }
    return batch;
}

std::shared_ptr<FinishPart> read_finish(const wire::Image& finish) {
    auto part = std::make_shared<FinishPart>();
    part->first = finish.first();
    part->last = finish.last();
    if (const auto* light = finish.light()) {
        part->light.reserve(light->size());
        for (const wire::Light* l : *light) {
            const wire::Vec3f& c = l->colour();
            part->light.push_back({{c.x(), c.y(), c.z()}, l->transmittance()});
        }
    }
    return part;
}

}  // namespace

Order read_order(const Frame& content, std::size_t max_positions, std::string& fault) {
    flatbuffers::Verifier verifier(content.data(), content.size());
    if (!verifier.VerifyBuffer<wire::ToTracer>("PVTR")) {
        fault = "an order that is none";
        return {};
    }
    const auto* order = flatbuffers::GetRoot<wire::ToTracer>(content.data());
    if (const wire::Trace* trace = order->order_as_Trace())
        return {read_trace(*trace, max_positions, fault), nullptr};
    if (const wire::Image* finish = order->order_as_Image()) return {nullptr, read_finish(*finish)};
    fault = "an order of unknown kind";
    return {};
}

}  // namespace povpreview::tracer
