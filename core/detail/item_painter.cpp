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
    Reading(const DrawableScene& scene, const PixelRays& rays, const ItemCanvas& canvas)
        : scene_(scene), rays_(rays), canvas_(canvas) {}

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
                          for (int y = top; y < bottom; ++y)
                              for (int x = 0; x < result_.width; ++x) read(x, y);
                      });
        for (const ItemCanvas::Tie& tie : canvas_.ties())
            if (canvas_.stands(tie) &&
                surface_of(scene_, tie.first) != surface_of(scene_, tie.second))
                forget(tie.pixel);
        return std::move(result_);
    }

   private:
    /// Whether samples tell of what is seen in the surface (see Sample).
    bool shows_more(Source source) const {
        const Look* look = look_of(scene_, source);
        return look && is_plain_mirror(*look);
    }

    void read(int x, int y) {
        const std::size_t pixel = canvas_.index(x, y);
        const Source source = canvas_.source(pixel);
        result_.surfaces[pixel] = surface_of(scene_, source);
        const SeenLook look =
            seen_look(scene_, rays_, glm::dvec2(x + .5, y + .5), canvas_.nearness(pixel), source);
        result_.kinds[pixel] = shows_more(source) ? Look::Kind::traced : look.kind;
        if (look.albedo) result_.albedos[pixel] = *look.albedo;
    }

    void forget(std::size_t pixel) {
        result_.surfaces[pixel] = ItemBuffer::unknown;
        result_.kinds[pixel] = Look::Kind::mixed;
    }

    const DrawableScene& scene_;
    const PixelRays& rays_;
    const ItemCanvas& canvas_;
    ItemBuffer result_;
};

}  // namespace

ItemPainting::ItemPainting(const DrawableScene& scene, const std::atomic<bool>& stop)
    : rays_(scene.polygons.camera), canvas_(scene.polygons.width, scene.polygons.height) {
    if (!rays_.valid) {
        for (std::size_t pixel = 0; pixel < canvas_.index(0, canvas_.height()); ++pixel)
            canvas_.hide(pixel, 0);
        return;
    }
    draw_faces(scene.polygons, rays_, canvas_, stop);
    draw_curved(scene, rays_, canvas_, stop);
}

ItemBuffer ItemPainting::read(const DrawableScene& scene) const {
    return Reading(scene, rays_, canvas_).read();
}

void ItemPainting::paint_mirrors(const DrawableScene& scene, const std::atomic<bool>& stop,
                                 ItemBuffer& items) {
    if (rays_.valid) mirror_views_ = paint_mirrored(scene, rays_, canvas_, stop, items);
    read_mirrored_looks(scene, items);
}

void ItemPainting::read_mirrored_looks(const DrawableScene& scene, ItemBuffer& items) const {
    povpreview::read_mirrored_looks(scene, mirror_views_, items);
}

ItemBuffer paint_items(const DrawableScene& scene, const std::atomic<bool>& stop) {
    ItemPainting painting(scene, stop);
    ItemBuffer items = painting.read(scene);
    painting.paint_mirrors(scene, stop, items);
    return items;
}

}  // namespace povpreview
