// SPDX-License-Identifier: AGPL-3.0-or-later
#include "adapter/povray_options.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>

#include "adapter/povray_words.h"
#include "adapter/scene.h"
#include "core/error.h"

namespace povpreview {
namespace {

namespace fs = std::filesystem;
using Kind = PovrayWord::Kind;

constexpr const char* example = "name one, as in: povpreview scene.pov +W640 +H480";

bool is_file(const fs::path& path) {
    std::error_code error;
    return fs::exists(path, error) && !fs::is_directory(path, error);
}

/// The INI file that POV-Ray reads before the command line (its Process_povray_ini), or nothing.
fs::path default_ini() {
    if (const char* named = std::getenv("POVINI"); named && is_file(named)) return named;
    const char* home = std::getenv("HOME");
    for (const fs::path& path :
         {fs::path("./povray.ini"), home ? fs::path(home) / ".povray/3.7/povray.ini" : fs::path(),
          fs::path("/etc/povray/3.7/povray.ini")})
        if (is_file(path)) return path;
    return {};
}

/// Follows the words to where they lead.
class Reader {
   public:
    Reader();
    void read(const std::string& argument);
    /// Where the scene lies. Throws if there is none, or more than one was named.
    fs::path scene() const;
    void check_size() const;
    /// All that is read on the way to the scene's samples.
    std::vector<fs::path> readable() const;
    std::vector<std::string> departures() const;

    FrameRange frames;
    bool antialias = false;
    int threads = 0;

   private:
    void read_ini(const std::string& specification, int depth);
    void read_ini_file(const fs::path& file, const std::string& section, int depth);
    void take(std::string_view text, int depth);
    std::optional<fs::path> find(const std::string& name) const;

    std::vector<std::string> named_;  ///< scenes, on the command line
    std::string in_ini_;              ///< the last scene that an INI file names
    std::vector<fs::path> libraries_, inis_;
    std::set<Departure> departures_;
    std::int64_t width_ = 1, height_ = 1;  ///< as far as the command line says
};

/// A side of the image in pixels. Throws unless it is one.
std::int64_t side(const std::string& text, const char* what, const char* option) {
    std::int64_t value = 0;
    const char* end = text.data() + text.size();
    const auto [stopped, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stopped != end || value < 1 || value > max_image_side)
        throw Error(
            Exit::usage, fmt::format("'{}' is no {} in pixels", text, what), "",
            fmt::format("give a whole number from 1 to {}, as in {}", max_image_side, option));
    return value;
}

Reader::Reader() {
    const fs::path ini = default_ini();
    if (!ini.empty())
        read_ini_file(ini, "", 0);
    else
        libraries_.emplace_back("/usr/share/povray-3.7/include");
    if (const char* path = std::getenv("POVINC")) libraries_.emplace_back(path);
}

void Reader::read(const std::string& argument) {
    for (const std::string& text : split_words(argument)) {
        const PovrayWord word = read_word(text);
        if (word.kind == Kind::width) width_ = side(word.value, "width", "+W640");
        if (word.kind == Kind::height) height_ = side(word.value, "height", "+H480");
        if (word.kind == Kind::input)
            named_.push_back(word.value);
        else
            take(text, 0);
    }
}

/// The settings that mean the same on the command line and in an INI file `depth` - 1 levels down.
void Reader::take(std::string_view text, int depth) {
    const PovrayWord word = read_word(text);
    departures_.insert(departure_of(text));
    if (word.kind == Kind::input) in_ini_ = word.value;
    if (word.kind == Kind::library) libraries_.emplace_back(word.value);
    if (word.kind == Kind::ini) read_ini(word.value, depth);
    if (word.kind == Kind::antialias) antialias = is_on(word.value);
    if (word.kind == Kind::threads) threads = std::atoi(word.value.c_str());
    frames.take(word);
}

/// `specification` is a file name with a section behind it in brackets, or none.
void Reader::read_ini(const std::string& specification, int depth) {
    const std::size_t bracket = specification.find('[');
    const std::string name = specification.substr(0, bracket);
    std::string section;
    if (bracket != std::string::npos) {
        section = specification.substr(bracket + 1);
        section = section.substr(0, section.find(']'));
    }
    const std::optional<fs::path> file = find(name);
    if (!file)
        throw Error(Exit::usage, "there is no such file, neither a scene nor an INI file", name,
                    "check the name; scenes end in .pov");
    read_ini_file(*file, section, depth);
}

void Reader::read_ini_file(const fs::path& file, const std::string& section, int depth) {
    constexpr int deepest = 16;  // a file may include itself
    if (depth > deepest)
        throw Error(Exit::usage, "INI files include one another without end", file.string(),
                    "take out an Include_Ini");
    const auto same = [](const std::string& a, const std::string& b) {
        return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) {
            return std::tolower(static_cast<unsigned char>(x)) ==
                   std::tolower(static_cast<unsigned char>(y));
        });
    };
    inis_.push_back(file);
    std::ifstream stream(file);
    bool ours = true;  // what stands before the first section belongs to all
    for (std::string line; std::getline(stream, line);) {
        const std::size_t begin = line.find_first_not_of(" \t\r");
        if (begin == std::string::npos) continue;
        line = line.substr(begin, line.find_first_of(";#", begin) - begin);
        if (line.starts_with('['))
            ours = !section.empty() && same(line.substr(1, line.find(']') - 1), section);
        else if (ours && line.find('=') != std::string::npos && line[0] != '+' && line[0] != '-')
            take(line, depth + 1);
        else if (ours)
            for (const std::string& word : split_words(line)) take(word, depth + 1);
    }
}

