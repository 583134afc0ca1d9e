// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <thread>

#include "core/colour.h"
#include "core/error.h"
#include "tests/display/pictures.h"
#include "tests/display/xvfb.h"

namespace povpreview::test {
namespace {

using namespace std::chrono_literals;

TEST(WindowWithoutDisplay, IsAnErrorThatTheCallerCanHear) {
    const char* display = std::getenv("DISPLAY");
    const std::string before = display ? display : "";
    for (const char* nobody : {"", ":4711"}) {
        ::setenv("DISPLAY", nobody, 1);
        if (!*nobody) ::unsetenv("DISPLAY");
        try {
            Window window(64, 48, "test");
            ADD_FAILURE() << "a window opened nowhere";
        } catch (const Error& error) {
            EXPECT_EQ(error.exit(), Exit::usage);
            EXPECT_NE(std::string(error.what()).find("display"), std::string::npos);
        }
    }
    if (display) ::setenv("DISPLAY", before.c_str(), 1);
}

class WindowTest : public testing::Test {
   protected:
    void SetUp() override {
        if (!server.why_not().empty()) GTEST_SKIP() << server.why_not();
        window = std::make_unique<Window>(640, 480, "test");
        attend();
    }
    /// Lets the X server and the window come to rest.
    void attend() {
        for (int round = 0; round < 5; ++round) window->update(20ms);
    }
    void type(unsigned letter) {
        GLFWwindow* handle = glfwGetCurrentContext();
        const GLFWcharfun typed = glfwSetCharCallback(handle, nullptr);
        glfwSetCharCallback(handle, typed);
        typed(handle, letter);
        attend();
    }
    void resize(int width, int height) {
        glfwSetWindowSize(glfwGetCurrentContext(), width, height);
        attend();
    }

