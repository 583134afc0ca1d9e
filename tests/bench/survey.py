#!/usr/bin/env python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""survey.py POVPREVIEW OUT [POV-Ray options and those of povpreview compare]

Asks: how does `mesh` do on every scene that POV-Ray comes with, not on chosen ones? Runs `povpreview
compare` with all methods on each distributed scene, in an order that is the same each time but
shuffled, so that those done so far are a fair choice. Goes on where an earlier run into OUT stopped
(touch OUT/stop to stop it after the scene at hand). Prints the scenes that failed and why; by
quantiles over the others the seconds from the end of the parse to mesh's first picture and to an
error (L1) of .02, and how many times as long each other method took to that, and the best of them;
and the scenes where mesh is behind that one by more than 5 %.
"""
import math, random

from comparisons import EXAMPLES, METHODS, bench, compare, first_pictures, reached

LEVEL = .02
FIRST = 42  # samples of which a first picture is made, as many as are traced in a few milliseconds
QUANTILES = [0, .05, .25, .5, .75, .95, 1]


def run(povpreview, out, options):
    scenes = sorted(EXAMPLES.rglob("*.pov"))
    random.Random(1).shuffle(scenes)
    for scene in scenes:
        folder = out / "_".join(scene.relative_to(EXAMPLES).with_suffix("").parts)
        if (out / "stop").exists():
            break
        if (folder / "messages").exists():
            continue
        code, said = compare(povpreview, scene, ["+W320", "+H240", "--methods", ",".join(METHODS),
                                                 "--time", "3", *options], folder)
        folder.mkdir(exist_ok=True)
        for picture in folder.rglob("*.png"):
            picture.unlink()
        # Last, as it says that the scene is done.
        (folder / "messages").write_text(f"{code}\n{said}")


def read(folder):
    """Of a scene, for each method: seconds to its first picture and to the level."""
    shown = first_pictures(folder, FIRST)
    return {method: (shown.get(method, math.inf), seconds)
            for method, seconds in reached(folder, LEVEL).items()}


def quantiles(what, values):
    values = sorted(values)
    at = [values[round(q * (len(values) - 1))] for q in QUANTILES]
    print(f"{what:<34}" + "".join(f"{v:>8.3g}" for v in at))


def say(out):
    results, failures = {}, []
    for folder in sorted(p.parent for p in out.glob("*/messages")):
        code, _, said = (folder / "messages").read_text().partition("\n")
        if code == "0" and (folder / "curves.csv").exists():
            results[folder.name] = read(folder)
        else:
            lines = [line for line in said.splitlines() if line.strip()]
            failures.append((folder.name, code, lines[-1] if lines else ""))
    print(f"{len(results)} scenes compared, {len(failures)} failed:")
    for name, code, why in failures:
        print(f"  {name}: exit {code}: {why[:150]}")
    both = {name: r for name, r in results.items() if math.isfinite(r["mesh"][1])}
    print(f"{len(results) - len(both)} did not come to L1 {LEVEL} within the time")
    print(f"{'quantiles':<34}" + "".join(f"{100 * q:>7.0f}%" for q in QUANTILES))
    quantiles("mesh: seconds to first picture", [r["mesh"][0] for r in results.values()])
    quantiles(f"mesh: seconds to {LEVEL}", [r["mesh"][1] for r in both.values()])
    for method in METHODS[1:]:
        quantiles(f"{method} over mesh", [r[method][1] / r["mesh"][1] for r in both.values()])
    best = {name: min(r[m][1] for m in METHODS[1:]) / r["mesh"][1] for name, r in both.items()}
    quantiles("best of them over mesh", best.values())
    for name, ratio in sorted(best.items(), key=lambda item: item[1]):
        if ratio < .95:
            print(f"  {name}: {ratio:.2f} ({both[name]['mesh'][1]:.3f} s)")


bench(run, say)
