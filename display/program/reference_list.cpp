// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/reference_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>

#include "adapter/povray_words.h"
#include "core/error.h"

namespace povpreview {
namespace {

namespace fs = std::filesystem;

bool is_scene(const std::string& word) {
    const std::string quoted = quoted_for_povray(word);
    const std::vector<std::string> parts = split_words(quoted);
    return parts.size() == 1 && read_word(parts.front()).kind == PovrayWord::Kind::input;
}

/// The names in brackets, each once, in order.
std::vector<std::string> sections_of(const fs::path& ini) {
    std::ifstream stream(ini);
    std::vector<std::string> result;
    for (std::string line; std::getline(stream, line);) {
        const std::size_t open = line.find_first_not_of(" \t");
        if (open == std::string::npos || line[open] != '[') continue;
        const std::string name = line.substr(open + 1, line.find(']', open) - open - 1);
        if (std::find(result.begin(), result.end(), name) == result.end()) result.push_back(name);
    }
    if (result.empty())
        throw Error(Exit::usage, fs::exists(ini) ? "this file has no sections" : "no such file",
                    ini.string(), "give an INI file with lines like [small] above their settings");
    return result;
}

/// A scene with everything that is said about it, before its frames are told apart.
struct Picture {
    std::string named;  ///< as the user did
    std::string section;
    PovrayOptions povray;
    std::string problem;
};

std::string without_pov(const fs::path& scene) {
    return scene.extension() == ".pov" ? scene.stem() : scene.filename();
}

/// The last `folders` folders of a file's path, and its name without ".pov".
fs::path tail(const fs::path& file, std::size_t folders) {
    fs::path result = without_pov(file);
    fs::path folder = file.parent_path();
    for (; folders > 0 && folder.has_relative_path(); --folders, folder = folder.parent_path())
        result = folder.filename() / result;
    return result;
}

/// As few folders before each name as tell all scenes apart that have it.
std::map<fs::path, std::string> short_names(const std::set<fs::path>& scenes) {
    std::map<std::string, std::vector<fs::path>> alike;
    for (const fs::path& scene : scenes) alike[without_pov(scene)].push_back(scene);
    std::map<fs::path, std::string> result;
    for (const auto& [name, group] : alike) {
        const auto depth = [](const fs::path& p) { return std::distance(p.begin(), p.end()); };
        std::size_t folders = 0, most = 0;
        for (const fs::path& scene : group)
            most = std::max(most, static_cast<std::size_t>(depth(scene)));
        const auto all_differ = [&, &group = group] {
            std::set<fs::path> tails;
            for (const fs::path& scene : group) tails.insert(tail(scene, folders));
            return tails.size() == group.size();
        };
        while (!all_differ() && folders < most) ++folders;
        for (const fs::path& scene : group) result[scene] = tail(scene, folders).string();
    }
    return result;
}

/// A scene's place, however it was named; a missing one's as it was named.
fs::path place(const Picture& picture) {
    const fs::path file =
        picture.povray.scene.empty() ? fs::path(picture.named) : picture.povray.scene;
    std::error_code gone;
    const fs::path whole = fs::weakly_canonical(fs::absolute(file), gone);
    return gone ? fs::absolute(file) : whole;
}

std::vector<Picture> pictures(const std::vector<std::string>& words, const fs::path& ini) {
    std::vector<std::string> scenes, common{"+WT1"};
    for (const std::string& word : words) (is_scene(word) ? scenes : common).push_back(word);
    if (scenes.empty()) scenes.emplace_back();  // an INI file may name it
    const std::vector<std::string> sections =
        ini.empty() ? std::vector<std::string>{""} : sections_of(ini);
    std::vector<Picture> result;
    for (const std::string& scene : scenes)
        for (const std::string& section : sections) {
            Picture picture{scene, section, {}, {}};
            std::vector<std::string> all = common;
            if (!section.empty()) all.push_back(fmt::format("{}[{}]", ini.string(), section));
            if (!scene.empty()) all.push_back(scene);
            try {
                picture.povray = read_povray_options(all);
            } catch (const Error& error) {
                if (scene.empty()) throw;
                picture.problem = error.what();
            }
            result.push_back(std::move(picture));
        }
    return result;
}

/// The items of one picture: its frames.
void add_items(const Picture& picture, std::string name, std::vector<ReferenceItem>& items) {
    if (!picture.section.empty()) name += "-" + picture.section;
    std::replace(name.begin() + std::ptrdiff_t(name.size() - picture.section.size()), name.end(),
                 '/', '-');
    const ReferenceItem still{name, picture.povray, {}, picture.problem};
    const FrameRange& range = picture.povray.frames;
    std::vector<int> frames;
    try {
        frames = range.frames();
    } catch (const Error& error) {
        items.push_back({name, picture.povray, {}, error.what()});
        return;
    }
    if (frames.empty()) items.push_back(still);
    for (const int frame : frames)
        items.push_back({fmt::format("{}{:0{}}", name, frame, range.digits()), picture.povray,
                         frame, picture.problem});
}

}  // namespace

std::vector<ReferenceItem> reference_items(const std::vector<std::string>& words,
                                           const fs::path& sections) {
    const std::vector<Picture> all = pictures(words, sections);
    std::set<fs::path> scenes;
    for (const Picture& picture : all) scenes.insert(place(picture));
    const std::map<fs::path, std::string> names = short_names(scenes);

    std::vector<ReferenceItem> items;
    std::set<std::pair<fs::path, std::string>> seen;  // a scene may have been named twice
    for (const Picture& picture : all)
        if (seen.emplace(place(picture), picture.section).second)
            add_items(picture, names.at(place(picture)), items);

    std::set<std::string> taken;
    for (const ReferenceItem& item : items)
        if (!taken.insert(item.name).second)
            throw Error(Exit::usage, "two pictures would have this name", item.name,
                        "render their scenes into different folders, or rename one");
    return items;
}

}  // namespace povpreview
