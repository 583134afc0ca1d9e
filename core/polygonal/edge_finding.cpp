// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/polygonal/edge_finding.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <memory>
#include <numeric>

#include "core/polygonal/backdrop.h"
#include "core/polygonal/contrast.h"
#include "core/polygonal/face_crossings.h"
#include "core/polygonal/face_edges.h"
#include "core/polygonal/sides.h"
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

/// Part of a shadow's border, on one face.
struct ShadowPiece {
    SpaceSegment segment;
    std::uint32_t face;
    Doubt doubt;
};

/// The borders of all shadows that fall from one light, wherever anyone may see them.
struct Shadows {
    Shadows(const FlatFaces& faces, const FaceHierarchy& hierarchy, const PointLight& from)
        : volumes(faces, hierarchy, from.position, Viewer::light),
          light(static_cast<std::uint16_t>(from.number)) {}

    ShadowVolumes volumes;
    std::uint16_t light;
    float importance = 0;
    std::vector<ShadowPiece> pieces;
};

class Finder {
   public:
    Finder(const PolygonScene& scene, const EdgeFinding& options, const EdgesFound& found)
        : scene_(scene),
          options_(options),
          found_(found),
          faces_(scene),
          hierarchy_(faces_),
          edges_(faces_),
          contrast_(faces_),
          eye_(scene, faces_, hierarchy_),
          lights_(lights_by_brightness(scene)) {}

    bool run() {
        if (faces_.size() == 0) return true;
        if (!geometry(eye_) || !hand_over() || !cross() || !crossings(eye_)) return false;
        near_border();
        if (!hand_over()) return false;
        for (const PointLight& light : lights_) {
            shadows_.push_back(std::make_unique<Shadows>(faces_, hierarchy_, light));
            if (!cast(light, *shadows_.back()) || !show(eye_, *shadows_.back()) || !hand_over())
                return false;
        }
        return mirrors(eye_, options_.mirror_depth);
    }

   private:
    // ---- handing over

    /// Whether to go on; asked between edges, hands over when there is enough.
    bool look() {
        if (pieces_.size() >= batch) return hand_over();
        if (++since_look_ < edges_between_looks) return true;
        since_look_ = 0;
        if (hierarchy_.effort() >= options_.most_effort) return hand_over();
        return pieces_.empty() ? found_({}, hierarchy_.effort()) : true;
    }
    bool hand_over() {
        since_look_ = 0;
        return found_(std::exchange(pieces_, {}), hierarchy_.effort()) &&
               hierarchy_.effort() < options_.most_effort;
    }

    /// Adds what the image shows, by a view, of a segment on faces.
    void show(const View& view, const SpaceSegment& segment, std::span<const std::uint32_t> faces,
              Doubt doubt, float importance) {
        visible_.assign({});
        view.hide(segment, visible_);
        const auto contrast = [&](double t) {
            return contrast_.of_surfaces(view.volumes(), faces, segment.at(t),
                                         segment.b - segment.a);
        };
        for (const Interval& part : visible_.intervals())
            keep_where(part, doubt, contrast, [&](const Interval& kept) {
                add(view, segment, kept, EdgeKind::geometric, 0, importance);
            });
    }

    void add(const View& view, const SpaceSegment& segment, const Interval& part, EdgeKind kind,
             std::uint16_t light, float importance) {
        if (view.mirrored()) kind = EdgeKind::reflection;
        importance *= view.strength();
        view.show(segment.at(part.from), segment.at(part.to), [&](glm::dvec2 from, glm::dvec2 to) {
            const glm::dvec2 d = to - from;
            if (!(d.x * d.x + d.y * d.y > shortest_piece * shortest_piece)) return;
            pieces_.push_back({from, to, kind, light, importance});
        });
    }

    // ---- what a view shows

    bool geometry(const View& view) {
        const auto shown = [&](const Face& face) { return view.shows(face); };
        for (const FaceEdges::Edge& edge : edges_.edges()) {
            const SpaceSegment segment = edges_.segment(edge);
            Interval part;
            if (view.clip_to_window(segment, part) && edges_.any(edge, shown)) {
                const bool outline = edges_.silhouette(edge, view.volumes(), shown);
                const float importance = outline ? 1 : edge.crease;
                const Doubt doubt = !edge.regular() ? Doubt::much
                                    : outline       ? Doubt::some
                                                    : Doubt::none;
                if (importance > 0) show(view, segment, edges_.faces(edge), doubt, importance);
            }
            if (!look()) return false;
        }
        return true;
    }

    /// Finds where faces pass through each other.
    bool cross() {
        const std::size_t most = least_crossings + crossings_per_face * faces_.size();
        bool go_on = true;
        crossings_ = find_crossings(faces_, hierarchy_, [&](std::size_t found) {
            go_on = look();
            return go_on && found < most;
        });
        return go_on;
    }

    bool crossings(const View& view) {
        for (const Crossing& crossing : crossings_) {
            if (view.shows(faces_.face(crossing.f)) && view.shows(faces_.face(crossing.g)))
                show(view, crossing.segment, std::array{crossing.f, crossing.g}, Doubt::some,
                     crossing_step);
            if (!look()) return false;
        }
        return true;
    }

