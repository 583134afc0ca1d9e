// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/adapter/frames.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "adapter/wire_generated.h"

namespace povpreview::fake {
namespace {

using Builder = flatbuffers::FlatBufferBuilder;

Bytes frame(Builder& builder, wire::Report type, flatbuffers::Offset<void> report) {
    builder.Finish(wire::CreateToPreviewer(builder, type, report), "PVPR");
    const std::uint32_t size = builder.GetSize();
    Bytes bytes(sizeof size + size);
    std::memcpy(bytes.data(), &size, sizeof size);
    std::memcpy(bytes.data() + sizeof size, builder.GetBufferPointer(), size);
    return bytes;
}

wire::Vec3f vec3f(const glm::vec3& v) { return {v.x, v.y, v.z}; }

}  // namespace

Bytes hello_frame(std::uint32_t version) {
    Builder b;
    return frame(b, wire::Report::Hello,
                 wire::CreateHelloDirect(b, version, "3.7.0.10 fake", 2).Union());
}

Bytes progress_frame(std::uint8_t stage, std::uint64_t done, std::uint64_t total) {
    Builder b;
    return frame(b, wire::Report::Progress,
                 wire::CreateProgress(b, static_cast<wire::Stage>(stage), done, total).Union());
}

Bytes scene_frame(std::uint32_t width, std::uint32_t height, bool target_ready) {
    Builder b;
    const wire::Vec3d location(1, 2, -5), direction(0, 0, 1), right(1.33, 0, 0), up(0, 1, 0),
        sky(0, 1, 0), look_at(0, 0, 4);
    const auto camera = wire::CreateCamera(b, wire::CameraKind::perspective, &location, &direction,
                                           &right, &up, &sky, &look_at, 67.5, .25, 8, 30, true);
    const wire::Vec3f white(1, 1, 1), background(.25, .5, .75);
    const std::vector lights{
        wire::CreateLightSource(b, wire::LightKind::area, &location, &look_at, &white, false, true,
                                true, 3, 5, true),
        wire::CreateLightSource(b, wire::LightKind::point, &look_at, nullptr, &white)};
    const std::vector features{b.CreateString("reflection"), b.CreateString("area_light")};
    const std::vector textures{wire::CreateCountDirect(b, "plain", 3)};
    const std::vector objects{wire::CreateCountDirect(b, "sphere", 2),
                              wire::CreateCountDirect(b, "plane", 1)};
    const std::vector files{b.CreateString("x.pov"), b.CreateString("y.inc")};
    const std::vector rungs{wire::CreateRungDirect(b, "sketch", true),
                            wire::CreateRungDirect(b, "unprepared", true),
                            wire::CreateRungDirect(b, "target", target_ready)};
    return frame(
        b, wire::Report::Scene,
        wire::CreateSceneDirect(b, width, height, 2.2F, true, camera, &lights, &features, &textures,
                                &objects, &background, true, "out.png", &files, &rungs, 24)
            .Union());
}

Bytes rung_ready_frame(std::uint8_t rung) {
    Builder b;
    return frame(b, wire::Report::RungReady, wire::CreateRungReady(b, rung).Union());
}

Bytes swollen_scene_frame(std::size_t count, std::size_t length) {
    Builder b;
    const std::vector features(count, b.CreateString(std::string(length, 'x')));
    return frame(b, wire::Report::Scene,
                 wire::CreateSceneDirect(b, 64, 48, 1, false, 0, nullptr, &features).Union());
}

Bytes failure_frame(const std::string& message, const std::string& file, std::uint32_t line) {
    Builder b;
    return frame(b, wire::Report::Failure,
                 wire::CreateFailureDirect(b, message.c_str(), file.c_str(), line).Union());
}

Bytes answer_frame(const Slice& slice) {
    std::vector<wire::Light> light;
    std::vector<wire::Surface> surface;
    std::vector<wire::Shading> shading;
    std::vector<wire::Signature> signature;
    std::vector<std::uint32_t> cost;
    for (const Sample& s : slice.samples) {
        light.emplace_back(vec3f(s.colour), s.transmittance);
        surface.emplace_back(s.surface, s.reflected_surface, s.depth, vec3f(s.normal));
        shading.emplace_back(vec3f(s.albedo), vec3f(s.illumination), vec3f(s.remainder));
        const Signature& t = s.signature;
        signature.emplace_back(t.primary, t.lights, t.reflected, t.refracted);
        cost.push_back(s.cost_ns);
    }
    const bool full = slice.kind == RayKind::full;
    const auto if_full = [&](Parts part) { return full && contains(slice.parts, part); };
    Builder b(slice.samples.size() * 96 + 256);
    return frame(
        b, wire::Report::Answer,
        wire::CreateAnswerDirect(
            b, slice.batch, slice.first, slice.count, full ? &light : nullptr,
            !full || if_full(Parts::surface) ? &surface : nullptr,
            slice.kind == RayKind::albedo || if_full(Parts::shading) ? &shading : nullptr,
            slice.kind == RayKind::probe || if_full(Parts::signature) ? &signature : nullptr, &cost,
            slice.failed.empty() ? nullptr : &slice.failed, slice.rung)
            .Union());
}

Bytes geometry_frame(const Geometry& geometry, bool last) {
    using Flags = wire::PolygonFlags;
    std::vector<wire::Vec3d> points;
    for (const glm::dvec3& p : geometry.points) points.emplace_back(p.x, p.y, p.z);
    std::vector<std::uint32_t> rings;
    for (const Geometry::Ring& ring : geometry.rings) rings.push_back(ring.count);
    std::vector<wire::Polygon> polygons;
    for (const Geometry::Polygon& polygon : geometry.polygons) {
        const Face& face = polygon.face;
        Flags flags = Flags::NONE;
        const auto set = [&flags](bool condition, Flags flag) {
            if (condition) flags |= flag;
        };
        set(polygon.convex, Flags::convex);
        set(face.transparent, Flags::transparent);
        set(!face.casts_shadow, Flags::no_shadow);
        set(!face.visible, Flags::no_image);
        set(!face.reflected, Flags::no_reflection);
        set(face.lit_from_behind, Flags::double_illuminate);
        polygons.emplace_back(face.surface, face.material, face.smooth, face.mirror, polygon.rings,
                              flags);
    }
    Builder b;
    const auto v = [](const glm::dvec3& p) { return wire::Vec3d(p.x, p.y, p.z); };
    const auto frame_of = [&v](const glm::dmat4x3& m) {
        return wire::Frame(v(m[0]), v(m[1]), v(m[2]), v(m[3]));
    };
    const auto box = [&v](const Bounds& bounds) {
        return wire::Box(v(bounds.low), v(bounds.high));
    };
    std::vector<wire::Vec2f> uvs;
    for (const glm::vec2& uv : geometry.corner_uvs) uvs.emplace_back(uv.x, uv.y);
    std::vector<wire::Solid> solids;
    std::vector<double> numbers;
    for (const Solid& solid : geometry.solids) {
        const std::size_t before = numbers.size();
        const std::ptrdiff_t count = solid.kind == Solid::Kind::quadric          ? 10
                                     : solid.kind == Solid::Kind::torus          ? 1
                                     : solid.kind == Solid::Kind::superellipsoid ? 2
                                                                                 : 0;
        numbers.insert(numbers.end(), solid.coefficients.begin(),
                       solid.coefficients.begin() + count);
        const auto list = geometry.numbers.begin() + solid.first_number;
        numbers.insert(numbers.end(), list, list + solid.numbers);
        solids.emplace_back(frame_of(solid.to_frame),
                            static_cast<std::uint32_t>(numbers.size() - before),
                            static_cast<wire::SolidKind>(solid.kind));
    }
    std::vector<wire::Piece> pieces;
    for (const CurvedPiece& p : geometry.pieces)
        pieces.emplace_back(p.solid, p.surface, p.material, p.conditions);
    std::vector<wire::CurvedObject> objects;
    for (const CurvedObject& o : geometry.objects) objects.emplace_back(box(o.bounds), o.pieces);
    std::vector<wire::Box> unknown;
    for (const Bounds& bounds : geometry.unknown) unknown.push_back(box(bounds));
    std::vector<wire::Box> unknown_in_mirrors;
    for (const Bounds& bounds : geometry.unknown_in_mirrors)
        unknown_in_mirrors.push_back(box(bounds));
    std::vector<wire::Look> looks;
    const auto colour = [](const glm::vec3& c) { return wire::Vec3f(c.r, c.g, c.b); };
    const auto pattern_of = [&](const PatternLook& p) {
        return wire::Pattern(v(p.brick_size), p.mortar, colour(p.colours[0]), colour(p.colours[1]),
                             colour(p.colours[2]), static_cast<wire::PatternKind>(p.kind));
    };
    for (const auto& [material, look] : geometry.looks)
        looks.emplace_back(frame_of(look.kind == Look::Kind::pattern ? look.pattern.to_pattern
                                                                     : look.image.to_map),
                           pattern_of(look.pattern), material, look.image.image,
                           static_cast<wire::LookKind>(look.kind),
                           static_cast<wire::Mapping>(look.image.mapping),
                           static_cast<wire::Interpolation>(look.image.interpolation),
                           look.image.once, look.mirror);
    std::vector<wire::ImageSize> images;
    for (const ImageTexels& image : geometry.images) images.emplace_back(image.width, image.height);
    std::vector<flatbuffers::Offset<wire::LeftOut>> left_out;
    for (const Geometry::LeftOut& l : geometry.left_out)
        left_out.push_back(
            wire::CreateLeftOutDirect(b, l.kind.c_str(), l.reason.c_str(), l.count, l.drawn));
    return frame(
        b, wire::Report::Geometry,
        wire::CreateGeometryDirect(b, &points, &geometry.corners, &rings, &polygons, &left_out,
                                   last, &uvs, &solids, &numbers, &geometry.conditions, &pieces,
                                   &objects, &unknown, &looks, &images, &unknown_in_mirrors)
            .Union());
}

Bytes texels_frame(std::uint32_t image, std::uint32_t first, const std::vector<Texel>& texels) {
    std::vector<std::uint16_t> halves;
    for (const Texel& texel : texels) halves.insert(halves.end(), texel.begin(), texel.end());
    return raw_texels_frame(image, first, halves);
}

Bytes raw_texels_frame(std::uint32_t image, std::uint32_t first,
                       const std::vector<std::uint16_t>& halves) {
    Builder b;
    return frame(b, wire::Report::Texels,
                 wire::CreateTexelsDirect(b, image, first, &halves).Union());
}

std::vector<Texel> small_texels() {
    std::vector<Texel> texels;
    for (std::uint16_t i = 0; i < 6; ++i)
        texels.push_back({i, static_cast<std::uint16_t>(100 * i), 0x3c00, 0x3c00});
    return texels;
}

namespace {

/// A cut torus and a quadric, a curve and a superellipsoid; something unknown; four looks.
void add_curved_part(Geometry& geometry) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const glm::dmat4x3 frame({1, 2, 3}, {4, 5, 6}, {7, 8, 10}, {.5, .25, 0});
    geometry.solids = {{Solid::Kind::torus, frame, {.25}},
                       {Solid::Kind::half_space, glm::dmat4x3(1), {}},
                       {Solid::Kind::quadric, glm::dmat4x3(2), {1, 2, 3, 4, 5, 6, 7, 8, 9, -1}},
                       {Solid::Kind::lathe, frame, {}, 0, 8},
                       {Solid::Kind::superellipsoid, frame, {2, 5}}};
    geometry.numbers = {0, 0, 1, 0, 1, 1, 0, 1};
    geometry.conditions = {1, condition_not, 2, condition_or, 0};
    geometry.pieces = {{0, 501, 1, 0, 4}, {1, 502, 2, 4, 1}, {2, 503, 1, 5, 0}};
    geometry.objects = {{{{-1, -1, -1}, {1, 1, 1}}, 0, 2}, {{{0, 0, 0}, {infinity, 2, 2}}, 2, 1}};
    geometry.unknown = {{{-infinity, 0, 0}, {infinity, 1, 1}}};
    geometry.unknown_in_mirrors = {{{2, 2, 2}, {3, 3, 3}}, {{4, 4, 4}, {5, 5, 5}}};
    Look image{Look::Kind::image, {}};
    image.image = {0, ImageLook::Mapping::toroidal, ImageLook::Interpolation::bicubic, true, frame};
    Look bricks{Look::Kind::pattern, {}};
    bricks.pattern = {PatternLook::Kind::brick,
                      {{{.5, .5, .5}, {.7, .2, .1}, {1, 2, 3}}},
                      {8, 3, 4.5},
                      .25,
                      frame};
    bricks.mirror = .25f;
    geometry.looks = {
        {1, {Look::Kind::plain, {}}}, {2, image}, {3, {Look::Kind::traced, {}}}, {4, bricks}};
    geometry.images = {{3, 2, {}}};
}

}  // namespace

