// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/painter.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <limits>

#include "core/error.h"
#include "display/detail_layer.h"
#include "display/gl_objects.h"
#include "display/painter_shaders.h"

namespace povpreview {

namespace {

using Corner = Picture::Corner;
using Paint = std::array<float, 4>;

/// A line as it is drawn.
struct Stroke {
    glm::vec2 from, to;
    Paint paint;
};

// Overlays, in linear light and target pixels.
constexpr Paint mesh_paint{.22f, .22f, .22f, .55f};
constexpr Paint sample_paint{1.f, .85f, .1f, .9f};
constexpr float mesh_half_width = .4f, constraint_half_width = .7f, sample_radius = 1.6f;

// Constraints by kind; bright and pure, since pictures seldom are.
constexpr Paint geometric_paint{1.f, .16f, .02f, .95f};  // red
constexpr Paint reflection_paint{1.f, .03f, .8f, .95f};  // magenta
constexpr Paint traced_paint{1.f, .9f, .3f, .95f};       // pale yellow
// Shadows by light, in turn: azure, green, violet, teal.
constexpr std::array<Paint, 4> shadow_paints{
    {{.02f, .35f, 1.f, .95f}, {.1f, .8f, .05f, .95f}, {.35f, .1f, 1.f, .95f}, {0, .7f, .6f, .95f}}};

Paint constraint_paint(EdgeKind kind, std::uint16_t light) {
    switch (kind) {
        case EdgeKind::geometric:
            return geometric_paint;
        case EdgeKind::shadow:
            return shadow_paints[light % shadow_paints.size()];
        case EdgeKind::reflection:
            return reflection_paint;
        case EdgeKind::traced:
            break;
    }
    return traced_paint;
}

/// One vertex array over one buffer of equal elements.
struct Elements {
    explicit Elements(const GlFunctions& gl_functions)
        : gl(gl_functions), array(gl_functions), buffer(gl_functions) {}

    template <class T>
    void upload(const std::vector<T>& elements) {
        gl.BindBuffer(GL_ARRAY_BUFFER, buffer.id());
        gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(elements.size() * sizeof(T)),
                      elements.data(), GL_DYNAMIC_DRAW);
        count = static_cast<GLsizei>(elements.size());
    }
    /// `step` 0: one value a vertex; 1: one an instance.
    void attribute(GLuint index, GLint floats, std::size_t stride, std::size_t offset,
                   GLuint step) const {
        gl.BindVertexArray(array.id());
        gl.BindBuffer(GL_ARRAY_BUFFER, buffer.id());
        gl.EnableVertexAttribArray(index);
        gl.VertexAttribPointer(index, floats, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                               reinterpret_cast<const void*>(offset));
        gl.VertexAttribDivisor(index, step);
    }

    const GlFunctions& gl;
    GlVertexArray array;
    GlBuffer buffer;
    GLsizei count = 0;
};

/// Side of a block: Mesa takes no texture of more than a gigabyte, whatever its sides.
constexpr int largest_block = 4096;

/// A block of the picture's pixels, no larger than a texture may be.
struct PixelBlock {
    PixelBlock(const GlFunctions& gl, const Picture& picture, int x0, int y0, int limit)
        : x(x0),
          y(y0),
          width(std::min(limit, picture.width - x0)),
          height(std::min(limit, picture.height - y0)),
          colours(gl),
          known(gl) {
        const std::size_t start = static_cast<std::size_t>(y) * picture.width + x;
        gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
        gl.PixelStorei(GL_UNPACK_ROW_LENGTH, picture.width);
        upload(gl, colours, GL_RGB32F, GL_RGB, GL_FLOAT, picture.pixels.data() + start);
        upload(gl, known, GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE, picture.known.data() + start);
        gl.PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    }

    int x, y, width, height;
    GlTexture colours, known;

   private:
    void upload(const GlFunctions& gl, const GlTexture& texture, GLint internal, GLenum format,
                GLenum type, const void* data) const {
        gl.BindTexture(GL_TEXTURE_2D, texture.id());
        gl.TexImage2D(GL_TEXTURE_2D, 0, internal, width, height, 0, format, type, data);
        for (GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
            gl.TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
    }
};

}  // namespace

struct Painter::Layers {
    explicit Layers(GlContext& with)
        : context(with),
          gl(with.gl()),
          triangle_program(gl, shaders::triangle_vertex, shaders::triangle_fragment),
          pixel_program(gl, whole_viewport_shader, shaders::pixel_fragment),
          line_program(gl, shaders::line_vertex, shaders::line_fragment),
          dot_program(gl, shaders::dot_vertex, shaders::dot_fragment),
          detail(with),
          triangles(gl),
          mesh(gl),
          constraints(gl),
          samples(gl),
          no_attributes(gl) {
        triangles.attribute(0, 2, sizeof(Corner), offsetof(Corner, position), 0);
        triangles.attribute(1, 3, sizeof(Corner), offsetof(Corner, colour), 0);
        for (const Elements* lines : {&mesh, &constraints}) {
            lines->attribute(0, 2, sizeof(Stroke), offsetof(Stroke, from), 1);
            lines->attribute(1, 2, sizeof(Stroke), offsetof(Stroke, to), 1);
            lines->attribute(2, 4, sizeof(Stroke), offsetof(Stroke, paint), 1);
        }
        samples.attribute(0, 2, sizeof(glm::vec2), 0, 1);
    }

    void load_pixels(const Picture& picture);
    void draw_pixels(const View& view) const;
    void draw_lines(const Elements& lines, const View& view, float half_width) const;
    void draw_samples(const View& view) const;
    void place(const GlProgram& program, const View& view) const;

