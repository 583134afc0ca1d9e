#!/usr/bin/env bash
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# reference.sh POVPREVIEW SAME_PICTURE: batches of references. What is made equals what povray makes, one by one;
# what has not changed is kept and what has changed never is; failures, interruptions and full disks
# lose nothing else.
set -u
povpreview=$1 same_picture=$2
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
# reference EXIT ARGUMENTS...: whether it ends so.
reference() {
    timeout 120 "$povpreview" reference "${@:2}" >out 2>err </dev/null
    local got=$?
    [ $got -eq "$1" ] || { echo "exit $got, not $1: ${*:2}" >>err && false; }
}
counts() { grep -qE "$1 rendered in .* s, $2 kept, $3 failed" out; }
made() { grep -qE "^ *rendered .*  $1\.(png|exr)" out; }
kept() { grep -qE "^ *kept .*  $1\.(png|exr)" out; }
stock() { povray "$@" -D -P -GA +FN16 -UA File_Gamma=sRGB >/dev/null 2>&1; }

mkdir one two
cat >ball.inc <<'P'
#declare Ball = sphere { <0, 1, 0>, 1 pigment { rgb <1, .3, .2> } }
P
cat >ball.pov <<'P'
#version 3.7;
global_settings { assumed_gamma 1.0 }
// A name that no one can know who does not run the scene.
#include concat("ba", "ll", ".inc")
#ifndef (File) #declare File = "nothing.inc"; #end
#if (file_exists("extra.inc")) #include "extra.inc" #end
camera { location <0, 1 + clock, -4> look_at <0, .5, 0> }
light_source { <5, 8, -6>, 1 }
plane { y, 0 pigment { checker rgb 1, rgb .3 } }
object { Ball }
P
cp ball.pov one/ball.pov
sed 's/rgb \.3/rgb .1/' ball.pov >two/ball.pov
printf '#version 3.7;\nsphere { <0, 0, 0>, 1\n  pigment { rgb 1 }\n  nonsense\n}\n' >error.pov
printf '#while (1) #declare A = 1; #end\n' >endless.pov
# Slow enough to be still at work when it is disturbed.
sed 's/light_source.*/light_source { <5, 8, -6>, 1 area_light x*4, z*4, 65, 65 }/' ball.pov >slow.pov
size="+W48 +H36"

# One by one, and all together.
check "a batch goes on past failures" \
    reference 1 ball.pov error.pov one/ball.pov two/ball.pov missing.pov ball.pov $size --out all
check "three of five rendered, one named twice once" counts 3 0 2
check "POV-Ray's message is passed on" grep -q "error: .*line 4.*nonsense" out
check "a missing file is named" grep -q "missing.pov: there is no such file" out
stock ball.pov $size +Oball.png && stock two/ball.pov $size +Otwo.png
here=$(basename "$work")
check "scenes of one name lie apart" \
    test "$(find all -name '*.png' | wc -l)" -eq 3 -a -s all/one/ball.png -a -s "all/$here/ball.png"
check "the first as povray renders it" $same_picture "all/$here/ball.png" ball.png
check "the second as povray renders it" $same_picture all/two/ball.png two.png
check "the same again fails alike" \
    reference 1 two/ball.pov error.pov ball.pov one/ball.pov missing.pov $size --out all
check "and renders nothing" counts 0 3 2
check "not even what failed" grep -q "nothing has changed" out

# What has changed is rendered, and only that.
check "one alone" reference 0 ball.pov $size --out d
cp d/ball.png before.png
reference 0 ball.pov $size --out d
check "kept" kept ball
sed -i 's/\.3, \.2/.3, .9/' ball.inc
reference 0 ball.pov $size --out d
check "a changed include whose name is computed" made ball
check "shows" test -n "$(cmp before.png d/ball.png 2>&1)"
sed -i 's/\.3, \.9/.3, .2/' ball.inc
reference 0 ball.pov $size --out d
check "changed back" made ball
check "gives the very same file" cmp -s before.png d/ball.png
touch ball.inc ball.pov
reference 0 ball.pov $size --out d
check "touching changes nothing" kept ball
echo 'background { rgb z }' >extra.inc
reference 0 ball.pov $size --out d
check "a file that was looked for in vain and has come" made ball
rm extra.inc
reference 0 ball.pov $size --out d
check "and has gone" made ball
echo >>d/ball.png
reference 0 ball.pov $size --out d
check "a damaged picture" made ball
reference 0 ball.pov $size --out d --engine tracer
check "another engine" made ball
check "the tracer's is the same picture" $same_picture d/ball.png ball.png
reference 0 ball.pov $size --out d --engine tracer
check "the tracer's is kept" kept ball
echo '// more' >>ball.inc
reference 0 ball.pov $size --out d --engine tracer
check "the tracer's depends on its includes" made ball

