"""Drift against the time that it costs, over the steps of those programs that have one."""
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.ticker import NullFormatter  # noqa: E402

from peers import cases, measure  # noqa: E402

MM = 1e3  # per m
MS = 1e3  # per s
# Okabe and Ito's colours, which colour-blind readers tell apart.
# Which steps are written beside their points [ms]: all of them would lie over each other.
LOOKS = {"chipmunk": ("Chipmunk", "#0072B2", "o", (17, 10, 4.2, 2, 1, 0.1, 0.03)),
         "box2d": ("Box2D", "#D55E00", "s", (10, 4.2, 0.53, 0.1, 0.03)),
         "lammps": ("LAMMPS", "#009E73", "^", (0.005,))}
OURS = "#111111"
SPECIES = ("A (1 mm, 10 g)", "B (2 mm, 1 g)")
CLIP = (-5.0, 75.0)  # what is farther off is drawn at the edge [mm/s]
STYLE = {"figure.dpi": 150, "font.size": 9, "axes.spines.top": False, "axes.spines.right": False,
         "axes.grid": True, "grid.color": "#E6E6E6", "axes.axisbelow": True, "axes.titlesize": 9,
         "axes.titleweight": "bold", "legend.frameon": False, "legend.fontsize": 8}


def by_step(runs, program):
    """The runs of a program, those of one step together, the finest step first."""
    steps = {}
    for run in runs:
        if run["program"] == program:
            steps.setdefault(run["step"], []).append(run)
    return sorted(steps.items())


def write_step(axes, program, step, place):
    colour, _, written = LOOKS[program][1:]
    milliseconds = float(f"{step * MS:.2g}")
    if milliseconds in written:
        below = milliseconds == 0.53 or (program == "chipmunk" and milliseconds < 0.05)
        axes.annotate(f"{milliseconds:g} ms", place, textcoords="offset points", ha="center", fontsize=6.5,
                      xytext=(0, -14 if below else 8), color=colour)


def draw_program(axes, runs, program, species):
    name, colour, marker, _ = LOOKS[program]
    points = [(step, measure.speed(of_step), *measure.drift(of_step)[species], any(r["lost"] for r in of_step))
              for step, of_step in by_step(runs, program)]
    if not points:
        return
    times = [point[1] for point in points]
    drifts = [min(max(MM * point[2], CLIP[0]), CLIP[1]) for point in points]
    axes.errorbar(times, drifts, [MM * (point[3] or 0.0) for point in points], color=colour, linewidth=1.0,
                  elinewidth=1.0, zorder=2)
    for (step, time, *_, lost), drift in zip(points, drifts):
        axes.plot(time, drift, marker, color=colour, markersize=5, zorder=3,
                  markerfacecolor="white" if lost else colour, label="_")
        write_step(axes, program, step, (time, drift))
    axes.plot([], [], marker + "-", color=colour, markersize=5, label=name)


def draw_ours(axes, runs, species):
    """The others have no tangential restitution: held against them is the run that has none either."""
    own = [run for run in runs if run["program"] == cases.OURS]
    alike = [run for run in own if "β = 0 " in run["row"]] or own
    mean, error = measure.drift(alike)[species]
    band = MM * (error or 0.0)
    axes.axhline(MM * mean, color=OURS, linewidth=1.0, zorder=1)
    axes.axhspan(MM * mean - band, MM * mean + band, color=OURS, alpha=0.12, linewidth=0, zorder=0)
    axes.plot(measure.speed(alike), MM * mean, "D", color=OURS, markersize=6, zorder=4, label="this project: no step")


def draw(runs, path):
    with plt.rc_context(STYLE):
        figure, panels = plt.subplots(1, 2, figsize=(9.0, 3.9), sharex=True)
        for species, axes in enumerate(panels):
            draw_ours(axes, runs, species)
            for program in LOOKS:
                draw_program(axes, runs, program, species)
            axes.set_xscale("log")
            axes.xaxis.set_minor_formatter(NullFormatter())
            axes.set_title(SPECIES[species], loc="left")
            axes.set_xlabel("processor seconds per simulated second")
        panels[0].set_ylabel("drift, mm/s")
        panels[0].plot([], [], "o", color="#555555", markerfacecolor="white", markersize=5,
                       label="open: disks fell through the base")
        handles, labels = panels[0].get_legend_handles_labels()
        figure.legend(handles, labels, ncol=len(labels), loc="lower center")
        figure.tight_layout(rect=(0.0, 0.07, 1.0, 1.0))
        path.parent.mkdir(parents=True, exist_ok=True)
        figure.savefig(path)
        plt.close(figure)
