#!/usr/bin/env bash
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# time_to_error.sh POVPREVIEW OUT [povpreview compare's options]
#
# Asks: how long does each method take to show a picture within a given error of the finished one,
# and how long until it is complete? Runs `povpreview compare` on our scenes and on those of
# scenes.txt, all methods of a scene in one go, and prints for each scene the seconds of mesh and the
# ratio of every other method to it (above 1: mesh was faster), then the geometric means.
set -euo pipefail
povpreview=$(realpath "$1") out=$2
shift 2
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
examples=/usr/share/doc/povray/examples
mkdir -p "$out"
out=$(realpath "$out")

scenes=("$here"/../../scenes/*.pov)
while read -r scene; do scenes+=("$examples/$scene"); done < <(grep -v '^#' "$here/scenes.txt")
for scene in "${scenes[@]}"; do
    name=$(basename "$scene" .pov)
    # POV-Ray looks for includes where it is started, not beside the scene.
    (cd "$(dirname "$scene")" && "$povpreview" compare "$(basename "$scene")" \
        --out "$out/$name" "$@" >"$out/$name.txt" 2>"$out/$name.err") ||
        echo "$name failed: $(tail -n 1 "$out/$name.err")"
done

awk -F, -v OFS='\t' '
# When the error fell to the level, between two points on logarithmic axes.
function crossing(time, error, level) {
    if (before_method != scene $1) return time
    return exp(log(before_time) + log(time / before_time) * \
        log(before_error / level) / log(before_error / error))
}
function add(key, ratio) { sum[key] += log(ratio); count[key]++ }
FNR == 1 { n = split(FILENAME, path, "/"); scene = path[n - 1]; scenes[++total] = scene; next }
{
    seconds[scene, $1] = $2
    for (i = 1; i <= levels; i++) {
        key = scene SUBSEP $1 SUBSEP i
        if ($7 > level[i]) delete reached[key]
        else if (!(key in reached)) reached[key] = crossing($2, $7 + 1e-6, level[i])
    }
    before_method = scene $1
    before_time = $2
    before_error = $7 + 1e-6
}
BEGIN { levels = split(".05 .02 .01 .005 .002", level, " ") }
END {
    others = split("delaunay blocks mosaic bicubic", other, " ")
    printf "%-14s %7s %9s", "scene", "L1", "mesh s"
    for (j = 1; j <= others; j++) printf " %9s", other[j]
    print ""
    for (s = 1; s <= total; s++) {
        for (i = 1; i <= levels + 1; i++) {
            printf "%-14s %7s", scenes[s], (i > levels ? "all" : level[i])
            mine = i > levels ? seconds[scenes[s], "mesh"] : reached[scenes[s], "mesh", i]
            if (mine == "") { printf " %9s\n", "-"; continue }
            printf " %9.3f", mine
            for (j = 1; j <= others; j++) {
                theirs = i > levels ? seconds[scenes[s], other[j]] : reached[scenes[s], other[j], i]
                if (theirs == "") { printf " %9s", "-"; continue }
                printf " %9.2f", theirs / mine
                add(i SUBSEP other[j], theirs / mine)
            }
            print ""
        }
    }
    for (i = 1; i <= levels + 1; i++) {
        printf "%-14s %7s %9s", "geometric mean", (i > levels ? "all" : level[i]), ""
        for (j = 1; j <= others; j++) {
            key = i SUBSEP other[j]
            printf " %9s", (count[key] ? sprintf("%.2f", exp(sum[key] / count[key])) : "-")
        }
        print ""
    }
}' "$out"/*/curves.csv
