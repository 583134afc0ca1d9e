// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/polygonal/edge_finding.h"

#include <algorithm>
#include <memory>
#include <numeric>

#include "core/polygonal/backdrop.h"
#include "core/polygonal/face_crossings.h"
#include "core/polygonal/face_edges.h"
#include "core/polygonal/view.h"

namespace povpreview {
namespace {

/// Pieces handed over at a time.
constexpr std::size_t batch = 1024;
/// Pieces shorter than this, in pixels, are nothing to see.
constexpr double shortest_piece = 1e-3;
/// Edges to search between two questions whether to go on.
constexpr std::size_t edges_between_looks = 256;

/// Lights that give less than this share of all light cast no shadow that anyone sees.
constexpr float least_light = .01f;
constexpr std::size_t most_lights = 32;

/// Mirrors that show less than this, in square pixels times their reflectance, hold no edge worth a
/// constraint, and so many are looked into at most, counting those seen in mirrors.
constexpr double least_mirror = 64;
constexpr std::size_t most_mirrors = 32;

/// Crossings of faces that are looked at, at most, for each face and in all.
constexpr std::size_t crossings_per_face = 4, least_crossings = 1000;

/// Expected step in colour where two faces cross, and at a shadow's border when all light is
/// blocked, relative to a silhouette.
constexpr float crossing_step = .5f, shadow_step = .7f;

/// Part of a shadow's border.
struct ShadowPiece {
    SpaceSegment segment;
    std::uint32_t face;  ///< on which it lies
    int facing;          ///< side of the face that the light shines on
    float importance;
};

struct Shadows {
    std::uint16_t light;
    std::vector<ShadowPiece> pieces;
};

class Finder {
   public:
    Finder(const PolygonScene& scene, const EdgeFinding& options,
           const std::function<bool(std::vector<ImageEdge>&&)>& found)
        : scene_(scene),
          options_(options),
          found_(found),
          faces_(scene),
          hierarchy_(faces_),
          edges_(faces_),
          eye_(scene, faces_, hierarchy_) {}

    void run() {
        if (faces_.size() == 0) return;
        if (!geometry(eye_) || !hand_over()) return;
        crossings_ = find_crossings(faces_, hierarchy_, scene_.camera.eye,
                                    least_crossings + crossings_per_face * faces_.size());
        if (!crossings(eye_) || !hand_over()) return;
        for (const PointLight& light : lights_by_brightness())
            if (!cast(light) || !shadows(eye_, shadows_.back()) || !hand_over()) return;
        mirrors(eye_, options_.mirror_depth);
    }

   private:
    // ---- handing over

    /// Whether to go on; asked between edges, hands over when there is enough.
    bool look() {
        if (pieces_.size() >= batch) return hand_over();
        if (++since_look_ < edges_between_looks) return true;
        since_look_ = 0;
        return pieces_.empty() ? found_({}) : true;
    }
    bool hand_over() {
        since_look_ = 0;
        return found_(std::exchange(pieces_, {}));
    }

    void show(const View& view, const SpaceSegment& segment, EdgeKind kind, std::uint16_t light,
              float importance) {
        if (view.mirrored()) kind = EdgeKind::reflection;
        importance *= view.strength();
        view.show(segment, [&](glm::dvec2 from, glm::dvec2 to) {
            const glm::dvec2 d = to - from;
            if (!(d.x * d.x + d.y * d.y > shortest_piece * shortest_piece)) return;
            pieces_.push_back({from, to, kind, light, importance});
        });
    }

    // ---- what a view shows

    bool geometry(const View& view) {
        for (const FaceEdges::Edge& edge : edges_.edges()) {
            const SpaceSegment segment = edges_.segment(edge);
            Interval part;
            if (!view.clip_to_window(segment, part)) continue;
            const bool outline = edges_.silhouette(
                edge, view.volumes(), [&](const Face& face) { return view.shows(face); });
            const float importance = outline ? 1 : edge.crease;
            if (importance > 0 && edges_.any(edge, [&](const Face& f) { return view.shows(f); }))
                show(view, segment, EdgeKind::geometric, 0, importance);
            if (!look()) return false;
        }
        return true;
    }

    bool crossings(const View& view) {
        for (const Crossing& crossing : crossings_) {
            if (view.shows(faces_.face(crossing.f)) && view.shows(faces_.face(crossing.g)))
                show(view, crossing.segment, EdgeKind::geometric, 0, crossing_step);
            if (!look()) return false;
        }
        return true;
    }