Geometry small_geometry() {
    Geometry geometry;
    for (int i = 0; i < 12; ++i) geometry.points.emplace_back(i % 4, i / 4, .5);
    const auto add = [&geometry](std::vector<std::vector<std::uint32_t>> rings, Face face) {
        geometry.polygons.push_back(
            {.first_ring = static_cast<std::uint32_t>(geometry.rings.size()),
             .rings = static_cast<std::uint32_t>(rings.size()),
             .convex = rings.size() == 1,
             .face = face});
        for (const auto& ring : rings) {
            geometry.rings.push_back({static_cast<std::uint32_t>(geometry.corners.size()),
                                      static_cast<std::uint32_t>(ring.size())});
            geometry.corners.insert(geometry.corners.end(), ring.begin(), ring.end());
        }
    };
    geometry.points.insert(geometry.points.end(), {{1.2, .4, .5}, {1.8, .4, .5}, {1.5, 1.2, .5}});
    Face face;
    face.surface = 77;
    face.material = 3;
    add({{0, 1, 4}}, face);
    face.smooth = 9;
    face.transparent = true;
    face.casts_shadow = face.visible = face.reflected = false;
    face.lit_from_behind = true;
    face.mirror = .25;
    add({{1, 5, 4}}, face);
    add({{0, 3, 11, 8}, {12, 13, 14}}, Face{});
    geometry.left_out = {{"sphere", "curved", 4, true}, {"blob", "curved", 1}};
    for (std::size_t i = 0; i < geometry.corners.size(); ++i)
        geometry.corner_uvs.emplace_back(.25f * static_cast<float>(i), 1.f);
    add_curved_part(geometry);
    return geometry;
}

