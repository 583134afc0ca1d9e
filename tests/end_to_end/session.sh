#!/usr/bin/env bash
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# session.sh POVPREVIEW: a run that is killed again and again and gone on with ends in the same
# picture, and what is no session of this scene is refused in one line.
set -u
povpreview=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
failures=0

report() {
    if [ "$1" = 0 ]; then echo "ok: $2"; else
        echo "FAILED: $2"
        sed 's/^/    /' err
        failures=$((failures + 1))
    fi
}

# expect EXIT REGEX ARGUMENTS...: the exit code, and one line on stderr that matches.
expect() {
    local exit=$1 regex=$2 got
    shift 2
    timeout 120 "$povpreview" "$@" >out 2>err </dev/null
    got=$?
    [ $got -eq "$exit" ] && grep -qE -- "$regex" err && [ "$(wc -l <err)" -eq 1 ]
    report $? "exit $exit (got $got) and /$regex/: $*"
}

mkdir parts
echo '#declare Balls = 3;' >parts/number.inc
cat >scene.pov <<'P'
#version 3.7;
global_settings { assumed_gamma 1.0 }
#include "number.inc"
camera { location <0, 1, -4> look_at <0, .5, 0> }
light_source { <5, 8, -6>, 1 area_light x*4, z*4, 25, 25 jitter }
plane { y, 0 pigment { checker rgb 1, rgb .3 } }
#for (I, 1, Balls)
  sphere { <I - 2, 1, I>, .7 pigment { rgb <1, .3, .2> } finish { reflection .3 } }
#end
P
# BMP, since POV-Ray's PNG tells the time.
words=(scene.pov +Lparts +W120 +H90 +A0.1 +R2 --headless --finish +FB)

timeout 200 "$povpreview" "${words[@]}" +Owhole.bmp >out 2>err </dev/null
[ -s whole.bmp ]
report $? "the whole picture at once"

# Killed at ten moments of chance; some come before the first sample, some may come too late.
seed=${SEED:-1}
echo "seed $seed"
RANDOM=$seed
for kill in 1 2 3 4 5 6 7 8 9 10; do
    "$povpreview" "${words[@]}" +Omended.bmp --session s --resume >out 2>err </dev/null &
    pid=$!
    sleep "0.$((RANDOM % 8 + 2))"
    kill -KILL $pid 2>/dev/null
    wait $pid 2>/dev/null
    echo "kill $kill: $(stat -c %s s 2>/dev/null || echo no) bytes kept"
done
timeout 200 "$povpreview" "${words[@]}" +Omended.bmp --session s --resume >out 2>err </dev/null
cmp -s whole.bmp mended.bmp && grep -q 'going on with [1-9]' err
report $? "killed ten times, the same picture"
timeout 200 "$povpreview" "${words[@]}" +Oagain.bmp --session s --resume --log log >out 2>err </dev/null
cmp -s whole.bmp again.bmp
report $? "a complete session gives the picture again"

# Ctrl-C keeps all of it, and says how to go on.
"$povpreview" scene.pov +Lparts +W640 +H480 --headless --output cut.png --session cut >out 2>err </dev/null &
pid=$!
sleep 3
kill -INT $pid
wait $pid
[ $? -eq 130 ] && [ -s cut.png ] && grep -q -- '--session cut --resume' err
report $? "Ctrl-C saves the picture, keeps the session and exits with 130"

plain=(scene.pov +Lparts +W120 +H90 --headless --output x.png)
expect 2 's: .*--resume' "${plain[@]}" --session s
expect 2 'nowhere' "${plain[@]}" --session /nowhere/s
expect 2 'without|made otherwise' "${plain[@]}" Declare=X=1 --session s --resume
expect 2 'size 120 x 90' scene.pov +Lparts +W121 +H90 --headless --session s --resume
expect 2 '--session' "${plain[@]}" --resume
head -c 100 s >short
expect 2 'damaged' "${plain[@]}" --session short --resume
cp scene.pov foreign
expect 2 'no session' "${plain[@]}" --session foreign --resume
cmp -s scene.pov foreign
report $? "what is no session is not touched"
echo '#declare Balls = 4;' >parts/number.inc
expect 2 'number.inc has changed' "${plain[@]}" --session s --resume

echo "$failures failures"
exit $((failures > 0))
