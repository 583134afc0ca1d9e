// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/progress_log.h"

#include <fmt/format.h>

#include <cstring>
#include <vector>

#include "core/error.h"
#include "display/program/json_text.h"

namespace povpreview {
namespace {

/// ,"rungs":[...],"below_target":N, or nothing where there is only the target.
std::string rungs(const Statistics& statistics) {
    if (statistics.rungs.empty()) return "";
    std::vector<std::string> rungs;
    for (const RungStanding& rung : statistics.rungs) {
        std::string text = fmt::format("{{\"name\":{},\"samples\":{},\"cost_us\":{:.1f}",
                                       json_string(rung.name), rung.samples, rung.cost_ns / 1e3);
        if (rung.error >= 0) text += fmt::format(",\"error\":{:.4f}", rung.error);
        rungs.push_back(text + (rung.dropped ? ",\"dropped\":true}" : "}"));
    }
    return fmt::format(",\"rungs\":[{}],\"below_target\":{}", fmt::join(rungs, ","),
                       statistics.below_target);
}

}  // namespace

ProgressLog::ProgressLog(const std::filesystem::path& file) : file_(file), stream_(file) {
    if (!stream_)
        throw Error(Exit::usage, std::string("cannot write the log: ") + std::strerror(errno),
                    file.string(), "give --log a file in a folder that you may write");
}

void ProgressLog::write(const Standing& p) {
    const auto& kinds = p.statistics.constraints_by_kind;
    const auto of = [&](EdgeKind kind) { return kinds[static_cast<std::size_t>(kind)]; };
    put(fmt::format(
        "{{\"time_s\":{:.4f},\"launch_s\":{:.4f},\"full\":{},\"probe\":{},"
        "\"albedo\":{},\"vertices\":{},\"constraints\":{},\"geometric\":{},"
        "\"shadow\":{},\"reflection\":{},\"traced\":{},\"filled\":{},"
        "\"items\":{},\"albedos\":{},\"contradicted\":{},\"busy\":{:.3f}{}}}\n",
        p.time_s, p.launch_s, p.full, p.probe, p.albedo, p.statistics.vertices,
        p.statistics.constraints, of(EdgeKind::geometric), of(EdgeKind::shadow),
        of(EdgeKind::reflection), of(EdgeKind::traced), p.statistics.filled, p.statistics.items,
        p.statistics.albedos, p.statistics.contradicted, p.busy, rungs(p.statistics)));
}

void ProgressLog::write_event(double time_s, const std::string& text) {
    put(fmt::format("{{\"time_s\":{:.4f},\"event\":{}}}\n", time_s, json_string(text)));
}

void ProgressLog::write_plan(double time_s, const std::vector<Stage>& stages) {
    for (const Stage& stage : stages)
        put(fmt::format("{{\"time_s\":{:.4f},\"stage\":{},\"runs\":{},\"why\":{}}}\n", time_s,
                        json_string(stage.name), stage.runs, json_string(stage.why)));
}

void ProgressLog::put(const std::string& line) {
    stream_ << line << std::flush;
    if (!stream_)
        throw Error(Exit::usage, "the log could not be written to its end", file_.string(),
                    "make room on the disk");
}

}  // namespace povpreview
