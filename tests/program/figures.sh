#!/usr/bin/env bash
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# figures.sh POVPREVIEW: `figures` writes its pictures, the constrained preview is the better
# one by far, edges of all kinds are found where there are any, and none where the camera is bent.
set -u
povpreview=$1
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

cat >room.pov <<'P'
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { CAMERA location <1, 2.2, -6> look_at <0, 1, 0> }
light_source { <4, 7, -5>, 1 }
box { <-6, -1, -7>, <6, 0, 6> pigment { rgb <.7, .7, .6> } }
box { <-1, 0, -1>, <0, 1.6, 0> rotate y * 20 pigment { rgb <1, .3, .2> } }
box {
  <-4, 0, 2>, <4, 4, 2.2>
  pigment { rgb .05 } finish { reflection .8 }
}
P
sed 's/CAMERA/fisheye angle 90/' room.pov >bent.pov
sed -i 's/CAMERA//' room.pov

cat >tiles.pov <<'P'
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <1, 2.2, -6> look_at <0, 1, 0> }
light_source { <4, 7, -5>, 1 }
plane {
  y, 0
  pigment { image_map { function 16, 16 { pattern { checker scale 1 / 4 } } } rotate x * 90 }
}
sphere { y, 1 pigment { granite scale 2 } }
P

figures() { timeout 120 "$povpreview" figures "$@" >out 2>err </dev/null; }
# error LETTER: the L1 error that its caption tells.
error() { sed -nE "s/^$1: .*L1 ([0-9.]+) .*/\1/p" out; }
samples() { sed -nE "s/^$1: .*[; ]([0-9]+) samples.*/\1/p" out; }
much_better() { awk -v b="$(error b)" -v d="$(error d)" 'BEGIN { exit !(d > 0 && d * 4 < b) }'; }
all_pictures() {
    local name
    for name in "${@:2}" figure; do [ -s "$1/$name.png" ] || return 1; done
}

check "room.pov succeeds" figures room.pov +W160 +H120 --out room --samples 400
check "seven pictures" all_pictures room a b c d e f
check "constraints mend three quarters of the error" much_better
check "about as many samples as asked for" test "$(samples b)" -gt 360 -a "$(samples b)" -lt 440
check "as many samples for both" test "$(samples b)" = "$(samples d)"
check "edges of all kinds" grep -qE '^f: .*[1-9][0-9]* geometric.*[1-9][0-9]* shadow.*[1-9][0-9]* reflection' out
check "no mirrors on request" figures room.pov +W160 +H120 --out room --mirror-depth 0
check "no reflected edges then" grep -qE '^f: .* 0 reflection' out
check "a bent camera succeeds" figures bent.pov +W160 +H120 --out bent
check "a bent camera has no edges" grep -qE '^f: .*[; ]0 geometric.* 0 shadow.* 0 reflection' out
check "figure 2 succeeds" figures tiles.pov +W160 +H120 --out tiles --figure 2 --samples 800
check "nine pictures" all_pictures tiles a b c d e f g h
better_in_the_end() { awk -v f="$(error f)" -v h="$(error h)" 'BEGIN { exit !(h > 0 && h * 2 < f) }'; }
check "refinement mends half of the first error" better_in_the_end
check "figure 2 under a bent camera succeeds" figures bent.pov +W80 +H60 --out bent --figure 2
l1() { awk -F, -v m="$1" '$1 == m { l = $6 } END { print l + 0 }' four/curves.csv; }
ends_exact() { awk -v a="$(l1 blocks)" -v b="$(l1 delaunay)" -v c="$(l1 mesh)" 'BEGIN { exit !(a < 1e-4 && b < 1e-4 && c < 1e-4) }'; }
check "figure 3 succeeds" figures room.pov +W160 +H120 --out three --figure 3
check "three pictures a row" test "$(grep -cE '^[a-l]: (blocks|delaunay|mesh)' out)" = "$(ls three/[a-l].png | wc -l)"
check "its sheet" test -s three/figure.png
check "figure 4 succeeds" figures room.pov +W160 +H120 --out four --figure 4
check "a drawing over time" grep -q '</svg>' four/figure.svg
check "a drawing over rays" grep -q 'rays of all kinds' four/rays.svg
check "its curves end at the finished picture" ends_exact
figures room.pov --out d --figure 5
check "there is no fifth figure" test $? = 2
figures room.pov --out d --figure 3 --samples 100
check "figure 3 knows no number of samples" test $? = 2
figures missing.pov --out d
check "a missing scene is the user's fault" test $? = 2
figures room.pov --out /dev/null/d
check "a folder that cannot be made is the user's fault" test $? = 2

exit $((failures > 0))
