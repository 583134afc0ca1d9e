// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/reference.h"

#include <fstream>
#include <sstream>

#include "adapter/povray_options.h"
#include "adapter/stock_povray.h"
#include "core/error.h"
#include "display/atomic_file.h"
#include "display/image_file.h"
#include "display/progress_line.h"

namespace povpreview {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
    std::ifstream stream(file);
    std::stringstream text;
    text << stream.rdbuf();
    return text.str();
}

/// Whether no file in the scene's folder (where its includes and images usually lie) is newer.
bool newer_than_all_beside(const fs::path& reference, const fs::path& scene) {
    const auto made = fs::last_write_time(reference);
    const fs::path folder = fs::absolute(scene).parent_path();
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        std::error_code gone;
        if (entry.is_regular_file(gone) && entry.last_write_time(gone) > made) return false;
    }
    return true;
}

}  // namespace

Image stock_reference(const std::vector<std::string>& povray_words, const fs::path& folder,
                      const std::function<bool()>& interrupted, Antialiasing antialiasing) {
    const PovrayOptions options = read_povray_options(povray_words);
    const bool smooth = antialiasing == Antialiasing::on;
    const std::string name = smooth ? "reference-aa" : "reference";
    const fs::path image = folder / (name + ".png"), half_made = folder / (name + ".new.png"),
                   command = folder / (name + ".txt");
    std::vector<std::string> arguments = options.stock_arguments(half_made);
    if (smooth)
        for (const char* word : {"+A0.3", "+AM1", "+R3", "-J"}) arguments.emplace_back(word);
    std::string words;
    for (const std::string& word : arguments) words += word + '\n';
    if (fs::exists(image) && text_of(command) == words &&
        newer_than_all_beside(image, options.scene))
        return read_image(image);

    ProgressLine line;
    const bool complete = render_by_stock_povray(arguments, folder / (name + ".log"), [&] {
        line.show("rendering the reference by the stock povray");
        return interrupted();
    });
    line.clear();
    if (!complete) {
        std::error_code gone;
        fs::remove(half_made, gone);
        throw Error(Exit::interrupted, "interrupted while rendering the reference", "", "");
    }
    fs::rename(half_made, image);
    write_text(command, words);
    return read_image(image);
}

}  // namespace povpreview
