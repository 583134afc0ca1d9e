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

/// Longer switches first: +HR is no height, +AM no anti-aliasing.
constexpr std::pair<std::string_view, Kind> switches[] = {
    {"am", Kind::other},        {"a", Kind::antialias},
    {"ef", Kind::subset_end},   {"hi", Kind::other},
    {"hr", Kind::other},        {"h", Kind::height},
    {"i", Kind::input},         {"kc", Kind::cyclic},
    {"kff", Kind::final_frame}, {"kfi", Kind::initial_frame},
    {"l", Kind::library},       {"sf", Kind::subset_start},
    {"stp", Kind::frame_step},  {"wl", Kind::other},
    {"wt", Kind::threads},      {"w", Kind::width}};
constexpr std::pair<std::string_view, Kind> keywords[] = {
    {"antialias", Kind::antialias},
    {"cyclic_animation", Kind::cyclic},
    {"final_frame", Kind::final_frame},
    {"frame_step", Kind::frame_step},
    {"height", Kind::height},
    {"include_ini", Kind::ini},
    {"initial_frame", Kind::initial_frame},
    {"input_file_name", Kind::input},
    {"library_path", Kind::library},
    {"subset_end_frame", Kind::subset_end},
    {"subset_start_frame", Kind::subset_start},
    {"width", Kind::width},
    {"work_threads", Kind::threads}};

PovrayWord read_switch(std::string_view word) {
    const std::string key = lower(word.substr(1));
    for (const auto& [name, kind] : switches) {
        if (!key.starts_with(name)) continue;
        if (kind == Kind::antialias || kind == Kind::cyclic)
            return {kind, word.front() == '+' ? "on" : "off"};
        return {kind, unquoted(word.substr(1 + name.size()))};
    }
    return {};
}

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
    if (word.front() == '+' || word.front() == '-') return read_switch(word);
    const std::size_t equals = word.find('=');
    if (equals == std::string_view::npos || word.front() == '"' || word.front() == '\'')
        return read_name(word);
    const std::string key = lower(trimmed(word.substr(0, equals)));
    for (const auto& [name, kind] : keywords)
        if (key == name) return {kind, unquoted(trimmed(word.substr(equals + 1)))};
    return {};
}

namespace {

struct Setting {
    std::string name;   ///< in lower case: letters of a switch, or a keyword
    std::string value;  ///< in lower case
    bool is_switch = false, on = true;
};

/// A word as name and value: "+KFF30" is kff and 30, "Quality=3" quality and 3.
Setting setting_of(std::string_view word) {
    Setting result;
    const std::string text = lower(unquoted(word));
    if (text.starts_with('+') || text.starts_with('-')) {
        std::size_t end = 1;
        while (end < text.size() && std::isalpha(static_cast<unsigned char>(text[end]))) ++end;
        return {text.substr(1, end - 1), text.substr(end), true, text[0] == '+'};
    }
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) return result;
    result.name = trimmed(std::string_view(text).substr(0, equals));
    result.value = trimmed(std::string_view(text).substr(equals + 1));
    const std::array<std::string_view, 5> off{"off", "false", "no", "0", ""};
    result.on = std::find(off.begin(), off.end(), result.value) == off.end();
    return result;
}

template <class Names>
bool is_one_of(const Names& names, std::string_view name) {
    return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

}  // namespace

Departure departure_of(std::string_view word) {
    const Setting setting = setting_of(word);
    if (!setting.on) return Departure::none;
    const std::string& name = setting.name;
    if (setting.is_switch) {
        if (name == "rfo") return Departure::saves_radiosity;
        if (name == "c") return Departure::continues;
        if (name == "sp" || name == "ep") return Departure::mosaic;
        if (name == "kff" && setting.value != "1") return Departure::animation;
        // Behind these letters comes the file's name.
        constexpr std::string_view files[] = {"ga", "gd", "gf", "gi", "gr", "gs", "gw"};
        const bool named = name.size() > 2 || !setting.value.empty();
        if (named && is_one_of(files, name.substr(0, 2))) return Departure::writes_messages;
        return Departure::none;
    }
    if (name == "radiosity_to_file") return Departure::saves_radiosity;
    if (name == "continue_trace") return Departure::continues;
    if (name == "preview_start_size" || name == "preview_end_size") return Departure::mosaic;
    if (name == "final_frame" && setting.value != "1") return Departure::animation;
    if (name.ends_with("_command")) return Departure::runs_command;
    constexpr std::string_view files[] = {"all_file",       "create_ini",  "debug_file",
                                          "fatal_file",     "render_file", "statistic_file",
                                          "histogram_name", "warning_file"};
    return is_one_of(files, name) ? Departure::writes_messages : Departure::none;
}

bool samples_depend_on(std::string_view word) {
    const Setting setting = setting_of(word);
    const std::string& name = setting.name;
    if (setting.is_switch) {
        constexpr std::string_view switches[] = {"a",  "ag", "am", "c",  "d",  "ec", "ep",
                                                 "er", "j",  "p",  "r",  "sc", "sp", "sr",
                                                 "th", "v",  "wl", "wt", "rfo"};
        // Behind the first letter of these comes a name or a kind.
        return !is_one_of(switches, name) && !name.starts_with('o') && !name.starts_with('f') &&
               !name.starts_with('g');
    }
    constexpr std::string_view keywords[] = {
        "sampling_method", "file_gamma",  "grayscale_output", "bits_per_color",
        "bits_per_colour", "compression", "work_threads",     "verbose",
        "continue_trace",  "palette",     "pause_when_done",  "start_row",
        "start_column",    "end_row",     "end_column",       "radiosity_to_file"};
    constexpr std::string_view beginnings[] = {"antialias", "jitter",  "dither",  "output_file",
                                               "output_to", "display", "preview_"};
    if (is_one_of(keywords, name)) return false;
    return std::none_of(std::begin(beginnings), std::end(beginnings),
                        [&](std::string_view begin) { return name.starts_with(begin); });
}

bool is_on(std::string_view value) {
    const std::string word = lower(trimmed(value));
    return word == "on" || word == "true" || word == "yes" || word == "1";
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
