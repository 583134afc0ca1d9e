// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/error.h"
#include "display/gl_context.h"

#ifdef POVPREVIEW_HAVE_OSMESA

#include <dlfcn.h>
// OSMesa's header brings the GL types by <GL/gl.h>, which glcorearb.h's guard keeps apart from ours
#include <GL/osmesa.h>

#include <array>

namespace povpreview {

namespace {

/// The off-screen library, loaded when asked for: newer Mesa (25.1 on) has none, and its absence
/// must not keep the program from starting.
struct OsmesaLibrary {
    decltype(&OSMesaCreateContextAttribs) create = nullptr;
    decltype(&OSMesaDestroyContext) destroy = nullptr;
    decltype(&OSMesaMakeCurrent) make_current = nullptr;
    decltype(&OSMesaGetProcAddress) proc_address = nullptr;
    std::string why_not;

    OsmesaLibrary() {
        void* handle = nullptr;
        for (const char* name : {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"})
            if (!handle) handle = dlopen(name, RTLD_NOW | RTLD_LOCAL);
        if (!handle) {
            why_not = dlerror();
            return;
        }
        load(handle, "OSMesaCreateContextAttribs", create);
        load(handle, "OSMesaDestroyContext", destroy);
        load(handle, "OSMesaMakeCurrent", make_current);
        load(handle, "OSMesaGetProcAddress", proc_address);
    }

   private:
    template <class Function>
    void load(void* handle, const char* name, Function& function) {
        function = reinterpret_cast<Function>(dlsym(handle, name));
        if (!function && why_not.empty()) why_not = std::string("libOSMesa has no ") + name;
    }
};

/// Loaded once and never unloaded: drivers leave threads and exit handlers behind.
const OsmesaLibrary& osmesa_library() {
    static const OsmesaLibrary library;
    return library;
}

class OsmesaContext final : public GlContext {
   public:
    OsmesaContext() : library_(osmesa_library()) {
        if (!library_.why_not.empty()) throw failure(library_.why_not);
        const int attributes[] = {OSMESA_FORMAT,
                                  OSMESA_RGBA,
                                  OSMESA_PROFILE,
                                  OSMESA_CORE_PROFILE,
                                  OSMESA_CONTEXT_MAJOR_VERSION,
                                  3,
                                  OSMESA_CONTEXT_MINOR_VERSION,
                                  3,
                                  0};
        context_ = library_.create(attributes, nullptr);
        if (!context_) throw failure("it gives no context with OpenGL 3.3 core");
        try {
            load("OSMesa");
        } catch (...) {
            leave();
            library_.destroy(context_);
            throw;
        }
    }
    ~OsmesaContext() override {
        leave();
        library_.destroy(context_);
    }

   private:
    static Error failure(const std::string& cause) {
        return Error(Exit::usage, cause, "OSMesa", "install Debian's libosmesa6");
    }
    void bind() override {
        if (!library_.make_current(context_, surface_.data(), GL_UNSIGNED_BYTE, side, side))
            throw failure("its context cannot be made current");
    }
    void release() override { library_.make_current(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0); }
    GlProc proc_address(const char* name) const override { return library_.proc_address(name); }

    const OsmesaLibrary& library_;
    OSMesaContext context_ = nullptr;
    // OSMesa wants a default framebuffer; everything is drawn into framebuffers of our own.
    static constexpr int side = 4;
    std::array<unsigned char, 4 * side * side> surface_{};
};

}  // namespace

std::unique_ptr<GlContext> open_osmesa() { return std::make_unique<OsmesaContext>(); }

}  // namespace povpreview

#else

namespace povpreview {

std::unique_ptr<GlContext> open_osmesa() {
    throw Error(Exit::usage, "this program was built without it", "OSMesa",
                "install Debian's libosmesa6-dev and build again, or use EGL");
}

}  // namespace povpreview

#endif
