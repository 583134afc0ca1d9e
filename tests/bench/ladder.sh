#!/usr/bin/env bash
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# ladder.sh POVPREVIEW OUT [POV-Ray options and those of povpreview compare]
#
# Asks: what is it worth to begin at a low accuracy? Runs `povpreview compare` with mesh on each
# scene of ladder_scenes.txt, 20 s at most, once rising on its ladder of accuracy and once at the
# target alone, and prints of both the seconds from the end of the parse to the first picture (300
# samples: the first, regular grid) and to an error (L1) of .05 and .02 against the complete render,
# and how many times as long the target alone took; >: more than that, it did not come to it within
# the time given.
#
# With OUT from an earlier run and RESULTS_ONLY=1 in the environment it only prints.
set -euo pipefail
povpreview=$(realpath "$1") out=$2
shift 2
. "$(dirname "${BASH_SOURCE[0]}")/scenes.sh"

run() { # accuracy (empty: rising), name, scene, its options; "${common[@]}" are those of all
    "$povpreview" compare +W320 +H240 "$3" "${@:4}" --methods mesh --time 20 --out "$out/$2" \
        ${1:+--accuracy "$1"} "${common[@]}" >/dev/null || true # what failed has said so
    cp "$out/$2/curves.csv" "$out/$2-${1:-ladder}.csv"
}

common=("$@")
names=()
while read -r scene options; do
    name=$(basename "$scene" .pov)
    names+=("$name")
    [ -z "${RESULTS_ONLY:-}" ] || continue
    scene=$(scene_path "$scene")
    # shellcheck disable=SC2086 # options are words
    run '' "$name" "$scene" $options </dev/null
    # shellcheck disable=SC2086
    run target "$name" "$scene" $options </dev/null
done < <(grep -v '^#' "$here/ladder_scenes.txt")

for name in "${names[@]}"; do
    for way in ladder target; do
        [ ! -f "$out/$name-$way.csv" ] || sed "1d; s/^[^,]*,[^,]*/$name,$way/" "$out/$name-$way.csv"
    done
done | awk -F, '
# When the error fell to the level, between two points on logarithmic axes.
function crossing(time, error, level) {
    if (before != $1 SUBSEP $2) return time
    return exp(log(before_time) + log(time / before_time) * \
        log(before_error / level) / log(before_error / error))
}
function reach(i, time) {
    if (!(($1, $2, i) in reached)) reached[$1, $2, i] = time
}
function seconds(key) { return key in reached ? sprintf("%.2f", reached[key]) : "-" }
BEGIN { levels = split("first .05 .02", level, " ") }
!($1 in seen) { seen[$1] = 1; scenes[++total] = $1 }
{
    if ($7 >= 300) reach(1, $5)
    for (i = 2; i <= levels; ++i) {
        if ($14 > level[i]) delete reached[$1, $2, i]
        else reach(i, crossing($5, $14 + 1e-6, level[i]))
    }
    last[$1, $2] = $5
    before = $1 SUBSEP $2
    before_time = $5
    before_error = $14 + 1e-6
}
END {
    printf "%-16s", "scene"
    for (i = 1; i <= levels; ++i) printf " | %6s %7s %8s", level[i], "target", "ratio"
    print ""
    for (s = 1; s <= total; ++s) {
        printf "%-16s", scenes[s]
        for (i = 1; i <= levels; ++i) {
            mine = scenes[s] SUBSEP "ladder" SUBSEP i
            its = scenes[s] SUBSEP "target" SUBSEP i
            ratio = "-"
            if (mine in reached)
                ratio = its in reached ? sprintf("%.2f", reached[its] / reached[mine]) : \
                    sprintf("> %.2f", last[scenes[s], "target"] / reached[mine])
            printf " | %6s %7s %8s", seconds(mine), seconds(its), ratio
        }
        print ""
    }
}'
