// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/core/polygonal/edge_laws.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>

#include "core/polygonal/edge_finding.h"
#include "tests/core/polygonal/sight_change.h"

namespace povpreview {
namespace {

constexpr double beside = 5e-3;  ///< pixels from a spot to where its two sides are looked at
constexpr std::size_t examples_kept = 5;
constexpr int grid_size = 48;
/// Positions of the grid that mirrors must show in to be asked about: edges in mirrors that are
/// seen as a speck are not worth finding.
constexpr int least_seen = 6;

double distance_to(const ImageEdge& piece, glm::dvec2 spot) {
    const glm::dvec2 along = piece.to - piece.from;
    const double length2 = glm::dot(along, along);
    const double t =
        length2 > 0 ? std::clamp(glm::dot(spot - piece.from, along) / length2, 0., 1.) : 0;
    return glm::distance(spot, piece.from + t * along);
}

std::string name(EdgeKind kind) {
    constexpr const char* names[] = {"geometric", "shadow", "reflection", "traced"};
    return names[int(kind)];
}

}  // namespace

void Tally::note(const std::string& example) {
    if (examples.size() < examples_kept) examples.push_back(example);
}

Tally& Tally::operator+=(const Tally& other) {
    asked += other.asked, ties += other.ties, broken += other.broken, idle += other.idle;
    for (const std::string& example : other.examples) note(example);
    return *this;
}

std::string Tally::text() const {
    std::string text =
        fmt::format("asked {}, broken {}, without contrast {}, ties {}", asked, broken, idle, ties);
    for (const std::string& example : examples) text += "\n  " + example;
    return text;
}

EdgeLaws::EdgeLaws(const PolygonScene& scene, int mirror_depth)
    : scene_(scene), brute_(scene, mirror_depth) {
    find_edges(scene, {.mirror_depth = mirror_depth},
               [&](std::vector<ImageEdge>&& found, std::uint64_t) {
                   std::move(found.begin(), found.end(), std::back_inserter(pieces_));
                   return true;
               });
    for (int i = 0; i < grid_size * grid_size; ++i) {
        grid_.emplace_back((i % grid_size + .5) * scene.width / grid_size,
                           (i / grid_size + .5) * scene.height / grid_size);
        sights_.push_back(brute_.look(grid_.back()));
        std::uint64_t path = 0;
        for (const Hit& hit : sights_.back().hits)
            if (hit.path != path) ++seen_in_[path = hit.path];
    }
}

/// Counts what is no question as such.
bool EdgeLaws::asks_for_piece(const Sight& a, const Sight& b, const std::optional<Change>& change,
                              Tally& tally) const {
    if (!change || change->optional) return false;
    if (a.tie || b.tie) {
        ++tally.ties;
        return false;
    }
    if (change->path != 0) {
        const auto seen = seen_in_.find(change->path);
        if (seen == seen_in_.end() || seen->second < least_seen) return false;
    }
    ++tally.asked;
    return true;
}

bool EdgeLaws::served(glm::dvec2 spot, const Change& change, bool edge_on) const {
    const double reach = edge_on ? edge_on_tolerance : tolerance;
    return std::any_of(pieces_.begin(), pieces_.end(), [&](const ImageEdge& piece) {
        // Where borders of several kinds coincide, the one in front stands for all.
        bool fits = piece.kind <= change.kind;
        if (change.kind == EdgeKind::shadow && piece.kind == EdgeKind::shadow) {
            fits = false;
            for (std::size_t l = 0; l < scene_.lights.size(); ++l)
                fits |= (change.lights >> l & 1U) && scene_.lights[l].number == piece.light;
        }
        return fits && distance_to(piece, spot) <= reach;
    });
}

std::string EdgeLaws::describe(glm::dvec2 spot, const Change& change) const {
    double nearest = INFINITY;
    for (const ImageEdge& piece : pieces_)
        if (piece.kind == change.kind) nearest = std::min(nearest, distance_to(piece, spot));
    return fmt::format("at ({:.6f}, {:.6f}): {} (lights {:b}); nearest of the kind {:.3g} px off",
                       spot.x, spot.y, name(change.kind), change.lights, nearest);
}

Tally EdgeLaws::neighbours_are_parted(Dice& dice, int limit) const {
    Tally tally;
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t i = 0; i < grid_.size(); ++i) {
        if (i % grid_size + 1 < grid_size && !same_sight(sights_[i], sights_[i + 1]))
            pairs.emplace_back(i, i + 1);
        if (i + grid_size < grid_.size() && !same_sight(sights_[i], sights_[i + grid_size]))
            pairs.emplace_back(i, i + grid_size);
    }
    for (; limit > 0 && !pairs.empty(); --limit) {
        const auto [i, j] = pairs[std::size_t(dice.whole(0, int(pairs.size()) - 1))];
        // One change after the other on the way between the two positions.
        glm::dvec2 at = grid_[i];
        const glm::dvec2 along = beside * glm::normalize(grid_[j] - at);
        for (int step = 0; step < 30 && !same_sight(brute_.look(at), sights_[j]); ++step) {
            glm::dvec2 before = at, after = grid_[j];
            close_in(brute_, before, after);
            at = after;
            // Ties are told from a little off: at the very spot everything meets.
            Sight a = brute_.look(before), b = brute_.look(after);
            a.tie = brute_.look(before - along).tie, b.tie = brute_.look(after + along).tie;
            const auto change = change_between(brute_, a, b);
            if (!asks_for_piece(a, b, change, tally) ||
                served(after, *change, a.edge_on || b.edge_on))
                continue;
            ++tally.broken;
            tally.note(describe(after, *change));
        }
    }
    return tally;
}

