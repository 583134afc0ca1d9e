#!/usr/bin/env bash
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# sandboxed_scenes.sh POVPREVIEW: what a scene or an INI file from a stranger tries beyond showing
# a picture does not happen, and POV-Ray's own message tells why; what a scene may need works.
set -u
povpreview=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/project/here" "$work/elsewhere" "$work/library"
cd "$work/project/here" || exit 1
failures=0

report() {
    if [ "$1" = 0 ]; then echo "ok: $2"; else
        echo "FAILED: $2"
        sed 's/^/    /' err
        failures=$((failures + 1))
    fi
}
preview() { timeout 120 "$povpreview" "$@" +W32 +H24 --headless --output x.png >out 2>err </dev/null; }

body='camera { location <0, 1, -4> look_at 0 } light_source { <5, 8, -6>, 1 }
sphere { 0, 1 pigment { rgb <1, .3, .2> } }'
head='#version 3.7; global_settings { assumed_gamma 1.0 }'
echo "$head $body" >good.pov

echo "$head #fopen F \"written.txt\" write #write(F, \"text\") #fclose F $body" >write.pov
preview write.pov
[ $? -eq 1 ] && grep -q 'write access to.*written.txt' err && [ ! -e written.txt ]
report $? "#fopen write is refused by POV-Ray's own message"
grep -q -- '--allow-writing' err && preview write.pov --allow-writing && grep -q text written.txt
report $? "and allowed where the user says so"
rm -f written.txt
echo "$head #fopen F \"$work/elsewhere/a.txt\" append #write(F, \"text\") #fclose F $body" >append.pov
preview append.pov
[ $? -eq 1 ] && [ ! -e "$work/elsewhere/a.txt" ]
report $? "#fopen append is refused"

cat >commands.ini <<INI
Input_File_Name=good.pov
Pre_Scene_Command=touch $work/project/here/ran-before
Pre_Frame_Command=touch $work/project/here/ran-before
Post_Frame_Command=touch $work/project/here/ran-after
Post_Scene_Command=touch $work/project/here/ran-after
INI
preview commands.ini
[ $? -eq 0 ] && [ -s x.png ] && ! ls ran-* >/dev/null 2>&1 && grep -q 'commands.*not run' err
report $? "commands in INI files are not run, and that is said"
timeout 120 "$povpreview" commands.ini +W32 +H24 --headless --finish >out 2>err </dev/null
[ $? -eq 0 ] && [ -s good.png ] && ! ls ran-* >/dev/null 2>&1
report $? "nor with --finish"

echo "$head" >photons.pov
echo "global_settings { photons { spacing .1 save_file \"photons.map\" } } plane { y, -1 pigment { rgb 1 } }
$body sphere { 2*y, .5 pigment { rgbf 1 } interior { ior 1.5 } photons { target refraction on } }" >>photons.pov
preview photons.pov
[ $? -eq 0 ] && [ ! -e photons.map ]
report $? "photons are shot, and not saved"
povray -D -GA +W32 +H24 photons.pov +Ostock.png >/dev/null 2>&1
sed 's/save_file/load_file/' photons.pov >load.pov
preview load.pov
[ $? -eq 0 ]
report $? "photons are loaded"
rm photons.map
preview load.pov
[ $? -eq 1 ] && grep -q 'photon' err
report $? "photons that cannot be loaded are POV-Ray's own error"

echo "$head global_settings { radiosity { count 10 } } $body" >radiosity.pov
preview radiosity.pov +RFO +RFsaved.rca
[ $? -eq 0 ] && [ ! -e saved.rca ] && grep -q 'radiosity file is not saved' err
report $? "radiosity is not saved, and that is said"
povray -D -GA +W32 +H24 radiosity.pov +RFO +RFsaved.rca +Ostock.png >/dev/null 2>&1
preview radiosity.pov +RFI +RFsaved.rca
[ $? -eq 0 ] && [ -s saved.rca ]
report $? "saved radiosity is loaded"

for word in +GAall.txt +GStatistics.txt +GImade.ini; do
    rm -f ./*.txt made.ini
    preview good.pov $word
    [ $? -eq 0 ] && ! ls ./*.txt made.ini >/dev/null 2>&1
    report $? "$word writes no file"
done

echo '#declare Seen = 1;' >"$work/elsewhere/a.inc"
echo "$head #include \"$work/elsewhere/a.inc\" $body" >far.pov
preview far.pov "+L$work/elsewhere"
[ $? -eq 0 ]
report $? "+L opens a folder to the scene"
cp "$work/elsewhere/a.inc" "$work/library"
echo "$head #include \"a.inc\" text { ttf \"crystal.ttf\" \"A\" 1, 0 } $body" >near.pov
preview near.pov "+L$work/library"
[ $? -eq 0 ]
report $? "libraries and fonts are found"
echo '#declare Shared = 1;' >../shared.inc
echo "$head #include \"../shared.inc\" $body" >beside.pov
preview beside.pov
[ $? -eq 0 ]
report $? "what a project's scenes share in the folder above is read"
timeout 120 "$povpreview" +W32 +H24 --headless --log log --output x.png far.pov >out 2>err </dev/null
if grep -q 'no Landlock' log; then echo "skipped: this kernel has no Landlock"; else
    # Its log may not even have begun: the scene is refused.
    grep -q 'a.inc' err && grep -q -- '+L' err
    report $? "a file elsewhere is not read, and +L is named as the remedy"
fi

echo "$head #declare A = array[1000000]; #declare I = 0; #while (I < 1000000) #declare A[I] = array[100]; #declare I = I + 1; #end $body" >glutton.pov
timeout 120 "$povpreview" glutton.pov +W32 +H24 --headless --memory-limit 400 --output x.png >out 2>err </dev/null
code=$?
[ $code -eq 1 ] || [ $code -eq 3 ]
report $? "a scene that wants more memory than it may ends in a message (exit $code)"
preview good.pov --memory-limit 600
report $? "enough memory is enough"

echo "$failures failures"
exit $((failures > 0))
