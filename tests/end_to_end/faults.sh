#!/usr/bin/env bash
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# faults.sh POVPREVIEW: what the world does to a preview at work ends in the right picture, or in one
# clear error with what was traced so far saved. (bad_input.sh has what is wrong from the start.)
set -u
povpreview=$1
work=$(mktemp -d)
pid=
trap '[ -z "$pid" ] || kill -KILL $pid 2>/dev/null; umount "$work/small" 2>/dev/null; rm -rf "$work"' EXIT
cd "$work" || exit 1
export TMPDIR=$work/tmp
mkdir tmp
failures=0

report() {
    if [ "$1" = 0 ]; then echo "ok: $2"; else
        echo "FAILED: $2"
        sed 's/^/    /' err
        failures=$((failures + 1))
    fi
}

# Slow enough to be still at work when it is disturbed.
cat >slow.pov <<'P'
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 1, -4> look_at <0, .5, 0> }
light_source { <5, 8, -6>, 1 area_light x*4, z*4, 17, 17 }
plane { y, 0 pigment { checker rgb 1, rgb .3 } }
sphere { <0, 1, 0>, 1 pigment { rgb <1, .3, .2> } }
P

# start ARGUMENTS...: begins a preview and waits until it samples; its process is $pid.
start() { start_shown --headless "$@"; }
start_shown() {
    rm -f log
    "$povpreview" slow.pov --log log "$@" >out 2>err </dev/null &
    pid=$!
    for _ in $(seq 600); do
        grep -qs '"full"' log && return
        sleep .1
    done
}
# ended EXIT: waits for its end, a minute at most.
ended() {
    for _ in $(seq 600); do
        kill -0 $pid 2>/dev/null || break
        sleep .1
    done
    wait $pid
    local got=$?
    pid=
    [ $got -eq "$1" ]
}

timeout 120 "$povpreview" +W120 +H90 slow.pov --headless --output whole.png >out 2>err </dev/null
report $? "an undisturbed preview"

start +W120 +H90 --output paused.png
tracer=$(pgrep -P $pid)
kill -STOP "$tracer"
sleep 1
kill -CONT "$tracer"
ended 0 && cmp -s whole.png paused.png
report $? "a tracer that is stopped for a second loses nothing"

start +W120 +H90 --output slept.png --stall-timeout 2
kill -STOP $pid
sleep 3
kill -CONT $pid
ended 0 && cmp -s whole.png slept.png
report $? "a preview that is stopped for longer than a stall may last loses nothing"

start +W640 +H480 --output stalled.png --stall-timeout 1
kill -STOP "$(pgrep -P $pid)"
ended 3 && grep -q 'stall-timeout' err && [ -s stalled.png ]
report $? "a tracer that is stopped for good is given up, and what was traced is saved"

start +W640 +H480 --output starved.png
prlimit --pid "$(pgrep -P $pid)" --cpu=1
ended 0 || { [ $? -ne 0 ] && [ -s starved.png ] && [ "$(grep -c . err)" -le 3 ]; }
report $? "a tracer that may not go on ends in a picture"

mkdir gone
start +W120 +H90 --output gone/x.png
rm -r gone
ended 2 && saved=$(sed -n 's/.*the picture is in \(.*\) instead.*/\1/p' err) && cmp -s whole.png "$saved"
report $? "where the folder is gone, the picture goes elsewhere"

if [ "$(id -u)" -eq 0 ] && mkdir small && mount -t tmpfs -o size=8k tmpfs small 2>/dev/null; then
    start +W120 +H90 --output small/x.png
    ended 2 && saved=$(sed -n 's/.*the picture is in \(.*\) instead.*/\1/p' err) && cmp -s whole.png "$saved"
    report $? "where the disk is full, the picture goes elsewhere"
    "$povpreview" +W640 +H480 slow.pov --headless --log small/log --output logged.png >out 2>err </dev/null &
    pid=$!
    until grep -qs full small/log || ! kill -0 $pid; do sleep .1; done
    head -c 100k /dev/zero >small/filler 2>/dev/null
    ended 2 && grep -q 'log' err && [ -s logged.png ]
    report $? "where the log cannot go on, what was traced is saved"
    umount small
fi

# Too little memory, from less than a start takes to nearly enough: an error, no crash, above all not
# in the libraries that draw and write pictures (at 300, 390, 600 and 1000 MiB).
for mib in 40 300 390 600 1000 1680 1700 1750; do
    (ulimit -v $((mib * 1024)) && exec timeout 60 "$povpreview" +W120 +H90 slow.pov --headless --output tight.png) \
        >out 2>err </dev/null
    got=$?
    [ $got -eq 0 ] || { [ $got -eq 2 ] && grep -q 'ulimit -v' err; }
    report $? "$mib MiB of address space: exit $got"
done

DISPLAY=:987 WAYLAND_DISPLAY= timeout 120 "$povpreview" +W120 +H90 slow.pov --output shown.png >out 2>err </dev/null
[ $? -eq 0 ] && grep -q 'without a window' err && cmp -s whole.png shown.png
report $? "where the display refuses, the preview goes on without"

if command -v Xvfb >/dev/null; then
    Xvfb -displayfd 3 3>display >/dev/null 2>&1 &
    server=$!
    until [ -s display ] || ! kill -0 $server 2>/dev/null; do sleep .05; done
    DISPLAY=:$(cat display) WAYLAND_DISPLAY= start_shown +W120 +H90 --output left.png
    kill -KILL $server
    ended 0 && grep -q 'display is gone' err && cmp -s whole.png left.png
    report $? "where the display goes away, the preview goes on without"
fi

echo "$failures failures"
exit $((failures > 0))