    Xvfb server;
    std::unique_ptr<Window> window;
};

/// The greatest difference of a channel between the screen and the encoded colour.
float apart(const glm::vec3& shown, const glm::vec3& linear) {
    const glm::vec3 d = glm::abs(shown - display_encoded(linear));
    return std::max({d.x, d.y, d.z});
}

glm::vec3 ramp(int x, int y) {
    return {static_cast<float>(x) / 640, static_cast<float>(y) / 480, x % 2 ? 3.f : -1.f};
}

TEST_F(WindowTest, ShowsKnownPixelsEncodedAtTheirPlaces) {
    Picture picture;
    picture.width = 640;
    picture.height = 480;
    fill_pixels(picture, ramp, [](int, int) { return true; });
    window->show(picture, "all known\nin two lines");
    attend();
    const Image screen = window->screenshot();
    ASSERT_EQ(screen.width, 640);
    ASSERT_GT(screen.height, 480) << "there is room for the caption";
    for (int y = 0; y < 480; ++y)
        for (int x = 0; x < 640; ++x)
            ASSERT_LE(apart(screen.at(x, y), ramp(x, y)), 1.01f / 255) << x << ", " << y;
    int lit = 0;
    for (int y = 482; y < screen.height; ++y)
        for (int x = 0; x < 640; ++x) lit += screen.at(x, y).x > .5f;
    EXPECT_GT(lit, 50) << "the caption can be read";
}

TEST_F(WindowTest, ResizingDrawsTheEdgeCrispAgain) {
    window->show(step_edge(64, 48, 30, 34), "");
    for (const auto& [width, height] : {std::pair{1280, 960}, {500, 375}}) {
        resize(width, height);
        const Image screen = window->screenshot();
        ASSERT_EQ(screen.width, width);
        for (int y = 5; y < screen.height - 5; ++y) {
            int between = 0;
            for (int x = 0; x < width; ++x)
                between += screen.at(x, y).x > .2f && screen.at(x, y).x < .8f;
            ASSERT_LE(between, 2) << "row " << y;
        }
    }
}

TEST_F(WindowTest, AShrunkPictureIsAveraged) {
    Picture picture;
    picture.width = 640;
    picture.height = 480;
    fill_pixels(
        picture, [](int x, int y) { return glm::vec3((x + y) % 2); },
        [](int, int) { return true; });
    window->show(picture, "");
    resize(320, 240);
    const Image screen = window->screenshot();
    for (const glm::vec3& colour : screen.pixels) ASSERT_LE(apart(colour, glm::vec3(.5f)), .02f);
}

TEST_F(WindowTest, KeysChangeWhatIsShown) {
    Picture picture = step_edge(640, 480, 320, 320);
    picture.lines = {{{0, 100}, {640, 100}, false}, {{0, 200}, {640, 200}, true}};
    picture.samples = {{100.5f, 300.5f}};
    window->show(picture, "");
    attend();
    const auto seen = [&](int x, int y) {
        return glm::length(window->screenshot().at(x, y + 26)) > .05f;  // room of the caption: 52
    };
    EXPECT_FALSE(seen(100, 100) || seen(100, 200) || seen(100, 300));
    type('m');
    EXPECT_TRUE(seen(100, 100) && seen(100, 200) && !seen(100, 300));
    type('e');
    EXPECT_TRUE(!seen(100, 100) && seen(100, 200) && !seen(100, 300));
    type('s');
    EXPECT_TRUE(!seen(100, 100) && !seen(100, 200) && seen(100, 300));
    type('s');
    EXPECT_FALSE(seen(100, 100) || seen(100, 200) || seen(100, 300));
    EXPECT_FALSE(window->take_save_request());
    type('p');
    EXPECT_TRUE(window->take_save_request());
    EXPECT_FALSE(window->take_save_request());
    EXPECT_FALSE(window->controls().closed);
    type('q');
    EXPECT_TRUE(window->controls().closed);
}

TEST_F(WindowTest, BeginsWithTheOverlayItIsGiven) {
    window->set_overlay(Overlay::edges);
    EXPECT_EQ(window->controls().overlay, Overlay::edges);
    type('e');
    EXPECT_EQ(window->controls().overlay, Overlay::none);
}

TEST_F(WindowTest, BesideShowsTheSecondPictureAndDoublesTheWindow) {
    Picture red = step_edge(640, 480, 0, 0), blue = red;
    for (auto& corner : red.corners) corner.colour = {1, 0, 0};
    for (auto& corner : blue.corners) corner.colour = {0, 0, 1};
    window->show(red, "");
    window->show_beside(blue, "");
    attend();
    EXPECT_EQ(window->screenshot().at(639, 240), glm::vec3(1, 0, 0));
    EXPECT_EQ(window->screenshot().width, 640);
    type('b');
    const Image both = window->screenshot();
    EXPECT_EQ(both.width, 2 * 640 + 8);
    EXPECT_EQ(both.at(320, 240), glm::vec3(1, 0, 0));
    EXPECT_EQ(both.at(648 + 320, 240), glm::vec3(0, 0, 1));
    type('b');
    EXPECT_EQ(window->screenshot().width, 640);
}

TEST_F(WindowTest, KeepsUpWithAStreamOfPictures) {
    for (int frame = 0; frame < 40; ++frame) {
        const float at = 320 + static_cast<float>(frame);
        window->show(step_edge(640, 480, at, at), std::to_string(frame));
        window->update();
    }
    std::this_thread::sleep_for(350ms);
    attend();  // at rest, a frame that was drawn in a hurry is drawn smoothly
    const Image screen = window->screenshot();
    EXPECT_EQ(screen.at(358, 240), glm::vec3(0));
    EXPECT_EQ(screen.at(360, 240), glm::vec3(1));
}

TEST_F(WindowTest, TinyWindowsAndEarlyDrawingAreNoHarm) {
    type('m');  // nothing to show yet
    window->show(step_edge(640, 480, 1, 2), "a caption with no room");
    window->show_beside(step_edge(1, 1, 0, 1), "another");
    type('b');
    for (const auto& [width, height] : {std::pair{1, 1}, {3, 200}, {200, 3}, {700, 500}}) {
        resize(width, height);
        EXPECT_FALSE(window->screenshot().pixels.empty());
    }
}

TEST_F(WindowTest, ClosingEnds) {
    GLFWwindow* handle = glfwGetCurrentContext();
    const GLFWwindowclosefun close = glfwSetWindowCloseCallback(handle, nullptr);
    glfwSetWindowCloseCallback(handle, close);
    close(handle);
    EXPECT_TRUE(window->controls().closed);
}

}  // namespace
}  // namespace povpreview::test