    /// A parallel view begins at the camera's plane, where it cuts faces open.
    void near_border() {
        std::optional<NearPlane> plane = eye_.volumes().near();
        if (!plane) return;
        // What is on the plane itself is not in the picture.
        plane->on += 10 * contact * faces_.scale(plane->on) * plane->normal;
        for (const SpaceSegment& segment : find_cuts(faces_, *plane))
            show(eye_, segment, {}, Doubt::none, 1);
    }

    bool show(const View& view, const Shadows& shadows) {
        for (const ShadowPiece& piece : shadows.pieces) {
            const Face& face = faces_.face(piece.face);
            const bool lit =
                view.volumes().facing(piece.face) == shadows.volumes.facing(piece.face);
            if (view.shows(face) && (lit || face.lit_from_behind)) show(view, shadows, piece);
            if (!look()) return false;
        }
        return true;
    }

    void show(const View& view, const Shadows& shadows, const ShadowPiece& piece) {
        const SpaceSegment& segment = piece.segment;
        visible_.assign({});
        view.hide(segment, visible_);
        const auto contrast = [&](double t) {
            return contrast_.of_light(shadows.volumes, piece.face, segment.at(t),
                                      segment.b - segment.a);
        };
        for (const Interval& part : visible_.intervals())
            keep_where(part, piece.doubt, contrast, [&](const Interval& kept) {
                add(view, segment, kept, EdgeKind::shadow, shadows.light, shadows.importance);
            });
    }

    // ---- shadows

    static std::vector<PointLight> lights_by_brightness(const PolygonScene& scene) {
        std::vector<PointLight> lights;
        std::copy_if(
            scene.lights.begin(), scene.lights.end(), std::back_inserter(lights),
            [](const PointLight& light) { return usable(light.position) && light.brightness > 0; });
        std::stable_sort(lights.begin(), lights.end(),
                         [](const auto& a, const auto& b) { return a.brightness > b.brightness; });
        const float least = least_light * all_of(lights);
        while (!lights.empty() &&
               (lights.size() > most_lights || !(lights.back().brightness >= least)))
            lights.pop_back();
        return lights;
    }
    static float all_of(const std::vector<PointLight>& lights) {
        return std::accumulate(
            lights.begin(), lights.end(), 0.f,
            [](float sum, const PointLight& light) { return sum + light.brightness; });
    }

    bool cast(const PointLight& light, Shadows& shadows) {
        shadows.importance = shadow_step * light.brightness / all_of(lights_);
        // What transparent things take from the light is little, and mostly at no sharp border.
        const auto casts = [](const Face& f) { return f.casts_shadow && !f.transparent; };
        for (const FaceEdges::Edge& edge : edges_.edges()) {
            if (edges_.silhouette(edge, shadows.volumes, casts))
                cast(edges_.segment(edge), edge.regular() ? Doubt::some : Doubt::much, shadows);
            if (!look()) return false;
        }
        for (const Crossing& crossing : crossings_) {
            cast_along(crossing.segment, crossing.f, crossing.g, shadows);
            cast_along(crossing.segment, crossing.g, crossing.f, shadows);
        }
        return true;
    }

    /// The shadow of a face that is not seen itself begins where it cuts another one.
    void cast_along(const SpaceSegment& crossing, std::uint32_t from, std::uint32_t on,
                    Shadows& shadows) const {
        if (!faces_.face(from).visible && faces_.face(from).casts_shadow)
            shadows.pieces.push_back({crossing, on, Doubt::much});
    }

    void cast(const SpaceSegment& segment, Doubt doubt, Shadows& shadows) {
        lit_.assign({});
        shadows.volumes.hide(segment, lit_);
        if (lit_.empty()) return;
        shadows.volumes.cast(segment, backdrops_);
        for (const Backdrop& backdrop : backdrops_)
            for (const Interval& rest : lit_.intervals()) {
                const double from = std::max(rest.from, backdrop.part.from);
                const double to = std::min(rest.to, backdrop.part.to);
                if (to - from <= IntervalSet::shortest) continue;
                const auto behind = [&](double t) {
                    return shadows.volumes.behind(segment, t, nearness(backdrop, t));
                };
                shadows.pieces.push_back({{behind(from), behind(to)}, backdrop.face, doubt});
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
            for (const auto& shadows : shadows_)
                if (!show(reflection, *shadows)) return false;
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
    const EdgesFound& found_;
    const FlatFaces faces_;
    const FaceHierarchy hierarchy_;
    const FaceEdges edges_;
    const Contrast contrast_;
    const View eye_;
    const std::vector<PointLight> lights_;  // that cast shadows worth looking for
    std::vector<Crossing> crossings_;
    std::vector<std::unique_ptr<Shadows>> shadows_;
    IntervalSet visible_, lit_;
    std::vector<Backdrop> backdrops_;
    std::vector<ImageEdge> pieces_;
    std::size_t since_look_ = 0, mirrors_left_ = most_mirrors;
};

}  // namespace

bool find_edges(const PolygonScene& scene, const EdgeFinding& options, const EdgesFound& found) {
    return !usable(scene.camera.eye) || Finder(scene, options, found).run();
}

}  // namespace povpreview
