#!/usr/bin/python3
"""Draws the cost of a collision over the number of disks: this project on one thread and on two, and other programs.

Takes the figures of docs/data/performance.json, which measure_threads.py and compare_peers.py write. The steps of the
other programs find no collisions: their time is divided by those of the same scene in this project.
"""
import argparse
import json
import pathlib
import re

from ratchet_sieve import plots

ROOT = pathlib.Path(__file__).resolve().parent.parent
US_PER_S = 1e6
FIG8 = 524  # disks
LINES = {r"threads\.disks_(\d+)\.one": ("this project, one thread", "#111111", "o-"),
         r"threads\.disks_(\d+)\.two": ("two threads", plots.COLOURS[0], "o-"),
         r"edmd\.disks_(\d+)\.rate": ("EDMD, elastic disks in a plane", plots.COLOURS[1], "s--")}
STEPS = {"chipmunk_0_1ms": "Chipmunk, 0.1 ms", "box2d_0_1ms": "Box2D, 0.1 ms", "lammps": "LAMMPS, 5 µs"}


def number(text):
    return float(text.replace(",", "").partition(" ")[0])


def line(figures, pattern):
    """Numbers of disks, and the cost of a collision [µs]."""
    found = sorted((int(match[1]), 1.0 / number(text)) for key, text in figures.items()
                   if (match := re.fullmatch(pattern, key)))
    return zip(*found)


def steps(figures, program):
    """Cost of a collision of Fig. 8 [µs]."""
    seconds = number(figures["peers.ours.cost"]) * number(figures[f"peers.{program}.times"])
    return US_PER_S * seconds / number(figures["peers.ours.collisions"])


def draw(figures, path):
    with plots.styled():
        figure, axes = plots.panels(1, 1, (6.0, 3.4))
        for pattern, (name, colour, form) in LINES.items():
            axes.plot(*line(figures, pattern), form, color=colour, markersize=5, label=name)
        for program, name in STEPS.items():
            cost = steps(figures, program)
            axes.plot(FIG8, cost, "^", color=plots.COLOURS[2], markersize=6)
            axes.annotate(name, (FIG8, cost), textcoords="offset points", xytext=(9, 0), va="center", fontsize=8,
                          color=plots.COLOURS[2])
        axes.set(xscale="log", yscale="log", xlabel="disks", ylabel="wall time of a collision, µs")
        axes.set_xlim(right=3e5)
        axes.legend(loc="center right")
        plots.save(figure, path, svg=False)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--figures", type=pathlib.Path, default=ROOT / "docs/data/performance.json", metavar="FILE",
                        help="default: docs/data/performance.json")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "docs/images/cost.png", metavar="FILE",
                        help="default: docs/images/cost.png")
    arguments = parser.parse_args()
    draw(json.loads(arguments.figures.read_text(encoding="utf-8")), arguments.out)


if __name__ == "__main__":
    main()
