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
import math, pathlib, sys

from comparisons import METHODS, bench, compare, first_pictures, listed_scenes, reached

SCENES = list(listed_scenes(pathlib.Path(__file__).parent / "ladder_scenes.txt"))
FIRST = 300
LEVELS = [.05, .02]


def run(povpreview, out, options):
    ways = {"rising": ["--methods", "mesh"],
            "target": ["--methods", ",".join(METHODS), "--accuracy", "target"]}
    for scene, own in SCENES:
        for way, its in ways.items():
            common = ["+W320", "+H240", *own, "--time", "20", *options]
            code, said = compare(povpreview, scene, [*its, *common], out / scene.stem / way)
            if code:
                print(said, end="", file=sys.stderr)


def say(out):
    print(f"{'scene':<18}{'until':>6}{'rising':>8} | times as long, target alone"
          f"\n{'':<32} |" + "".join(f"{m:>10}" for m in METHODS))
    for scene, _ in SCENES:
        rising, target = (out / scene.stem / way for way in ("rising", "target"))
        if not all((folder / "summary.json").exists() for folder in (rising, target)):
            print(f"{scene.stem:<18}  failed")
            continue
        rows = [("first", first_pictures(rising, FIRST), first_pictures(target, FIRST))]
        rows += [(str(level)[1:], reached(rising, level), reached(target, level)) for level in LEVELS]
        for until, mine, its in rows:
            seconds = mine.get("mesh", math.inf)
            print(f"{scene.stem:<18}{until:>6}{seconds:>8.2f} |" +
                  "".join(f"{its.get(m, math.inf) / seconds:>10.2f}" for m in METHODS))


bench(run, say)
