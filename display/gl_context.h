// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "display/gl_functions.h"

namespace povpreview {

/// An OpenGL 3.3 core context and its functions; where it comes from (EGL, OSMesa, a window) is its
/// makers' business. Belongs to the thread that made it.
class GlContext {
   public:
    GlContext(const GlContext&) = delete;
    GlContext& operator=(const GlContext&) = delete;
    virtual ~GlContext() = default;

    /// Makes it the calling thread's current context. Cheap when it is already.
    void make_current();

    const GlFunctions& gl() const { return gl_; }
    /// Such as "EGL device, llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5".
    const std::string& description() const { return description_; }
    /// The largest side of a texture or a renderbuffer, pixels.
    int max_texture_size() const { return max_texture_size_; }
    /// The most samples per pixel of a multisampled renderbuffer.
    int max_samples() const { return max_samples_; }

   protected:
    GlContext() = default;
    /// Last step of every maker's constructor: loads the functions and asks for the limits.
    void load(const std::string& maker);
    /// First step of every maker's destructor.
    void leave();

   private:
    virtual void bind() = 0;
    virtual void release() = 0;
    virtual GlProc proc_address(const char* name) const = 0;

    GlFunctions gl_;
    std::string description_;
    int max_texture_size_ = 0, max_samples_ = 0;
};

/// Who makes offscreen contexts.
enum class Backend { automatic, egl, osmesa };

/// "automatic", "egl" or "osmesa"; anything else throws Error(Exit::usage).
Backend backend_named(std::string_view name);

/// A context without a window. `automatic` takes the one that the environment variable
/// POVPREVIEW_BACKEND names; where there is none, EGL, and if that fails OSMesa. Throws
/// Error(Exit::usage) saying why each failed and which Debian packages bring them.
std::unique_ptr<GlContext> open_offscreen(Backend backend = Backend::automatic);

/// EGL without a surface: on a hardware device if there is one, else in software by Mesa.
std::unique_ptr<GlContext> open_egl();

/// Mesa's off-screen library, which needs neither EGL nor devices.
std::unique_ptr<GlContext> open_osmesa();

}  // namespace povpreview
