// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <utility>

#include "display/glfw_context.h"
#include "display/window_panel.h"

namespace povpreview {

namespace {

constexpr int smallest_width = 480;  ///< of a window for small pictures, screen units
constexpr int caption_room = 52;     ///< for a caption of two lines, screen units

// Smoothing costs three times the drawing where GL runs in software, on the same cores as the
// tracer. Where a smooth frame takes long, frames are rough as long as new ones keep coming.
constexpr int smooth_samples = 4;               ///< per pixel
constexpr double longest_smooth_frame = .03;    ///< seconds
constexpr double forgetting = .95;              ///< by which a frame lets it be tried again
constexpr std::chrono::milliseconds rest{300};  ///< without news, before a rough frame is smoothed

/// Whole times the picture, so that its pixels are equal squares.
int magnification(int picture_width) {
    return std::max(1, (smallest_width + picture_width - 1) / picture_width);
}

}  // namespace

struct Window::State {
    using Clock = std::chrono::steady_clock;

    State(int across, int down, const std::string& title)
        : context(across, down, title), presenter(context), main(context), second(context) {
        GLFWwindow* window = context.window();
        glfwSetWindowUserPointer(window, this);
        // Letters come as characters, so that they are where the user's keyboard has them.
        glfwSetCharCallback(window, [](GLFWwindow* w, unsigned character) {
            if (character < 0x80) of(w).press(static_cast<char>(character));
        });
        glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int) {
            if (key == GLFW_KEY_ESCAPE && action == GLFW_PRESS) of(w).press(Controls::escape);
        });
        glfwSetWindowCloseCallback(window, [](GLFWwindow* w) { of(w).controls.closed = true; });
        glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { of(w).stale = true; });
        glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { of(w).stale = true; });
    }
    ~State() { context.make_current(); }  // for what the members delete

    static State& of(GLFWwindow* window) {
        return *static_cast<State*>(glfwGetWindowUserPointer(window));
    }

    void press(char key) {
        const bool was_beside = controls.beside;
        stale |= controls.press(key);
        if (controls.beside == was_beside) return;
        int across = 0, down = 0;
        glfwGetWindowSize(context.window(), &across, &down);
        if (GlfwContext::lost()) return;
        context.resize(
            controls.beside ? across * 2 + column_gap : std::max((across - column_gap) / 2, 1),
            down);
    }

    void load(WindowPanel& panel, const Picture& picture, const std::string& caption) {
        context.make_current();
        panel.load(picture, caption);
        stale |= &panel == &main || controls.beside;
    }

    /// Draws if there is news, or if a rough frame has stood long enough.
    void refresh() {
        if (stale)
            show(smooth_cost > longest_smooth_frame ? 1 : smooth_samples);
        else if (rough && Clock::now() - shown > rest)
            show(smooth_samples);
    }

    void show(int samples) {
        const auto start = Clock::now();
        stale = false;
        if (!draw(samples)) return;
        context.gl().Finish();  // or the time would be that of handing over the work
        glfwSwapBuffers(context.window());
        shown = Clock::now();
        rough = samples < smooth_samples;
        smooth_cost =
            rough ? forgetting * smooth_cost : std::chrono::duration<double>(shown - start).count();
    }

    /// Draws all, without showing it yet. False where the window has no area (it is iconified), or
    /// the display has gone away: sizes that are asked of it then are what was in memory before.
    bool draw(int samples) {
        glfwGetFramebufferSize(context.window(), &pixels_x, &pixels_y);
        if (GlfwContext::lost() || pixels_x <= 0 || pixels_y <= 0) return false;
        context.make_current();
        const bool both = controls.beside && second.loaded();
        const std::vector<Rectangle> where = columns(pixels_x, pixels_y, controls.beside ? 2 : 1);
        presenter.begin(pixels_x, pixels_y);
        if (main.loaded()) main.draw(presenter, where[0], pixels_y, controls.overlay, samples);
        if (both) second.draw(presenter, where[1], pixels_y, controls.overlay, samples);
        return true;
    }

    GlfwContext context;
    Presenter presenter;
    WindowPanel main, second;
    Controls controls;
    bool stale = true;               ///< there is something new to draw
    bool rough = false;              ///< what is shown was drawn with one sample per pixel
    double smooth_cost = 0;          ///< of the last smooth frame, seconds, fading
    Clock::time_point shown{};       ///< when the last frame was
    int pixels_x = 0, pixels_y = 0;  ///< of the framebuffer
};

Window::Window(int picture_width, int picture_height, const std::string& title) {
    const int times = magnification(picture_width);
    state_ = std::make_unique<State>(picture_width * times, picture_height * times + caption_room,
                                     title);
}

Window::~Window() {
    if (lost()) static_cast<void>(state_.release());  // what would close it talks to the display
}

bool Window::lost() const { return GlfwContext::lost(); }

void Window::show(const Picture& picture, const std::string& caption) {
    state_->load(state_->main, picture, caption);
}

void Window::show_beside(const Picture& picture, const std::string& caption) {
    state_->load(state_->second, picture, caption);
}

void Window::update(std::chrono::milliseconds patience) {
    if (patience.count() > 0)
        glfwWaitEventsTimeout(std::chrono::duration<double>(patience).count());
    else
        glfwPollEvents();
    if (!lost()) state_->refresh();
}

const Controls& Window::controls() const { return state_->controls; }

void Window::set_overlay(Overlay overlay) {
    state_->controls.overlay = overlay;
    state_->stale = true;
}

void Window::press(char key) { state_->press(key); }

bool Window::take_save_request() { return std::exchange(state_->controls.save, false); }

void Window::set_title(const std::string& title) {
    glfwSetWindowTitle(state_->context.window(), title.c_str());
}

const std::string& Window::description() const { return state_->context.description(); }

Image Window::screenshot() {
    if (!state_->draw(smooth_samples)) return {};
    const GlFunctions& gl = state_->context.gl();
    Image bottom_up(state_->pixels_x, state_->pixels_y), image = bottom_up;
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
    gl.ReadPixels(0, 0, image.width, image.height, GL_RGB, GL_FLOAT, bottom_up.pixels.data());
    for (int y = 0; y < image.height; ++y)
        std::copy_n(&bottom_up.at(0, image.height - 1 - y), image.width, &image.at(0, y));
    return image;
}

}  // namespace povpreview