Order decode_order(const Bytes& flatbuffer) {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(flatbuffer.data());
    flatbuffers::Verifier verifier(bytes, flatbuffer.size());
    if (!verifier.VerifyBuffer<wire::ToTracer>("PVTR"))
        throw std::runtime_error("not an order to the tracer");
    const auto* any = flatbuffers::GetRoot<wire::ToTracer>(bytes);
    if (const wire::Image* from = any->order_as_Image()) {
        Order order;
        order.image = Order::Image{from->first(), {}, from->last()};
        if (from->light())
            for (const wire::Light* l : *from->light())
                order.image->pixels.push_back({{l->colour().x(), l->colour().y(), l->colour().z()},
                                               l->transmittance(),
                                               !std::isnan(l->colour().x())});
        return order;
    }
    const wire::Trace* trace = any->order_as_Trace();
    if (!trace || !trace->positions()) throw std::runtime_error("an order without positions");
    Order order{.batch = trace->batch(),
                .kind = static_cast<RayKind>(trace->kind()),
                .parts = static_cast<Parts>(trace->parts()),
                .positions = {},
                .rung = trace->rung()};
    for (const wire::Vec2d* p : *trace->positions()) order.positions.emplace_back(p->x(), p->y());
    return order;
}

}  // namespace povpreview::fake
