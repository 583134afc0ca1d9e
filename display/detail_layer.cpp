// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/detail_layer.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "core/detail/detail_map.h"
#include "display/detail_shaders.h"

namespace povpreview {

namespace {

using Light = Picture::Light;

/// A corner with what the shaders want to know of its triangle.
struct TriangleCorner {
    glm::vec2 position;
    glm::vec3 colour, illumination, remainder;
    std::array<std::uint32_t, 3> items;
    std::uint32_t shaded;  ///< a bit for each corner
};

/// Texels to a row, of tables that are no pictures.
constexpr std::size_t table_width = 1024;
/// Albedos are held twice while they go to GL, in 24 bytes a pixel.
constexpr long long most_pixels = 1LL << 26;

bool is_even(const Light* corners) {
    return corners[0].item == corners[1].item && corners[1].item == corners[2].item;
}

}  // namespace

DetailLayer::DetailLayer(const GlContext& context)
    : context_(context),
      gl_(context.gl()),
      even_program_(gl_, shaders::even_vertex, shaders::even_fragment.c_str()),
      odd_program_(gl_, shaders::odd_vertex, shaders::odd_fragment.c_str()),
      array_(gl_),
      corners_(gl_),
      items_(gl_),
      albedos_(gl_),
      ranges_(gl_),
      anchors_(gl_) {
    gl_.BindVertexArray(array_.id());
    gl_.BindBuffer(GL_ARRAY_BUFFER, corners_.id());
    const auto at = [](std::size_t offset) { return reinterpret_cast<const void*>(offset); };
    constexpr GLsizei stride = sizeof(TriangleCorner);
    const auto floats = [&](GLuint index, GLint count, std::size_t offset) {
        gl_.EnableVertexAttribArray(index);
        gl_.VertexAttribPointer(index, count, GL_FLOAT, GL_FALSE, stride, at(offset));
    };
    const auto integers = [&](GLuint index, GLint count, std::size_t offset) {
        gl_.EnableVertexAttribArray(index);
        gl_.VertexAttribIPointer(index, count, GL_UNSIGNED_INT, stride, at(offset));
    };
    floats(0, 2, offsetof(TriangleCorner, position));
    floats(1, 3, offsetof(TriangleCorner, colour));
    floats(2, 3, offsetof(TriangleCorner, illumination));
    floats(3, 3, offsetof(TriangleCorner, remainder));
    integers(4, 3, offsetof(TriangleCorner, items));
    integers(5, 1, offsetof(TriangleCorner, shaded));
    for (const GlTexture* texture : {&items_, &albedos_, &ranges_, &anchors_}) {
        gl_.BindTexture(GL_TEXTURE_2D, texture->id());
        for (GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
            gl_.TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
    }
}

bool DetailLayer::takes(const Picture& picture) const {
    return picture.detail &&
           std::max(picture.width, picture.height) <= context_.max_texture_size() &&
           1LL * picture.width * picture.height <= most_pixels;
}

void DetailLayer::load(const Picture& picture) {
    load_triangles(picture);
    load_pixels(picture);
    load_anchors(picture);
}

void DetailLayer::load_triangles(const Picture& picture) {
    std::vector<TriangleCorner> corners;
    corners.reserve(picture.corners.size());
    const auto add = [&](std::size_t triangle) {
        const Light* lights = &picture.lights[triangle];
        std::uint32_t shaded = 0;
        for (unsigned i = 0; i < 3; ++i) shaded |= std::uint32_t(lights[i].shaded) << i;
        for (unsigned i = 0; i < 3; ++i) {
            const Picture::Corner& corner = picture.corners[triangle + i];
            corners.push_back({corner.position,
                               corner.colour,
                               lights[i].illumination,
                               lights[i].remainder,
                               {lights[0].item, lights[1].item, lights[2].item},
                               shaded});
        }
    };
    for (std::size_t i = 0; i < picture.corners.size(); i += 3)
        if (is_even(&picture.lights[i])) add(i);
    even_ = static_cast<GLsizei>(corners.size());
    for (std::size_t i = 0; i < picture.corners.size(); i += 3)
        if (!is_even(&picture.lights[i])) add(i);
    odd_ = static_cast<GLsizei>(corners.size()) - even_;
    gl_.BindBuffer(GL_ARRAY_BUFFER, corners_.id());
    gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners.size() * sizeof corners[0]),
                   corners.data(), GL_DYNAMIC_DRAW);
}

