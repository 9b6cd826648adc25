#!/usr/bin/python3
"""Measures what separate() answers and what it costs: several mixtures, each with many seeds, against a dense grid of
runs with fresh seeds.

Writes data/separate.json and the table in separate.md. Each answer takes one core.
"""
import argparse
import json
import pathlib
import statistics
import time
import warnings

import numpy as np

import ratchet_sieve as rs
from ratchet_sieve import documents, origin, stats
from ratchet_sieve.texts import plus_minus, table, two_digits

ROOT = pathlib.Path(__file__).resolve().parent.parent
MARK = "separate-costs"
WITHIN = 0.02
THETA, F = "base.inclination", "base.frequency"
RANGES = {THETA: (0.0, 0.35), F: (15, 48)}
FRESH = 900_000_000  # first seed of the reference, of which no search knows
GRID = {THETA: 15, F: 12}
GRID_SEEDS = 10_000  # between the seeds of its rounds
COLUMNS = {"seeds": "seeds", "cost": "median [s]", "most": "most [s]", "separated": "separated", "near": "within 0.02",
           "held": "held", "lost": "mean loss"}
STAGE = {THETA: 0.25, F: 18.0, "duration": 300.0}  # of each of two stages of glass and rubber
STAGES = "two_stages"


def feeder(*species):
    return rs.Scene({"base": {"teeth": 30}, "boundary": "open", "feed": {"rate": 7.3}, "species": list(species)})


def grains(name, **keys):
    return {"name": name, "radius": 0.002, **keys}


def problems():
    """@return map from the name to the scene, its ranges and what it is in words"""
    beads = rs.Scene.load(ROOT / "config/glass_rubber.yaml")
    fig9 = rs.Scene.load(ROOT / "config/paper_fig9.yaml", {"base.teeth": 40})
    return {
        "glass_rubber": (beads, RANGES, "glass and rubber, fed"),
        "mass": (feeder(grains("light", mass=4e-5), grains("heavy", mass=4e-4)), RANGES, "0.04 g and 0.4 g, fed"),
        "fig9": (fig9, {THETA: (-0.3, 0.3)}, "mixture of Fig. 9, poured"),
        "twins": (feeder(grains("one", mass=4e-5), grains("two", mass=4e-5)), RANGES, "two alike species, fed"),
    }


def reference(scene, settings, duration, seeds, first=FRESH):
    """The separation at some settings, of a fed machine once it has filled, by long runs with fresh seeds."""
    keys = {} if duration is None else {"duration": duration}
    rows = rs.sweep(scene.replace(keys), cases=settings, seeds=(first, seeds), progress=False)
    values = rows.get("steady.separation.value" if scene["feed.rate"] > 0.0 else "separation")
    return [stats.mean_of(part.dropna()) for part in np.array_split(values, len(settings))]


def best_of_grid(scene, over, is_fed):
    """|s| at the best place of a dense grid: its five highest are run again, and the highest of these once more, each
    time with seeds that did not choose it."""
    axes = [np.linspace(*over[key], GRID[key] if len(over) > 1 else 61).round(4) for key in over]
    places = [dict(zip(over, map(float, place))) for place in np.stack(np.meshgrid(*axes), -1).reshape(-1, len(over))]
    length, runs = (600.0, 12) if is_fed else (None, 40)
    for first, kept, duration, seeds in ((1, 5, length and 0.5 * length, 4), (2, 1, length, runs)):
        means = reference(scene, places, duration, seeds, FRESH + first * GRID_SEEDS)
        order = sorted(range(len(places)), key=lambda k: -abs(means[k].value) if means[k] else 0.0)
        places = [places[k] for k in order[:kept]]
    return abs(reference(scene, places, length, 2 * runs, FRESH + 3 * GRID_SEEDS)[0].value)


def timed(call):
    begin = time.process_time()
    found = call()
    return found, time.process_time() - begin


