// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdlib>
#include <span>

#include "adapter/wire.h"

namespace povpreview {

/// Does to a stream all that the previewer does, and more: reads it in chunks, decodes each frame,
/// reads each sample as if it had been asked for. Ends the process where a promise of wire.h is
/// broken. Returns whether something was refused.
inline bool exercise_wire(std::span<const std::byte> stream, std::size_t chunk) {
    const auto promise = [](bool kept) {
        if (!kept) std::abort();
    };
    const auto read_all = [&](const report::Answer& answer) {
        for (const RayKind kind : {RayKind::full, RayKind::probe, RayKind::albedo})
            for (unsigned parts = 0; parts < 8; ++parts) try {
                    answer.check_asked(wire_max_batch,
                                       {kind, target_rung, static_cast<Parts>(parts)});
                } catch (const WireFault&) {
                }
        promise(answer.count() >= 1 && answer.first() + answer.count() <= wire_max_batch);
        for (std::uint32_t i = 0; i < answer.count(); ++i) {
            Sample sample{.position = {3, 4}, .kind = static_cast<RayKind>(i % 3)};
            answer.read(i, sample);
            promise(sample.position == glm::dvec2(3, 4) && std::isfinite(sample.colour.x) &&
                    std::isfinite(sample.illumination.y) && std::isfinite(sample.depth));
            promise(!sample.failed || sample.colour == glm::vec3(0));
        }
    };
    const auto walk = [&](const Geometry& geometry) {
        for (const std::uint32_t corner : geometry.corners)
            promise(corner < geometry.points.size());
        for (const Geometry::Ring& ring : geometry.rings)
            promise(ring.first <= geometry.corners.size() &&
                    ring.count <= geometry.corners.size() - ring.first);
        for (const Geometry::Polygon& polygon : geometry.polygons)
            promise(polygon.first_ring <= geometry.rings.size() &&
                    polygon.rings <= geometry.rings.size() - polygon.first_ring &&
                    polygon.face.mirror >= 0 && polygon.face.mirror <= 1);
        promise(geometry.corner_uvs.empty() ||
                geometry.corner_uvs.size() == geometry.corners.size());
        for (const CurvedPiece& piece : geometry.pieces) {
            promise(piece.solid < geometry.solids.size() &&
                    piece.first_condition <= geometry.conditions.size() &&
                    piece.conditions <= geometry.conditions.size() - piece.first_condition);
            std::size_t depth = piece.conditions == 0 ? 1 : 0;
            for (std::uint32_t i = 0; i < piece.conditions; ++i) {
                const ConditionStep step = geometry.conditions[piece.first_condition + i];
                promise(step >= condition_or &&
                        step < static_cast<std::int64_t>(geometry.solids.size()));
                if (step >= 0) ++depth;
                promise(depth >= (step < condition_not ? 2U : 1U) && depth <= 32);
                if (step < condition_not) --depth;
            }
            promise(depth == 1);
        }
        for (const CurvedObject& object : geometry.objects)
            promise(object.first_piece <= geometry.pieces.size() &&
                    object.pieces <= geometry.pieces.size() - object.first_piece);
        for (const Geometry::MaterialLook& look : geometry.looks)
            promise(look.look.kind <= Look::Kind::mixed &&
                    look.look.image.mapping <= ImageLook::Mapping::uv &&
                    look.look.pattern.kind <= PatternLook::Kind::hexagon &&
                    std::isfinite(look.look.pattern.mortar) &&
                    std::isfinite(look.look.pattern.colours[2].z));
        for (const ImageTexels& image : geometry.images)
            promise(std::uint64_t{image.width} * image.height <= wire_max_texels);
        Geometry twice = geometry;
        twice.append(geometry);
        promise(twice.pieces.size() == 2 * geometry.pieces.size());
    };
    FrameReader reader;
    try {
        while (!stream.empty()) {
            const auto part = stream.first(std::min(chunk, stream.size()));
            stream = stream.subspan(part.size());
            reader.feed(part, [&](std::span<const std::byte> frame) {
                promise(frame.size() <= wire_max_frame);
                const Report report = decode_report(frame);
                if (const auto* answer = std::get_if<report::Answer>(&report)) read_all(*answer);
                if (const auto* geometry = std::get_if<report::GeometryChunk>(&report))
                    walk(geometry->part);
                if (const auto* scene = std::get_if<SceneDescription>(&report))
                    promise(scene->width >= 1 && scene->height >= 1 &&
                            !scene->ladder.rungs.empty());
            });
        }
    } catch (const WireFault&) {
        return true;
    }
    return false;
}

}  // namespace povpreview
