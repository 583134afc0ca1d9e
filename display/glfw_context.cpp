// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/glfw_context.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <X11/Xlib.h>
#include <dlfcn.h>

#include <algorithm>
#include <atomic>

#include "core/error.h"

namespace povpreview {

namespace {

Error failure(const std::string& what) {
    const char* description = nullptr;
    glfwGetError(&description);
    return Error(Exit::usage, what + (description ? std::string(" (") + description + ")" : ""),
                 "window", "start it where a display can be reached, or run without a window");
}

/// Room on the main screen, screen units; without one, more than any.
void cut_to_screen(int& width, int& height) {
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    if (!monitor) return;
    int x = 0, y = 0, room_x = 0, room_y = 0;
    glfwGetMonitorWorkarea(monitor, &x, &y, &room_x, &room_y);
    if (room_x > 0) width = std::min(width, room_x);
    if (room_y > 0) height = std::min(height, room_y);
}

std::atomic<bool> display_lost{false};

template <class Function>
Function* loaded(void* library, const char* name) {
    return reinterpret_cast<Function*>(dlsym(library, name));
}

/// Xlib ends the whole program when its server is gone; with these handlers its functions return,
/// and do nothing from then on. Looked up where GLFW has loaded them: on Wayland there are none.
void outlive_the_display() {
    void* xlib = dlopen("libX11.so.6", RTLD_NOW | RTLD_NOLOAD);
    if (!xlib) return;
    const auto display_of_glfw = loaded<Display*()>(RTLD_DEFAULT, "glfwGetX11Display");
    const auto on_error = loaded<decltype(XSetIOErrorHandler)>(xlib, "XSetIOErrorHandler");
    const auto on_exit = loaded<decltype(XSetIOErrorExitHandler)>(xlib, "XSetIOErrorExitHandler");
    Display* display = display_of_glfw ? display_of_glfw() : nullptr;
    if (!display || !on_error || !on_exit) return;
    on_error([](Display*) { return 0; });
    on_exit(
        display, [](Display*, void*) { display_lost = true; }, nullptr);
}

}  // namespace

bool GlfwContext::lost() { return display_lost; }

/// GLFW's process-wide state, alive while any window is.
struct GlfwContext::Library {
    Library() {
        if (!glfwInit()) throw failure("no display can be opened");
        outlive_the_display();
    }
    ~Library() { glfwTerminate(); }

    static std::shared_ptr<Library> get() {
        static std::weak_ptr<Library> alive;
        std::shared_ptr<Library> library = alive.lock();
        if (!library) alive = library = std::make_shared<Library>();
        return library;
    }
};

GlfwContext::GlfwContext(int width, int height, const std::string& title)
    : library_(Library::get()) {
    cut_to_screen(width, height);
    // The platform's own way first; EGL serves displays whose GLX has no core profile.
    for (int maker : {GLFW_NATIVE_CONTEXT_API, GLFW_EGL_CONTEXT_API}) {
        glfwDefaultWindowHints();
        glfwWindowHint(GLFW_CONTEXT_CREATION_API, maker);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_DEPTH_BITS, 0);
        glfwWindowHint(GLFW_STENCIL_BITS, 0);
        window_ = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
        if (window_) break;
    }
    if (!window_) throw failure("no window with OpenGL 3.3 can be opened");
    try {
        load("window");
        glfwSwapInterval(0);  // the thread that shows also works: it must not wait for the screen
    } catch (...) {
        leave();
        glfwDestroyWindow(window_);
        throw;
    }
}

GlfwContext::~GlfwContext() {
    leave();
    glfwDestroyWindow(window_);
}

void GlfwContext::resize(int width, int height) {
    cut_to_screen(width, height);
    glfwSetWindowSize(window_, width, height);
}

void GlfwContext::bind() { glfwMakeContextCurrent(window_); }

void GlfwContext::release() { glfwMakeContextCurrent(nullptr); }

GlProc GlfwContext::proc_address(const char* name) const { return glfwGetProcAddress(name); }

}  // namespace povpreview
