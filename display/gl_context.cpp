// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/gl_context.h"

#include <cstdlib>
#include <cstring>

#include "core/error.h"
#include "display/address_space.h"

namespace povpreview {

namespace {

// EGL and OSMesa both come from Mesa and share one "current context" slot per thread, but each
// only remembers what it bound itself: eglMakeCurrent would do nothing where OSMesa has taken the
// slot in between. So the one that has it is told to let go before another one binds.
thread_local GlContext* current = nullptr;

std::string text(const GLubyte* string) {
    return string ? reinterpret_cast<const char*>(string) : "unknown";
}

}  // namespace

void GlContext::make_current() {
    if (current == this) return;
    if (current) current->release();
    current = nullptr;
    bind();
    current = this;
}

void GlContext::leave() {
    if (current != this) return;
    release();
    current = nullptr;
}

void GlContext::load(const std::string& maker) {
    make_current();
    gl_.load([this](const char* name) { return proc_address(name); }, maker.c_str());
    int major = 0, minor = 0;
    gl_.GetIntegerv(GL_MAJOR_VERSION, &major);
    gl_.GetIntegerv(GL_MINOR_VERSION, &minor);
    description_ = maker + ", " + text(gl_.GetString(GL_RENDERER)) + ", OpenGL " +
                   std::to_string(major) + "." + std::to_string(minor);
    if (major * 10 + minor < 33)
        throw Error(Exit::usage, "OpenGL 3.3 is needed", description_,
                    "install a newer driver, such as Debian's libgl1-mesa-dri");
    int texture = 0, renderbuffer = 0;
    gl_.GetIntegerv(GL_MAX_TEXTURE_SIZE, &texture);
    gl_.GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &renderbuffer);
    gl_.GetIntegerv(GL_MAX_SAMPLES, &max_samples_);
    max_texture_size_ = texture < renderbuffer ? texture : renderbuffer;
}

Backend backend_named(std::string_view name) {
    if (name == "automatic") return Backend::automatic;
    if (name == "egl") return Backend::egl;
    if (name == "osmesa") return Backend::osmesa;
    throw Error(Exit::usage, "no display backend is named \"" + std::string(name) + "\"", "",
                "choose egl, osmesa or automatic");
}

std::unique_ptr<GlContext> open_offscreen(Backend backend) {
    require_address_space(address_space::drawing, "OpenGL");
    const char* named = std::getenv("POVPREVIEW_BACKEND");
    if (backend == Backend::automatic && named && *named) backend = backend_named(named);
    if (backend == Backend::egl) return open_egl();
    if (backend == Backend::osmesa) return open_osmesa();
    std::string why_not;
    try {
        return open_egl();
    } catch (const Error& error) {
        why_not = error.what();
    }
    try {
        return open_osmesa();
    } catch (const Error& error) {
        throw Error(Exit::usage, why_not + "; or " + error.what(), "no way to draw was found", "");
    }
}

}  // namespace povpreview
