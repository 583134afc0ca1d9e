// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>

#include "adapter/wire_values.h"

namespace povpreview {

using namespace wire_values;

namespace {

Geometry::Polygon polygon(const wire::Polygon& from, std::uint32_t first_ring) {
    const auto has = [flags = from.flags()](wire::PolygonFlags flag) {
        return (flags & flag) != wire::PolygonFlags::NONE;
    };
    Geometry::Polygon to;
    to.first_ring = first_ring;
    to.rings = from.rings();
    to.convex = has(wire::PolygonFlags::convex);
    to.face.surface = from.surface();
    to.face.material = from.material();
    to.face.smooth = from.smooth();
    to.face.transparent = has(wire::PolygonFlags::transparent);
    to.face.casts_shadow = !has(wire::PolygonFlags::no_shadow);
    to.face.visible = !has(wire::PolygonFlags::no_image);
    to.face.reflected = !has(wire::PolygonFlags::no_reflection);
    to.face.lit_from_behind = has(wire::PolygonFlags::double_illuminate);
    to.face.mirror = from.mirror() > 0 ? std::min(from.mirror(), 1.f) : 0;  // not if NaN
    return to;
}

/// Takes `count` more of `total` things; throws if there are not that many left.
std::uint32_t take(std::uint32_t& taken, std::uint32_t count, std::size_t total, const char* what) {
    if (count > total - taken)
        throw WireFault(fmt::format("geometry of {} {} that uses more of them", total, what));
    return std::exchange(taken, taken + count);
}

/// A vector's elements. In a damaged buffer they may lie at any address, which the verifier does
/// not look at, so they are copied, not read in place.
template <class Element>
std::vector<Element> copied(const flatbuffers::Vector<const Element*>* from) {
    static_assert(std::is_trivially_copyable_v<Element>);
    std::vector<Element> to(from ? from->size() : 0);
    if (!to.empty()) std::memcpy(to.data(), from->Data(), to.size() * sizeof(Element));
    return to;
}
template <class Number>
std::vector<Number> copied(const flatbuffers::Vector<Number>* from) {
    std::vector<Number> to(from ? from->size() : 0);
    if (!to.empty()) std::memcpy(to.data(), from->Data(), to.size() * sizeof(Number));
    return to;
}

void read_polygons(const wire::Geometry& from, Geometry& part) {
    for (const wire::Vec3d& p : copied(from.points())) part.points.push_back(vec3(p));
    part.corners = copied(from.corners());
    for (const std::uint32_t corner : part.corners)
        if (corner >= part.points.size())
            throw WireFault(
                fmt::format("geometry with point {} of {}", corner, part.points.size()));
    for (const wire::Vec2f& uv : copied(from.corner_uvs()))
        part.corner_uvs.emplace_back(uv.x(), uv.y());
    if (!part.corner_uvs.empty() && part.corner_uvs.size() != part.corners.size())
        throw WireFault(fmt::format("geometry of {} corners with coordinates for {}",
                                    part.corners.size(), part.corner_uvs.size()));
    std::uint32_t corners_taken = 0, rings_taken = 0;
    for (const std::uint32_t count : copied(from.rings()))
        part.rings.push_back({take(corners_taken, count, part.corners.size(), "corners"), count});
    for (const wire::Polygon& p : copied(from.polygons()))
        part.polygons.push_back(
            polygon(p, take(rings_taken, p.rings(), part.rings.size(), "rings")));
    if (corners_taken != part.corners.size() || rings_taken != part.rings.size())
        throw WireFault("geometry with corners or rings that belong to nothing");
}

// ---- curved objects

glm::dmat4x3 frame(const wire::Frame& from) {
    return {vec3(from.x()), vec3(from.y()), vec3(from.z()), vec3(from.origin())};
}

Bounds box(const wire::Box& from) { return {vec3(from.low()), vec3(from.high())}; }

/// How many coefficients a solid has; those of the other kinds have a list.
std::optional<std::uint32_t> coefficient_count(Solid::Kind kind) {
    switch (kind) {
        case Solid::Kind::quadric:
            return 10;
        case Solid::Kind::torus:
            return 1;
        case Solid::Kind::superellipsoid:
            return 2;
        case Solid::Kind::prism:
        case Solid::Kind::conic_prism:
        case Solid::Kind::lathe:
        case Solid::Kind::surface_of_revolution:
        case Solid::Kind::blob:
            return std::nullopt;
        default:
            return 0;
    }
}

/// Lists are taken as they are: what makes no sense of them cannot be drawn (see is_sound()).
void read_solids(const wire::Geometry& from, Geometry& part) {
    const std::vector<double> numbers = copied(from.numbers());
    std::uint32_t taken = 0;
    for (const wire::Solid& s : copied(from.solids())) {
        Solid to;
        to.kind = enumerator<Solid::Kind>(s.kind(), wire::SolidKind::MAX, "solid");
        to.to_frame = frame(s.frame());
        const auto first = numbers.begin() + take(taken, s.numbers(), numbers.size(), "numbers");
        if (const auto count = coefficient_count(to.kind)) {
            if (s.numbers() != *count)
                throw WireFault(fmt::format("a solid of {} numbers", s.numbers()));
            std::copy_n(first, *count, to.coefficients.begin());
        } else {
            to.first_number = static_cast<std::uint32_t>(part.numbers.size());
            to.numbers = s.numbers();
            part.numbers.insert(part.numbers.end(), first, first + s.numbers());
        }
        part.solids.push_back(to);
    }
    if (taken != numbers.size()) throw WireFault("geometry with numbers that belong to nothing");
}

/// Throws unless a condition runs: no operation without operands, one value in the end.
void check_condition(std::span<const ConditionStep> steps, std::size_t solids) {
    constexpr std::size_t deepest = 32;
    std::size_t depth = 0;
    for (const ConditionStep step : steps) {
        if (step >= 0) {
            if (static_cast<std::size_t>(step) >= solids || ++depth > deepest)
                throw WireFault(fmt::format("a condition on solid {} of {}", step, solids));
        } else if (step == condition_not ? depth < 1 : step < condition_or || depth-- < 2) {
            throw WireFault(fmt::format("a condition with step {} on {} values", step, depth));
        }
    }
    if (!steps.empty() && depth != 1)
        throw WireFault(fmt::format("a condition that leaves {} values", depth));
}

void read_objects(const wire::Geometry& from, Geometry& part) {
    part.conditions = copied(from.steps());
    std::uint32_t steps_taken = 0, pieces_taken = 0;
    for (const wire::Piece& p : copied(from.pieces())) {
        const std::uint32_t first = take(steps_taken, p.steps(), part.conditions.size(), "steps");
        if (p.solid() >= part.solids.size())
            throw WireFault(
                fmt::format("geometry with solid {} of {}", p.solid(), part.solids.size()));
        check_condition(std::span(part.conditions).subspan(first, p.steps()), part.solids.size());
        part.pieces.push_back({p.solid(), p.surface(), p.material(), first, p.steps()});
    }
    for (const wire::CurvedObject& o : copied(from.objects()))
        part.objects.push_back({box(o.bounds()),
                                take(pieces_taken, o.pieces(), part.pieces.size(), "pieces"),
                                o.pieces()});
    if (steps_taken != part.conditions.size() || pieces_taken != part.pieces.size())
        throw WireFault("geometry with steps or pieces that belong to nothing");
    for (const wire::Box& b : copied(from.unknown())) part.unknown.push_back(box(b));
    for (const wire::Box& b : copied(from.unknown_in_mirrors()))
        part.unknown_in_mirrors.push_back(box(b));
}

// ---- looks

/// Throws unless all its numbers are finite.
PatternLook pattern(const wire::Pattern& from, const wire::Frame& to_pattern) {
    PatternLook to;
    to.kind = enumerator<PatternLook::Kind>(from.kind(), wire::PatternKind::MAX, "pattern");
    to.colours = {vec3(from.first()), vec3(from.second()), vec3(from.third())};
    to.brick_size = vec3(from.brick_size());
    to.mortar = from.mortar();
    to.to_pattern = frame(to_pattern);
    glm::dvec3 sum = to.brick_size + to.mortar;
    for (const glm::vec3& colour : to.colours) sum += glm::dvec3(colour);
    for (glm::length_t i = 0; i < 4; ++i) sum += to.to_pattern[i];
    if (!std::isfinite(sum.x) || !std::isfinite(sum.y) || !std::isfinite(sum.z))
        throw WireFault("a pattern whose numbers are not finite");
    return to;
}

void read_looks(const wire::Geometry& from, Geometry& part) {
    for (const wire::Look& l : copied(from.looks())) {
        Look to;
        to.kind = enumerator<Look::Kind>(l.kind(), wire::LookKind::MAX, "look");
        to.image.image = l.image();
        to.image.mapping =
            enumerator<ImageLook::Mapping>(l.mapping(), wire::Mapping::MAX, "mapping");
        to.image.interpolation = enumerator<ImageLook::Interpolation>(
            l.interpolation(), wire::Interpolation::MAX, "interpolation");
        to.image.once = l.once();
        if (to.kind == Look::Kind::pattern)
            to.pattern = pattern(l.pattern(), l.to_map());
        else
            to.image.to_map = frame(l.to_map());
        to.mirror = l.mirror() > 0 ? std::min(l.mirror(), 1.f) : 0;  // not if NaN
        part.looks.push_back({l.material(), to});
    }
    for (const wire::ImageSize& i : copied(from.images())) {
        if (i.width() == 0 || i.height() == 0 || i.width() > wire_max_texels / i.height())
            throw WireFault(fmt::format("an image of {} x {} texels", i.width(), i.height()));
        part.images.push_back({i.width(), i.height(), {}});
    }
}

}  // namespace

report::GeometryChunk decode_geometry(const wire::Geometry& from) {
    report::GeometryChunk to;
    to.last = from.last();
    Geometry& part = to.part;
    read_polygons(from, part);
    check_list(from.left_out(), max_kinds, "kinds left out");
    if (from.left_out())
        for (const wire::LeftOut* l : *from.left_out())
            part.left_out.push_back({name(l->kind()), name(l->reason()), l->count(), l->drawn()});
    read_solids(from, part);
    read_objects(from, part);
    read_looks(from, part);
    return to;
}

report::Texels decode_texels(const wire::Texels& from) {
    report::Texels to;
    to.image = from.image();
    to.first = from.first();
    const std::vector<std::uint16_t> halves = copied(from.halves());
    if (halves.size() % 4 != 0 || halves.empty())
        throw WireFault(fmt::format("{} numbers as texels", halves.size()));
    to.texels.resize(halves.size() / 4);
    std::memcpy(to.texels.data(), halves.data(), halves.size() * sizeof(std::uint16_t));
    return to;
}

}  // namespace povpreview
