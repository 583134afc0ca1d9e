// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/items/item_programs.h"

#include <cstddef>
#include <initializer_list>
#include <string>

#include "core/error.h"
#include "display/items/item_shaders.h"
#include "display/items/item_target.h"

namespace povpreview::items {

namespace {

template <class... Parts>
std::string source(const Parts*... parts) {
    return (std::string() + ... + parts);
}

std::string object_source(const char* tori, const char* conditions) {
    return source(shaders::records, shaders::result, shaders::local_ray, shaders::quadratic,
                  shaders::solids, tori, conditions, shaders::object_fragment);
}

}  // namespace

ItemPrograms::ItemPrograms(GlContext& context)
    : context_(context),
      gl_(context.gl()),
      faces_(gl_, shaders::corner_vertex,
             source(shaders::records, shaders::result, shaders::face_fragment).c_str()),
      spheres_(gl_, shaders::sphere_vertex,
               source(shaders::result, shaders::sphere_fragment).c_str()),
      capped_(gl_, shaders::capped_vertex,
              source(shaders::result, shaders::quadratic, shaders::capped_fragment).c_str()),
      unknown_(
          gl_, shaders::corner_vertex,
          source(shaders::records, shaders::result, shaders::local_ray, shaders::unknown_fragment)
              .c_str()),
      simple_objects_(gl_, shaders::corner_vertex,
                      object_source(shaders::without_tori, shaders::no_conditions).c_str()),
      objects_(gl_, shaders::corner_vertex,
               object_source(shaders::without_tori, shaders::conditions).c_str()),
      torus_objects_(gl_, shaders::corner_vertex,
                     object_source(shaders::with_tori, shaders::conditions).c_str()),
      records_(gl_),
      record_buffer_(gl_),
      corner_buffer_(gl_),
      sphere_buffer_(gl_),
      capped_buffer_(gl_),
      corner_array_(gl_),
      sphere_array_(gl_),
      capped_array_(gl_) {
    const auto offset = [](std::size_t bytes) { return reinterpret_cast<const void*>(bytes); };
    gl_.BindVertexArray(corner_array_.id());
    gl_.BindBuffer(GL_ARRAY_BUFFER, corner_buffer_.id());
    for (GLuint index : {0u, 1u}) gl_.EnableVertexAttribArray(index);
    gl_.VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(ItemCorner),
                            offset(offsetof(ItemCorner, position)));
    gl_.VertexAttribIPointer(1, 1, GL_UNSIGNED_INT, sizeof(ItemCorner),
                             offset(offsetof(ItemCorner, record)));

    declare_instances(sphere_array_, sphere_buffer_, sizeof(SphereInstance),
                      {{4, offsetof(SphereInstance, rectangle)},
                       {4, offsetof(SphereInstance, reference)},
                       {4, offsetof(SphereInstance, base)},
                       {4, offsetof(SphereInstance, direction)},
                       {3, offsetof(SphereInstance, across)},
                       {3, offsetof(SphereInstance, down)}},
                      {1, offsetof(SphereInstance, item)});
    declare_instances(capped_array_, capped_buffer_, sizeof(CappedInstance),
                      {{4, offsetof(CappedInstance, corners_low)},
                       {4, offsetof(CappedInstance, corners_high)},
                       {4, offsetof(CappedInstance, reference)},
                       {4, offsetof(CappedInstance, base)},
                       {4, offsetof(CappedInstance, direction)},
                       {3, offsetof(CappedInstance, across)},
                       {3, offsetof(CappedInstance, down)},
                       {4, offsetof(CappedInstance, signs)},
                       {4, offsetof(CappedInstance, planes)},
                       {4, offsetof(CappedInstance, planes) + sizeof(glm::vec4)}},
                      {4, offsetof(CappedInstance, items)});
}

