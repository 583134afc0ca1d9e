// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/detail/mirrored_items.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <map>
#include <optional>
#include <unordered_map>

#include "core/detail/curved_items.h"
#include "core/detail/face_items.h"
#include "core/detail/item_sources.h"
#include "core/detail/row_bands.h"
#include "core/detail/runs.h"
#include "core/detail/seen_look.h"

namespace povpreview {

namespace {

using Source = ItemCanvas::Source;

/// Mirrors of fewer pixels are left to samples, as are all beyond the largest few: each takes as
/// long as painting the scene.
constexpr std::size_t least_pixels = 64, most_mirrors = 32;

/// Two faces lie in one plane if they are as near as rounding can tell, as a share of the distance
/// from the eye.
constexpr double coplanar = 1e-12;

/// What a mirror touches is unknown, in units of the scene: POV-Ray's rays miss what is nearer to
/// where they start than their tolerance, which varies with the object.
constexpr double touch = 1e-2;

/// A surface of which less of what it mirrors is known, as a share of its pixels, is left alone:
/// its pixels are told apart by what it mirrors, all or none.
constexpr double least_known = .8;

/// Of the plane of a face through points as seen from the eye; nothing if there is none.
std::optional<MirrorPlane> plane_of(const PolygonScene& scene, const Face& face) {
    // The widest triangle out of the first corner.
    const glm::dvec3 through = scene.corner(face, 0);
    glm::dvec3 normal(0);
    for (std::size_t i = 1; i + 1 < face.count; ++i) {
        const glm::dvec3 n =
            glm::cross(scene.corner(face, i) - through, scene.corner(face, i + 1) - through);
        if (glm::dot(n, n) > glm::dot(normal, normal)) normal = n;
    }
    const double length = glm::length(normal);
    if (!(length > 0) || !std::isfinite(length)) return std::nullopt;
    return MirrorPlane{through, normal / length};
}

/// Of the half space z <= 0 of a frame.
std::optional<MirrorPlane> plane_of(const glm::dmat4x3& to_frame) {
    const glm::dvec3 gradient(to_frame[0].z, to_frame[1].z, to_frame[2].z);
    const double size2 = glm::dot(gradient, gradient);
    if (!(size2 > 0) || !std::isfinite(size2)) return std::nullopt;
    return MirrorPlane{-to_frame[3].z / size2 * gradient, gradient / std::sqrt(size2)};
}

std::optional<MirrorPlane> mirror_of(const DrawableScene& scene, Source source) {
    const Look* look = look_of(scene, source);
    if (!look || look->mirror < least_mirror) return std::nullopt;
    if (source & ItemCanvas::piece_bit) {
        const Solid& solid = scene.solids[scene.pieces[source & ~ItemCanvas::piece_bit].solid];
        if (solid.kind != Solid::Kind::half_space) return std::nullopt;
        return plane_of(solid.to_frame);
    }
    const Face& face = scene.polygons.faces[source];
    if (face.smooth != 0) return std::nullopt;
    return plane_of(scene.polygons, face);
}

/// Neighbours in a row, from `begin` to before `end`, that show one source.
struct Run {
    std::uint32_t begin, end;
};

/// The pixels that show mirrors in one plane.
struct Mirror {
    MirrorPlane plane;
    std::vector<Run> runs{};
    std::size_t pixels = 0;  ///< in all of them
    PixelBox box{};
};

/// Calls work(i) for each run, side by side.
void for_each_run(const Mirror& mirror, const std::function<void(std::size_t)>& work) {
    const int runs = static_cast<int>(mirror.runs.size());
    for_each_band(0, runs, rows_for_threads(runs), [&](int, int first, int last) {
        for (int i = first; i < last; ++i) work(std::size_t(i));
    });
}

class MirrorSearch {
   public:
    MirrorSearch(const DrawableScene& scene, const PixelRays& rays, const ItemCanvas& canvas)
        : scene_(scene), rays_(rays), canvas_(canvas) {}

    std::vector<Mirror> find() {
        for (int y = 0; y < canvas_.height(); ++y)
            canvas_.visit_row(y, [&](std::size_t begin, std::size_t end) {
                const int mirror = mirror_of_source(canvas_.source(begin));
                if (mirror != none) add(mirrors_[static_cast<std::size_t>(mirror)], y, begin, end);
            });
        std::erase_if(mirrors_, [](const Mirror& m) { return m.pixels < least_pixels; });
        std::stable_sort(mirrors_.begin(), mirrors_.end(),
                         [](const Mirror& a, const Mirror& b) { return a.pixels > b.pixels; });
        if (mirrors_.size() > most_mirrors) mirrors_.resize(most_mirrors);
        return std::move(mirrors_);
    }