std::optional<fs::path> Reader::find(const std::string& name) const {
    std::vector<fs::path> folders{""};
    if (fs::path(name).is_relative())
        folders.insert(folders.end(), libraries_.begin(), libraries_.end());
    for (const fs::path& folder : folders)
        if (is_file(folder / name)) return folder / name;
    return std::nullopt;
}

fs::path Reader::scene() const {
    for (const std::string& name : named_)
        if (name != named_.front())
            throw Error(Exit::usage,
                        fmt::format("there are two scenes, {} and {}", named_.front(), name), "",
                        "name one of them");
    const std::string& name = named_.empty() ? in_ini_ : named_.front();
    if (name.empty()) throw Error(Exit::usage, "there is no scene to show", "", example);
    std::optional<fs::path> found = find(name);
    if (!found) found = find(name + ".pov");
    if (!found) {
        std::error_code error;
        const bool folder = fs::is_directory(name, error);
        throw Error(Exit::usage, folder ? "this is a folder" : "there is no such file", name,
                    folder ? example : "check the name, or give the folder it lies in by +Lfolder");
    }
    if (access(found->c_str(), R_OK) != 0)
        throw Error(Exit::usage, "the scene cannot be read", found->string(),
                    "see who may read it (ls -l)");
    return *found;
}

void Reader::check_size() const {
    if (!image_size_fits(width_, height_))
        throw Error(Exit::usage,
                    fmt::format("an image of {} x {} pixels is too large", width_, height_), "",
                    fmt::format("choose +W and +H for at most {} pixels", max_image_pixels));
}

/// Projects keep what their scenes share in the folder above ("../colours.inc"). Not so the folders
/// that hold everything of somebody, and those above them.
bool is_shared(const fs::path& folder) {
    const char* home = std::getenv("HOME");
    const auto holds = [&](const fs::path& what) {
        const fs::path way = what.lexically_relative(folder);
        return !way.empty() && *way.begin() != "..";
    };
    return !holds("/tmp") && !(home && holds(home));
}

std::vector<fs::path> Reader::readable() const {
    std::vector<fs::path> result = libraries_;
    result.insert(result.end(), inis_.begin(), inis_.end());
    for (const fs::path& folder : {fs::absolute(scene()).parent_path(), fs::current_path()}) {
        result.push_back(folder);
        if (is_shared(folder.parent_path())) result.push_back(folder.parent_path());
    }
    // POV-Ray's own settings.
    result.emplace_back("/etc/povray");
    result.emplace_back("/usr/share/povray-3.7");
    result.emplace_back("/usr/share/fonts");  // Debian's POV-Ray has links to them
    if (const char* home = std::getenv("HOME")) result.push_back(fs::path(home) / ".povray");
    return result;
}

