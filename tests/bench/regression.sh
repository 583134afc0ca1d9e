#!/usr/bin/env bash
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# regression.sh POVPREVIEW OUT [--record] [POV-Ray options and those of povpreview compare]
#
# Asks: is mesh still as far ahead as it was? Runs `povpreview compare` on a few scenes, cheap and
# dear, polygonal, textured and curved, three times each, and prints how many times as long (and as
# many rays) blocks and delaunay need to the same L1 errors, next to the ratios recorded in
# regression.csv, with a mark where mesh has lost or won a quarter. Ratios within one run hold from
# machine to machine where seconds do not; a loaded machine still shifts them. --record replaces what
# is recorded.
#
# With OUT from an earlier run and RESULTS_ONLY=1 in the environment it only prints.
set -euo pipefail
povpreview=$1 out=$2
shift 2
record=
if [ "${1:-}" = --record ]; then record=1 && shift; fi
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
recorded=$here/regression.csv
examples=/usr/share/doc/povray/examples

if [ -z "${RESULTS_ONLY:-}" ]; then
    "$povpreview" compare +W320 +H240 "$here"/../../scenes/{office,image_maps,still_life}.pov \
        "$examples"/advanced/woodbox.pov \
        --methods mesh,blocks,delaunay --repeat 3 --time 30 --out "$out" "$@" >/dev/null
fi

# scene,method,axis,level,ratio: every ratio of L1 to mesh's, where both came to the level.
ratios() {
    sed -nE 's/^\{"scene": "([^"]*)", "method": "(blocks|delaunay)", "measure": "l1", "axis": "(time_s|rays)", "level": ([0-9.]+),.*"ratio": ([0-9.e+-]+)\}.*/\1,\2,\3,\4,\5/p' \
        "$out/summary.json"
}

if [ -n "$record" ]; then
    {
        echo "scene,method,axis,level,ratio"
        ratios
    } >"$recorded"
    echo "recorded $(($(wc -l <"$recorded") - 1)) ratios in $recorded"
    exit
fi

ratios | awk -F, '
FILENAME != "-" { if (FNR > 1) before[$1, $2, $3, $4] = $5; next }
!printed++ { printf "%-14s %-9s %-7s %6s %9s %9s\n", "scene", "method", "over", "L1", "now", "recorded" }
{
    was = before[$1, $2, $3, $4]
    printf "%-14s %-9s %-7s %6s %9.2f %9s%s\n", $1, $2, $3, $4, $5, was == "" ? "-" : sprintf("%.2f", was), \
        (was == "" ? "" : $5 < was / 1.25 ? "  worse" : ($5 > was * 1.25) ? "  better" : "")
    if (was != "") { sum[$2 " " $3] += log($5 / was); ++count[$2 " " $3] }
}
END {
    for (key in sum) printf "%s: now %.2f times what was recorded (geometric mean of %d)\n", key, \
        exp(sum[key] / count[key]), count[key]
}' "$recorded" -
