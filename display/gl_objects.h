// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <utility>

#include "display/gl_functions.h"

namespace povpreview {

/// Owner of one named GL object. Its context must be current when it is made and when it dies.
template <auto generate, auto destroy>
class GlObject {
   public:
    explicit GlObject(const GlFunctions& gl) : gl_(&gl) { (gl.*generate)(1, &id_); }
    GlObject(GlObject&& other) noexcept : gl_(other.gl_), id_(std::exchange(other.id_, 0)) {}
    GlObject& operator=(GlObject&& other) noexcept {
        std::swap(gl_, other.gl_);
        std::swap(id_, other.id_);
        return *this;
    }
    ~GlObject() {
        if (id_) (gl_->*destroy)(1, &id_);
    }
    GLuint id() const { return id_; }

   private:
    const GlFunctions* gl_;
    GLuint id_ = 0;
};

using GlBuffer = GlObject<&GlFunctions::GenBuffers, &GlFunctions::DeleteBuffers>;
using GlTexture = GlObject<&GlFunctions::GenTextures, &GlFunctions::DeleteTextures>;
using GlVertexArray = GlObject<&GlFunctions::GenVertexArrays, &GlFunctions::DeleteVertexArrays>;
using GlFramebuffer = GlObject<&GlFunctions::GenFramebuffers, &GlFunctions::DeleteFramebuffers>;
using GlRenderbuffer = GlObject<&GlFunctions::GenRenderbuffers, &GlFunctions::DeleteRenderbuffers>;

/// A linked program of a vertex and a fragment shader. A shader that does not compile is a fault of
/// this program, not of its user: its log is printed and the program aborts.
class GlProgram {
   public:
    /// The sources without "#version 330 core", which is put before them.
    GlProgram(const GlFunctions& gl, const char* vertex, const char* fragment);
    GlProgram(const GlProgram&) = delete;
    GlProgram& operator=(const GlProgram&) = delete;
    ~GlProgram();

    void use() const { gl_.UseProgram(id_); }
    GLint uniform(const char* name) const { return gl_.GetUniformLocation(id_, name); }

   private:
    GLuint compile(GLenum stage, const char* source) const;

    const GlFunctions& gl_;
    GLuint id_;
};

/// Vertex shader of passes over the whole viewport: three vertices by gl_VertexID alone, no
/// attributes. The core profile wants an (empty) vertex array bound all the same.
extern const char* const whole_viewport_shader;

}  // namespace povpreview