# Animations and sections.
cat >sizes.ini <<'I'
Antialias=off
[small]
Width=24
Height=18
[large]
Width=32
Height=24
I
check "frames" reference 0 ball.pov +W24 +H18 +KFI9 +KFF10 --out f
check "two frames" counts 2 0 0
stock ball.pov +W24 +H18 +KFI9 +KFF10 +Oframe.png
for n in 09 10; do check "frame $n as povray's" $same_picture f/ball$n.png frame$n.png; done
reference 0 ball.pov +W24 +H18 +KFI9 +KFF10 --out f +SF10 +EF10
check "of a subset, what is there is not kept for other options" counts 1 0 0
check "no frames" reference 1 ball.pov +KFI5 +KFF3 --out f
check "are said to be none" grep -q "no frames from 5 to 3" out
check "sections" reference 0 ball.pov --sections sizes.ini +KFI2 +KFF2 --out s
check "and frames of them" test "$(cd s && echo *.png)" = "ball-large2.png ball-small2.png"
check "a file without sections" reference 2 ball.pov --sections ball.inc --out s
check "is refused" grep -q sections err

# Formats.
sed 's/rgb <1, .3, .2>/rgb <1e9, .3, .2>/' ball.inc >bright.inc
sed 's/concat("ba", "ll", ".inc")/"bright.inc"/; s/^plane.*//' ball.pov >bright.pov
check "EXR" reference 0 bright.pov $size --format exr --out e
check "tells of infinities" grep -qE "bright.exr: [0-9]+ pixels are infinite" out
check "8 bit" reference 0 ball.pov $size --format png8 --out e
check "is 8 bit" test "$(od -An -tu1 -j24 -N1 e/ball.png | tr -d ' ')" = 8
check "the command and the versions are in it" \
    test -n "$(grep -aoE 'POV-Ray 3[0-9.a-z]*, povpreview [0-9.]+' e/ball.png)"

# Time, interruption, death.
check "an endless parse ends" reference 1 endless.pov $size --timeout 1.5 --out t
check "at its time" grep -q "endless: not finished after 1.5 s" out
leftovers() {
    sleep 0.3
    local pid
    for pid in $(pgrep -x povray); do
        [ "$(readlink "/proc/$pid/cwd")" = "$work" ] && return 1
    done
    return 0
}
batch="ball.pov slow.pov +W640 +H480 --jobs 2 --out k"
for signal in INT KILL; do
    "$povpreview" reference $batch >out 2>err </dev/null &
    pid=$!
    for _ in $(seq 600); do [ -s k/ball.png ] && break || sleep 0.1; done
    kill -$signal $pid
    wait $pid 2>/dev/null
    got=$?
    [ $signal = INT ] && check "Ctrl-C gives exit 130" test $got -eq 130
    check "$signal ends the renders" leftovers
    check "$signal leaves no half-made picture" test ! -e k/slow.png -a -z "$(ls k | grep -v png)"
done
reference 1 $batch --timeout 0.5
check "what was done before is kept" kept ball

# Places that cannot be written.
check "no place to write" reference 2 ball.pov $size --out /proc/nowhere
if [ "$(id -u)" -eq 0 ] && mkdir full && mount -t tmpfs -o size=64k tmpfs full 2>/dev/null; then
    check "a full disk" reference 2 ball.pov +W320 +H240 --out full
    check "is named" grep -q "full/ball.png: .*[Nn]o space" err
    check "and leaves nothing half-made" test -z "$(find full -name '*.png*')"
    umount full
fi
check "no scene" reference 2 $size --out n
check "no folder" reference 2 ball.pov

# Slurm: the batch file, and one array of its elements run by hand.
mkdir bin
PATH_BEFORE=$PATH
cat >bin/sbatch <<'S'
#!/bin/sh
for last; do :; done
elements=$(sed -n 's/^#SBATCH --array=0-//p' "$last")
for i in $(seq 0 "$elements"); do SLURM_ARRAY_TASK_ID=$i sh "$last" >>array.log 2>&1; done
echo 4711
S
chmod +x bin/sbatch
if ! command -v sbatch >/dev/null; then
    check "without Slurm" reference 2 ball.pov "two/ball.pov" $size "Declare=Text='it''s'" --out q --slurm
    check "it is said what to do" grep -q "sbatch q/reference.sbatch" err
fi
PATH=$work/bin:$PATH_BEFORE
check "submitted" reference 0 ball.pov two/ball.pov $size +A0.2 --out q --slurm
check "with the job's number" grep -q "as job 4711: 2 pictures" out
PATH=$PATH_BEFORE
reference 0 ball.pov two/ball.pov $size +A0.2 --out q
check "the elements have rendered all" counts 0 2 0

exit $((failures > 0))
