// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/scene_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "adapter/povray_options.h"
#include "adapter/povray_words.h"

namespace povpreview {
namespace {

bool names_a_scene(const std::string& word) {
    const std::vector<std::string> parts = split_words(quoted_for_povray(word));
    return parts.size() == 1 && read_word(parts.front()).kind == PovrayWord::Kind::input;
}

/// The name, or with a number behind it that makes it the only one.
std::string unique(const std::string& name, const std::vector<NamedScene>& others) {
    const auto taken = [&](const std::string& candidate) {
        return std::any_of(others.begin(), others.end(),
                           [&](const NamedScene& scene) { return scene.name == candidate; });
    };
    std::string result = name;
    for (int number = 2; taken(result); ++number) result = fmt::format("{}-{}", name, number);
    return result;
}

}  // namespace

std::vector<NamedScene> scene_list(const std::vector<std::string>& povray_words) {
    std::vector<std::string> shared, scenes;
    for (const std::string& word : povray_words)
        (names_a_scene(word) ? scenes : shared).push_back(word);
    if (scenes.empty()) scenes.emplace_back();  // an INI file names it, or an error says so
    std::vector<NamedScene> list;
    for (const std::string& scene : scenes) {
        NamedScene named{.name = {}, .words = shared};
        if (!scene.empty()) named.words.push_back(scene);
        const std::filesystem::path file = read_povray_options(named.words).scene;
        named.name = unique(file.stem().string(), list);
        named.words.push_back("+L" + std::filesystem::absolute(file).parent_path().string());
        list.push_back(std::move(named));
    }
    return list;
}

}  // namespace povpreview
