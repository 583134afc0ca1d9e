#!/usr/bin/env bash
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# time_to_error.sh POVPREVIEW OUT [POV-Ray options and those of povpreview compare]
#
# Asks: how long does each method take to show a picture within a given error of the finished one?
# Runs `povpreview compare` on our scenes and on those of scenes.txt in one go: OUT/report.html shows
# what came of it, and the geometric means are printed last.
set -euo pipefail
povpreview=$1 out=$2
shift 2
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
examples=/usr/share/doc/povray/examples

scenes=("$here"/../../scenes/*.pov)
while read -r scene; do scenes+=("$examples/$scene"); done < <(grep -v '^#' "$here/scenes.txt")
exec "$povpreview" compare "${scenes[@]}" --out "$out" "$@"
