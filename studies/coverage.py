#!/usr/bin/python3
"""Measures whether the intervals of separate() hold: of finished answers, and of answers that were interrupted after
20, 40 and 60 % of the runs, against long steady runs with fresh seeds at the same settings.

Writes data/separate.json and a table in separate.md. A few minutes of one core for each ten answers.
"""
import argparse
import contextlib
import json
import pathlib
import statistics
import tempfile
import warnings

import numpy as np
from separate import FRESH, RANGES, ROOT, THETA, WITHIN, F, best_of_grid

import ratchet_sieve as rs
from ratchet_sieve import documents, origin, stats
from ratchet_sieve.answers.search import Search
from ratchet_sieve.texts import table

MARK = "separate-coverage"
CUTS = (1.0, 0.2, 0.4, 0.6)  # of the runs of the finished answer; 1: that one
DISKS = 4000        # that are fed in a run of the reference
RUNS, MOST = 8, 96  # of the reference at a time, and at most
SURER = 2.0         # the interval over that of the reference, whose error counts as well
COLUMNS = {"seeds": "seeds", "known": "with an interval", "held": "held", "width": "median ±",
           "near": "within 0.02", "lost": "mean loss"}


def fed(*species):
    """A feeder of 0.6 m with disks in equal numbers."""
    return rs.Scene({"base": {"teeth": 30}, "boundary": "open", "feed": {"rate": 10.0},
                     "species": [{"tangential_restitution": 0.4, "inertia_factor": 0.4, **keys} for keys in species]})


def problems():
    """@return map from the name to the scene, its ranges and what it is in words"""
    steel = {"name": "steel", "radius": 0.001, "density": 7800.0, "restitution": 0.93, "friction": 0.11}
    glass = {"name": "glass", "radius": 0.001, "density": 2500.0, "restitution": 0.97, "friction": 0.092}
    flake = {"name": "pet", "radius": 0.0015, "mass": 2.926e-6, "restitution": 0.5, "friction": 0.3,
             "inertia_factor": 0.5, "size": {
                 "distribution": "table", "by": "mass", "mass_exponent": 2, "weights": [0, 8.5, 20.2, 31.8, 27.1, 12.4],
                 "radii": [0.001, 0.00118, 0.0014, 0.001575, 0.001775, 0.002]}}
    bit = {"name": "alu", "radius": 0.0015, "density": 2700.0, "restitution": 0.65, "friction": 0.35,
           "size": {"distribution": "uniform", "spread": 0.3}}
    return {
        "glass_rubber": (rs.Scene.load(ROOT / "config/glass_rubber.yaml"), RANGES, "glass and rubber"),
        "steel_glass": (fed(steel, glass), {THETA: (0.0, 0.35), F: (10, 45)}, "steel and glass of 2 mm"),
        "flakes": (fed(flake, bit), {THETA: (0.0, 0.35), F: (12, 40)}, "flakes of PET and aluminium"),
    }


class Truth:
    """The steady separation at settings, by long runs with fresh seeds, as surely as is asked for."""

    def __init__(self, scene):
        self.scene = scene.replace({"duration": DISKS / scene["feed.rate"]})
        self._values = {}

    def at(self, settings, width):
        """@return a Mean whose interval is narrower than a width, or of MOST runs; None: nothing settles"""
        values = self._values.setdefault(tuple(settings.items()), [])
        while True:
            found = stats.mean_of([value for value in values if np.isfinite(value)])
            if len(values) >= MOST or found and found.count > 2 and found.half_width() < width:
                return found
            rows = rs.sweep(self.scene.replace(settings), seeds=(FRESH + len(values), RUNS), progress=False)
            values += list(rows.get("steady.separation.value", [np.nan] * RUNS))


@contextlib.contextmanager
def interrupted_after(count):
    """Ctrl-C once a search has this many runs. @param count None: never"""
    measure, once = Search.measure, [count]

    def measured(self, *arguments):
        if once[0] is not None and len(self.runs) >= once[0]:
            once[0] = None
            raise KeyboardInterrupt
        measure(self, *arguments)

    Search.measure = measured
    try:
        yield
    finally:
        Search.measure = measure


