// SPDX-License-Identifier: AGPL-3.0-or-later
#include "adapter/geometry_arrival.h"

#include <fmt/format.h>

namespace povpreview {
namespace {

/// Points, corners or polygons of a scene: ten times what the tracer sends at most.
constexpr std::size_t geometry_limit = std::size_t{1} << 24;

void check_size(const Geometry& geometry) {
    for (const std::size_t size :
         {geometry.points.size(), geometry.corners.size(), geometry.polygons.size(),
          geometry.left_out.size(), geometry.solids.size(), geometry.conditions.size(),
          geometry.pieces.size(), geometry.objects.size(), geometry.unknown.size(),
          geometry.unknown_in_mirrors.size(), geometry.looks.size()})
        if (size > geometry_limit)
            throw WireFault(fmt::format("geometry of more than {} parts", geometry_limit));
}

}  // namespace

void GeometryArrival::begin() {
    arriving_ = {};
    ended_ = false;
    arriving_images_.clear();
    image_ = 0;
}

void GeometryArrival::accept(const report::GeometryChunk& chunk) {
    if (ended_) throw WireFault("more geometry after the last of it");
    ended_ = chunk.last;
    expect_images(chunk.part.images);
    if (chunk.last) check_images_complete();
    if (geometry_complete_) return;
    arriving_.append(chunk.part);
    check_size(arriving_);
    if (!chunk.last) return;
    geometry_complete_ = true;
    geometry_ = std::exchange(arriving_, {});
}

/// Of their texels nothing has come yet.
void GeometryArrival::expect_images(const std::vector<ImageTexels>& images) {
    arriving_images_.insert(arriving_images_.end(), images.begin(), images.end());
    std::size_t texels = 0;
    for (const ImageTexels& image : arriving_images_)
        texels += std::size_t{image.width} * image.height;
    if (texels > wire_max_texels) throw WireFault(fmt::format("images of {} texels", texels));
}

void GeometryArrival::accept(const report::Texels& part) {
    if (!ended_) throw WireFault("texels before the last of the geometry");
    if (image_ >= arriving_images_.size() || part.image != image_)
        throw WireFault(fmt::format("texels of image {}, not of image {}", part.image, image_));
    ImageTexels& image = arriving_images_[image_];
    const std::size_t size = std::size_t{image.width} * image.height;
    if (part.first != image.texels.size() || part.texels.size() > size - part.first)
        throw WireFault(fmt::format("texels {} to {} of an image of {}, after {}", part.first,
                                    part.first + part.texels.size(), size, image.texels.size()));
    image.texels.insert(image.texels.end(), part.texels.begin(), part.texels.end());
    if (image.texels.size() == size) ++image_;
    check_images_complete();
}

void GeometryArrival::check_images_complete() {
    if (image_ < arriving_images_.size()) return;
    if (!images_complete_) images_ = std::move(arriving_images_);
    images_complete_ = true;
    arriving_images_.clear();
    image_ = 0;
}

}  // namespace povpreview
