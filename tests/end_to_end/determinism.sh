#!/usr/bin/env bash
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# determinism.sh POVPREVIEW: the same input gives the same picture, byte for byte: in every run, with
# one tracer thread and many, and the same mesh whatever draws it.
set -u
povpreview=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
failures=0

# Edges, shadows, reflections, a pattern that is drawn and one that is traced, an image.
cat >scene.pov <<'P'
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <1, 2.2, -6> look_at <0, 1, 0> }
light_source { <4, 7, -5>, 1 }
light_source { <-6, 4, -3>, .4 area_light x*2, y*2, 3, 3 }
plane { y, 0 pigment { checker rgb 1, rgb <.2, .3, .5> } }
box { <-1, 0, -1>, <0, 1.6, 0> rotate y * 20 pigment { granite } }
box { <-4, 0, 2>, <4, 4, 2.2> pigment { rgb .05 } finish { reflection .8 } }
sphere { <1.4, .8, 0>, .8 pigment { image_map { function 16, 16 { pattern { wood scale .3 } } map_type 1 } } }
torus { .6, .2 translate <1, .2, -2> pigment { rgb <1, .3, .2> } finish { phong .6 } }
P

# same A B WHAT
same() {
    if [ -s "$1" ] && cmp -s "$1" "$2"; then echo "ok: $3"; else
        echo "FAILED: $3"
        cat out err
        failures=$((failures + 1))
    fi
}
# picture FILE ARGUMENTS...; beside it FILE.log, the counts alone.
picture() {
    timeout 120 "$povpreview" scene.pov +W200 +H150 --headless --output "$1" --log log "${@:2}" >out 2>err </dev/null ||
        rm -f "$1"
    tail -n 1 log | sed -E 's/"(time_s|launch_s|busy)":[^,}]*,?//g' >"$1.log"
}

for samples in 300 3000; do
    picture one-$samples.png --samples $samples +WT1
    picture again-$samples.png --samples $samples +WT1
    same one-$samples.png again-$samples.png "two runs to $samples samples"
    picture many-$samples.png --samples $samples +WT4
    same one-$samples.png many-$samples.png "one thread and four, $samples samples"
    picture osmesa-$samples.png --samples $samples +WT3 --backend osmesa
    same one-$samples.png.log osmesa-$samples.png.log "the same mesh for EGL and OSMesa, $samples samples"
done
picture whole.png
picture whole-beside.png --beside blocks +WT3
same whole.png whole-beside.png "the finished picture, alone and beside another method"

exit $((failures > 0))
