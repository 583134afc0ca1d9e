#!/usr/bin/env bash
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# polygonal.sh POVPREVIEW OUT [POV-Ray options and those of povpreview compare]
#
# Asks: what are edges that are known without rays worth on polygonal scenes? Runs `povpreview
# compare --methods mesh,delaunay` on office.pov, chair_mirror.pov and the scenes of
# polygonal_scenes.txt, and prints for each scene the time that mesh needs to the errors (L1) that
# delaunay has at 1, 1.5, 2, 3, 4.5, 7 and 10 % of the samples, over delaunay's own, and the same of
# full samples: geometric mean and range. Below 1, mesh is better. Errors that delaunay has before
# its first point of the curve are left out; where mesh is better at its own first point already,
# that point counts, so the true ratio is smaller.
#
# The last column is what mesh could do were the edges known at once: previews by `povpreview
# figures` from 1, 3 and 10 % of the samples, over the samples that delaunay needs to their errors.
#
# With OUT from an earlier run and RESULTS_ONLY=1 in the environment it only prints.
set -euo pipefail
povpreview=$(realpath "$1") out=$2
shift 2
. "$(dirname "${BASH_SOURCE[0]}")/scenes.sh"

scenes=("$here"/../../scenes/office.pov "$here"/../../scenes/chair_mirror.pov)
while read -r scene _; do
    scenes+=("$(scene_path "$scene")")
done < <(grep -v '^#' "$here/polygonal_scenes.txt")

# samples,error of previews whose edges are known before they begin.
known_at_once() {
    local scene=$1 folder=$2 pixels samples
    shift 2
    pixels=$(awk -F, '$2 == "delaunay" { n = $7 } END { print n }' "$folder/curves.csv")
    for samples in $((pixels / 100)) $((pixels * 3 / 100)) $((pixels / 10)); do
        (cd "$(dirname "$scene")" && "$povpreview" figures "$(basename "$scene")" --out "$folder" \
            --samples "$samples" "$@") 2>"$folder/figures.err" |
            sed -nE 's/^d: .*;([0-9]+) samples, error L1 ([0-9.]+) .*/\1,\2/p'
    done
}

curves=()
for scene in "${scenes[@]}"; do
    name=$(basename "$scene" .pov)
    if [ -z "${RESULTS_ONLY:-}" ]; then
        # POV-Ray looks for includes where it is started, not beside the scene.
        (cd "$(dirname "$scene")" && "$povpreview" compare "$(basename "$scene")" \
            --methods mesh,delaunay --out "$out/$name" "$@" \
            >"$out/$name.txt" 2>"$out/$name.err") ||
            echo "$name failed: $(tail -n 1 "$out/$name.err")"
        known_at_once "$scene" "$out/$name" "$@" >"$out/$name/known.csv" || echo "$name: no figures"
    fi
    [ -f "$out/$name/curves.csv" ] || continue
    : >>"$out/$name/known.csv"
    curves+=("$out/$name"/{curves,known}.csv)
done

awk -F, '
# Curves of the scene read last: time, samples and error of each point, from 1, by method.
function value(what, method, i) { return what == "time" ? time[method, i] : full[method, i] }
function between(a, b, share) { return exp(log(a) + share * (log(b) - log(a))) }

# Where a method stood when it had so many samples; 0 before its first point.
function at_samples(what, method, samples,    i) {
    if (full[method, 1] > samples) return 0
    for (i = 2; i <= points[method]; i++)
        if (full[method, i] >= samples && full[method, i] > full[method, i - 1])
            return between(what == "error" ? error[method, i - 1] : value(what, method, i - 1), \
                what == "error" ? error[method, i] : value(what, method, i), \
                log(samples / full[method, i - 1]) / log(full[method, i] / full[method, i - 1]))
    return 0
}

# Its time or samples from which on its error stays at or below a level; 0 if it never does.
function reached(what, method, level,    i) {
    for (i = points[method]; i > 0 && error[method, i] <= level; i--);
    if (i == points[method]) return 0
    if (i == 0) return value(what, method, 1)
    return between(value(what, method, i), value(what, method, i + 1), \
        log(error[method, i] / level) / log(error[method, i] / error[method, i + 1]))
}

function ratios(what,    k, samples, mine, theirs, ratio, sum, count, low, high) {
    sum = count = 0
    for (k = 1; k <= shares; k++) {
        samples = share[k] / 100 * full["delaunay", points["delaunay"]]
        theirs = at_samples(what, "delaunay", samples)
        if (!theirs) continue
        mine = reached(what, "mesh", at_samples("error", "delaunay", samples))
        if (!mine) continue
        ratio = mine / theirs
        sum += log(ratio)
        if (!count || ratio < low) low = ratio
        if (!count || ratio > high) high = ratio
        count++
    }
    if (!count) { printf " %24s", "-"; return }
    printf " %8.2f (%5.2f .. %5.2f)", exp(sum / count), low, high
    total[what] += sum / count
    number[what]++
}

function known_ratio(    i, theirs, sum, count) {
    sum = count = 0
    for (i = 1; i <= known; i++) {
        theirs = reached("samples", "delaunay", known_error[i])
        if (!theirs || theirs == full["delaunay", 1]) continue
        sum += log(known_samples[i] / theirs)
        count++
    }
    if (!count) { printf " %14s", "-"; return }
    printf " %14.2f", exp(sum / count)
    total["known"] += sum / count
    number["known"]++
}

function finish() {
    if (!points["mesh"] || !points["delaunay"]) return
    printf "%-20s", scene
    ratios("time")
    ratios("samples")
    known_ratio()
    print ""
    fflush()
}

BEGIN {
    shares = split("1 1.5 2 3 4.5 7 10", share, " ")
    printf "%-20s %24s %24s %14s\n", "scene", "time mesh/delaunay", "samples mesh/delaunay", \
        "known at once"
}
FILENAME ~ /known.csv$/ {
    known_samples[++known] = $1
    known_error[known] = $2 + 1e-6
    next
}
FNR == 1 {
    finish()
    split("", points)
    known = 0
    n = split(FILENAME, path, "/")
    scene = path[n - 1]
    next
}
$7 > 0 {
    i = ++points[$2]
    time[$2, i] = $5
    full[$2, i] = $7
    error[$2, i] = $14 + 1e-6
}
END {
    finish()
    if (number["time"])
        printf "%-20s %8.2f %15s %8.2f %15s %14.2f\n", "geometric mean", \
            exp(total["time"] / number["time"]), "", exp(total["samples"] / number["samples"]), "", \
            number["known"] ? exp(total["known"] / number["known"]) : 0
}' "${curves[@]}"
