"""Processor time of a collision over the number of disks, beside EDMD; drift over processor time, for the time steps of
the other programs. The steps are a table, docs/data/peers.csv; the rest is in docs/data/performance.json."""
import json

import pandas
from matplotlib.ticker import NullFormatter

from ratchet_sieve import origin, plots
from ratchet_sieve.tables import write_csv
from peers import runs

# A line is a program with one step; this project has none. Drifts in m/s, cost: processor time over simulated time.
COLUMNS = ("program", "step", "cost", "drift_a", "error_a", "drift_b", "error_b", "loses_disks", "runs", "origin")

OURS = "#111111"
LOOKS = {runs.OURS: ("this project", OURS, "D"), "chipmunk": ("Chipmunk", plots.COLOURS[0], "o"),
         "box2d": ("Box2D", plots.COLOURS[1], "s"), "lammps": ("LAMMPS, 5 µs", plots.COLOURS[2], "^")}
# Steps that are written beside their points [s], and how far beside [points].
WRITTEN = {"chipmunk": {0.004167: (6, 5), 0.001: (-26, -11), 0.0001: (-4, -13)},
           "box2d": {0.01: (6, 0), 0.004167: (6, 5), 0.000527: (-30, -13), 0.0001: (4, 6)}}
# Keys of performance.json with the number of disks, of this project by the two measurements of processor time.
SIZES = {524: ("engine.fig8.collisions", "edmd.disks_1000"), 10_008: ("engine.disks_1e4.collisions", "edmd.disks_10000"),
         100_004: ("engine.disks_1e5.collisions", "edmd.disks_100000")}


def write(path, taken, about):
    """Of this project without tangential restitution, and of every program and step. @param about date and machine"""
    groups = {}
    for run in taken:
        if run["program"] != runs.OURS or run["row"] == runs.ALIKE_ROW:
            groups.setdefault((run["program"], run["step"]), []).append(run)
    lines = []
    for (program, step), own in groups.items():
        numbers = [step, runs.speed(own), *(number for mean in runs.drift(own) for number in (mean.value, mean.error))]
        lines.append([program, *(None if number is None else f"{number:.4g}" for number in numbers),
                      any(run["lost"] for run in own), len(own), origin.text(about)])
    write_csv(path, COLUMNS, lines)


def number(text):
    return float(text.partition(" ")[0])


def draw_costs(axes, figures):
    """This project's bars have the two measurements as their ends; of EDMD there is one."""
    for disks, (key, edmd) in SIZES.items():
        theirs = number(figures[f"{edmd}.rate"])
        costs = sorted(1.0 / rate for rate in (number(figures[key]), theirs * number(figures[f"{edmd}.times"])))
        middle = sum(costs) / 2.0
        axes.errorbar(disks, middle, costs[1] - middle, fmt="D", color=OURS, capsize=3, markersize=5)
        axes.plot(float(edmd.rpartition("_")[2]), 1.0 / theirs, "o", color=plots.COLOURS[3], markersize=5)
    axes.plot([], [], "D", color=OURS, label="this project; bar: two series of runs")
    axes.plot([], [], "o", color=plots.COLOURS[3], label="EDMD, elastic disks in a plane")
    axes.set(xscale="log", xlabel="disks", ylabel="processor time of a collision, µs", ylim=(0.0, None))
    axes.legend(loc="lower right")


def draw_drifts(axes, points):
    for program, (name, colour, marker) in LOOKS.items():
        own = points[points["program"] == program].sort_values("step")
        axes.errorbar(own["cost"], plots.MM * own["drift_a"], plots.MM * own["error_a"], fmt=marker + "-", color=colour,
                      linewidth=1.0, markersize=5, label=name)
        lost = own[own["loses_disks"]]
        axes.plot(lost["cost"], plots.MM * lost["drift_a"], marker, color=colour, markerfacecolor="white", markersize=5,
                  zorder=3)
        for step, beside in WRITTEN.get(program, {}).items():
            for _, one in own[own["step"] == step].iterrows():
                axes.annotate(f"{1e3 * step:.2g} ms", (one["cost"], plots.MM * one["drift_a"]), fontsize=8,
                              color=colour, xytext=beside, textcoords="offset points")
    ours = points[points["program"] == runs.OURS].iloc[0]
    axes.axhspan(*(plots.MM * (ours["drift_a"] + sign * ours["error_a"]) for sign in (-1.0, 1.0)), color=OURS, alpha=0.2,
                 linewidth=0)
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.plot([], [], "o", color=OURS, markerfacecolor="white", label="open: disks fall through the base")
    axes.set(xscale="log", xlabel="processor seconds per simulated second", ylabel="drift of A, mm/s; bar: its error")
    axes.legend(loc="lower left", fontsize=8)


def draw(data, path):
    """@param data the directory of the two tables"""
    with plots.styled():
        figure, (costs, drifts) = plots.panels(1, 2, (9.6, 3.9), None)
        draw_costs(costs, json.loads((data / "performance.json").read_text(encoding="utf-8")))
        draw_drifts(drifts, pandas.read_csv(data / "peers.csv"))
        figure.tight_layout()
        plots.save(figure, path, svg=False)