void EdgeLaws::ask_across(glm::dvec2 spot, glm::dvec2 along, const std::string& origin,
                          Tally& tally) const {
    if (!(glm::length(along) > 0)) return;
    const glm::dvec2 aside = beside * glm::normalize(glm::dvec2(-along.y, along.x));
    const Sight a = brute_.look(spot - aside), b = brute_.look(spot + aside);
    const auto change = change_between(brute_, a, b);
    if (!asks_for_piece(a, b, change, tally) || served(spot, *change, a.edge_on || b.edge_on))
        return;
    ++tally.broken;
    tally.note(origin + " " + describe(spot, *change));
}

void EdgeLaws::ask_of_point(const Vec3& point, const Vec3& along, Tally& tally) const {
    const auto ask = [&](const Vec3& p, const Vec3& q, const char* origin) {
        const auto at = brute_.project(p), next = brute_.project(q);
        if (!at || !next) return;
        if (at->x <= 0 || at->y <= 0 || at->x >= scene_.width || at->y >= scene_.height) return;
        ask_across(*at, *next - *at, origin, tally);
    };
    const Vec3 next = point + along;
    ask(point, next, "point");
    for (std::uint32_t f = 0; f < scene_.faces.size(); ++f)
        if (scene_.faces[f].mirror > 0)
            ask(brute_.mirrored(point, f), brute_.mirrored(next, f), "mirrored point");
}

Tally EdgeLaws::points_lie_on_pieces(Dice& dice, int points) const {
    Tally tally;
    if (scene_.faces.empty()) return tally;
    for (; points > 0; --points) {
        const Face& face = scene_.faces[std::size_t(dice.whole(0, int(scene_.faces.size()) - 1))];
        const auto i = std::uint32_t(dice.whole(0, int(face.count) - 1));
        const Vec3 from(scene_.corner(face, i)), to(scene_.corner(face, (i + 1) % face.count));
        const Vec3 point = from + Real(dice.from_to(.01, .99)) * (to - from);
        // Far enough along for a direction, near enough to be cast on the same faces.
        const Vec3 along = Real(1e-5) * (to - from);
        ask_of_point(point, along, tally);
        for (const PointLight& light : scene_.lights) {
            const bool parallel = light.position.w == 0;
            const Vec3 source(glm::dvec3(light.position));
            const auto cast = brute_.beyond(source, point, parallel);
            const auto next = brute_.beyond(source, point + along, parallel);
            for (std::size_t k = 0; k < cast.size() && cast.size() == next.size(); ++k)
                ask_of_point(cast[k], next[k] - cast[k], tally);
        }
    }
    return tally;
}

bool EdgeLaws::visible_edge_at(glm::dvec2 spot) const {
    for (const Face& face : scene_.faces)
        for (std::uint32_t i = 0; i < face.count; ++i) {
            const Vec3 from(scene_.corner(face, i)), to(scene_.corner(face, (i + 1) % face.count));
            // Perspective moves a middle along, not aside: halve the side towards the spot.
            Real low = 0, high = 1;
            for (int step = 0; step < 50; ++step) {
                const Real third = (high - low) / 3;
                const auto a = brute_.project(from + (low + third) * (to - from));
                const auto b = brute_.project(from + (high - third) * (to - from));
                if (!b || (a && glm::distance(*a, spot) < glm::distance(*b, spot)))
                    high -= third;
                else
                    low += third;
            }
            const Vec3 point = from + low * (to - from);
            const auto at = brute_.project(point);
            if (at && glm::distance(*at, spot) < tolerance && brute_.eye_sees(point)) return true;
        }
    return false;
}

Tally EdgeLaws::pieces_part_the_picture(Dice& dice, EdgeKind kind) const {
    Tally tally;
    for (const ImageEdge& piece : pieces_) {
        const glm::dvec2 along = piece.to - piece.from;
        const double length = glm::length(along);
        if (piece.kind != kind || length < 100 * beside) continue;
        const glm::dvec2 spot = piece.from + dice.from_to(.1, .9) * along;
        const glm::dvec2 aside = beside / length * glm::dvec2(-along.y, along.x);
        const Sight a = brute_.look(spot - aside), b = brute_.look(spot + aside);
        if (a.tie || b.tie) {
            ++tally.ties;
            continue;
        }
        ++tally.asked;
        if (change_between(brute_, a, b)) continue;
        const bool broken = kind == EdgeKind::geometric && !visible_edge_at(spot);
        ++(broken ? tally.broken : tally.idle);
        tally.note(fmt::format(
            "{} piece ({:.6f}, {:.6f}) to ({:.6f}, {:.6f}), light {}: {} at ({:.6f}, {:.6f})",
            name(kind), piece.from.x, piece.from.y, piece.to.x, piece.to.y, piece.light,
            broken ? "parts nothing" : "no contrast", spot.x, spot.y));
    }
    return tally;
}

}  // namespace povpreview
