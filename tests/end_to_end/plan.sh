#!/usr/bin/env bash
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# plan.sh POVPREVIEW: what `plan --run` says that was left out took no time of ours and, but for the
# few samples that told it, no rays; what ran is said to have taken what it took.
set -u
povpreview=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
failures=0

head='#version 3.7; global_settings { assumed_gamma 1 } light_source { <3, 5, -4>, 1 }
camera { location <0, 1, -5> look_at <0, .5, 0> }'
echo "$head sphere { <0, 1, 0>, 1 pigment { rgb x } } plane { y, 0 pigment { checker } }" >cheap.pov
# Each ray takes a thousand looks at a pattern.
echo "$head #declare F = function { pattern { granite scale .01 } }
sphere { 0, 20 hollow finish { ambient 1 diffuse 0 }
pigment { function { sum(i, 1, 1000, F(x * i, y, z)) / 1000 } } }" >dear.pov

# stage FILE NAME: "runs|left out RAYS TRACER_S OWN_S" after the run.
stage() {
    sed -n '/^complete/,$p' "$1" |
        sed -nE "s/^$2 +(runs|left out) +[0-9.?]+ ?%? +([0-9]+) +([0-9.]+) +([0-9.]+) .*/\1 \2 \3 \4/p"
}
# expect FILE NAME REGEX
expect() {
    local is
    is=$(stage "$1" "$2")
    if [[ $is =~ ^$3$ ]]; then echo "ok: $1 $2: $is"; else
        echo "FAILED: $1 $2 is '$is', not '$3'"
        cat "$1"
        failures=$((failures + 1))
    fi
}
plan() { timeout 120 "$povpreview" plan "$1.pov" --run +W"$2" +H"$2" +WT2 >"$1" 2>err </dev/null || cat err; }

some='([1-9][0-9]*\.[0-9]+|0\.[0-9]*[1-9][0-9]*)'
plan cheap 140
expect cheap triangulation "left out [1-9][0-9]{1,2} [0-9.]+ 0\.000"
expect cheap lattice "runs [0-9]{5} $some $some"
expect cheap 'outlines by probes' 'left out 0 0\.000 0\.000'
# On a loaded machine the search may begin before the plan is known.
expect cheap 'edges without rays' 'left out 0 0\.000 0\.[0-9]+'
expect cheap 'albedo rays' 'left out [0-9]{1,2} [0-9.]+ 0\.000'
expect cheap 'rising accuracy' 'left out 0 0\.000 0\.000'
plan dear 70
expect dear triangulation "runs [0-9]+ $some $some"
expect dear filling "runs [0-9]+ $some 0\.000"
expect dear 'rising accuracy' 'left out 0 0\.000 0\.000'
expect dear lattice ''
exit $((failures > 0))
