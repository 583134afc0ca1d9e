// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/previewer.h"
#include "display/gl_context.h"
#include "display/image_file.h"
#include "display/program/tracer_wishes.h"

namespace povpreview {

/// What renders a reference.
enum class Engine {
    stock,  ///< the stock `povray`: independent of all that is ours
    tracer  ///< the patched one, a sample at every pixel's centre
};

/// What every command that traces is asked.
struct TracingOptions {
    std::vector<std::string> povray;  ///< everything that is not ours, in order
    int mirror_depth = 1;             ///< edges are found in mirrors seen in mirrors, so many deep
    TracerWishes tracer;
};

/// What `povpreview SCENE.pov` was asked to do. Times are seconds since the end of the parse.
struct PreviewOptions : TracingOptions {
    bool headless = false;
    std::optional<double> time;
    std::optional<std::size_t> samples;  ///< full rays of the method shown
    std::string method = "mesh";
    std::string beside;  ///< method drawn next to it, "none", or empty: blocks, if it is shown
    Overlay overlay = Overlay::none;
    Backend backend = Backend::automatic;
    std::optional<glm::ivec2> size;                ///< of pictures, where it is not the scene's
    std::filesystem::path snapshots, log, output;  ///< empty: not wanted
    std::filesystem::path reference;  ///< finished picture that captions measure against, or empty
    std::string accuracy;  ///< rung of the ladder to stay on; empty: from the lowest to the target
    bool finish = false;   ///< POV-Ray's image is made in the end
    std::filesystem::path session;  ///< file that keeps the samples, or empty
    bool resume = false;            ///< the session's samples are used
};

/// What `povpreview compare SCENE.pov...` was asked to do.
struct CompareOptions : TracingOptions {
    std::filesystem::path out;
    std::vector<std::string> methods;
    std::optional<double> time;  ///< for each method; to completion if not given
    int repeat = 1;              ///< runs of each method on each scene
    int threads = 0;             ///< that trace, and cores for everything; 0: all of the machine
    std::string accuracy;
    Backend backend = Backend::automatic;
};

/// What `povpreview figures SCENE.pov` was asked to do.
struct FiguresOptions : TracingOptions {
    std::filesystem::path out;
    int figure = 1;                      ///< of the paper: 1 to 4
    std::optional<std::size_t> samples;  ///< of each preview; one for a hundred pixels if not given
    Backend backend = Backend::automatic;
};

/// What `povpreview plan SCENE.pov` was asked to do.
struct PlanOptions : TracingOptions {
    bool run = false;  ///< to the end, to tell what the stages took
};

/// Every `count`-th item of a list, beginning with item `index`.
struct Share {
    std::size_t index = 0, count = 1;
};

/// What `povpreview reference SCENE...` was asked to do.
struct ReferenceOptions {
    std::vector<std::string> povray;  ///< with all scenes
    std::filesystem::path out;
    std::filesystem::path sections;  ///< an INI file, each section of which is rendered, or empty
    Engine engine = Engine::stock;
    FileFormat format = FileFormat::png16;
    std::optional<int> jobs;        ///< renders at a time
    std::optional<double> timeout;  ///< seconds for each
    bool slurm = false;
    Share share;
};

/// What the command line says: one of these, or a text to print (help, version) and no more.
struct CommandLine {
    std::optional<PreviewOptions> preview;
    std::optional<CompareOptions> compare;
    std::optional<FiguresOptions> figures;
    std::optional<PlanOptions> plan;
    std::optional<ReferenceOptions> reference;
    std::string text;
};

/// Reads the command line in POV-Ray's manner: options of ours begin with `--`, all others and the
/// scene go to POV-Ray unread. Throws Error(Exit::usage) that names the remedy.
CommandLine read_command_line(int argc, const char* const* argv);

}  // namespace povpreview
