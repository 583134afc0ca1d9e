// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "display/gl_context.h"

struct GLFWwindow;

namespace povpreview {

/// A window on the screen and its context. For the main thread alone, as GLFW asks.
class GlfwContext final : public GlContext {
   public:
    /// `width` x `height` in screen units, cut to what the screen has room for. Throws
    /// Error(Exit::usage) if there is no display, or none with OpenGL 3.3.
    GlfwContext(int width, int height, const std::string& title);
    ~GlfwContext() override;

    GLFWwindow* window() const { return window_; }
    /// Whether the display has gone away. Nothing may be asked of the window any more then, nor may
    /// it be closed.
    static bool lost();
    /// Like the constructor's size.
    void resize(int width, int height);

   private:
    struct Library;

    void bind() override;
    void release() override;
    GlProc proc_address(const char* name) const override;

    std::shared_ptr<Library> library_;
    GLFWwindow* window_ = nullptr;
};

}  // namespace povpreview