def measure(name, scene, over, seeds):
    """@return the figures of a problem as texts"""
    is_fed = scene["feed.rate"] > 0.0
    best = best_of_grid(scene, over, is_fed) if name != "twins" else 0.0
    costs, lost, held, separated = [], [], 0, 0
    for seed in range(1, seeds + 1):
        answer, cost = timed(lambda: rs.separate(scene, over, within=WITHIN, seed=seed, threads=1, progress=False))
        costs.append(cost)
        separated += answer.separated
        if not answer.separated:
            continue
        true, = reference(scene, [answer.best], 600.0 if is_fed else None, 8 if is_fed else 40)
        lost.append(best - abs(true.value))
        held += abs(true.value - answer.separation.value) < np.hypot(answer.separation.half_width, true.half_width())
        print(name, seed, answer.best, answer.separation, true.text(), f"{cost:.1f} s", flush=True)
    figures = {"best": f"{best:.3f}", "cost": two_digits(statistics.median(costs)), "most": two_digits(max(costs)),
               "separated": f"{separated} of {seeds}", "seeds": f"{seeds}"}
    if name == "twins":
        return {**figures, "lost": "—", "near": "—", "held": "—"}
    return {**figures, "lost": f"{statistics.mean(lost):.3f}", "held": f"{held} of {seeds}",
            "near": f"{sum(each <= WITHIN for each in lost)} of {seeds}"}


def measure_two_stages(scene, seeds):
    """Of two like machines, the second one sieving what leaves the first one to the right: by mass, the purity of glass
    at the far end and that of rubber at the others. @return the figures as texts"""
    def purities(seed):
        first = rs.run(scene.replace(seed=seed))
        second = rs.run(scene.replace(seed=seed + FRESH), feed=first.exits.right)
        for name, rows in (("glass", [*second.exits.right]), ("rubber", [*first.exits.left, *second.exits.left])):
            yield sum(row["mass"] for row in rows if row["species"] == name) / sum(row["mass"] for row in rows)

    found, cost = timed(lambda: [list(purities(seed)) for seed in range(1, seeds + 1)])
    means = [stats.mean_of(column) for column in zip(*found)]
    return {"seeds": f"{seeds}", "cost": two_digits(cost),
            **{name: plus_minus(mean.value, mean.half_width()) for name, mean in zip(("glass", "rubber"), means)}}


def lines_of(path):
    """The table's lines, from the figures of all problems that were measured."""
    figures = json.loads((path.parent / "data" / f"{path.stem}.json").read_text(encoding="utf-8"))
    for name, (_, _, words) in problems().items():
        found = {key: figures.get(f"{name}.{key}", "") for key in COLUMNS}
        if found["cost"]:
            yield [words, *found.values()]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seeds", type=int, default=20, metavar="N", help="of each problem (default: 20)")
    parser.add_argument("--only", nargs="+", metavar="PROBLEM", choices=[*problems(), STAGES],
                        help="measure these alone; the others are kept: " + ", ".join([*problems(), STAGES]))
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "docs", metavar="DIR",
                        help="directory with separate.md (default: docs)")
    options = parser.parse_args()
    path = options.out / "separate.md"
    documents.require_place(parser, path, MARK)
    warnings.simplefilter("ignore", rs.SieveWarning)
    about = origin.describe_physics()
    for name in options.only or [*problems(), STAGES]:
        if name == STAGES:
            scene = rs.Scene.load(ROOT / "config/glass_rubber.yaml", STAGE)
            documents.quote(path, name, measure_two_stages(scene, 48), about)
            continue
        scene, over, _ = problems()[name]
        documents.quote(path, name, measure(name, scene, over, options.seeds), about)
    documents.put(path, MARK, table(["mixture", *COLUMNS.values()], lines_of(path))
                  + f"\n\n{origin.text(about)}.")


if __name__ == "__main__":
    main()
