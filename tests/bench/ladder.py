#!/usr/bin/env python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""ladder.py POVPREVIEW OUT [POV-Ray options and those of povpreview compare]

Asks: what is it worth to begin at a low accuracy? Runs `povpreview compare` on each scene of
ladder_scenes.txt, 20 s at most, with mesh rising on its ladder of accuracy, and with all methods at
the target alone, as the others always are. Prints for mesh rising the seconds from the end of the
parse to the first picture (300 samples: the first, regular grid) and to errors (L1) of .05 and .02
against the complete render, and how many times as long mesh at the target and the other methods
took; inf: they did not come to it.

With OUT from an earlier run and RESULTS_ONLY=1 in the environment it only prints.
"""
import math, os, pathlib, sys

from comparisons import METHODS, compare, first_pictures, listed_scenes, reached

FIRST = 300
LEVELS = [.05, .02]


def run(povpreview, out, options):
    for scene, own in listed_scenes(pathlib.Path(__file__).parent / "ladder_scenes.txt"):
        common = ["+W320", "+H240", *own, "--time", "20", *options]
        compare(povpreview, scene, ["--methods", "mesh", *common], out / scene.stem / "rising")
        compare(povpreview, scene, ["--methods", ",".join(METHODS), "--accuracy", "target", *common],
                out / scene.stem / "target")


def say(out):
    print(f"{'scene':<18}{'until':>6}{'rising':>8} | times as long, target alone"
          f"\n{'':<32} |" + "".join(f"{m:>10}" for m in METHODS))
    for scene, _ in listed_scenes(pathlib.Path(__file__).parent / "ladder_scenes.txt"):
        rising, target = (out / scene.stem / way for way in ("rising", "target"))
        rows = [("first", first_pictures(rising, FIRST), first_pictures(target, FIRST))]
        rows += [(str(level)[1:], reached(rising, level), reached(target, level)) for level in LEVELS]
        for until, mine, its in rows:
            seconds = mine.get("mesh", math.inf)
            print(f"{scene.stem:<18}{until:>6}{seconds:>8.2f} |" +
                  "".join(f"{its.get(m, math.inf) / seconds:>10.2f}" for m in METHODS))


def main():
    out = pathlib.Path(sys.argv[2]).resolve()
    out.mkdir(parents=True, exist_ok=True)
    if not os.environ.get("RESULTS_ONLY"):
        run(str(pathlib.Path(sys.argv[1]).resolve()), out, sys.argv[3:])
    say(out)


main()
