// SPDX-License-Identifier: AGPL-3.0-or-later
#include "adapter/povray_words.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <utility>

namespace povpreview {
namespace {

using Kind = PovrayWord::Kind;

std::string lower(std::string_view text) {
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

std::string unquoted(std::string_view text) {
    std::string result;
    char quote = 0;
    for (const char c : text) {
        if (quote == 0 && (c == '"' || c == '\''))
            quote = c;
        else if (c == quote)
            quote = 0;
        else
            result += c;
    }
    return result;
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front())))
        text.remove_prefix(1);
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())))
        text.remove_suffix(1);
    return text;
}

/// Longer switches first: +HR is no height, +WT no width.
constexpr std::array<std::pair<std::string_view, Kind>, 8> switches{{{"hi", Kind::other},
                                                                     {"hr", Kind::other},
                                                                     {"wl", Kind::other},
                                                                     {"wt", Kind::other},
                                                                     {"h", Kind::height},
                                                                     {"w", Kind::width},
                                                                     {"i", Kind::input},
                                                                     {"l", Kind::library}}};
constexpr std::array<std::pair<std::string_view, Kind>, 5> keywords{
    {{"height", Kind::height},
     {"width", Kind::width},
     {"input_file_name", Kind::input},
     {"include_ini", Kind::ini},
     {"library_path", Kind::library}}};

PovrayWord read_name(std::string_view word) {
    const std::string name = unquoted(word);
    if (lower(name).ends_with(".pov")) return {Kind::input, name};
    return {name.ends_with('/') ? Kind::library : Kind::ini, name};
}

}  // namespace

std::vector<std::string> split_words(std::string_view text) {
    std::vector<std::string> words;
    std::string word;
    char quote = 0;
    for (const char c : text) {
        if (quote == 0 && std::isspace(static_cast<unsigned char>(c))) {
            if (!word.empty()) words.push_back(std::exchange(word, {}));
            continue;
        }
        if (quote == 0 && (c == '"' || c == '\''))
            quote = c;
        else if (c == quote)
            quote = 0;
        word += c;
    }
    if (!word.empty()) words.push_back(word);
    return words;
}

PovrayWord read_word(std::string_view word) {
    if (word.empty()) return {};
    if (word.front() == '+' || word.front() == '-') {
        const std::string key = lower(word.substr(1));
        for (const auto& [name, kind] : switches)
            if (key.starts_with(name)) return {kind, unquoted(word.substr(1 + name.size()))};
        return {};
    }
    const std::size_t equals = word.find('=');
    if (equals == std::string_view::npos || word.front() == '"' || word.front() == '\'')
        return read_name(word);
    const std::string key = lower(trimmed(word.substr(0, equals)));
    for (const auto& [name, kind] : keywords)
        if (key == name) return {kind, unquoted(trimmed(word.substr(equals + 1)))};
    return {};
}

std::string quoted_name(const std::string& name) {
    if (name.find_first_of(" \t'\"") == std::string::npos) return name;
    const char quote = name.find('"') == std::string::npos ? '"' : '\'';
    return quote + name + quote;
}

std::string quoted_for_povray(const std::string& argument) {
    const bool blank = argument.find_first_of(" \t") != std::string::npos;
    if (!blank || argument.find_first_of("\"'") != std::string::npos) return argument;
    const PovrayWord whole = read_word(argument);
    const bool names_file =
        whole.kind == Kind::input || whole.kind == Kind::library || whole.kind == Kind::ini;
    std::error_code error;
    if (!names_file || whole.value.empty() || !argument.ends_with(whole.value) ||
        !std::filesystem::exists(whole.value, error))
        return argument;
    return argument.substr(0, argument.size() - whole.value.size()) + quoted_name(whole.value);
}

}  // namespace povpreview
