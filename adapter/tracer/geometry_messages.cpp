// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>

#include "backend/oracle/wire_frame.h"
#include "backend/oracle/wire_messages.h"

namespace povpreview::tracer {

namespace {

using flatbuffers::FlatBufferBuilder;
using flatbuffers::Offset;

wire::Polygon polygon(const PolygonFacts& facts) {
    unsigned flags = 0;
    const auto flag = [&flags](bool set, wire::PolygonFlags which) {
        if (set) flags |= which;
    };
    flag(facts.transparent, wire::PolygonFlags_transparent);
    flag(facts.no_shadow, wire::PolygonFlags_no_shadow);
    flag(facts.no_image, wire::PolygonFlags_no_image);
    flag(facts.no_reflection, wire::PolygonFlags_no_reflection);
    flag(facts.double_illuminate, wire::PolygonFlags_double_illuminate);
    flag(facts.convex, wire::PolygonFlags_convex);
    return {facts.surface, facts.material, facts.smooth,
            facts.mirror,  facts.rings,    static_cast<wire::PolygonFlags>(flags)};
}

wire::Frame columns(const LocalFrame& frame) {
    const auto column = [&frame](std::size_t j) {
        return wire::Vec3d(frame.row[0][j], frame.row[1][j], frame.row[2][j]);
    };
    return {column(0), column(1), column(2), column(3)};
}

wire::Solid solid(const ClosedSolid& from) {
    return {columns(from.frame), static_cast<std::uint32_t>(from.numbers.size()),
            static_cast<wire::SolidKind>(from.kind)};
}
wire::Piece piece(const PieceFacts& from) {
    return {from.solid, from.surface, from.material, from.steps};
}
wire::Box box(const BoxFacts& from) { return {vec3d(from.low), vec3d(from.high)}; }
wire::CurvedObject object(const CurvedFacts& from) { return {box(from.bounds), from.pieces}; }
wire::Pattern pattern(const PatternFacts& from) {
    const auto colour = [&from](std::size_t i) {
        return wire::Vec3f(from.colours[i][0], from.colours[i][1], from.colours[i][2]);
    };
    return {vec3d(from.brick_size),
            from.mortar,
            colour(0),
            colour(1),
            colour(2),
            static_cast<wire::PatternKind>(from.kind)};
}
wire::Look look(const LookFacts& from) {
    return {columns(from.to_map),
            pattern(from.pattern),
            from.material,
            from.image,
            static_cast<wire::LookKind>(from.kind),
            static_cast<wire::Mapping>(from.mapping),
            static_cast<wire::Interpolation>(from.interpolation),
            from.once,
            from.mirror};
}
wire::ImageSize image(const ImageSize& from) { return {from.width, from.height}; }
wire::Vec2f uv(const std::array<float, 2>& from) { return {from[0], from[1]}; }

/// A vector of the wire; absent if there is nothing in it.
template <typename From, typename Make>
auto structs(FlatBufferBuilder& builder, const std::vector<From>& from, Make make) {
    using To = decltype(make(from.front()));
    if (from.empty()) return Offset<flatbuffers::Vector<const To*>>(0);
    To* to = nullptr;
    const auto vector = builder.CreateUninitializedVectorOfStructs<To>(from.size(), &to);
    std::transform(from.begin(), from.end(), to, make);
    return vector;
}

template <typename Number>
Offset<flatbuffers::Vector<Number>> numbers(FlatBufferBuilder& builder,
                                            const std::vector<Number>& from) {
    if (from.empty()) return 0;
    return builder.CreateVector(from);
}

}  // namespace

WireFrame geometry_frame(const GeometryChunk& chunk) {
    FlatBufferBuilder builder(24 * (chunk.points.size() + chunk.polygons.size()) +
                              4 * (chunk.corners.size() + chunk.rings.size()) + 1024);
    std::vector<double> solid_numbers;
    for (const ClosedSolid& from : chunk.solids)
        solid_numbers.insert(solid_numbers.end(), from.numbers.begin(), from.numbers.end());
    const auto points = structs(builder, chunk.points, vec3d);
    const auto corners = numbers(builder, chunk.corners);
    const auto rings = numbers(builder, chunk.rings);
    const auto polygons = structs(builder, chunk.polygons, polygon);
    std::vector<Offset<wire::LeftOut>> left_out;
    for (const auto& [what, count] : chunk.left_out)
        left_out.push_back(wire::CreateLeftOutDirect(builder, what.kind.c_str(),
                                                     what.reason.c_str(), count, what.drawn));
    const auto left_out_vector = builder.CreateVector(left_out);
    const auto uvs = structs(builder, chunk.corner_uvs, uv);
    const auto solids = structs(builder, chunk.solids, solid);
    const auto solid_number_vector = numbers(builder, solid_numbers);
    const auto steps = numbers(builder, chunk.steps);
    const auto pieces = structs(builder, chunk.pieces, piece);
    const auto objects = structs(builder, chunk.objects, object);
    const auto unknown = structs(builder, chunk.unknown, box);
    const auto looks = structs(builder, chunk.looks, look);
    const auto images = structs(builder, chunk.images, image);
    const auto unknown_in_mirrors = structs(builder, chunk.unknown_in_mirrors, box);
    return wire_frame(
        builder, wire::Report_Geometry,
        wire::CreateGeometry(builder, points, corners, rings, polygons, left_out_vector, chunk.last,
                             uvs, solids, solid_number_vector, steps, pieces, objects, unknown,
                             looks, images, unknown_in_mirrors));
}

WireFrame texels_frame(const TexelChunk& chunk) {
    FlatBufferBuilder builder(2 * chunk.halves.size() + 256);
    const auto halves = builder.CreateVector(chunk.halves);
    return wire_frame(builder, wire::Report_Texels,
                      wire::CreateTexels(builder, chunk.image, chunk.first, halves));
}

}  // namespace povpreview::tracer