std::vector<std::string> Reader::departures() const {
    std::vector<std::string> result;
    for (const Departure departure : departures_) switch (departure) {
            case Departure::none:
                break;
            case Departure::saves_radiosity:
                result.emplace_back(
                    "the radiosity file is not saved: a preview writes no files of POV-Ray's but "
                    "the image of --finish");
                break;
            case Departure::runs_command:
                result.emplace_back("commands before and after the render are not run");
                break;
            case Departure::mosaic:
                result.emplace_back(
                    "+SP and +EP are not used: povpreview has its own order of samples; --method "
                    "mosaic shows POV-Ray's");
                break;
            case Departure::continues:
                result.emplace_back(
                    "+C is not used: --session and --resume go on with an earlier run");
                break;
            case Departure::animation:
                result.emplace_back("one frame is shown, the first; +K sets another clock");
                break;
            case Departure::writes_messages:
                result.emplace_back("POV-Ray's messages are not written to files");
                break;
        }
    return result;
}

}  // namespace

PovrayOptions read_povray_options(const std::vector<std::string>& words) {
    PovrayOptions result;
    Reader reader;
    for (const std::string& word : words) {
        result.words.push_back(quoted_for_povray(word));
        reader.read(result.words.back());
    }
    reader.check_size();
    result.scene = reader.scene();
    result.readable = reader.readable();
    result.departures = reader.departures();
    result.frames = reader.frames;
    result.antialias = reader.antialias;
    result.threads = reader.threads;
    return result;
}

namespace {

/// One frame, even where an INI file describes an animation.
void add_frame(std::vector<std::string>& words, std::optional<int> frame) {
    if (frame) {
        words.push_back(fmt::format("Subset_Start_Frame={}", *frame));
        words.push_back(fmt::format("Subset_End_Frame={}", *frame));
        return;
    }
    // The still picture; what clock it has, +K says.
    words.emplace_back("Initial_Frame=1");
    words.emplace_back("Final_Frame=1");
}

const char* file_type(StockPicture::Type type) {
    switch (type) {
        case StockPicture::Type::png8:
            return "+FN8";
        case StockPicture::Type::exr:
            return "+FE";
        case StockPicture::Type::png16:
            break;
    }
    return "+FN16";
}

}  // namespace

std::vector<std::string> PovrayOptions::tracer_arguments(const TracerPicture& picture) const {
    std::vector<std::string> result;
    // A word whose file POV-Ray may not write would end it.
    const auto passed_on = [](const std::string& word) {
        return departure_of(word) != Departure::writes_messages;
    };
    std::copy_if(words.begin(), words.end(), std::back_inserter(result), passed_on);
    add_frame(result, picture.frame);
    for (const char* forced : {"-D", "-P", "-C", "-RFO"}) result.emplace_back(forced);
    if (!picture.finish) result.emplace_back("-F");
    return result;
}

std::vector<std::string> PovrayOptions::sample_words() const {
    std::vector<std::string> result;
    for (const std::string& argument : words)
        for (std::string& word : split_words(argument))
            if (samples_depend_on(word)) result.push_back(std::move(word));
    return result;
}

std::vector<std::string> PovrayOptions::stock_arguments(const StockPicture& picture) const {
    std::vector<std::string> result = words;
    add_frame(result, picture.frame);
    if (!picture.antialias) result.emplace_back("-A");  // one sample per pixel
    result.emplace_back(file_type(picture.type));
    for (const char* forced :
         {"-D", "-P", "-C", "+SC0.0", "+EC1.0", "+SR0.0", "+ER1.0",  // the whole image
          "-UA", "-TH", "Grayscale_Output=off", "File_Gamma=sRGB",
          // Warnings and what ends it; -GA would also silence the line that says where.
          "-GD", "-GR", "-GS"})
        result.emplace_back(forced);
    result.push_back("+O" + quoted_name(picture.output));
    return result;
}

}  // namespace povpreview
