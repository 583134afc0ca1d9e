#!/usr/bin/env bash
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# textured.sh POVPREVIEW OUT [POV-Ray options and those of povpreview compare]
#
# Asks: what is the DetailMap worth in time? Runs `povpreview compare` on the scenes of
# textured_scenes.txt: mesh, the same without the DetailMap (constrained), and the baselines. Prints
# for each scene and error (L1) the seconds of mesh and how many times as long the others took: the
# best of the block previewers (blocks, mosaic), bicubic, delaunay and constrained. "-": an error
# that mesh, or the other, did not come to within the time given. Then the geometric means, and the
# scenes where mesh lost to the best block previewer by more than 5 %.
#
# With OUT from an earlier run and RESULTS_ONLY=1 in the environment it only prints.
set -euo pipefail
povpreview=$(realpath "$1") out=$2
shift 2
. "$(dirname "${BASH_SOURCE[0]}")/scenes.sh"

scenes=()
while read -r scene _; do
    scenes+=("$(scene_path "$scene")")
done < <(grep -v '^#' "$here/textured_scenes.txt")
if [ -z "${RESULTS_ONLY:-}" ]; then
    "$povpreview" compare "${scenes[@]}" \
        --methods mesh,constrained,delaunay,blocks,mosaic,bicubic --out "$out" "$@" \
        >/dev/null || true # what failed has said so
fi

awk -F, '
# When the error fell to the level, between two points on logarithmic axes.
function crossing(time, error, level) {
    if (before != scene SUBSEP $2) return time
    return exp(log(before_time) + log(time / before_time) * \
        log(before_error / level) / log(before_error / error))
}
function column(mine, other, key) {
    if (other == "") return sprintf(" %9s", "-")
    sum[key] += log(other / mine)
    ++count[key]
    return sprintf(" %9.2f", other / mine)
}
FNR == 1 || $3 > 1 { next }
$1 != scene { scene = $1; scenes[++total] = scene }
{
    for (i = 1; i <= levels; ++i) {
        key = scene SUBSEP $2 SUBSEP i
        if ($14 > level[i]) delete reached[key]
        else if (!(key in reached)) reached[key] = crossing($5, $14 + 1e-6, level[i])
    }
    before = scene SUBSEP $2
    before_time = $5
    before_error = $14 + 1e-6
}
BEGIN { levels = split(".05 .02 .01 .005", level, " ") }
END {
    printf "%-14s %5s %8s %9s %9s %9s %9s\n", "scene", "L1", "mesh s", "blocks", "bicubic", \
        "delaunay", "no detail"
    for (s = 1; s <= total; ++s)
        for (i = 1; i <= levels; ++i) {
            mine = reached[scenes[s], "mesh", i]
            printf "%-14s %5s", scenes[s], level[i]
            if (mine == "") { printf " %8s\n", "-"; continue }
            blocks = reached[scenes[s], "blocks", i]
            mosaic = reached[scenes[s], "mosaic", i]
            if (blocks == "" || (mosaic != "" && mosaic < blocks)) blocks = mosaic
            printf " %8.3f%s%s%s%s\n", mine, column(mine, blocks, "blocks" i), \
                column(mine, reached[scenes[s], "bicubic", i], "bicubic" i), \
                column(mine, reached[scenes[s], "delaunay", i], "delaunay" i), \
                column(mine, reached[scenes[s], "constrained", i], "constrained" i)
            if (blocks != "" && blocks / mine < .95) lost[i] = lost[i] " " scenes[s]
        }
    for (i = 1; i <= levels; ++i) {
        printf "%-14s %5s %8s", "mean", level[i], ""
        split("blocks bicubic delaunay constrained", other, " ")
        for (j = 1; j <= 4; ++j)
            printf " %9s", count[other[j] i] ? sprintf("%.2f", exp(sum[other[j] i] / count[other[j] i])) : "-"
        print ""
    }
    for (i = 1; i <= levels; ++i) if (lost[i] != "") print "lost at " level[i] ":" lost[i]
}' "$out/curves.csv"
