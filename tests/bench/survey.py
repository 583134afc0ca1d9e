#!/usr/bin/env python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""survey.py TIME_TO_L1 OUT [--scenes LIST] [--methods A,B,...] [--seconds S] [--patience S]
          [POV-Ray options]

Asks: how soon does the first method come to an error, on many scenes, and how many times as long do
the others take? The scenes are those of LIST, or all that POV-Ray comes with, in an order that is
the same each time but shuffled, so that those done so far are a fair choice. Each is rendered by
povray (kept in OUT; left out where that takes longer than --patience), then each method previews it
for --seconds from the end of the parse. Prints a line a scene: the seconds of the first method to
its first picture and to errors (L1) of .1, .05, .02, .01 and .005, each followed by how many times
as long the others took ("-": not reached, "ahead": reached where the first was not). Then the
scenes that failed and why, the same by quantiles over the scenes ("block previewer" is the better
of blocks and mosaic, "best" the best of all others), and the scenes where the first method is behind
by more than 5 %.

    survey.py TIME_TO_L1 OUT                                                  every scene
    survey.py TIME_TO_L1 OUT --scenes dear_scenes.txt --seconds 2.5 +W1920 +H1080
    survey.py TIME_TO_L1 OUT --scenes textured_scenes.txt --methods mesh,constrained,blocks,mosaic

Goes on where an earlier run into OUT stopped: what has been measured is not measured again.
"""
import argparse, csv, math, pathlib, random, subprocess

from comparisons import EXAMPLES, METHODS, listed_scenes

QUANTILES = [0, .05, .25, .5, .75, .95, 1]
BEHIND = .95


def arguments():
    usage, _, description = __doc__.partition("\n\n")
    parser = argparse.ArgumentParser(usage=usage, description=description,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("time_to_l1", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--scenes", type=pathlib.Path)
    parser.add_argument("--methods", default=",".join(METHODS))
    parser.add_argument("--seconds", default="1")
    parser.add_argument("--patience", type=float)
    parser.add_argument("options", nargs="*")
    return parser.parse_intermixed_args()


def all_scenes():
    scenes = sorted(EXAMPLES.rglob("*.pov"))
    random.Random(1).shuffle(scenes)
    return [(scene, []) for scene in scenes]


def last_line(text):
    return next((line for line in reversed(text.splitlines()) if line.strip()), "")[:150]


def run(command, folder, patience=None):
    """From the scene's folder, where its own files are. What it prints, and what went wrong."""
    try:
        ended = subprocess.run([str(word) for word in command], cwd=folder, timeout=patience,
                               stdin=subprocess.DEVNULL, capture_output=True, text=True,
                               errors="replace")
    except subprocess.TimeoutExpired:
        return "", f"takes longer than {patience:g} s"
    return ended.stdout, "" if ended.returncode == 0 else last_line(ended.stderr)


def measure(scene, options, result, args):
    """Writes what time_to_l1 printed to `result`. What went wrong."""
    reference, words = result.with_suffix(".png"), [*options, scene.name]
    if not reference.exists():
        unfinished = reference.with_suffix(".tmp.png")
        _, wrong = run(["povray", *words, "-A", "+FN16", "-D", "-P", f"+O{unfinished}"],
                       scene.parent, args.patience)
        if wrong or not unfinished.exists():
            return f"povray: {wrong or 'no picture'}"
        unfinished.rename(reference)
    rows, wrong = run([args.time_to_l1, reference, args.seconds, *args.methods.split(","), "--",
                       *words], scene.parent)
    if not wrong:
        result.write_text(rows)
    return wrong


def read(result):
    """For each method, the seconds to each column of time_to_l1's; inf: not reached."""
    return {row.pop("method"): {column: float(value or "inf") for column, value in row.items()}
            for row in csv.DictReader(open(result))}


def ratio(mine, other):
    """How many times as long the other took."""
    return other / mine if math.isfinite(mine) else 0 if math.isfinite(other) else math.nan


def line(name, times):
    mine, *others = times.values()

    def cell(column):
        words = [f"{mine[column]:.3f}" if math.isfinite(mine[column]) else "-"]
        for value in (ratio(mine[column], other[column]) for other in others):
            words.append("ahead" if value == 0 else f"{value:.2f}" if math.isfinite(value) else "-")
        return " ".join(words)
    return f"{name:<28} | " + " | ".join(cell(column) for column in mine)


def quantiles(what, values):
    values = sorted(values)
    at = [values[round(q * (len(values) - 1))] for q in QUANTILES]
    print(f"  {what:<28}" + "".join(f"{v:>8.3g}" for v in at))


def rivals(methods):
    """What the first method is held against: each other one, and the best of some."""
    groups = {other: [other] for other in methods[1:]}
    for name, those in (("block previewer", ("blocks", "mosaic")), ("best", METHODS[1:])):
        group = [method for method in methods[1:] if method in those]
        if len(group) > 1:
            groups[name] = group
    return groups


def summarise(results, methods):
    mine = methods[0]
    print(f"\n{'quantiles':<30}" + "".join(f"{100 * q:>7.0f}%" for q in QUANTILES))
    for column in next(iter(results.values()))[mine]:
        both = {name: times for name, times in results.items() if math.isfinite(times[mine][column])}
        print(f"{column}: {mine} comes there in {len(both)} of {len(results)}")
        if not both:
            continue
        quantiles(f"seconds of {mine}", [times[mine][column] for times in both.values()])
        for name, group in rivals(methods).items():
            ratios = {scene: ratio(times[mine][column], min(times[other][column] for other in group))
                      for scene, times in results.items()}
            quantiles(f"{name} over {mine}", [ratios[scene] for scene in both])
            behind = sorted((value, scene) for scene, value in ratios.items() if value < BEHIND)
            if len(group) > 1:
                print(f"  behind the {name} by over 5 % in {len(behind)}: " +
                      ", ".join(f"{scene} {value:.2f}" for value, scene in behind))


def main():
    args = arguments()
    args.time_to_l1, args.out = args.time_to_l1.resolve(), args.out.resolve()
    args.out.mkdir(parents=True, exist_ok=True)
    scenes = list(listed_scenes(args.scenes)) if args.scenes else all_scenes()
    results, failures = {}, {}
    for scene, its in scenes:
        name = "_".join(scene.with_suffix("").parts[len(EXAMPLES.parts):]) \
            if scene.is_relative_to(EXAMPLES) else scene.stem
        result = args.out / f"{name}.csv"
        wrong = "" if result.exists() else \
            measure(scene, ["+W640", "+H480", *args.options, *its], result, args)
        if wrong:
            failures[name] = wrong
        else:
            results[name] = read(result)
            print(line(name, results[name]), flush=True)
    print(f"\n{len(results)} scenes measured, {len(failures)} failed:")
    for name, why in failures.items():
        print(f"  {name}: {why}")
    if results:
        summarise(results, args.methods.split(","))


main()
