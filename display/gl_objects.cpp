// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/gl_objects.h"

#include <cstdio>
#include <cstdlib>
#include <string>

namespace povpreview {

namespace {

[[noreturn]] void fault(const char* what, const std::string& log) {
    std::fprintf(stderr, "povpreview: fault in a %s:\n%s\n", what, log.c_str());
    std::abort();
}

}  // namespace

//    3 +          One triangle that is larger than the viewport (#) has no seam, as two would
//      | `.       have along a diagonal.
//    1 +---`.
//      |####|`.
//   -1 +####+--`+
//     -1    1   3
const char* const whole_viewport_shader = R"(
void main() {
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    gl_Position = vec4(corner, 0.0, 1.0);
})";

GlProgram::GlProgram(const GlFunctions& gl, const char* vertex, const char* fragment)
    : gl_(gl), id_(gl.CreateProgram()) {
    const GLuint stages[] = {compile(GL_VERTEX_SHADER, vertex),
                             compile(GL_FRAGMENT_SHADER, fragment)};
    for (GLuint stage : stages) gl_.AttachShader(id_, stage);
    gl_.LinkProgram(id_);
    for (GLuint stage : stages) gl_.DeleteShader(stage);  // lives on while the program does
    GLint linked = 0;
    gl_.GetProgramiv(id_, GL_LINK_STATUS, &linked);
    if (!linked) {
        char log[4096] = "";
        gl_.GetProgramInfoLog(id_, sizeof log, nullptr, log);
        fault("shader program", log);
    }
}

GlProgram::~GlProgram() { gl_.DeleteProgram(id_); }

GLuint GlProgram::compile(GLenum stage, const char* source) const {
    const GLuint shader = gl_.CreateShader(stage);
    const char* const sources[] = {"#version 330 core\n", source};
    gl_.ShaderSource(shader, 2, sources, nullptr);
    gl_.CompileShader(shader);
    GLint compiled = 0;
    gl_.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (!compiled) {
        char log[4096] = "";
        gl_.GetShaderInfoLog(shader, sizeof log, nullptr, log);
        fault("shader", std::string(log) + source);
    }
    return shader;
}

}  // namespace povpreview