   private:
    static constexpr int none = -1;

    int mirror_of_source(Source source) {
        const auto [known, is_new] = numbers_.try_emplace(source, none);
        if (!is_new) return known->second;
        const auto plane = mirror_of(scene_, source);
        if (!plane) return none;
        const auto same = std::find_if(mirrors_.begin(), mirrors_.end(),
                                       [&](const Mirror& m) { return is_same(m.plane, *plane); });
        known->second = static_cast<int>(same - mirrors_.begin());
        if (same == mirrors_.end())
            mirrors_.push_back({.plane = *plane, .box = {canvas_.width(), canvas_.height(), 0, 0}});
        return known->second;
    }

    bool is_same(const MirrorPlane& a, const MirrorPlane& b) const {
        const double far = glm::length(b.through - rays_.origin);
        return glm::length(glm::cross(a.normal, b.normal)) <= coplanar &&
               std::abs(glm::dot(a.normal, b.through - a.through)) <= coplanar * far;
    }

    void add(Mirror& mirror, int y, std::size_t begin, std::size_t end) const {
        mirror.runs.push_back({static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)});
        mirror.pixels += end - begin;
        const int left = static_cast<int>(begin - canvas_.index(0, y)),
                  right = static_cast<int>(end - canvas_.index(0, y));
        PixelBox& box = mirror.box;
        box = {std::min(box.left, left), std::min(box.top, y), std::max(box.right, right),
               std::max(box.bottom, y + 1)};
    }

    const DrawableScene& scene_;
    const PixelRays& rays_;
    const ItemCanvas& canvas_;
    std::vector<Mirror> mirrors_;
    std::unordered_map<Source, int> numbers_;
};

glm::dvec2 centre_of(std::uint32_t pixel, int width) {
    return {pixel % static_cast<std::uint32_t>(width) + .5,
            pixel / static_cast<std::uint32_t>(width) + .5};
}

/// Draws what a mirror shows.
void draw(const DrawableScene& scene, const PixelRays& turned, const ItemCanvas& canvas,
          const Mirror& mirror, ItemCanvas& reflection, const PaintingPace& pace) {
    reflection.limit_to(mirror.box);
    draw_bands(reflection, rows_for_threads(mirror.box.bottom - mirror.box.top),
               [](ItemCanvas& band) { band.close(); });
    for_each_run(mirror, [&](std::size_t i) {
        const Run& run = mirror.runs[i];
        for (std::uint32_t pixel = run.begin; pixel < run.end; ++pixel)
            reflection.open(pixel, canvas.nearness(pixel));
    });
    draw_faces(scene.polygons, turned, reflection, pace);
    draw_curved(scene, turned, reflection, pace);
}

/// Reads it.
class MirrorReading {
   public:
    /// `turned`: the rays that the reflection was drawn by.
    MirrorReading(const DrawableScene& scene, const PixelRays& rays, const PixelRays& turned,
                  const ItemCanvas& canvas, const Mirror& mirror, const ItemCanvas& reflection)
        : scene_(scene),
          rays_(rays),
          canvas_(canvas),
          mirror_(mirror),
          reflection_(reflection),
          view_{turned} {}

    MirrorView read(std::vector<std::uint32_t>& mirrored) {
        std::size_t seen = 0;
        for (const Run& run : mirror_.runs) {
            places_.push_back(seen);
            if (is_plain(run)) seen += run.end - run.begin;
        }
        view_.seen.resize(seen);
        for_each_run(mirror_, [&](std::size_t i) {
            const Run& run = mirror_.runs[i];
            for (std::uint32_t pixel = run.begin; pixel < run.end; ++pixel)
                mirrored[pixel] = surface_at(pixel);
            if (!is_plain(run)) return;
            for (std::uint32_t pixel = run.begin; pixel < run.end; ++pixel)
                view_.seen[places_[i] + (pixel - run.begin)] = {pixel, reflection_.source(pixel),
                                                                reflection_.nearness(pixel)};
        });
        for (const ItemCanvas::Tie& tie : reflection_.ties())
            if (reflection_.stands(tie) &&
                surface_of(scene_, tie.first) != surface_of(scene_, tie.second))
                mirrored[tie.pixel] = ItemBuffer::unknown;
        return std::move(view_);
    }

   private:
    bool is_plain(const Run& run) const {
        return is_plain_mirror(*look_of(scene_, canvas_.source(run.begin)));
    }

