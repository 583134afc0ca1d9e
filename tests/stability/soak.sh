#!/usr/bin/env bash
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# soak.sh POVPREVIEW [SECONDS [SEED]]: previews at work whose tracers are killed and stopped, and
# which are stopped themselves, at random moments, for so long (default 600 s). Every one must end
# with the very picture of an undisturbed preview. Prints the faults survived and the mean time
# between them; fails at the first that was not, with the seed that repeats the choices.
set -u
povpreview=$(realpath "$1") length=${2:-600} seed=${3:-1}
RANDOM=$seed
work=$(mktemp -d)
pid=
trap '[ -z "$pid" ] || kill -KILL $pid 2>/dev/null; rm -rf "$work"' EXIT
cd "$work" || exit 1

# Scenes that differ in what is sent beside samples: polygons, curved solids, images.
lights='light_source { <5, 8, -6>, 1 area_light x*4, z*4, 17, 17 }'
view='#version 3.7; global_settings { assumed_gamma 1 } camera { location <0, 1, -4> look_at <0, .5, 0> }'
echo "$view $lights plane { y, 0 pigment { checker rgb 1, rgb .3 } } sphere { y, 1 pigment { rgb x } }" >curved.pov
echo "$view $lights box { <-4, -1, -4>, <4, 0, 9> pigment { rgb .8 } } box { <-1, 0, 0>, 1 pigment { rgb x } }
mesh { triangle { <-2, 0, 1>, <2, 0, 1>, <0, 2, 2> } pigment { rgb y } }" >flat.pov
echo "$view $lights plane { y, 0 pigment { image_map { function 64, 64 { pattern { wood scale .2 } } } rotate x*90 } }
box { <-1, 0, 0>, 1 pigment { granite } finish { reflection .3 } }" >images.pov
scenes=(curved flat images)

for scene in "${scenes[@]}"; do
    timeout 300 "$povpreview" +W120 +H90 $scene.pov --headless --output $scene-whole.png >out 2>&1 </dev/null || {
        echo "an undisturbed preview of $scene fails:" && cat out
        exit 1
    }
done

# disturb PROCESS: stops it for up to a second.
disturb() {
    kill -STOP "$1" 2>/dev/null && pause 1 && kill -CONT "$1" 2>/dev/null && stops=$((stops + 1))
}
pause() { sleep "$(printf '%d.%03d' $((RANDOM % $1)) $((RANDOM % 1000)))"; }

kills=0 stops=0 previews=0
begin=$SECONDS
while [ $((SECONDS - begin)) -lt "$length" ]; do
    scene=${scenes[RANDOM % ${#scenes[@]}]}
    rm -f log
    timeout 300 "$povpreview" +W120 +H90 $scene.pov --headless --output soak.png --log log >out 2>&1 </dev/null &
    pid=$!
    # A death before the scene has come ends a preview, rightly: it would come again.
    until grep -qs '"full"' log || ! kill -0 $pid 2>/dev/null; do sleep .02; done
    for ((i = RANDOM % 5; i >= 0; --i)); do
        preview=$(pgrep -P $pid) && tracer=$(pgrep -P "$preview") || break
        case $((RANDOM % 3)) in
        0) kill -KILL "$tracer" 2>/dev/null && kills=$((kills + 1)) ;;
        1) disturb "$tracer" ;;
        2) disturb "$preview" ;;
        esac
        pause 1
    done
    wait $pid
    status=$?
    pid=
    previews=$((previews + 1))
    if [ $status -ne 0 ] || ! cmp -s soak.png $scene-whole.png; then
        echo "not survived: $scene, exit $status, seed $seed, preview $previews, after $((kills + stops)) faults"
        cat out
        exit 1
    fi
done
faults=$((kills + stops))
echo "$previews previews survived $kills deaths and $stops stops of tracer or preview; a fault every" \
    "$(awk -v s=$((SECONDS - begin)) -v n=$faults 'BEGIN { printf "%.1f", n ? s / n : 0 }') s"