void ItemPrograms::declare_instances(const GlVertexArray& array, const GlBuffer& buffer,
                                     std::size_t stride, std::initializer_list<Attribute> floats,
                                     const Attribute& integers) const {
    const auto offset = [](std::size_t bytes) { return reinterpret_cast<const void*>(bytes); };
    gl_.BindVertexArray(array.id());
    gl_.BindBuffer(GL_ARRAY_BUFFER, buffer.id());
    GLuint index = 0;
    for (const Attribute& attribute : floats)
        gl_.VertexAttribPointer(index++, attribute.values, GL_FLOAT, GL_FALSE,
                                static_cast<GLsizei>(stride), offset(attribute.at));
    gl_.VertexAttribIPointer(index++, integers.values, GL_UNSIGNED_INT,
                             static_cast<GLsizei>(stride), offset(integers.at));
    for (GLuint i = 0; i < index; ++i) {
        gl_.EnableVertexAttribArray(i);
        gl_.VertexAttribDivisor(i, 1);
    }
}

void ItemPrograms::upload_records(Records& records) {
    std::vector<glm::uvec4>& texels = records.texels();
    if (texels.empty()) return;
    int limit = 0;
    gl_.GetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &limit);
    if (texels.size() > static_cast<std::size_t>(limit))
        throw Error(Exit::usage, "OpenGL cannot hold the scene's geometry", context_.description(),
                    "preview without drawing what is seen beforehand");
    gl_.BindBuffer(GL_TEXTURE_BUFFER, record_buffer_.id());
    gl_.BufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(texels.size() * sizeof texels[0]),
                   texels.data(), GL_STREAM_DRAW);
    gl_.BindTexture(GL_TEXTURE_BUFFER, records_.id());
    gl_.TexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32UI, record_buffer_.id());
}

void ItemPrograms::set_uniforms(const GlProgram& program, const PixelRays& rays, int width,
                                int height) const {
    program.use();
    gl_.Uniform2f(program.uniform("size"), static_cast<float>(width), static_cast<float>(height));
    gl_.Uniform1i(program.uniform("records"), 0);
    gl_.Uniform1i(program.uniform("orthographic"), rays.orthographic);
    const glm::vec3 across(rays.across), down(rays.down);
    gl_.Uniform3f(program.uniform("across"), across.x, across.y, across.z);
    gl_.Uniform3f(program.uniform("down"), down.x, down.y, down.z);
}

void ItemPrograms::draw_corners(const GlProgram& program, const std::vector<ItemCorner>& corners) {
    gl_.BindVertexArray(corner_array_.id());
    gl_.BindBuffer(GL_ARRAY_BUFFER, corner_buffer_.id());
    gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners.size() * sizeof(ItemCorner)),
                   corners.data(), GL_STREAM_DRAW);
    program.use();
    gl_.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners.size()));
}

template <class Instance>
void ItemPrograms::draw_instances(const GlProgram& program, const GlVertexArray& array,
                                  const GlBuffer& buffer, const std::vector<Instance>& instances) {
    if (instances.empty()) return;
    gl_.BindVertexArray(array.id());
    gl_.BindBuffer(GL_ARRAY_BUFFER, buffer.id());
    gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(instances.size() * sizeof(Instance)),
                   instances.data(), GL_STREAM_DRAW);
    program.use();
    gl_.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(instances.size()));
}

void ItemPrograms::draw(DrawLists& lists, const PixelRays& rays, int width, int height) {
    gl_.ActiveTexture(GL_TEXTURE0);
    upload_records(lists.records);
    gl_.Disable(GL_BLEND);
    gl_.Disable(GL_CULL_FACE);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthFunc(GL_GREATER);
    const std::pair<const GlProgram*, const std::vector<ItemCorner>*> passes[] = {
        {&faces_, &lists.faces},
        {&unknown_, &lists.unknown},
        {&simple_objects_, &lists.simple_objects},
        {&objects_, &lists.objects},
        {&torus_objects_, &lists.torus_objects}};
    for (const auto& [program, corners] : passes) {
        if (corners->empty()) continue;
        set_uniforms(*program, rays, width, height);
        draw_corners(*program, *corners);
    }
    for (const GlProgram* program : {&spheres_, &capped_})
        set_uniforms(*program, rays, width, height);
    draw_instances(spheres_, sphere_array_, sphere_buffer_, lists.spheres);
    draw_instances(capped_, capped_array_, capped_buffer_, lists.capped);
    gl_.DepthFunc(GL_LESS);
    gl_.Disable(GL_DEPTH_TEST);
}

}  // namespace povpreview::items