    GlContext& context;
    const GlFunctions& gl;
    GlProgram triangle_program, pixel_program, line_program, dot_program;
    DetailLayer detail;
    Elements triangles, mesh, constraints, samples;
    GlVertexArray no_attributes;
    std::vector<PixelBlock> pixels;
    int width = 1, height = 1;
    bool detailed = false;  // the triangles are with `detail`
};

void Painter::Layers::load_pixels(const Picture& picture) {
    pixels.clear();
    const auto is_known = [](std::uint8_t known) { return known != 0; };
    if (std::none_of(picture.known.begin(), picture.known.end(), is_known)) return;
    assert(picture.pixels.size() == static_cast<std::size_t>(picture.width) * picture.height);
    assert(picture.known.size() == picture.pixels.size());
    const int limit = std::min(largest_block, context.max_texture_size());
    for (int y = 0; y < picture.height; y += limit)
        for (int x = 0; x < picture.width; x += limit)
            pixels.emplace_back(gl, picture, x, y, limit);
    if (gl.GetError() != GL_NO_ERROR)
        throw Error(Exit::usage, "OpenGL cannot hold the picture's pixels", context.description(),
                    "choose a smaller size or another display backend");
}

/// Sets the uniforms that bring picture pixels to the viewport.
void Painter::Layers::place(const GlProgram& program, const View& view) const {
    program.use();
    gl.Uniform2f(program.uniform("scale"), static_cast<float>(view.width) / width,
                 static_cast<float>(view.height) / height);
    gl.Uniform2f(program.uniform("origin"), view.x, view.y);
    gl.Uniform2f(program.uniform("tile"), view.tile_width, view.tile_height);
    gl.Uniform1f(program.uniform("up"), view.top_row_first ? -1 : 1);
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const bool clamped = view.range == Range::display;
    gl.Uniform2f(program.uniform("range"), clamped ? 0 : -infinity, clamped ? 1 : infinity);
}

void Painter::Layers::draw_pixels(const View& view) const {
    place(pixel_program, view);
    gl.BindVertexArray(no_attributes.id());
    gl.Uniform1i(pixel_program.uniform("colours"), 0);
    gl.Uniform1i(pixel_program.uniform("known"), 1);
    for (const PixelBlock& block : pixels) {
        gl.ActiveTexture(GL_TEXTURE1);
        gl.BindTexture(GL_TEXTURE_2D, block.known.id());
        gl.ActiveTexture(GL_TEXTURE0);
        gl.BindTexture(GL_TEXTURE_2D, block.colours.id());
        gl.Uniform2i(pixel_program.uniform("first"), block.x, block.y);
        gl.DrawArrays(GL_TRIANGLES, 0, 3);
    }
}

void Painter::Layers::draw_lines(const Elements& lines, const View& view, float half_width) const {
    place(line_program, view);
    gl.Uniform1f(line_program.uniform("half_width"), half_width);
    gl.BindVertexArray(lines.array.id());
    gl.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, lines.count);
}

void Painter::Layers::draw_samples(const View& view) const {
    place(dot_program, view);
    gl.Uniform1f(dot_program.uniform("radius"), sample_radius);
    gl.Uniform4f(dot_program.uniform("paint"), sample_paint[0], sample_paint[1], sample_paint[2],
                 sample_paint[3]);
    gl.BindVertexArray(samples.array.id());
    gl.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, samples.count);
}

Painter::Painter(GlContext& context) : layers_(std::make_unique<Layers>(context)) {}

Painter::~Painter() = default;

void Painter::load(const Picture& picture) {
    assert(picture.width > 0 && picture.height > 0 && picture.corners.size() % 3 == 0);
    layers_->width = picture.width;
    layers_->height = picture.height;
    layers_->detailed = layers_->detail.takes(picture);
    if (layers_->detailed)
        layers_->detail.load(picture);
    else
        layers_->triangles.upload(picture.corners);
    std::vector<Stroke> mesh, constraints;
    for (const Picture::Line& line : picture.lines)
        if (line.constraint)
            constraints.push_back({line.from, line.to, constraint_paint(line.kind, line.light)});
        else
            mesh.push_back({line.from, line.to, mesh_paint});
    layers_->mesh.upload(mesh);
    layers_->constraints.upload(constraints);
    layers_->samples.upload(picture.samples);
    layers_->load_pixels(picture);
}

void Painter::draw(const View& view, Overlay overlay) const {
    const Layers& layers = *layers_;
    const GlFunctions& gl = layers.gl;
    gl.Disable(GL_BLEND);
    gl.Disable(GL_DEPTH_TEST);
    gl.Disable(GL_CULL_FACE);
    if (layers.detailed) {
        layers.detail.draw([&](const GlProgram& program) { layers.place(program, view); });
    } else {
        layers.place(layers.triangle_program, view);
        gl.BindVertexArray(layers.triangles.array.id());
        gl.DrawArrays(GL_TRIANGLES, 0, layers.triangles.count);
    }
    layers.draw_pixels(view);

    if (overlay == Overlay::none) return;
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    if (overlay == Overlay::mesh) layers.draw_lines(layers.mesh, view, mesh_half_width);
    if (overlay == Overlay::mesh || overlay == Overlay::edges)
        layers.draw_lines(layers.constraints, view, constraint_half_width);
    if (overlay == Overlay::samples) layers.draw_samples(view);
    gl.Disable(GL_BLEND);
}

}  // namespace povpreview
