// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "adapter/povray_options.h"
#include "core/colour.h"
#include "core/error_measures.h"
#include "core/mesh_previewer.h"
#include "core/session.h"
#include "display/offscreen.h"
#include "display/program/comparison_figures.h"
#include "display/program/detail_pictures.h"
#include "display/program/figure_sheet.h"
#include "display/program/folder.h"
#include "display/program/interrupt.h"
#include "display/program/reference.h"
#include "display/program/traced_scene.h"
#include "display/progress_line.h"

namespace povpreview {
namespace {

using namespace std::chrono_literals;

/// Smooths lines and the edges of triangles; Mesa in software offers no more.
constexpr int samples_per_pixel = 4;
/// Where nothing is said, one sample for so many pixels: a regular grid shows rough shapes by then,
/// and refinement still has far to go.
constexpr std::size_t pixels_per_sample = 100;

Image decoded(Image encoded) {
    for (glm::vec3& c : encoded.pixels) c = {decode_srgb(c.x), decode_srgb(c.y), decode_srgb(c.z)};
    return encoded;
}

/// The lines of a picture on white.
Picture lines_alone(const Picture& picture) {
    Picture lines;
    lines.width = picture.width;
    lines.height = picture.height;
    const float w = float(lines.width), h = float(lines.height);
    for (const glm::vec2 corner : {glm::vec2(0, 0), glm::vec2(w, 0), glm::vec2(w, h),
                                   glm::vec2(0, 0), glm::vec2(w, h), glm::vec2(0, h)})
        lines.corners.push_back({corner, glm::vec3(1)});
    lines.lines = picture.lines;
    return lines;
}

Picture picture_of(const std::vector<EdgeChain>& edges, glm::ivec2 size) {
    Picture picture;
    picture.width = size.x;
    picture.height = size.y;
    for (const EdgeChain& chain : edges)
        for (std::size_t i = 1; i < chain.vertices.size(); ++i)
            picture.lines.push_back({.from = chain.vertices[i - 1],
                                     .to = chain.vertices[i],
                                     .constraint = true,
                                     .kind = chain.kind,
                                     .light = chain.light});
    return picture;
}

/// Segments of each kind, with the colours in which the painter draws them.
std::string count(const std::vector<EdgeChain>& edges) {
    std::array<std::size_t, edge_kinds> counts{};
    for (const EdgeChain& chain : edges)
        counts[static_cast<std::size_t>(chain.kind)] += chain.vertices.size() - 1;
    return fmt::format(
        "{} geometric (red), {} shadow (each light a colour), {} reflection (magenta)",
        counts[static_cast<std::size_t>(EdgeKind::geometric)],
        counts[static_cast<std::size_t>(EdgeKind::shadow)],
        counts[static_cast<std::size_t>(EdgeKind::reflection)]);
}

class Figures {
   public:
    explicit Figures(const FiguresOptions& options)
        : options_(options),
          povray_(read_povray_options(options.povray)),
          offscreen_(open_offscreen(options.backend)) {}

    Exit run() {
        make_folder(options_.out, "--out");
        reference_ = stock_reference(options_.povray, options_.out, interrupted);
        TracedScene scene(povray_, options_.tracer,
                          [&](const std::string& text) { line_.show(text); }, interrupted,
                          {.edges = EdgeFinding{.mirror_depth = options_.mirror_depth},
                           .items = options_.figure == 2});
        size_ = {scene.description().width, scene.description().height};
        check_size();
        add("a", decoded(reference_),
            fmt::format("a: finished, {} samples", reference_.pixels.size()));
        // The edges first, so that the constrained triangulation is the same however fast they
        // came.
        line_.show("finding edges");
        scene.wait_for_foreknowledge(interrupted);
        if (options_.figure == 1)
            draw_worth_of_edges(scene);
        else
            draw_phases(scene);
        line_.clear();
        if (interrupted()) return Exit::interrupted;
        write_figure(parts_, options_.out);
        return Exit::success;
    }

   private:
    void check_size() const {
        if (size_ != glm::ivec2(reference_.width, reference_.height))
            throw Error(Exit::usage,
                        fmt::format("the reference is {} x {} pixels, the tracer's picture {} x {}",
                                    reference_.width, reference_.height, size_.x, size_.y),
                        "figures", "give the size by +W and +H");
    }

    std::size_t samples() const {
        const std::size_t pixels = std::size_t(size_.x) * std::size_t(size_.y);
        return options_.samples.value_or(std::max<std::size_t>(4, pixels / pixels_per_sample));
    }

