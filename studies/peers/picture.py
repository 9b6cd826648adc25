"""Drift over processor time, for the time steps of the other programs. The points are a table, docs/data/peers.csv."""
import pandas
from matplotlib.ticker import NullFormatter

from ratchet_sieve import origin, plots
from ratchet_sieve.tables import write_csv
from ratchet_sieve.texts import span
from labels import place as write_labels
from peers import runs

ALIKE = "β = 0 "  # in the row of this project's run without tangential restitution, which the others do not have either
# A line is a program with one step; this project has none. Drifts in m/s, cost: processor time over simulated time.
COLUMNS = ("program", "step", "cost", "drift_a", "error_a", "drift_b", "error_b", "loses_disks", "runs", "origin")

MS = 1e3  # per s
# The steps that are written beside their points [ms]; all of them would overlap.
LOOKS = {"chipmunk": ("Chipmunk", plots.COLOURS[0], "o", (17, 10, 4.2, 2, 1, 0.1, 0.03)),
         "box2d": ("Box2D", plots.COLOURS[1], "s", (10, 4.2, 0.53, 0.1, 0.03)),
         "lammps": ("LAMMPS", plots.COLOURS[2], "^", (0.005,))}
OURS = "#111111"
PANELS = {"a": "A (1 mm, 10 g)", "b": "B (2 mm, 1 g)"}
CLIP = (-5.0, 75.0)  # drifts beyond are drawn at the edge [mm/s]


def write(path, taken, about):
    """Of this project without tangential restitution, and of every program and step. @param about date and machine"""
    groups = {}
    for run in taken:
        if run["program"] != runs.OURS or ALIKE in run["row"]:
            groups.setdefault((run["program"], run["step"]), []).append(run)
    lines = []
    for (program, step), own in groups.items():
        numbers = [step, runs.speed(own), *(number for mean in runs.drift(own) for number in (mean.value, mean.error))]
        lines.append([program, *(None if number is None else f"{number:.4g}" for number in numbers),
                      any(run["lost"] for run in own), len(own), origin.text(about)])
    write_csv(path, COLUMNS, lines)


def seeds(points):
    return f"n = {span(sorted(points['runs'].unique()))}"


def draw_program(axes, points, program, species):
    """The finest step first. @return the places of the points, and the labels: triples (place, text, colour)"""
    name, colour, marker, written = LOOKS[program]
    own = points[points["program"] == program].sort_values("step", kind="stable")
    if not len(own):
        return [], []
    drifts = (plots.MM * own[f"drift_{species}"]).clip(*CLIP)
    axes.errorbar(own["cost"], drifts, plots.MM * own[f"error_{species}"].fillna(0.0), color=colour, linewidth=1.0,
                  elinewidth=1.0, zorder=2)
    for cost, drift, loses in zip(own["cost"], drifts, own["loses_disks"]):
        axes.plot(cost, drift, marker, color=colour, markersize=5, zorder=3,
                  markerfacecolor="white" if loses else colour, label="_")
    axes.plot([], [], marker + "-", color=colour, markersize=5, label=f"{name} ({seeds(own)})")
    places = list(zip(own["cost"], drifts))
    steps = [float(f"{MS * step:.2g}") for step in own["step"]]
    return places, [(place, f"{step:g} ms", colour) for place, step in zip(places, steps) if step in written]


def draw_ours(axes, points, species):
    own = points[points["program"] == runs.OURS].iloc[:1]
    drift, error = (plots.MM * own[f"{name}_{species}"].fillna(0.0).iloc[0] for name in ("drift", "error"))
    axes.axhline(drift, color=OURS, linewidth=1.0, zorder=1)
    axes.axhspan(drift - error, drift + error, color=OURS, alpha=0.12, linewidth=0, zorder=0)
    axes.plot(own["cost"].iloc[0], drift, "D", color=OURS, markersize=6, zorder=4,
              label=f"this project ({seeds(own)})")


def draw(table, path):
    """@param table its file"""
    points = pandas.read_csv(table)
    with plots.styled():
        figure, panels = plots.panels(1, 2, (9.0, 3.9), None, sharex=True)
        found = {}
        for (species, title), axes in zip(PANELS.items(), panels):
            draw_ours(axes, points, species)
            found[axes] = [draw_program(axes, points, program, species) for program in LOOKS]
            axes.set_xscale("log")
            axes.xaxis.set_minor_formatter(NullFormatter())
            axes.set_title(title, loc="left")
            axes.set_xlabel("processor seconds per simulated second")
        panels[0].set_ylabel("drift, mm/s")
        panels[0].plot([], [], "o", color=plots.GREY, markerfacecolor="white", markersize=5,
                       label="open: disks fell through the base")
        handles, labels = panels[0].get_legend_handles_labels()
        figure.legend(handles, labels, ncol=len(labels), loc="lower center")
        figure.tight_layout(rect=(0.0, 0.07, 1.0, 1.0))
        for axes, programs in found.items():
            places = [place for own, _ in programs for place in own]
            lines = [own for own, _ in programs if len(own) > 1]
            write_labels(axes, [text for _, texts in programs for text in texts], places, lines)
        plots.save(figure, path, svg=False)
