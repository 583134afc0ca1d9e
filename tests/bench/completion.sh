#!/usr/bin/env bash
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# completion.sh POVPREVIEW SAME_PICTURE OUT [POV-Ray options]
#
# Asks: what does a preview cost that is left running to its end, and is its end the render? Renders
# each scene of completion_scenes.txt by povray and by `povpreview --finish`, turn by turn, REPEATS
# times (3), with as many threads, and prints the medians of their seconds from start to exit, the
# ratio, and how many values differ and by how much: of the preview's picture from povray's, and of
# povray's own from that with one thread, which is what radiosity and photons leave open.
#
# With OUT from an earlier run and RESULTS_ONLY=1 in the environment it only prints.
set -euo pipefail
povpreview=$(realpath "$1") same_picture=$(realpath "$2") out=$3
shift 3
. "$(dirname "${BASH_SOURCE[0]}")/scenes.sh"
common=(+W320 +H240 -D +FN16 "+WT$(nproc)" "$@")

# Seconds that a command takes, which fails or not.
seconds() {
    local start=$EPOCHREALTIME
    "$@" >/dev/null 2>"$out/messages" </dev/null || echo "$*: $(tail -1 "$out/messages")" >&2
    awk "BEGIN { print $EPOCHREALTIME - $start }"
}

differing() { "$same_picture" "$out/$1.png" "$out/$2.png" || true; }

measure() { # name, scene, its options
    local name=$1 scene=$2 repeat
    shift 2
    cd "$(dirname "$scene")" # where its own files are
    for ((repeat = 0; repeat < ${REPEATS:-3}; ++repeat)); do
        printf '%s,%s,%s\n' "$name" \
            "$(seconds povray "${common[@]}" "$@" "+I$scene" "+O$out/$name-povray.png")" \
            "$(seconds "$povpreview" "${common[@]}" "$@" "$scene" --headless --finish \
                "+O$out/$name.png")" >>"$out/seconds.csv"
    done
    seconds povray "${common[@]}" "$@" +WT1 "+I$scene" "+O$out/$name-one.png" >/dev/null
    printf '%s,%s,%s\n' "$name" "$(differing "$name" "$name-povray")" \
        "$(differing "$name-povray" "$name-one")" >>"$out/differing.csv"
}

if [ -z "${RESULTS_ONLY:-}" ]; then
    rm -f "$out/seconds.csv" "$out/differing.csv"
    while read -r scene options; do
        # shellcheck disable=SC2086 # options are words
        (measure "$(basename "$scene" .pov)" "$(realpath "$(scene_path "$scene")")" $options)
    done < <(grep -v '^#' "$here/completion_scenes.txt")
fi

awk -F, '
# The middle one of words that are numbers.
function median(words, values, n, i, j, value) {
    n = split(words, values, " ")
    for (i = 2; i <= n; ++i) {
        value = values[i]
        for (j = i; j > 1 && values[j - 1] + 0 > value + 0; --j) values[j] = values[j - 1]
        values[j] = value
    }
    return n % 2 ? values[(n + 1) / 2] : (values[n / 2] + values[n / 2 + 1]) / 2
}
FILENAME ~ /differing/ { ours[$1] = $2; its[$1] = $3; next }
!($1 in povray) { scenes[++total] = $1 }
{ povray[$1] = povray[$1] " " ($2 + 0); preview[$1] = preview[$1] " " ($3 + 0); ratio[$1] = ratio[$1] " " $3 / $2 }
END {
    printf "%-18s %8s %8s %6s | %-28s | %s\n", "scene", "povray", "preview", "ratio", \
        "differs from povray", "povray from one thread"
    for (s = 1; s <= total; ++s) {
        name = scenes[s]
        printf "%-18s %8.2f %8.2f %6.3f | %-28s | %s\n", name, median(povray[name]), \
            median(preview[name]), median(ratio[name]), ours[name], its[name]
        all = all " " median(ratio[name])
    }
    printf "median ratio %.3f\n", median(all)
}' "$out/differing.csv" "$out/seconds.csv"
