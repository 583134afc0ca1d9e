// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "core/picture.h"
#include "display/controls.h"
#include "display/image.h"

namespace povpreview {

/// A window that shows a picture as it comes, and a second one beside it when asked for. Drawn anew
/// at the window's own size whenever that changes: triangles stay crisp. For the main thread alone.
class Window {
   public:
    /// Sized for a picture of `picture_width` x `picture_height` pixels. Throws Error(Exit::usage)
    /// where there is no display (no DISPLAY or WAYLAND_DISPLAY, or nobody answers there) or none
    /// with OpenGL 3.3; the caller can then go on without a window.
    Window(int picture_width, int picture_height, const std::string& title);
    ~Window();

    /// What to show, and the text below it. Drawn by the next update().
    void show(const Picture& picture, const std::string& caption);
    /// The same for the second picture, seen while controls().beside.
    void show_beside(const Picture& picture, const std::string& caption);

    /// Attends to keys, resizing and the rest, then draws if there is something new. Waits at most
    /// `patience` for the first event.
    void update(std::chrono::milliseconds patience = std::chrono::milliseconds(0));

    /// Whether the display has gone away: there is nothing to do but to destroy this.
    bool lost() const;

    const Controls& controls() const;
    /// What to begin with; keys change it.
    void set_overlay(Overlay overlay);
    /// As if that key were pressed.
    void press(char key);
    /// Whether saving was asked for since the last call.
    bool take_save_request();

    void set_title(const std::string& title);
    /// Which context draws.
    const std::string& description() const;
    /// What the window shows, read back as it is on the screen: sRGB-encoded, in [0, 1].
    Image screenshot();

   private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace povpreview
