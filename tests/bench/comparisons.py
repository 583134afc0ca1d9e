# SPDX-License-Identifier: AGPL-3.0-or-later
"""For benches that run `povpreview compare`: where scenes are, and what a comparison found out."""
import csv, json, math, os, pathlib, subprocess, sys

EXAMPLES = pathlib.Path("/usr/share/doc/povray/examples")
METHODS = ["mesh", "blocks", "mosaic", "delaunay", "bicubic"]


def scene_path(name):
    """A scene as lists name it: POV-Ray's by folder and name, ours by name alone."""
    return EXAMPLES / name if "/" in name else pathlib.Path(__file__).parents[2] / "scenes" / name


def listed_scenes(file):
    """Of a list, each scene with the POV-Ray options it needs."""
    for line in open(file):
        if line.strip() and not line.startswith("#"):
            scene, *options = line.split()
            yield scene_path(scene), options


def compare(povpreview, scene, options, out):
    """Runs it from the scene's folder, where its own files are. Its exit code and messages."""
    ended = subprocess.run([povpreview, "compare", str(scene), "--out", str(out), *options],
                           cwd=scene.parent, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                           stderr=subprocess.PIPE, text=True)
    return ended.returncode, ended.stderr


def first_pictures(out, samples):
    """For each method, seconds from the end of the parse until so many samples were shown."""
    shown = {}
    for row in csv.DictReader(open(out / "curves.csv")):
        if float(row["full"]) >= samples:
            shown.setdefault(row["method"], float(row["time_s"]))
    return shown


def reached(out, level):
    """For each method, seconds from the end of the parse to an error (L1); inf: not reached."""
    return {r["method"]: math.inf if r["median"] is None else r["median"]
            for r in json.load(open(out / "summary.json"))["reached"]
            if (r["measure"], r["axis"], r["level"]) == ("l1", "time_s", level)}


def bench(run, say):
    """What BENCH POVPREVIEW OUT [options] does: run(povpreview, out, options), unless RESULTS_ONLY is
    in the environment, and say(out)."""
    out = pathlib.Path(sys.argv[2]).resolve()
    out.mkdir(parents=True, exist_ok=True)
    if not os.environ.get("RESULTS_ONLY"):
        run(str(pathlib.Path(sys.argv[1]).resolve()), out, sys.argv[3:])
    say(out)
