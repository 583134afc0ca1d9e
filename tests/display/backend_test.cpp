// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdio>
#include <fstream>

#include "core/error.h"
#include "display/gl_context.h"
#include "tests/display/temporary_folder.h"

namespace povpreview::test {
namespace {

struct Outcome {
    int exit = -1;
    std::string output;
};

/// Opens a context in another process under the given environment ("NAME=value NAME=value").
Outcome open_under(const std::string& environment, const std::string& backend = "") {
    const std::string command =
        "env " + environment + " " OPEN_CONTEXT " " + backend + " 2>/dev/null";
    Outcome outcome;
    FILE* pipe = ::popen(command.c_str(), "r");
    char part[512];
    while (std::fgets(part, sizeof part, pipe)) outcome.output += part;
    const int status = ::pclose(pipe);
    if (WIFEXITED(status)) outcome.exit = WEXITSTATUS(status);
    return outcome;
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// A machine without some libraries: the loader finds files of their names that are none.
class WithoutLibraries {
   public:
    explicit WithoutLibraries(std::initializer_list<const char*> names) {
        for (const char* name : names) std::ofstream(folder_ / name) << "not a library\n";
    }
    std::string environment() const { return "LD_LIBRARY_PATH=" + folder_.path().string(); }

   private:
    TemporaryFolder folder_;
};

const char* const no_egl_driver = "__EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent.json";

TEST(Backend, Names) {
    EXPECT_EQ(backend_named("automatic"), Backend::automatic);
    EXPECT_EQ(backend_named("egl"), Backend::egl);
    EXPECT_EQ(backend_named("osmesa"), Backend::osmesa);
    EXPECT_THROW(backend_named("EGL "), Error);
    EXPECT_THROW(backend_named(""), Error);
}

TEST(Backend, AutomaticTakesEglFirst) {
    const Outcome outcome = open_under("-u POVPREVIEW_BACKEND");
    EXPECT_EQ(outcome.exit, 0);
    EXPECT_EQ(outcome.output.substr(0, 3), "EGL") << outcome.output;
}

TEST(Backend, NeedsNoDisplay) {
    const Outcome outcome = open_under("-u DISPLAY -u WAYLAND_DISPLAY -u XDG_RUNTIME_DIR", "egl");
    EXPECT_EQ(outcome.exit, 0) << outcome.output;
}

TEST(Backend, UnknownNameInTheEnvironmentIsAnError) {
    const Outcome outcome = open_under("POVPREVIEW_BACKEND=vulkan");
    EXPECT_EQ(outcome.exit, 2);
    EXPECT_TRUE(contains(outcome.output, "vulkan") && contains(outcome.output, "osmesa"))
        << outcome.output;
}

TEST(Backend, EglWithoutDriverSaysWhatToInstall) {
    const Outcome outcome = open_under(no_egl_driver, "egl");
    EXPECT_EQ(outcome.exit, 2);
    EXPECT_TRUE(contains(outcome.output, "libegl-mesa0")) << outcome.output;
}

TEST(Backend, EglWithoutOpenGl33SaysSo) {
    const Outcome outcome = open_under("MESA_GL_VERSION_OVERRIDE=2.1", "egl");
    EXPECT_EQ(outcome.exit, 2);
    EXPECT_TRUE(contains(outcome.output, "3.3")) << outcome.output;
}

TEST(Backend, WithNeitherSaysWhatToInstall) {
    const WithoutLibraries without{"libEGL.so.1", "libOSMesa.so.8", "libOSMesa.so.6",
                                   "libOSMesa.so"};
    const Outcome outcome = open_under(without.environment());
    EXPECT_EQ(outcome.exit, 2);
    EXPECT_TRUE(contains(outcome.output, "libegl1")) << outcome.output;
    EXPECT_TRUE(contains(outcome.output, "osmesa")) << outcome.output;
}

#ifdef POVPREVIEW_HAVE_OSMESA

TEST(Backend, EnvironmentNamesOne) {
    const Outcome outcome = open_under("POVPREVIEW_BACKEND=osmesa");
    EXPECT_EQ(outcome.exit, 0);
    EXPECT_EQ(outcome.output.substr(0, 6), "OSMesa") << outcome.output;
}

TEST(Backend, TheCallerOverridesTheEnvironment) {
    EXPECT_EQ(open_under("POVPREVIEW_BACKEND=osmesa", "egl").output.substr(0, 3), "EGL");
}

TEST(Backend, FallsBackToOsmesaWithoutEglDriver) {
    const Outcome outcome = open_under(no_egl_driver);
    EXPECT_EQ(outcome.exit, 0);
    EXPECT_EQ(outcome.output.substr(0, 6), "OSMesa") << outcome.output;
}

TEST(Backend, FallsBackToOsmesaWithoutEglLibrary) {
    const WithoutLibraries without{"libEGL.so.1"};
    const Outcome outcome = open_under(without.environment());
    EXPECT_EQ(outcome.exit, 0);
    EXPECT_EQ(outcome.output.substr(0, 6), "OSMesa") << outcome.output;
}

TEST(Backend, OsmesaWithoutLibrarySaysWhatToInstall) {
    const WithoutLibraries without{"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"};
    const Outcome outcome = open_under(without.environment(), "osmesa");
    EXPECT_EQ(outcome.exit, 2);
    EXPECT_TRUE(contains(outcome.output, "libosmesa6")) << outcome.output;
}

#endif

TEST(GlContext, TellsItsLimits) {
    const auto context = open_offscreen();
    EXPECT_GE(context->max_texture_size(), 1024);  // OpenGL 3.3 asks for no less
    EXPECT_GE(context->max_samples(), 4);
    EXPECT_NE(context->description().find("OpenGL"), std::string::npos);
}

TEST(GlFunctions, AMissingOneIsNamed) {
    GlFunctions gl;
    const auto none = [](const char* name) {
        return std::string(name) == "glUseProgram" ? nullptr
                                                   : reinterpret_cast<GlProc>(&std::abort);
    };
    try {
        gl.load(none, "nowhere");
        FAIL() << "a missing function was accepted";
    } catch (const Error& error) {
        EXPECT_TRUE(contains(error.what(), "glUseProgram")) << error.what();
        EXPECT_TRUE(contains(error.what(), "nowhere")) << error.what();
    }
}

}  // namespace
}  // namespace povpreview::test
