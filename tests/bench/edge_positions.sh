#!/usr/bin/env bash
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# edge_positions.sh EDGE_POSITIONS OUT [options of edge_positions, POV-Ray options]
#
# Runs edge_positions (see edge_positions/edge_positions.cpp) on office.pov, chair_mirror.pov and the
# scenes of polygonal_scenes.txt, all without textures, in four minutes or so at 320x240. Columns: strong
# jumps of the finer render and the share of them (%) within half a pixel of a constraint; pixels of
# length of constraints and the share of it (%) that is right: on a jump (on), with no contrast
# across (even), or beside the jump of another constraint (beside); not off; and the share of it
# where rays on both sides meet the very same surfaces and lights (idle).
set -euo pipefail
edge_positions=$(realpath "$1") out=$2
shift 2
. "$(dirname "${BASH_SOURCE[0]}")/scenes.sh"
scenes=("$here"/../../scenes/office.pov "$here"/../../scenes/chair_mirror.pov)
while read -r scene textured; do
    if [ "$textured" ]; then continue; fi
    scenes+=("$(scene_path "$scene")")
done < <(grep -v '^#' "$here/polygonal_scenes.txt")

printf '%-20s %-11s %8s %7s %9s %7s %6s %6s %6s %6s %6s\n' scene kind jumps found length right \
    on even beside off idle
for scene in "${scenes[@]}"; do
    name=$(basename "$scene" .pov)
    (cd "$(dirname "$scene")" && "$edge_positions" --out "$out/$name" \
        "$(basename "$scene")" +W320 +H240 Declare=Untextured=1 "$@") ||
        echo "$name failed"
done
