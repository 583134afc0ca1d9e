// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/detail/item_painter.h"

#include <algorithm>

#include "core/detail/curved_items.h"
#include "core/detail/face_items.h"
#include "core/detail/item_sources.h"
#include "core/detail/mirrored_items.h"
#include "core/detail/row_bands.h"
#include "core/detail/seen_look.h"

namespace povpreview {

namespace {

using Source = ItemCanvas::Source;

/// What a canvas shows, told in the scene's terms.
class Reading {
   public:
    Reading(const DrawableScene& scene, const PixelRays& rays, const ItemCanvas& canvas,
            const PaintingPace& pace)
        : scene_(scene), rays_(rays), canvas_(canvas), pace_(pace) {}

    ItemBuffer read() {
        result_.width = canvas_.width();
        result_.height = canvas_.height();
        const std::size_t pixels = std::size_t(result_.width) * std::size_t(result_.height);
        result_.surfaces.resize(pixels, ItemBuffer::unknown);
        result_.kinds.resize(pixels, Look::Kind::mixed);
        if (std::any_of(scene_.looks.begin(), scene_.looks.end(), has_albedo))
            result_.albedos.resize(pixels);
        for_each_band(0, result_.height, rows_for_threads(result_.height),
                      [&](int, int top, int bottom) {
                          for (int y = top; y < bottom; ++y) read_row(y);
                      });
        for (const ItemCanvas::Tie& tie : canvas_.ties())
            if (canvas_.stands(tie) &&
                surface_of(scene_, tie.first) != surface_of(scene_, tie.second))
                forget(tie.pixel);
        return std::move(result_);
    }

   private:
    void read_row(int y) {
        canvas_.visit_row(y, [&](std::size_t first, std::size_t last) {
            std::fill_n(result_.surfaces.begin() + std::ptrdiff_t(first), last - first,
                        surface_of(scene_, canvas_.source(first)));
            read_look(y, first, last);
        });
        pace_.row_done();
    }

    /// Of pixels of one source in a row.
    void read_look(int y, std::size_t first, std::size_t last) {
        const Source source = canvas_.source(first);
        const auto look_at = [&](std::size_t pixel) {
            const glm::dvec2 place(double(pixel - canvas_.index(0, y)) + .5, y + .5);
            return seen_look(scene_, rays_, place, canvas_.nearness(pixel), source);
        };
        const Look* look = look_of(scene_, source);
        if (!look || !has_albedo(*look)) {
            const Look::Kind kind =
                look && is_plain_mirror(*look) ? Look::Kind::traced : look_at(first).kind;
            std::fill_n(result_.kinds.begin() + std::ptrdiff_t(first), last - first, kind);
            return;
        }
        for (std::size_t pixel = first; pixel < last; ++pixel) {
            const SeenLook seen = look_at(pixel);
            result_.kinds[pixel] = seen.kind;
            if (seen.albedo) result_.albedos[pixel] = *seen.albedo;
        }
    }

    void forget(std::size_t pixel) {
        result_.surfaces[pixel] = ItemBuffer::unknown;
        result_.kinds[pixel] = Look::Kind::mixed;
    }

    const DrawableScene& scene_;
    const PixelRays& rays_;
    const ItemCanvas& canvas_;
    const PaintingPace& pace_;
    ItemBuffer result_;
};

}  // namespace

ItemPainting::ItemPainting(const DrawableScene& scene, const PaintingPace& pace)
    : pace_(pace),
      rays_(scene.polygons.camera),
      canvas_(scene.polygons.width, scene.polygons.height) {
    const bool valid = rays_.valid;
    draw_bands(canvas_, rows_for_threads(canvas_.height()),
               [valid](ItemCanvas& band) { valid ? band.clear() : band.hide_all(); });
    if (!valid) return;
    draw_faces(scene.polygons, rays_, canvas_, pace);
    draw_curved(scene, rays_, canvas_, pace);
}

ItemBuffer ItemPainting::read(const DrawableScene& scene) const {
    return Reading(scene, rays_, canvas_, pace_).read();
}

void ItemPainting::paint_mirrors(const DrawableScene& scene, ItemBuffer& items) {
    if (rays_.valid) mirror_views_ = paint_mirrored(scene, rays_, canvas_, pace_, items);
    read_mirrored_looks(scene, items);
}

void ItemPainting::read_mirrored_looks(const DrawableScene& scene, ItemBuffer& items) const {
    povpreview::read_mirrored_looks(scene, mirror_views_, items);
}

ItemBuffer paint_items(const DrawableScene& scene, const PaintingPace& pace) {
    ItemPainting painting(scene, pace);
    ItemBuffer items = painting.read(scene);
    painting.paint_mirrors(scene, items);
    return items;
}

}  // namespace povpreview
