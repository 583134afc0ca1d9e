// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/figure_sheet.h"

#include <fmt/format.h>

#include <algorithm>

#include "display/caption.h"
#include "display/image_file.h"

namespace povpreview {
namespace {

/// Three images a row, each above its caption.
Image sheet(const std::vector<FigurePart>& parts) {
    constexpr std::size_t columns = 3;
    std::vector<Image> rows;
    int width = 0, height = 0;
    for (std::size_t first = 0; first < parts.size(); first += columns) {
        std::vector<Panel> panels;
        for (std::size_t i = first; i < std::min(first + columns, parts.size()); ++i)
            panels.push_back({parts[i].image, parts[i].caption});
        rows.push_back(compose(panels));
        width = std::max(width, rows.back().width);
        height += rows.back().height;
    }
    Image all(width, height);
    int y = 0;
    for (const Image& row : rows) {
        for (int j = 0; j < row.height; ++j)
            std::copy_n(&row.at(0, j), row.width, &all.at(0, y + j));
        y += row.height;
    }
    return all;
}

}  // namespace

void write_figure(const std::vector<FigurePart>& parts, const std::filesystem::path& folder) {
    for (const FigurePart& part : parts) write_image(part.image, folder / (part.name + ".png"));
    write_image(sheet(parts), folder / "figure.png", FileFormat::png8);
    for (const FigurePart& part : parts) {
        std::string line = part.caption;
        std::replace(line.begin(), line.end(), '\n', ';');
        fmt::print("{}\n", line);
    }
}

}  // namespace povpreview
