// SPDX-License-Identifier: AGPL-3.0-or-later
//
// EGL is opened at run time, not linked: a machine without it then falls back to OSMesa, or says
// what to install, where a linked program would not even start.
#include <dlfcn.h>

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <cstring>
#include <vector>

#include "core/error.h"
#include "display/gl_context.h"

namespace povpreview {

namespace {

#define POVPREVIEW_EGL_FUNCTIONS(X) \
    X(GetProcAddress)               \
    X(GetError)                     \
    X(QueryString)                  \
    X(Initialize) X(BindAPI) X(ChooseConfig) X(CreateContext) X(DestroyContext) X(MakeCurrent)

struct EglLibrary {
#define POVPREVIEW_DECLARE(name) decltype(&egl##name) name = nullptr;
    POVPREVIEW_EGL_FUNCTIONS(POVPREVIEW_DECLARE)
#undef POVPREVIEW_DECLARE
    PFNEGLGETPLATFORMDISPLAYEXTPROC get_platform_display = nullptr;
    PFNEGLQUERYDEVICESEXTPROC query_devices = nullptr;             // may be absent
    PFNEGLQUERYDEVICESTRINGEXTPROC query_device_string = nullptr;  // may be absent
    std::string extensions;  ///< of the client, known before any display
    std::string why_not;     ///< empty if EGL can be used

    EglLibrary() {
        void* handle = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
        if (!handle) {
            why_not = dlerror();
            return;
        }
#define POVPREVIEW_LOAD(name)                                            \
    name = reinterpret_cast<decltype(name)>(dlsym(handle, "egl" #name)); \
    if (!name) why_not = "libEGL has no function egl" #name;
        POVPREVIEW_EGL_FUNCTIONS(POVPREVIEW_LOAD)
#undef POVPREVIEW_LOAD
        if (why_not.empty()) load_extensions();
    }

   private:
    void load_extensions() {
        const char* all = QueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
        extensions = all ? all : "";
        load(get_platform_display, "eglGetPlatformDisplayEXT");
        load(query_devices, "eglQueryDevicesEXT");
        load(query_device_string, "eglQueryDeviceStringEXT");
        if (!get_platform_display) why_not = "it cannot choose platforms (EGL_EXT_platform_base)";
    }
    template <class Function>
    void load(Function& function, const char* name) {
        function = reinterpret_cast<Function>(GetProcAddress(name));
    }
};

/// Loaded once and never unloaded: drivers leave threads and exit handlers behind.
const EglLibrary& egl_library() {
    static const EglLibrary library;
    return library;
}

/// Whether `list`, names between blanks, holds `name`.
bool has_extension(const char* list, std::string_view name) {
    const std::string padded = std::string(" ") + (list ? list : "") + " ";
    return padded.find(" " + std::string(name) + " ") != std::string::npos;
}

std::string error_code(const EglLibrary& egl) {
    char text[32];
    std::snprintf(text, sizeof text, " (EGL error 0x%04x)", static_cast<unsigned>(egl.GetError()));
    return text;
}

/// A place where EGL might give a context.
struct Candidate {
    EGLenum platform;
    void* native;
    std::string name;
};

std::vector<Candidate> device_candidates(const EglLibrary& egl, bool software) {
    if (!egl.query_devices || !egl.query_device_string ||
        !has_extension(egl.extensions.c_str(), "EGL_EXT_platform_device"))
        return {};
    EGLint count = 0;
    if (!egl.query_devices(0, nullptr, &count) || count <= 0) return {};
    std::vector<EGLDeviceEXT> devices(static_cast<std::size_t>(count));
    if (!egl.query_devices(count, devices.data(), &count) || count <= 0) return {};
    devices.resize(static_cast<std::size_t>(count));  // it may have shrunk in between

    std::vector<Candidate> found;
    for (EGLDeviceEXT device : devices) {
        const char* extensions = egl.query_device_string(device, EGL_EXTENSIONS);
        if (has_extension(extensions, "EGL_MESA_device_software") == software)
            found.push_back(
                {EGL_PLATFORM_DEVICE_EXT, device, software ? "EGL software device" : "EGL device"});
    }
    return found;
}

/// Best first: hardware, then Mesa without any device, then its software device.
std::vector<Candidate> candidates(const EglLibrary& egl) {
    std::vector<Candidate> all = device_candidates(egl, false);
    if (has_extension(egl.extensions.c_str(), "EGL_MESA_platform_surfaceless"))
        all.push_back({EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, "EGL surfaceless"});
    for (const Candidate& candidate : device_candidates(egl, true)) all.push_back(candidate);
    return all;
}

class EglContext final : public GlContext {
   public:
    EglContext(const EglLibrary& egl, const Candidate& candidate)
        : egl_(egl), name_(candidate.name) {
        display_ = egl_.get_platform_display(candidate.platform, candidate.native, nullptr);
        if (display_ == EGL_NO_DISPLAY) throw failure("no display");
        // Never terminated: a display is one for the whole process, and ending it here would end
        // the contexts that others made on it.
        if (!egl_.Initialize(display_, nullptr, nullptr)) throw failure("cannot be initialised");
        const char* extensions = egl_.QueryString(display_, EGL_EXTENSIONS);
        if (!has_extension(extensions, "EGL_KHR_surfaceless_context"))
            throw failure("needs a surface (no EGL_KHR_surfaceless_context)");
        if (!egl_.BindAPI(EGL_OPENGL_API)) throw failure("has no OpenGL");
        create(choose_config(extensions));
        try {
            load(name_);
        } catch (...) {
            destroy();
            throw;
        }
    }
    ~EglContext() override { destroy(); }

   private:
    Error failure(const std::string& cause) const {
        return Error(Exit::usage, cause + error_code(egl_), name_, "");
    }

    EGLConfig choose_config(const char* extensions) const {
        if (has_extension(extensions, "EGL_KHR_no_config_context")) return EGL_NO_CONFIG_KHR;
        const EGLint wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE,
                                 EGL_PBUFFER_BIT, EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        if (!egl_.ChooseConfig(display_, wanted, &config, 1, &count) || count < 1)
            throw failure("has no configuration for OpenGL");
        return config;
    }

    void create(EGLConfig config) {
        const EGLint wanted[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 3,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 3,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_NONE};
        context_ = egl_.CreateContext(display_, config, EGL_NO_CONTEXT, wanted);
        if (context_ == EGL_NO_CONTEXT) throw failure("gives no context with OpenGL 3.3 core");
    }

    void destroy() {
        leave();
        egl_.DestroyContext(display_, context_);
    }

    void bind() override {
        if (!egl_.MakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
            throw failure("its context cannot be made current");
    }
    void release() override {
        egl_.MakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
    GlProc proc_address(const char* name) const override { return egl_.GetProcAddress(name); }

    const EglLibrary& egl_;
    std::string name_;
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<GlContext> open_egl() {
    const EglLibrary& egl = egl_library();
    std::string why_not = egl.why_not;
    if (why_not.empty()) {
        for (const Candidate& candidate : candidates(egl)) {
            try {
                return std::make_unique<EglContext>(egl, candidate);
            } catch (const Error& error) {
                why_not += (why_not.empty() ? "" : ", ") + std::string(error.what());
            }
        }
        if (why_not.empty()) why_not = "it offers neither devices nor Mesa's surfaceless platform";
    }
    throw Error(Exit::usage, why_not, "EGL", "install Debian's libegl1 and libegl-mesa0");
}

}  // namespace povpreview
