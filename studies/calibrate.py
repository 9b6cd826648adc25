#!/usr/bin/python3
"""Measures how often the intervals of calibrate() hold, how wide they are and what they cost: feeders whose
coefficients are drawn are measured by runs, and calibrated from what was counted alone.

Writes data/calibrate.json and the table in calibrate.md. Each calibration takes one core.
"""
import argparse
import json
import pathlib
import statistics
import tempfile
import warnings

import numpy as np

import ratchet_sieve as rs
from ratchet_sieve import documents, origin, stats
from ratchet_sieve.answers.unknown import Prior
from ratchet_sieve.texts import table, two_digits

ROOT = pathlib.Path(__file__).resolve().parent.parent
MARK = "calibrate-coverage"
THETA, F, AMPLITUDE = "base.inclination", "base.frequency", "base.amplitude"
SETTINGS = [{THETA: 0.0}, {THETA: 0.1}, {THETA: 0.2}, {THETA: 0.1, F: 35.0}]  # each of 120 s, some 800 grains
SLOW = {THETA: 0.1, F: 16.0}  # near where grains pile up: tells of the amplitude
E, MU, BETA = "restitution", "friction", "tangential_restitution"
SYMBOLS = {E: "e", MU: "μ", BETA: "β", "amplitude": "amplitude"}
RANGES = {E: (0.7, 0.99), MU: (0.05, 0.5), BETA: (0.2, 0.7)}
ONE = {f"species.0.{name}": ends for name, ends in RANGES.items()}
TWO = {**ONE, f"species.1.{E}": RANGES[E], f"species.1.{MU}": RANGES[MU]}
FRESH = 800_000_000  # first seed of measurements, of which no calibration knows
WRONG = 1.1          # of the amplitude
SEPARATED = "two"    # the problem whose grains are then separated
OVER, WITHIN, OWN = {THETA: (0.0, 0.35)}, 0.04, {THETA: 0.1}
COLUMNS = {"truths": "feeders", "agree": "agree", "held": "intervals that hold", "half": "median ±",
           "cost": "cost [s]", "separated": "s within its spread"}


def feeder(*species):
    kinds = [{"name": name, "radius": radius, "density": density, "inertia_factor": 0.4}
             for name, radius, density in species]
    return rs.Scene({"base": {"teeth": 30, "frequency": 20.0}, "boundary": "open", "feed": {"rate": 7.3},
                     "species": kinds, "duration": 120.0})


def measured(scene, settings, seed):
    """What is counted of a feeder at some settings."""
    rows = rs.sweep(scene, cases=[{**setting, "seed": seed + k} for k, setting in enumerate(settings)], progress=False)
    found = []
    for setting, (_, row) in zip(settings, rows.iterrows()):
        counts = {f"{place}.{name}": int(row[f"{place}.{name}"]) for name in scene.species
                  for place in ("left", "right")}
        found.append({**setting, **counts, **{f"on_base.{name}": int(
            row[f"count.{name}"] - row[f"left.{name}"] - row[f"right.{name}"]) for name in scene.species}})
    return found


def problems():
    """@return map from the name to the feeder, what is unknown, what the calibration does not know, further settings,
    and words"""
    one, two = feeder(("A", 0.0015, 2500)), feeder(("A", 0.001, 2500), ("B", 0.0015, 1100))
    return {"one": (one, ONE, {}, [], "three coefficients of one species"),
            "two": (two, TWO, {}, [], "five of two species"),
            "amplitude": (one, {**ONE, AMPLITUDE: (0.0016, 0.0024)}, {}, [SLOW], "three, and the amplitude"),
            "wrong": (one, ONE, {AMPLITUDE: WRONG * 0.002}, [SLOW], "three; the amplitude is 10 % wrong")}


def is_within_spread(scene, grains, truth):
    """Whether the separation of the true grains, at the place that is best for those that they may be, is in the stated
    spread."""
    answer = rs.separate(grains, OVER, within=WITHIN, threads=1, progress=False)
    rows = rs.sweep(scene.replace({**truth, "duration": 600.0}), cases=[answer.best or OWN], seeds=(FRESH, 6),
                    progress=False)
    true = stats.mean_of(rows["steady.separation.value"].dropna())
    value, half = answer.separation.value, answer.separation.half_width
    low, high = answer.spread or (value - half, value + half)
    print("   s", answer.best, f"{low:.3f} to {high:.3f}", true.text(), f"{answer.cost.processor:.0f} s", flush=True)
    return low - true.half_width() <= true.value <= high + true.half_width()


def measure(name, feeders, results):
    """@param results file that keeps the first runs, which are the same for all but the first feeder, whose calibration
    tells the cost @return the figures as texts"""
    scene, unknown, hidden, more, _ = problems()[name]
    drawn = Prior(scene, unknown).values(np.random.default_rng(1).random((feeders, len(unknown))))
    found, within = [], 0
    for k, values in enumerate(drawn):
        truth = dict(zip(unknown, map(float, values)))
        counted = measured(scene.replace({**truth, **hidden}), SETTINGS + more, FRESH + 100 * k)
        grains = rs.calibrate(scene, unknown, counted, threads=1, results=results if k else None, progress=False)
        cost = cost if k else grains.cost.processor
        print(name, k, truth, grains, sep="\n", flush=True)
        if grains.agrees:
            found.append([(grains[key].half_width, abs(grains[key].value - value)) for key, value in truth.items()])
            within += name == SEPARATED and is_within_spread(scene, grains, truth)

    def of_each(text):
        return "—" if not found else ", ".join(
            f"{SYMBOLS[key.rpartition('.')[2]]} {text(of_key)}" for key, of_key in zip(unknown, zip(*found)))

    return {"truths": f"{feeders}", "agree": f"{len(found)}", "cost": two_digits(cost),
            "held": of_each(lambda of_key: sum(away <= half for half, away in of_key)),
            "half": of_each(lambda of_key: f"{statistics.median(half for half, _ in of_key):.2g}"),
            "separated": f"{within}" if name == SEPARATED else "—"}


def lines_of(path):
    """The table's lines, of all problems that were measured."""
    figures = json.loads((path.parent / "data" / f"{path.stem}.json").read_text(encoding="utf-8"))
    return [[words, *(figures[f"{name}.{key}"] for key in COLUMNS)] for name, (*_, words) in problems().items()
            if f"{name}.truths" in figures]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--feeders", type=int, default=20, metavar="N", help="of each problem (default: 20)")
    parser.add_argument("--only", nargs="+", metavar="PROBLEM", choices=problems(),
                        help="measure these alone; the others are kept: " + ", ".join(problems()))
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "docs", metavar="DIR",
                        help="directory with calibrate.md (default: docs)")
    options = parser.parse_args()
    warnings.simplefilter("ignore", rs.SieveWarning)
    path = options.out / "calibrate.md"
    documents.require_place(parser, path, MARK)
    about = origin.describe_physics()
    for name in options.only or problems():
        with tempfile.TemporaryDirectory() as folder:
            found = measure(name, options.feeders, pathlib.Path(folder) / "first.db")
        documents.quote(path, name, found, about)
    documents.put(path, MARK, table(["unknown", *COLUMNS.values()], lines_of(path)) + f"\n\n{origin.text(about)}.")


if __name__ == "__main__":
    main()