    void draw_worth_of_edges(TracedScene& scene) {
        const std::vector<EdgeChain>& edges = scene.edges();
        const RegularGrid grid = regular_grid(samples(), size_);
        MeshPreviewer plain(
            size_.x, size_.y,
            {.constraints = false, .detail = false, .lattice = false, .grid_cell = grid.cell});
        Session plain_session(plain, scene.oracle());
        trace(plain_session, grid.samples);
        draw(plain, "b", "c", "plain triangulation");

        // Most samples are for refinement, also where there are but few in all.
        MeshOptions sparse{.detail = false, .lattice = false};
        sparse.grid_cell = std::max(
            sparse.grid_cell, regular_grid(std::max<std::size_t>(4, grid.samples / 4), size_).cell);
        MeshPreviewer constrained(size_.x, size_.y, sparse);
        constrained.accept_edges(std::vector<EdgeChain>(edges));
        Session constrained_session(constrained, scene.oracle());
        trace(constrained_session, grid.samples);
        draw(constrained, "d", "e", "constrained triangulation");

        add("f", render(lines_alone(picture_of(edges, size_)), Overlay::edges),
            "f: edges known without rays\n" + count(edges));
    }

    void draw_phases(TracedScene& scene) {
        MeshPreviewer previewer(size_.x, size_.y, {.lattice = false});
        previewer.accept_edges(std::vector<EdgeChain>(scene.edges()));
        if (const DrawnDetail* items = scene.items())
            previewer.accept_items(*items);
        else
            previewer.accept_items(DrawnDetail(size_.x, size_.y));
        Session session(previewer, scene.oracle());
        trace(session, previewer.first_samples());
        const Picture first = previewer.picture(Overlay::mesh);
        add("b", render(lines_alone(first), Overlay::mesh),
            fmt::format("b: the first {} samples with the edges", traced_));
        add("c", render(albedo_picture(first), Overlay::none), "c: textures known without tracing");
        add("d", render(traced_surfaces_picture(first), Overlay::none),
            "d: surfaces whose texture is traced");
        const std::string first_caption = caption("f: first preview", first);
        trace(session, std::max(samples(), traced_ + 1));
        const Picture last = previewer.picture(Overlay::none);
        add("e", render(albedo_picture(last), Overlay::none),
            fmt::format("e: textures known after {} albedo rays", session.counts().albedo));
        add("f", render(first, Overlay::none), first_caption);
        add("g", render(detail_map_picture(last), Overlay::none), "g: DetailMap with BF-squares");
        add("h", render(last, Overlay::none), caption("h: preview", last));
    }

    /// Measured as `compare` does it, without smoothing.
    std::string caption(const std::string& what, const Picture& picture) {
        const ErrorMeasures error =
            measure_error(offscreen_.render(picture, size_.x, size_.y).pixels, reference_.pixels);
        return fmt::format("{}\n{} samples, error L1 {:.5f} RMSE {:.5f}", what, traced_, error.l1,
                           error.rmse);
    }

    void trace(Session& session, std::size_t limit) {
        session.limit_full(limit);
        while (session.advance(20ms) && !interrupted())
            line_.show(fmt::format("{} of {} samples", session.counts().full, limit));
        traced_ = session.counts().full;
    }

    void draw(const Previewer& previewer, const char* preview, const char* mesh,
              const std::string& what) {
        const Picture picture = previewer.picture(Overlay::mesh);
        add(preview, render(picture, Overlay::none),
            caption(fmt::format("{}: preview, {}", preview, what), picture));
        add(mesh, render(lines_alone(picture), Overlay::mesh),
            fmt::format("{}: {}, {} vertices", mesh, what, previewer.statistics().vertices));
    }

    Image render(const Picture& picture, Overlay overlay) {
        return offscreen_.render(picture, size_.x, size_.y, samples_per_pixel, overlay,
                                 Range::display);
    }

    void add(const char* name, Image image, const std::string& caption) {
        parts_.push_back({name, std::move(image), caption});
    }

    const FiguresOptions& options_;
    PovrayOptions povray_;
    Offscreen offscreen_;
    Image reference_;
    glm::ivec2 size_{};
    std::size_t traced_ = 0;  // by the latest of the two
    std::vector<FigurePart> parts_;
    ProgressLine line_;
};

}  // namespace

RegularGrid regular_grid(std::size_t samples, glm::ivec2 size) {
    // (w / c + 1) (h / c + 1) samples for cells of c pixels; solved for 1 / c.
    const double w = size.x, h = size.y, n = std::max(4., double(samples));
    const double u = (std::sqrt((w + h) * (w + h) + 4 * w * h * (n - 1)) - (w + h)) / (2 * w * h);
    const double share = 1 / u / std::max(w, h);
    // As MeshPreviewer does it, to the last bit: where a length is halfway between two numbers of
    // cells, rounding decides.
    const double cell = std::max(2., share * std::max(w, h));
    const auto cells = [&](double length) { return std::max(1L, std::lround(length / cell)) + 1; };
    return {share, std::size_t(cells(w)) * std::size_t(cells(h))};
}

Exit figures(const FiguresOptions& options) {
    return options.figure >= 3 ? comparison_figures(options) : Figures(options).run();
}

}  // namespace povpreview
