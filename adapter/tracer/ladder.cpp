// SPDX-License-Identifier: AGPL-3.0-or-later
#include "backend/oracle/ladder.h"

#include <algorithm>

namespace povpreview::tracer {

std::vector<RungKind> rungs_of(const std::set<std::string>& features) {
    std::vector<RungKind> rungs;
    const auto dear = {"area_light", "media", "focal_blur", "subsurface", "radiosity"};
    if (std::any_of(dear.begin(), dear.end(), [&](auto name) { return features.count(name) > 0; }))
        rungs.push_back(RungKind::sketch);
    if (needs_preparation(features)) rungs.push_back(RungKind::unprepared);
    rungs.push_back(RungKind::target);
    return rungs;
}

bool needs_preparation(const std::set<std::string>& features) {
    return features.count("radiosity") > 0 || features.count("photons") > 0;
}

std::vector<RungFacts> describe_rungs(const std::vector<RungKind>& rungs,
                                      const std::set<std::string>& features) {
    std::vector<RungFacts> facts;
    for (RungKind kind : rungs) switch (kind) {
            case RungKind::sketch:
                facts.push_back({"sketch", true});
                break;
            case RungKind::unprepared:
                facts.push_back({"unprepared", features.count("radiosity") == 0});
                break;
            case RungKind::target:
                facts.push_back({"target", !needs_preparation(features)});
                break;
        }
    return facts;
}

}  // namespace povpreview::tracer
