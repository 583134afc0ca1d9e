// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/caption.h"

#include <algorithm>
#include <vector>

#include "display/image_library.h"

namespace povpreview {

namespace {

constexpr glm::vec3 ground{.013f, .013f, .015f};
constexpr int gap = 8;                ///< between panels, pixels
constexpr int narrowest_panel = 240;  ///< pixels

void paste(const Image& image, int x, int y, Image& onto) {
    for (int row = 0; row < image.height; ++row)
        std::copy_n(&image.at(0, row), image.width, &onto.at(x, y + row));
}

}  // namespace

Image caption_strip(const std::string& text, int width) {
    return image_library().caption_strip(text, width);
}

Image compose(std::span<const Panel> panels) {
    int width = 0, image_height = 0, strip_height = 0;
    std::vector<Image> strips;
    std::vector<int> starts;
    for (const Panel& panel : panels) {
        const int panel_width = std::max(panel.image.width, narrowest_panel);
        strips.push_back(panel.caption.empty() ? Image()
                                               : caption_strip(panel.caption, panel_width));
        starts.push_back(width + (width > 0 ? gap : 0));
        width = starts.back() + panel_width;
        image_height = std::max(image_height, panel.image.height);
        strip_height = std::max(strip_height, strips.back().height);
    }
    Image all(width, image_height + strip_height, ground);
    for (std::size_t i = 0; i < panels.size(); ++i) {
        const Image& image = panels[i].image;
        const int slack = std::max(image.width, narrowest_panel) - image.width;
        paste(image, starts[i] + slack / 2, 0, all);
        paste(strips[i], starts[i], image_height, all);
    }
    return all;
}

}  // namespace povpreview