    bool shadows(const View& view, const Shadows& shadows) {
        for (const ShadowPiece& piece : shadows.pieces) {
            const Face& face = faces_.face(piece.face);
            const bool lit = view.volumes().facing(piece.face) == piece.facing;
            if (view.shows(face) && (lit || face.lit_from_behind))
                show(view, piece.segment, EdgeKind::shadow, shadows.light, piece.importance);
            if (!look()) return false;
        }
        return true;
    }

    // ---- shadows

    std::vector<PointLight> lights_by_brightness() const {
        std::vector<PointLight> lights = scene_.lights;
        std::stable_sort(lights.begin(), lights.end(),
                         [](const auto& a, const auto& b) { return a.brightness > b.brightness; });
        const float least = least_light * all_light();
        while (!lights.empty() &&
               (lights.size() > most_lights || !(lights.back().brightness >= least)))
            lights.pop_back();
        return lights;
    }
    float all_light() const {
        float sum = 0;
        for (const PointLight& light : scene_.lights) sum += light.brightness;
        return sum;
    }

    /// Finds the borders of the shadows that fall from one light, wherever anyone may see them.
    bool cast(const PointLight& light) {
        const ShadowVolumes volumes(faces_, hierarchy_, light.position, Viewer::light);
        shadows_.push_back({static_cast<std::uint16_t>(light.number), {}});
        const float strength = shadow_step * light.brightness / all_light();
        const auto casts = [](const Face& face) { return face.casts_shadow; };
        for (const FaceEdges::Edge& edge : edges_.edges()) {
            if (edges_.silhouette(edge, volumes, casts))
                cast(volumes, edges_.segment(edge), strength);
            if (!look()) return false;
        }
        return true;
    }

    void cast(const ShadowVolumes& volumes, const SpaceSegment& segment, float strength) {
        IntervalSet lit;
        lit.assign({});
        volumes.hide(segment, lit);
        if (lit.empty()) return;
        volumes.cast(segment, backdrops_);
        for (const auto& backdrop : backdrops_)
            for (const Interval& rest : lit.intervals()) {
                const double from = std::max(rest.from, backdrop.part.from);
                const double to = std::min(rest.to, backdrop.part.to);
                if (to - from <= IntervalSet::shortest) continue;
                const SpaceSegment on_face{volumes.behind(segment, from, nearness(backdrop, from)),
                                           volumes.behind(segment, to, nearness(backdrop, to))};
                shadows_.back().pieces.push_back(
                    {on_face, backdrop.face, volumes.facing(backdrop.face), strength});
            }
    }

    // ---- mirrors

    bool mirrors(const View& view, int depth) {
        if (depth <= 0) return true;
        for (const std::size_t mirror : mirrors_in(view)) {
            if (mirrors_left_ == 0) return true;
            --mirrors_left_;
            const View reflection(view, mirror);
            if (!geometry(reflection) || !crossings(reflection)) return false;
            for (const Shadows& cast : shadows_)
                if (!shadows(reflection, cast)) return false;
            if (!hand_over() || !mirrors(reflection, depth - 1)) return false;
        }
        return true;
    }

    /// Mirrors in a view, those that show most first.
    std::vector<std::size_t> mirrors_in(const View& view) const {
        std::vector<std::pair<double, std::size_t>> sizes;
        for (std::size_t i = 0; i < faces_.size(); ++i) {
            const Face& face = faces_.face(i);
            if (!(face.mirror > 0) || !view.shows(face) || view.volumes().facing(i) == 0) continue;
            const double size = view.image_area(i) * view.strength() * face.mirror;
            if (size >= least_mirror) sizes.emplace_back(-size, i);
        }
        std::sort(sizes.begin(), sizes.end());
        std::vector<std::size_t> result;
        for (const auto& [size, face] : sizes) result.push_back(face);
        return result;
    }

    const PolygonScene& scene_;
    const EdgeFinding& options_;
    const std::function<bool(std::vector<ImageEdge>&&)>& found_;
    const FlatFaces faces_;
    const FaceHierarchy hierarchy_;
    const FaceEdges edges_;
    const View eye_;
    std::vector<Crossing> crossings_;
    std::vector<Shadows> shadows_;
    std::vector<ShadowVolumes::Backdrop> backdrops_;
    std::vector<ImageEdge> pieces_;
    std::size_t since_look_ = 0, mirrors_left_ = most_mirrors;
};

}  // namespace

void find_edges(const PolygonScene& scene, const EdgeFinding& options,
                const std::function<bool(std::vector<ImageEdge>&& pieces)>& found) {
    Finder(scene, options, found).run();
}

}  // namespace povpreview