void DetailLayer::load_pixels(const Picture& picture) {
    const DetailMap& detail = *picture.detail;
    std::vector<std::uint32_t> items(std::size_t(picture.width) * std::size_t(picture.height));
    for (Pixel i = 0; i < items.size(); ++i) items[i] = detail.item(i);
    gl_.BindTexture(GL_TEXTURE_2D, items_.id());
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_R32UI, picture.width, picture.height, 0, GL_RED_INTEGER,
                   GL_UNSIGNED_INT, items.data());
    const bool any = detail.albedos() > 0;
    std::vector<glm::vec4> albedos(any ? items.size() : 1);
    for (Pixel i = 0; any && i < albedos.size(); ++i)
        if (detail.albedo_state(i) == DetailMap::Albedo::known)
            albedos[i] = glm::vec4(detail.albedo(i), 1);
    gl_.BindTexture(GL_TEXTURE_2D, albedos_.id());
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16F, any ? picture.width : 1, any ? picture.height : 1,
                   0, GL_RGBA, GL_FLOAT, albedos.data());
}

void DetailLayer::load_anchors(const Picture& picture) {
    const auto rows = [](std::size_t count) { return (count + table_width - 1) / table_width; };
    std::vector<std::array<std::uint32_t, 2>> ranges(
        std::max<std::size_t>(1, rows(picture.first_anchors.size())) * table_width);
    for (std::size_t item = 0; item + 1 < picture.first_anchors.size(); ++item)
        ranges[item] = {picture.first_anchors[item], picture.first_anchors[item + 1]};
    gl_.BindTexture(GL_TEXTURE_2D, ranges_.id());
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RG32UI, static_cast<GLsizei>(table_width),
                   static_cast<GLsizei>(ranges.size() / table_width), 0, GL_RG_INTEGER,
                   GL_UNSIGNED_INT, ranges.data());

    std::vector<std::array<glm::vec4, 4>> anchors;
    anchors.reserve(picture.anchors.size());
    for (const Picture::Anchor& a : picture.anchors)
        anchors.push_back({glm::vec4(a.corner.position, a.light.shaded, 0),
                           glm::vec4(a.corner.colour, 0), glm::vec4(a.light.illumination, 0),
                           glm::vec4(a.light.remainder, 0)});
    anchors.resize(std::max<std::size_t>(1, rows(anchors.size())) * table_width);
    gl_.BindTexture(GL_TEXTURE_2D, anchors_.id());
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, static_cast<GLsizei>(4 * table_width),
                   static_cast<GLsizei>(anchors.size() / table_width), 0, GL_RGBA, GL_FLOAT,
                   anchors.data());
}

void DetailLayer::draw(const std::function<void(const GlProgram&)>& place) const {
    constexpr std::array<GLenum, 4> units{GL_TEXTURE0, GL_TEXTURE1, GL_TEXTURE2, GL_TEXTURE3};
    const std::array<const GlTexture*, 4> textures{&items_, &albedos_, &ranges_, &anchors_};
    constexpr std::array<const char*, 4> names{"pixel_items", "pixel_albedos", "anchor_ranges",
                                               "anchors"};
    for (std::size_t i = 4; i-- > 0;) {
        gl_.ActiveTexture(units[i]);
        gl_.BindTexture(GL_TEXTURE_2D, textures[i]->id());
    }
    gl_.BindVertexArray(array_.id());
    const auto draw = [&](const GlProgram& program, GLsizei first, GLsizei count) {
        if (count == 0) return;
        place(program);
        for (std::size_t i = 0; i < 4; ++i)
            gl_.Uniform1i(program.uniform(names[i]), static_cast<GLint>(i));
        gl_.DrawArrays(GL_TRIANGLES, first, count);
    };
    draw(even_program_, 0, even_);
    draw(odd_program_, even_, odd_);
}

}  // namespace povpreview
