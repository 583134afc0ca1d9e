// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/stability/series.h"

#include <fmt/format.h>

#include <algorithm>

namespace povpreview::stability {

std::string Case::name() const {
    return fmt::format("{}/{}@{:g}", series->family, series->name, value);
}

std::string Case::scene() const {
    return fmt::format(
        "// {}: {}\n#version 3.7;\n#declare K = {};\nglobal_settings {{ assumed_gamma 1 }}\n{}",
        name(), series->reason, value, series->text);
}

std::vector<std::string> Case::words(bool full) const {
    const std::string size = *series->size ? series->size : full ? "320x240" : "64x48";
    const std::size_t cross = size.find('x');
    // One thread: where random numbers are drawn, stock POV-Ray repeats itself only so.
    return {"+W" + size.substr(0, cross), "+H" + size.substr(cross + 1), "+WT1"};
}

const std::vector<Series>& all_series() {
    static const std::vector<Series> all = [] {
        std::vector<Series> series;
        for (const auto& family : {scale_series(), degenerate_series(), colour_series(),
                                   light_series(), camera_series(), load_series(), mirror_series()})
            series.insert(series.end(), family.begin(), family.end());
        return series;
    }();
    return all;
}

std::vector<Case> cases(bool full, const std::vector<std::string>& prefixes) {
    std::vector<Case> result;
    for (const Series& series : all_series()) {
        std::vector<double> values = series.small;
        if (full) values.insert(values.end(), series.decades.begin(), series.decades.end());
        std::sort(values.begin(), values.end());
        for (const double value : values) {
            const Case one{&series, value};
            const auto begins = [&](const std::string& prefix) {
                return one.name().starts_with(prefix);
            };
            if (prefixes.empty() || std::any_of(prefixes.begin(), prefixes.end(), begins))
                result.push_back(one);
        }
    }
    return result;
}

}  // namespace povpreview::stability
