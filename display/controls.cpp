// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/controls.h"

namespace povpreview {

bool Controls::press(char key) {
    const auto toggle = [this](Overlay wanted) {
        overlay = overlay == wanted ? Overlay::none : wanted;
        return true;
    };
    switch (key >= 'A' && key <= 'Z' ? key - 'A' + 'a' : key) {
        case 'm':
            return toggle(Overlay::mesh);
        case 'e':
            return toggle(Overlay::edges);
        case 's':
            return toggle(Overlay::samples);
        case 'b':
            beside = !beside;
            return true;
        case 'p':
            return save = true;
        case 'q':
        case escape:
            return closed = true;
        default:
            return false;
    }
}

}  // namespace povpreview
