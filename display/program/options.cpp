// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/options.h"

#include <CLI/CLI.hpp>
#include <map>

#include "core/error.h"
#include "core/methods.h"
#include "display/program/method_run.h"

namespace povpreview {
namespace {

constexpr int largest_side = 65535;
constexpr double largest_pixel_count = 1 << 28;

/// Parts what CLI11 shall see (options that begin with `--`, and their values) from what POV-Ray
/// shall see. POV-Ray's own options begin with one sign or have the form Name=value.
void part(const CLI::App& app, const std::vector<std::string>& words,
          std::vector<std::string>& ours, std::vector<std::string>& povray) {
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string& word = words[i];
        if (!word.starts_with("--")) {
            povray.push_back(word);
            continue;
        }
        ours.push_back(word);
        const CLI::Option* option = app.get_option_no_throw(word);
        const bool takes_value = option && option->get_items_expected_min() > 0;
        if (takes_value && i + 1 < words.size()) ours.push_back(words[++i]);
    }
}

/// WxH in pixels.
glm::ivec2 read_size(const std::string& text) {
    int width = 0, height = 0, used = 0;
    if (std::sscanf(text.c_str(), "%dx%d%n", &width, &height, &used) != 2 ||
        used != static_cast<int>(text.size()) || width < 1 || height < 1 || width > largest_side ||
        height > largest_side || double(width) * height > largest_pixel_count)
        throw Error(Exit::usage, "'" + text + "' is no picture size", "--size",
                    "give WIDTHxHEIGHT in pixels, for instance --size 1280x960");
    return {width, height};
}

const std::map<std::string, Overlay> overlays{{"none", Overlay::none},
                                              {"mesh", Overlay::mesh},
                                              {"edges", Overlay::edges},
                                              {"samples", Overlay::samples}};
const std::map<std::string, Backend> backends{
    {"auto", Backend::automatic}, {"egl", Backend::egl}, {"osmesa", Backend::osmesa}};

const std::map<std::string, Engine> engines{{"stock", Engine::stock}, {"tracer", Engine::tracer}};
const std::map<std::string, FileFormat> formats{
    {"png", FileFormat::png16}, {"png8", FileFormat::png8}, {"exr", FileFormat::exr_half}};

/// I/N: the I-th of N shares, counted from 0.
Share read_share(const std::string& text) {
    long long index = 0, count = 0;
    int used = 0;
    if (std::sscanf(text.c_str(), "%lld/%lld%n", &index, &count, &used) != 2 ||
        used != static_cast<int>(text.size()) || index < 0 || index >= count)
        throw Error(Exit::usage, "'" + text + "' is no share", "--share",
                    "give INDEX/COUNT, for instance --share 0/8 for the first of eight");
    return {static_cast<std::size_t>(index), static_cast<std::size_t>(count)};
}

/// For commands that draw.
template <class Options>
void add_backend(CLI::App& app, Options& options) {
    app.add_option("--backend", options.backend, "OpenGL by: auto, egl, osmesa")
        ->transform(CLI::CheckedTransformer(backends))
        ->option_text("NAME");
}

void add_tracing(CLI::App& app, TracingOptions& options) {
    app.add_flag("--allow-writing", options.tracer.writes,
                 "Let the scene write files (#fopen), in its folder and the working folder");
    app.add_option("--stall-timeout", options.tracer.stall_timeout_s,
                   "Give the tracer up when it has been silent for so long (default 60)")
        ->check(CLI::PositiveNumber)
        ->option_text("SECONDS");
    app.add_option("--mirror-depth", options.mirror_depth,
                   "Find edges in mirrors seen in mirrors, so many deep (default 1; 0: in none)")
        ->check(CLI::Range(0, 8))
        ->option_text("N");
}

template <class Options>
void add_time(CLI::App& app, Options& options) {
    app.add_option("--time", options.time, "Stop so many seconds after the end of the parse")
        ->check(CLI::PositiveNumber)
        ->option_text("SECONDS");
}

template <class Options>
void add_accuracy(CLI::App& app, Options& options) {
    app.add_option("--accuracy", options.accuracy,
                   "Stay on one rung of the scene's ladder of accuracy, named or numbered from 0, "
                   "such as sketch or target (default: rise from the lowest to the target)")
        ->option_text("NAME");
}

/// Where a command writes its results.
template <class Options>
void add_out(CLI::App& app, Options& options) {
    app.add_option("--out", options.out, "Folder for the results")->option_text("DIR");
}

template <class Options>
void check_out(const Options& options, const std::string& command) {
    if (options.out.empty())
        throw Error(Exit::usage, "no folder for the results", command, "give --out DIR");
}

void parse(CLI::App& app, const std::vector<std::string>& words, std::vector<std::string>& povray,
           CommandLine& result) {
    std::vector<std::string> ours;
    part(app, words, ours, povray);
    std::reverse(ours.begin(), ours.end());  // CLI11 takes them from the back
    try {
        app.parse(ours);
    } catch (const CLI::CallForHelp&) {
        result.text = app.help();
    } catch (const CLI::ParseError& error) {
        throw Error(Exit::usage, error.what(), "command line", "see povpreview --help");
    }
}

/// What makes a preview the final render, and what keeps it.
void add_finish(CLI::App& app, PreviewOptions& options, std::uint64_t& memory_mib) {
    app.add_flag("--finish", options.finish,
                 "In the end make POV-Ray's image from what was traced: anti-aliased (+A), named "
                 "(+O) and stored (+F) as POV-Ray's options say");
    app.add_option("--session", options.session,
                   "Keep all that is traced in this file, about once a second")
        ->option_text("FILE");
    app.add_flag("--resume", options.resume,
                 "Go on with the session's file, if there is one; scene and options must be as "
                 "they were");
    app.add_option("--memory-limit", memory_mib,
                   "Mebibytes of memory that the tracer may take (default: no limit)")
        ->check(CLI::Range(std::uint64_t{16}, std::uint64_t{1} << 32))
        ->option_text("N");
}

void check_finish(const PreviewOptions& options) {
    if (options.finish && (options.time || options.samples))
        throw Error(Exit::usage, "--finish goes on to the end, and --time and --samples do not",
                    "command line", "leave one of them out");
    if (options.resume && options.session.empty())
        throw Error(Exit::usage, "--resume does not know with what to go on", "command line",
                    "name the session by --session FILE");
}

void read_preview(const std::vector<std::string>& words, CommandLine& result) {
    PreviewOptions options;
    CLI::App app(
        "Previews a POV-Ray scene: a picture close to the finished render after a few "
        "percent of the work.\n\n"
        "  povpreview [POV-Ray options] SCENE.pov [options]\n"
        "  povpreview compare [POV-Ray options] SCENE.pov --out DIR [options]\n"
        "  povpreview figures [POV-Ray options] SCENE.pov --out DIR [options]\n"
        "  povpreview plan [POV-Ray options] SCENE.pov [--run]\n"
        "  povpreview reference [POV-Ray options] SCENE.pov... --out DIR [options]\n\n"
        "POV-Ray's own options (+W640 +H480 +Lpath Declare=x=1 file.ini ...) mean what they "
        "mean to povray.",
        "povpreview");
    app.set_help_flag("--help", "Show this text");
    bool version = false;
    std::string size;
    std::uint64_t memory_mib = 0;
    const auto methods = method_names();
    auto methods_or_none = methods;
    methods_or_none.push_back("none");
    app.add_flag("--version", version, "Show the version");
    app.add_flag("--headless", options.headless, "No window: write pictures only");
    app.add_option("--samples", options.samples, "Stop after so many full samples")
        ->check(CLI::PositiveNumber)
        ->option_text("N");
    app.add_option("--method", options.method, "One of: " + CLI::detail::join(methods, ", "))
        ->check(CLI::IsMember(methods))
        ->option_text("NAME");
    app.add_option("--beside", options.beside,
                   "Method drawn next to it from as many samples, or none (default: blocks in a "
                   "window and in snapshots)")
        ->check(CLI::IsMember(methods_or_none))
        ->option_text("NAME");
    app.add_option("--overlay", options.overlay, "Draw on top: none, mesh, edges, samples")
        ->transform(CLI::CheckedTransformer(overlays))
        ->option_text("NAME");
    app.add_option("--size", size, "Size of pictures written; the mesh is magnified without blur")
        ->option_text("WxH");
    app.add_option("--snapshots", options.snapshots, "Write pictures there at geometric time steps")
        ->option_text("DIR");
    app.add_option("--log", options.log, "Write the progress there, as JSON lines")
        ->option_text("FILE");
    app.add_option("--output", options.output,
                   "Write the last picture there: .png (16 bit), .exr (linear)")
        ->option_text("FILE");
    app.add_option("--reference", options.reference,
                   "Finished picture of the same size; captions then tell the error against it")
        ->option_text("FILE");
    add_finish(app, options, memory_mib);
    add_time(app, options);
    add_accuracy(app, options);
    add_backend(app, options);
    add_tracing(app, options);
    parse(app, words, options.povray, result);
    if (!result.text.empty()) return;
    if (version) {
        result.text = "povpreview " POVPREVIEW_VERSION "\n";
        return;
    }
    if (!size.empty()) options.size = read_size(size);
    options.tracer.memory = memory_mib << 20;
    check_finish(options);
    result.preview = std::move(options);
}

void read_compare(const std::vector<std::string>& words, CommandLine& result) {
    CompareOptions options;
    CLI::App app(
        "Compares previewing methods against complete renders by the stock povray. DIR/report.html "
        "shows what came of it, DIR/curves.csv and DIR/summary.json tell it in numbers, DIR/SCENE "
        "holds pictures at equal times.\n\n"
        "  povpreview compare [POV-Ray options] SCENE.pov... --out DIR [options]\n\n"
        "The first method is the one that the others are held against. stock-mosaic is the stock "
        "povray itself with +SP32 +EP1.",
        "povpreview compare");
    app.set_help_flag("--help", "Show this text");
    auto methods = method_names();
    methods.emplace_back(stock_mosaic_name);
    options.methods = methods;
    // Of interest to us alone: what the DetailMap is worth.
    std::erase(options.methods, "constrained");
    add_out(app, options);
    app.add_option("--methods", options.methods,
                   "Comma-separated, of: " + CLI::detail::join(methods, ","))
        ->delimiter(',')
        ->check(CLI::IsMember(methods))
        ->option_text("A,B,...");
    app.add_option("--repeat", options.repeat,
                   "Run each method so often, in rotated order; medians count (default 1)")
        ->check(CLI::Range(1, 100))
        ->option_text("N");
    app.add_option("--threads", options.threads,
                   "Threads that trace, and cores that each method has for everything (default: "
                   "all of the machine)")
        ->check(CLI::Range(1, 512))
        ->option_text("N");
    add_time(app, options);
    add_accuracy(app, options);
    add_backend(app, options);
    add_tracing(app, options);
    parse(app, words, options.povray, result);
    if (!result.text.empty()) return;
    check_out(options, "compare");
    result.compare = std::move(options);
}

void read_figures(const std::vector<std::string>& words, CommandLine& result) {
    FiguresOptions options;
    CLI::App app(
        "Shows the method at work, as its authors did: pictures a.png, b.png ... in DIR, and "
        "figure.png, all of them.\n"
        "Figure 1, what edges known without rays are worth: the finished picture, a preview from a "
        "plain triangulation of a regular grid of samples, that triangulation, a preview from as "
        "many samples constrained by the edges, that triangulation, the edges alone.\n"
        "Figure 2, the phases of the method: the finished picture, the first triangulation, the "
        "textures known without tracing, the surfaces of which only tracing can tell them, those "
        "textures as far as they were traced, the first preview, the DetailMap in the end, the "
        "preview in the end.\n"
        "Figure 3, previewers compared: blocks, delaunay and mesh at four points in time.\n"
        "Figure 4, the L1 errors of the three over time, in figure.svg, and over rays, in "
        "rays.svg.\n\n"
        "  povpreview figures [POV-Ray options] SCENE.pov --out DIR [options]",
        "povpreview figures");
    app.set_help_flag("--help", "Show this text");
    add_out(app, options);
    app.add_option("--figure", options.figure, "1 (default) to 4")
        ->check(CLI::Range(1, 4))
        ->option_text("N");
    app.add_option("--samples", options.samples,
                   "Figures 1 and 2: full samples of each preview, about (default: one for a "
                   "hundred pixels)")
        ->check(CLI::PositiveNumber)
        ->option_text("N");
    add_backend(app, options);
    add_tracing(app, options);
    parse(app, words, options.povray, result);
    if (!result.text.empty()) return;
    check_out(options, "figures");
    if (options.figure > 2 && options.samples)
        throw Error(Exit::usage, "figures 3 and 4 go on until the picture is complete", "--samples",
                    "leave it out");
    result.figures = std::move(options);
}

void read_plan(const std::vector<std::string>& words, CommandLine& result) {
    PlanOptions options;
    CLI::App app(
        "Prints what a preview of the scene does and what it leaves out, and why.\n\n"
        "  povpreview plan [POV-Ray options] SCENE.pov [--run]",
        "povpreview plan");
    app.set_help_flag("--help", "Show this text");
    app.add_flag("--run", options.run, "Run the preview to its end, and tell what each part took");
    add_tracing(app, options);
    parse(app, words, options.povray, result);
    if (result.text.empty()) result.plan = std::move(options);
}

void read_reference(const std::vector<std::string>& words, CommandLine& result) {
    ReferenceOptions options;
    CLI::App app(
        "Renders scenes completely, several side by side. What was made from the same scene, "
        "includes, images, options and program already is kept; what fails is told in the end. "
        "Interrupted, it goes on where it was.\n\n"
        "  povpreview reference [POV-Ray options] SCENE.pov... --out DIR [options]\n\n"
        "POV-Ray's own options hold for all scenes, also those of an animation (+KFI1 +KFF20). "
        "Each picture is rendered on one thread, or as many as +WT says.",
        "povpreview reference");
    app.set_help_flag("--help", "Show this text");
    std::string share;
    add_out(app, options);
    app.add_option("--engine", options.engine,
                   "stock: the povray of this machine (default); tracer: ours, run to the end")
        ->transform(CLI::CheckedTransformer(engines))
        ->option_text("NAME");
    app.add_option("--format", options.format,
                   "png: 16 bit (default), png8: 8 bit, exr: linear light, 16-bit float")
        ->transform(CLI::CheckedTransformer(formats))
        ->option_text("NAME");
    app.add_option("--sections", options.sections,
                   "Render for every [section] of this INI file, such as one of sizes")
        ->option_text("FILE");
    app.add_option("--jobs", options.jobs, "Renders at a time (default: as many as the cores hold)")
        ->check(CLI::Range(1, 4096))
        ->option_text("N");
    app.add_option("--timeout", options.timeout, "Give a picture up after so many seconds")
        ->check(CLI::PositiveNumber)
        ->option_text("SECONDS");
    app.add_flag("--slurm", options.slurm, "Submit the pictures as a job array to Slurm");
    app.add_option("--share", share, "Only every N-th picture, beginning with number I from 0")
        ->option_text("I/N");
    parse(app, words, options.povray, result);
    if (!result.text.empty()) return;
    check_out(options, "reference");
    if (!share.empty()) options.share = read_share(share);
    result.reference = std::move(options);
}

}  // namespace

CommandLine read_command_line(int argc, const char* const* argv) {
    std::vector<std::string> words(argv + 1, argv + argc);
    CommandLine result;
    if (!words.empty() && words.front() == "compare") {
        words.erase(words.begin());
        read_compare(words, result);
    } else if (!words.empty() && words.front() == "figures") {
        words.erase(words.begin());
        read_figures(words, result);
    } else if (!words.empty() && words.front() == "plan") {
        words.erase(words.begin());
        read_plan(words, result);
    } else if (!words.empty() && words.front() == "reference") {
        words.erase(words.begin());
        read_reference(words, result);
    } else {
        read_preview(words, result);
    }
    return result;
}

}  // namespace povpreview
