#!/usr/bin/env bash
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# dear.sh TIME_TO_L1 OUT [POV-Ray options]
#
# Asks: what is mesh worth where it matters most, in large pictures that take povray long? Renders
# each scene of dear_scenes.txt at 1920x1080 by povray, once, and lets each method run for
# SECONDS_EACH (2.5): seconds of mesh to an error (L1) of .1, .05, .02, .01 and .005, each followed by how many
# times as long blocks, mosaic, delaunay and bicubic took.
set -euo pipefail
time_to_l1=$(realpath "$1") out=$2
shift 2
. "$(dirname "${BASH_SOURCE[0]}")/scenes.sh"
size=(+W1920 +H1080 "$@")
export POVPREVIEW_TRACER=${POVPREVIEW_TRACER:-$("$here/../../adapter/setup/build_tracer.sh" --where)}

while read -r scene options; do
    path=$(scene_path "$scene") reference=$out/$(basename "$scene" .pov).png
    cd "$(dirname "$path")" # where its own files are
    # shellcheck disable=SC2086
    [ -f "$reference" ] || povray "${size[@]}" $options "$(basename "$path")" -A +FN16 -D -P \
        "+O$reference" >"$out/messages" 2>&1 </dev/null ||
        { echo "$scene: $(tail -1 "$out/messages")" >&2 && continue; }
    # shellcheck disable=SC2086
    "$time_to_l1" "$reference" "${SECONDS_EACH:-2.5}" mesh blocks mosaic delaunay bicubic -- \
        "${size[@]}" $options "$(basename "$path")" </dev/null || true # what failed has said so
done < <(grep -v '^#' "$here/dear_scenes.txt")
