"""Drift over processor time, for the time steps of the other programs. The points are a table, docs/data/peers.csv."""
import dataclasses

from matplotlib.ticker import NullFormatter

from ratchet_sieve import origin, plots
from ratchet_sieve.tables import read_csv, write_csv
from labels import place as write_labels
from peers import runs

ALIKE = "β = 0 "  # in the row of this project's run without tangential restitution, which the others do not have either


@dataclasses.dataclass
class Point:
    """A program with one step. Undefined: None."""
    program: str
    step: float     # [s]; None for this project
    cost: float     # processor time over simulated time
    drift_a: float  # [m/s], as the following
    error_a: float
    drift_b: float
    error_b: float
    loses_disks: bool
    runs: int
    origin: str     # date and machine

    def drift(self, species):
        return (self.drift_a, self.error_a) if species == 0 else (self.drift_b, self.error_b)


def of_runs(taken, about):
    """@param about date and machine. @return this project without tangential restitution, and every
    program and step."""
    where = origin.text(about)
    groups = {}
    for run in taken:
        if run["program"] != runs.OURS or ALIKE in run["row"]:
            groups.setdefault((run["program"], run.get("step")), []).append(run)
    found = []
    for (program, step), own in groups.items():
        a, b = runs.drift(own)
        found.append(Point(program, step, runs.speed(own), a.value, a.error, b.value, b.error,
                           any(run["lost"] for run in own), len(own), where))
    return found


COLUMNS = [field.name for field in dataclasses.fields(Point)]


def write(path, points):
    write_csv(path, COLUMNS, ([f"{value:.4g}" if isinstance(value, float) else value
                               for value in dataclasses.astuple(point)] for point in points))


def read(path):
    def number(text):
        return float(text) if text else None

    return [Point(line["program"], *(number(line[name]) for name in COLUMNS[1:7]), line["loses_disks"] == "True",
                  int(line["runs"]), line["origin"]) for line in read_csv(path).to_dict("records")]


MS = 1e3  # per s
# The steps that are written beside their points [ms]; all of them would overlap.
LOOKS = {"chipmunk": ("Chipmunk", plots.COLOURS[0], "o", (17, 10, 4.2, 2, 1, 0.1, 0.03)),
         "box2d": ("Box2D", plots.COLOURS[1], "s", (10, 4.2, 0.53, 0.1, 0.03)),
         "lammps": ("LAMMPS", plots.COLOURS[2], "^", (0.005,))}
OURS = "#111111"
SPECIES = ("A (1 mm, 10 g)", "B (2 mm, 1 g)")
CLIP = (-5.0, 75.0)  # drifts beyond are drawn at the edge [mm/s]


def step_label(program, step):
    """None for a step that is not written."""
    milliseconds = float(f"{step * MS:.2g}")
    return f"{milliseconds:g} ms" if milliseconds in LOOKS[program][3] else None


def draw_program(axes, points, program, species):
    """The finest step first. @return the places of the points, and the labels: triples (place, text, colour)"""
    name, colour, marker, _ = LOOKS[program]
    own = sorted((point for point in points if point.program == program), key=lambda point: point.step)
    if not own:
        return [], []
    drifts = [min(max(plots.MM * point.drift(species)[0], CLIP[0]), CLIP[1]) for point in own]
    axes.errorbar([point.cost for point in own], drifts, [plots.MM * (point.drift(species)[1] or 0.0) for point in own],
                  color=colour, linewidth=1.0, elinewidth=1.0, zorder=2)
    for point, drift in zip(own, drifts):
        axes.plot(point.cost, drift, marker, color=colour, markersize=5, zorder=3,
                  markerfacecolor="white" if point.loses_disks else colour, label="_")
    axes.plot([], [], marker + "-", color=colour, markersize=5, label=f"{name} ({seeds(own)})")
    places = list(zip([point.cost for point in own], drifts))
    texts = [(place, step_label(program, point.step), colour) for point, place in zip(own, places)]
    return places, [text for text in texts if text[1]]


def seeds(points):
    counts = sorted({point.runs for point in points})
    return f"n = {counts[0]}" if len(counts) == 1 else f"n = {counts[0]} to {counts[-1]}"


def draw_ours(axes, points, species):
    own = next(point for point in points if point.program == runs.OURS)
    drift, error = own.drift(species)
    band = plots.MM * (error or 0.0)
    axes.axhline(plots.MM * drift, color=OURS, linewidth=1.0, zorder=1)
    axes.axhspan(plots.MM * drift - band, plots.MM * drift + band, color=OURS, alpha=0.12, linewidth=0, zorder=0)
    axes.plot(own.cost, plots.MM * drift, "D", color=OURS, markersize=6, zorder=4,
              label=f"this project ({seeds([own])})")


def draw(points, path):
    with plots.styled():
        figure, panels = plots.panels(1, 2, (9.0, 3.9), None, sharex=True)
        found = {}
        for species, axes in enumerate(panels):
            draw_ours(axes, points, species)
            found[axes] = [draw_program(axes, points, program, species) for program in LOOKS]
            axes.set_xscale("log")
            axes.xaxis.set_minor_formatter(NullFormatter())
            axes.set_title(SPECIES[species], loc="left")
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
