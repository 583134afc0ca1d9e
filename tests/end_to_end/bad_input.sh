#!/usr/bin/env bash
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# bad_input.sh POVPREVIEW: what a user gets wrong ends in one message with the cause and the
# remedy, and in the right exit code; what the world gets wrong loses nothing.
set -u
povpreview=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
export TMPDIR=$work # where a picture goes that cannot be written where it should
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

cat >good.pov <<'P'
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 1, -4> look_at <0, .5, 0> }
light_source { <5, 8, -6>, 1 }
plane { y, 0 pigment { checker rgb 1, rgb .3 } }
sphere { <0, 1, 0>, 1 pigment { rgb <1, .3, .2> } }
P
# Slow enough to be still at work when it is disturbed.
sed 's/light_source { <5, 8, -6>, 1 }/light_source { <5, 8, -6>, 1 area_light x*4, z*4, 33, 33 }/' good.pov >slow.pov
printf '#version 3.7;\nsphere { <0, 0, 0>, 1\n  pigment { rgb 1 }\n  nonsense\n}\n' >error.pov

expect 1 'error.pov.*line 4' error.pov --headless
expect 2 'missing.pov' missing.pov --headless
expect 2 'scene' --headless
expect 2 'nonsense.*--help' good.pov --nonsense
for size in +W0 +W-5 +W1000000000 +Wabc Height=0 Width=-3; do expect 2 'W|H' "$size" good.pov --headless; done
expect 2 'size' good.pov --headless --size 0x0
expect 2 'nowhere' good.pov --headless --output /nowhere/x.png
expect 2 'nowhere' good.pov --headless --log /nowhere/log
expect 2 'snap' good.pov --headless --snapshots /proc/snap
expect 2 'x.bmp' good.pov --headless --output x.bmp
expect 2 'finish' good.pov --headless --finish --time 3
expect 2 '-F' good.pov --headless --finish -F
expect 2 'stdout' good.pov --headless --finish +O-
expect 2 'nowhere' good.pov --headless --finish +O/nowhere/x.png
expect 2 'memory' good.pov --headless --memory-limit 3
expect 2 'out' compare good.pov
expect 2 'nowhere' compare good.pov --out /proc/nowhere
expect 1 'error.pov.*line 4' compare error.pov --out c

if [ "$(id -u)" -eq 0 ] && mkdir full && mount -t tmpfs -o size=64k tmpfs full 2>/dev/null; then
    expect 2 'full/x.exr' good.pov +W640 +H480 --headless --output full/x.exr
    [ -z "$(ls full)" ]
    report $? "a full disk leaves nothing behind"
    umount full
fi

# Ctrl-C: the picture as it stands is saved, exit 130.
"$povpreview" +W640 +H480 slow.pov --headless --output cut.png >out 2>err </dev/null &
pid=$!
sleep 3
kill -INT $pid
wait $pid
[ $? -eq 130 ] && [ -s cut.png ] && grep -q 'cut.png' err
report $? "Ctrl-C saves the picture and exits with 130"

# A tracer killed while sampling is started again; the picture is the same. That it samples, the log
# tells: a death before that ends the run.
samples_after_deaths() {
    awk -v deaths="$1" '
    /"event".*again/ { ++died; before = full }
    match($0, /"full":[0-9]+/) { full = substr($0, RSTART + 7, RLENGTH - 7) + 0 }
    END { exit !(died + 0 == deaths && full > before + 0) }' log 2>/dev/null
}
"$povpreview" +W160 +H120 slow.pov --headless --output whole.png >out 2>err </dev/null
timeout 120 "$povpreview" +W160 +H120 slow.pov --headless --output mended.png --log log >out 2>err </dev/null &
pid=$!
for deaths in 0 1; do
    for _ in $(seq 600); do
        samples_after_deaths $deaths && break
        sleep .1
    done
    pkill -KILL -P "$(pgrep -P $pid)"
done
wait $pid
[ $? -eq 0 ] && cmp -s whole.png mended.png
report $? "a killed tracer is started again and the picture is the same"
grep -q '"event".*again' log
report $? "the log tells of the killed tracer"

# The tracer dies with the previewer.
"$povpreview" +W640 +H480 slow.pov --headless --output x.png >out 2>err </dev/null &
pid=$!
sleep 2
tracer=$(pgrep -P $pid)
kill -KILL $pid
wait $pid 2>/dev/null
sleep 1
[ -n "$tracer" ] && ! grep -qs '^State:.[^ZX]' "/proc/$tracer/status"
report $? "the tracer dies with the previewer"

# A variable that is set to nothing names no tracer: the one beside the program serves.
POVPREVIEW_TRACER= "$povpreview" +W64 +H48 good.pov --headless --output own.png >out 2>err
[ $? -eq 0 ] && [ -s own.png ]
report $? "an empty POVPREVIEW_TRACER is as good as none"

# No EGL: OSMesa; neither: the packages are named.
__EGL_VENDOR_LIBRARY_FILENAMES=/nowhere "$povpreview" +W64 +H48 good.pov --headless --output osmesa.png >out 2>err
[ $? -eq 0 ] && [ -s osmesa.png ]
report $? "without EGL it draws by OSMesa"

echo "$failures failures"
exit $((failures > 0))
