#!/usr/bin/env bash
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# compare.sh POVPREVIEW: `compare` measures all methods against the stock POV-Ray, whose own
# mosaic ends at the reference; what it writes is consistent; a scene at fault does not keep the
# others from being compared.
set -u
povpreview=$1
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
failures=0

check() {
    if "${@:2}"; then echo "ok: $1"; else
        echo "FAILED: $1"
        sed 's/^/    /' out err
        failures=$((failures + 1))
    fi
}

mkdir scenes
cat >scenes/ball.pov <<'P'
#version 3.7;
global_settings { assumed_gamma ASSUMED }
#include "camera.inc"
light_source { <4, 7, -5>, 1 }
plane { y, 0 pigment { checker rgb .3, rgb .8 } }
sphere { y, 1 pigment { rgb <.9, .3, .2> } finish { phong .5 } }
P
echo 'camera { location <1, 2.2, -6> look_at <0, 1, 0> }' >scenes/camera.inc
sed 's/ASSUMED/2.2/' scenes/ball.pov >scenes/curved.pov
sed -i 's/ASSUMED/1/' scenes/ball.pov
sed 's/^sphere/sphare/' scenes/ball.pov >scenes/broken.pov

compare() { timeout 200 "$povpreview" compare "$@" >out 2>err </dev/null; }
rows() { awk -F, -v m="$1" -v r="$2" 'NR > 1 && $2 == m && $3 == r' "$3/curves.csv"; }
# last_l1 SCENE METHOD DIR: its L1 error in the end.
last_l1() { awk -F, -v s="$1" -v m="$2" '$1 == s && $2 == m { l = $14 } END { print l }' "$3/curves.csv"; }
exact() { awk -v l="$(last_l1 "$@")" 'BEGIN { exit !(l != "" && l < 1e-4) }'; }
spread() { [ -n "$(rows mesh 1 "$1")" ] && [ -n "$(rows mesh 2 "$1")" ] && [ -n "$(rows stock-mosaic 2 "$1")" ]; }
one_file() { # no address that leads out of the file
    ! grep -oE '(src|href)="[^"]{0,20}' "$1" | grep -vE 'src="data:|href="#' | grep -q .
}

# From another folder than the scenes': camera.inc must be found beside them.
check "two scenes, twice" compare +W80 +H60 scenes/ball.pov scenes/curved.pov \
    --methods mesh,blocks,stock-mosaic --repeat 2 --out twice
check "every run has its rows" spread twice
for scene in ball curved; do
    check "$scene: the stock mosaic ends at the reference" exact $scene stock-mosaic twice
    check "$scene: so does mesh" exact $scene mesh twice
done
check "every number follows from the curves" python3 "$here/recompute_summary.py" twice
check "the report needs no other file" one_file twice/report.html
check "the report has curves and pictures of both" test \
    "$(grep -c 'class="plots"' twice/report.html)" = 2 -a \
    "$(grep -o 'data:image/svg+xml' twice/report.html | wc -l)" = 8
check "memory is measured" awk -F, '$2 == "mesh" && $13 > 5 { n++ } END { exit !n }' twice/curves.csv
check "costs are measured" awk -F, '$2 == "mesh" && $10 > 0 { n++ } END { exit !n }' twice/curves.csv
before=$(stat -c %Y twice/ball/reference.png)
check "again, one core" compare +W80 +H60 scenes/ball.pov --methods mesh,mosaic --threads 1 --out twice
check "the reference is reused" test "$(stat -c %Y twice/ball/reference.png)" = "$before"
check "with a single scene too" python3 "$here/recompute_summary.py" twice

compare +W40 +H30 scenes/broken.pov scenes/ball.pov --methods mesh --out broken
check "a broken scene makes it 1" test $? = 1
check "its message is passed on" grep -q 'broken: .*[Pp]arse [Ee]rror' err
check "the other one is compared" exact ball mesh broken
check "the report says what is left out" grep -q 'Left out: broken' broken/report.html
compare scenes/ball.pov --out /dev/null/d
check "a folder that cannot be made is the user's fault" test $? = 2
compare scenes/missing.pov --out d
check "so is a missing scene" test $? = 2
compare scenes/ball.pov --threads 500 --out d
check "so are more cores than there are" test $? = 2

exit $((failures > 0))