    std::uint32_t surface_at(std::uint32_t pixel) const {
        const Source source = reflection_.source(pixel);
        if (source != ItemCanvas::nothing && source != ItemCanvas::unknown) {
            const double way = view_.rays.depth(reflection_.nearness(pixel)) -
                               rays_.depth(canvas_.nearness(pixel));
            const glm::dvec3 direction = view_.rays.direction(centre_of(pixel, canvas_.width()));
            if (way * glm::length(direction) < touch) return ItemBuffer::unknown;
        }
        return surface_of(scene_, source);
    }

    const DrawableScene& scene_;
    const PixelRays& rays_;
    const ItemCanvas& canvas_;
    const Mirror& mirror_;
    const ItemCanvas& reflection_;
    MirrorView view_;
    std::vector<std::size_t> places_;  // of runs in the view
};

/// Surfaces of which it is known what they mirror, ascending.
std::vector<std::uint32_t> known_mirrors(const std::vector<Mirror>& mirrors,
                                         const ItemBuffer& items) {
    std::map<std::uint32_t, std::size_t> known, pixels;
    const auto surfaces = items.surfaces.begin();
    for (const Mirror& mirror : mirrors)
        for (const Run& run : mirror.runs)  // of one surface, but where that ties with another
            visit_runs(surfaces + run.begin, surfaces + run.end, [&](auto begin, auto end) {
                const auto mirrored = items.mirrored.begin() + (begin - surfaces);
                known[*begin] +=
                    std::size_t((end - begin) - std::count(mirrored, mirrored + (end - begin),
                                                           ItemBuffer::unknown));
            });
    visit_runs(surfaces, items.surfaces.end(), [&](auto begin, auto end) {
        if (const auto found = known.find(*begin); found != known.end())
            pixels[*begin] += std::size_t(end - begin);
    });
    std::vector<std::uint32_t> result;
    for (const auto& [surface, count] : known)
        if (surface != ItemBuffer::unknown &&
            double(count) >= least_known * double(pixels[surface]))
            result.push_back(surface);
    return result;
}

bool may_mirror(const DrawableScene& scene) {
    return std::any_of(scene.looks.begin(), scene.looks.end(),
                       [](const Look& look) { return look.mirror >= least_mirror; });
}

}  // namespace

std::vector<MirrorView> paint_mirrored(const DrawableScene& scene, const PixelRays& rays,
                                       const ItemCanvas& canvas, const PaintingPace& pace,
                                       ItemBuffer& items) {
    if (!may_mirror(scene)) return {};
    const std::vector<Mirror> mirrors = MirrorSearch(scene, rays, canvas).find();
    if (mirrors.empty()) return {};
    items.mirrored.assign(items.surfaces.size(), ItemBuffer::unknown);
    ItemCanvas reflection(canvas.width(), canvas.height());
    std::vector<MirrorView> views;
    for (const Mirror& mirror : mirrors) {
        if (pace.stopped()) break;
        const PixelRays turned = rays.reflected(mirror.plane);
        draw(scene, turned, canvas, mirror, reflection, pace);
        views.push_back(
            MirrorReading(scene, rays, turned, canvas, mirror, reflection).read(items.mirrored));
    }
    items.mirrors = known_mirrors(mirrors, items);
    if (!items.mirrors.empty()) return views;
    items.mirrored.clear();
    return {};
}

void read_mirrored_looks(const DrawableScene& scene, const std::vector<MirrorView>& views,
                         ItemBuffer& items) {
    const auto is_mirror = [&](std::uint32_t surface) {
        return std::binary_search(items.mirrors.begin(), items.mirrors.end(), surface);
    };
    const auto read = [&](const MirrorView& view, const MirrorView::Seen& seen) {
        if (!is_mirror(items.surfaces[seen.pixel])) return;
        const Source source =
            items.mirrored[seen.pixel] == ItemBuffer::unknown ? ItemCanvas::unknown : seen.source;
        const SeenLook look =
            seen_look(scene, view.rays, centre_of(seen.pixel, items.width), seen.nearness, source);
        items.kinds[seen.pixel] = look.kind;
        if (look.albedo) items.albedos[seen.pixel] = *look.albedo;
    };
    // As many pixels as a row has are as much work as one.
    const auto row = static_cast<std::size_t>(items.width);
    for (const MirrorView& view : views) {
        const int rows = static_cast<int>((view.seen.size() + row - 1) / row);
        for_each_band(0, rows, rows_for_threads(rows), [&](int, int top, int bottom) {
            const std::size_t end = std::min(std::size_t(bottom) * row, view.seen.size());
            for (std::size_t i = std::size_t(top) * row; i < end; ++i) read(view, view.seen[i]);
        });
    }
}

}  // namespace povpreview