def answers_of(scene, over, seed, cuts):
    """@return for each part of the runs the answer"""
    runs = None
    with tempfile.TemporaryDirectory() as directory:
        for cut in cuts:
            with interrupted_after(runs and round(cut * runs)):
                # A copy of the runs saves the time of those that are known, and changes no bit.
                answer = rs.separate(scene, over, within=WITHIN, seed=seed, threads=1, progress=False,
                                     results=f"{directory}/runs.db")
            runs = runs or int((answer.runs.seed % 1_000_000 < 500_000).sum())
            yield cut, answer


def measure(name, scene, over, seeds, cuts, best):
    """@return map from the parts of the runs to their figures as texts"""
    truth, found = Truth(scene), {cut: [] for cut in cuts}
    for seed in seeds:
        for cut, answer in answers_of(scene, over, seed, cuts):
            width = answer.separation.half_width
            known = answer.best is not None and width is not None
            true = truth.at(answer.best, max((width or 0.08) / SURER, 0.003)) if answer.best else None
            held = known and true and \
                abs(true.value - answer.separation.value) < np.hypot(width, true.half_width())
            found[cut].append((known, bool(held), width, abs(true.value) if true else 0.0))
            print(name, seed, cut, answer.best, answer.separation, true and true.text(), "held" if held else "",
                  len(answer.runs), *answer.warnings, sep="; ", flush=True)
    return {cut: figures_of(rows, best) for cut, rows in found.items()}


def figures_of(rows, best):
    known, held, widths, values = zip(*rows)
    lost = [best - value for value in values] if best else []
    return {"seeds": f"{len(rows)}",
            "known": f"{sum(known)} of {len(rows)}", "held": f"{sum(held)} of {sum(known)}",
            "width": f"{statistics.median([w for w, k in zip(widths, known) if k] or [0.0]):.2g}",
            "near": f"{sum(each <= WITHIN for each in lost)} of {len(rows)}" if lost else "—",
            "lost": f"{statistics.mean(lost):.3f}" if lost else "—"}


def lines_of(path):
    figures = json.loads((path.parent / "data" / f"{path.stem}.json").read_text(encoding="utf-8"))
    for name, (_, _, words) in problems().items():
        for cut in CUTS:
            found = [figures.get(f"coverage_{name}.{100 * cut:.0f}.{key}", "") for key in COLUMNS]
            if all(found):
                yield [words, "finished" if cut == 1.0 else f"{100 * cut:.0f} % of the runs", *found]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seeds", type=int, default=20, metavar="N", help="of each mixture (default: 20)")
    parser.add_argument("--first", type=int, default=1, metavar="SEED", help="the first of them (default: 1)")
    parser.add_argument("--only", nargs="+", metavar="MIXTURE", choices=problems(), default=list(problems()),
                        help="measure these alone; the others are kept: " + ", ".join(problems()))
    parser.add_argument("--finished", action="store_true", help="measure no interrupted answers")
    parser.add_argument("--grid", action="store_true", help="measure the best of a dense grid as well")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "docs", metavar="DIR",
                        help="directory with separate.md (default: docs)")
    options = parser.parse_args()
    path = options.out / "separate.md"
    documents.require_place(parser, path, MARK)
    warnings.simplefilter("ignore", rs.SieveWarning)
    about = origin.describe_physics()
    for name in options.only:
        scene, over, _ = problems()[name]
        best = best_of_grid(scene, over, True) if options.grid else None
        print(name, "best of the grid:", best, flush=True)
        found = measure(name, scene, over, range(options.first, options.first + options.seeds),
                        CUTS[:1] if options.finished else CUTS, best)
        figures = {f"{100 * cut:.0f}.{key}": text for cut, each in found.items() for key, text in each.items()}
        documents.quote(path, f"coverage_{name}", {**figures, **({"best": f"{best:.3f}"} if best else {})}, about)
    documents.put(path, MARK, table(["mixture", "answer", *COLUMNS.values()], lines_of(path))
                  + f"\n\n{origin.text(about)}.")


if __name__ == "__main__":
    main()
