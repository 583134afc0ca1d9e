// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/openimageio/caption.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <sstream>
#include <vector>

#include "core/error.h"

namespace povpreview::openimageio {

namespace {

constexpr glm::vec3 ground{.013f, .013f, .015f};
constexpr float ink[3] = {.75f, .75f, .75f};
constexpr int largest_font = 15, smallest_font = 12;  ///< pixels
constexpr int margin = 6;                             ///< around a caption, pixels

/// Width of a line in pixels.
int line_width(const std::string& line, int size, const std::string& font) {
    const OIIO::ROI box = OIIO::ImageBufAlgo::text_size(line, size, font);
    return box.defined() ? box.xend : -1;
}

/// A font that the image library can read; looked for once.
const std::string& font() {
    static const std::string found = [] {
        for (const char* name :
             {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", "DejaVuSans",
              "LiberationSans-Regular", "NotoSans-Regular", "FreeSans", "DroidSans"})
            if (line_width("x", largest_font, name) > 0) return std::string(name);
        OIIO::geterror();  // the failed tries left a message behind
        return std::string();
    }();
    if (found.empty())
        throw Error(Exit::usage, "no font for captions was found", "",
                    "install Debian's fonts-dejavu-core");
    return found;
}

struct SetLine {
    std::string text;
    int size;  ///< of the font, pixels
};

/// Breaks a line that does not fit even at the smallest size; a single word may still stick out.
void break_line(const std::string& line, int width, std::vector<SetLine>& lines) {
    std::istringstream words(line);
    std::string word, taken;
    while (words >> word) {
        const std::string longer = taken.empty() ? word : taken + " " + word;
        if (!taken.empty() && line_width(longer, smallest_font, font()) > width) {
            lines.push_back({taken, smallest_font});
            taken = word;
        } else {
            taken = longer;
        }
    }
    if (!taken.empty()) lines.push_back({taken, smallest_font});
}

/// OpenImageIO 2.4 decodes UTF-8 wrongly and would draw other letters; one '?' a character is
/// honest.
std::string ascii(const std::string& text) {
    std::string plain;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x80) plain += c;
        if (byte >= 0xC0) plain += '?';
    }
    return plain;
}

std::vector<SetLine> set_lines(const std::string& text, int width) {
    std::vector<SetLine> lines;
    std::istringstream stream(ascii(text));
    for (std::string line; std::getline(stream, line);) {
        int size = largest_font;
        while (size > smallest_font && line_width(line, size, font()) > width) --size;
        if (line_width(line, size, font()) > width)
            break_line(line, width, lines);
        else
            lines.push_back({line, size});
    }
    return lines;
}

int line_height(int font_size) { return font_size * 4 / 3; }

}  // namespace

Image caption_strip(const std::string& text, int width) {
    const std::vector<SetLine> lines = set_lines(text, width - 2 * margin);
    int height = 2 * margin;
    for (const SetLine& line : lines) height += line_height(line.size);
    Image strip(width, height, ground);
    const OIIO::ImageSpec spec(width, height, 3, OIIO::TypeFloat);
    OIIO::ImageBuf buffer(spec, strip.pixels.data());
    int y = margin;
    for (const SetLine& line : lines) {
        const int baseline = y + line.size;
        if (!OIIO::ImageBufAlgo::render_text(buffer, margin, baseline, line.text, line.size, font(),
                                             ink))
            throw Error(Exit::usage, "a caption cannot be set: " + buffer.geterror(), font(),
                        "install Debian's fonts-dejavu-core");
        y += line_height(line.size);
    }
    return strip;
}

}  // namespace povpreview::openimageio
