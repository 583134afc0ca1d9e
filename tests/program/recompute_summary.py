#!/usr/bin/env python3
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# recompute_summary.py DIR: recomputes every number of DIR/summary.json from DIR/curves.csv, and
# fails if one is off. Shows how little is needed to follow a comparison's figures.
import csv, json, math, statistics, sys

rows = list(csv.DictReader(open(sys.argv[1] + "/curves.csv")))
summary = json.load(open(sys.argv[1] + "/summary.json"))
runs = {}
for row in rows:
    p = {k: v if k in ("scene", "method") else float(v) for k, v in row.items()}
    p["rays"] = p["full"] + p["probe"] + p["albedo"]
    runs.setdefault((p["scene"], p["method"]), {}).setdefault(p["repeat"], []).append(p)


def crossing(run, x, e, level):
    run = [p for p in run if p[x] > 0]
    i = len(run)
    while i > 0 and run[i - 1][e] <= level: i -= 1
    if i == len(run): return math.inf
    if i == 0: return run[0][x]
    a, b = run[i - 1], run[i]
    share = math.log(a[e] / level) / math.log(a[e] / max(b[e], 1e-6))
    return a[x] * (b[x] / a[x]) ** share


rounding = 2e-4  # by the digits that the curves have


def check(record, name, value):
    global checked
    checked += 1
    said = record[name] if record[name] is not None else math.inf
    if not (said == value or abs(said - value) <= rounding * abs(value) + 1e-6):
        sys.exit(f"{name} of {record} is {value} by the curves")


def check_sooner(record, name, pairs):
    """In how many pairs the first is sooner by over 5 %; the curves' digits leave open a pair at the border."""
    least, most = (sum(a * 1.05 * (1 + r) < b for a, b in pairs) for r in (rounding, -rounding))
    check(record, name, min(max(record[name], least), most))


checked = 0
medians = {}
for r in summary["reached"]:
    at = [crossing(run, r["axis"], r["measure"], r["level"]) for run in runs[r["scene"], r["method"]].values()]
    key = r["measure"], r["axis"], r["level"]
    medians[key, r["scene"], r["method"]] = median = statistics.median(at)
    check(r, "median", median)
    check(r, "least", min(at))
    check(r, "greatest", max([t for t in at if t < math.inf], default=math.inf))
    check(r, "reached", sum(t < math.inf for t in at))
    check(r, "repeats", len(at))
    first = medians[key, r["scene"], summary["reached"][0]["method"]]
    check(r, "ratio", median / first if median < math.inf and first < math.inf else math.inf)
for m in summary["means"]:
    key = m["measure"], m["axis"], m["level"]
    pairs = [(medians[key, s, summary["reached"][0]["method"]], medians[key, s, m["method"]])
             for s in dict.fromkeys(r["scene"] for r in summary["reached"])]
    both = [math.log(b / a) for a, b in pairs if a < math.inf and b < math.inf]
    check(m, "scenes", len(both))
    check(m, "geometric_mean", math.exp(sum(both) / len(both)) if both else math.inf)
    check_sooner(m, "wins", pairs)
    check_sooner(m, "losses", [(b, a) for a, b in pairs])
    check(m, "ties", sum(min(a, b) < math.inf for a, b in pairs) - m["wins"] - m["losses"])
for t in summary["totals"]:
    last = [run[-1] for run in runs[t["scene"], t["method"]].values()]
    for name in t:
        if name not in ("scene", "method"):
            check(t, name, statistics.median(p[name] for p in last))
print(checked, "numbers follow from the curves")
