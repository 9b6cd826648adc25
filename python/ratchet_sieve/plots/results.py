"""Pictures of what the engine returns: of the DataFrame of a sweep, and of the frames of a run. Each is one call, and
returns matplotlib's axes."""
from ratchet_sieve.plots.curves import distribution
from ratchet_sieve.plots.machine import trajectories
from ratchet_sieve.plots.means import Means, draw_curves, draw_map
from ratchet_sieve.plots.observed import PLACES
from ratchet_sieve.plots.style import GREY, coloured, drawing, legend_above, say_undefined
from ratchet_sieve.stats import density_of
from ratchet_sieve.tables import rows_of

SIZE = (6.4, 3.8)  # of a picture [inch]
BIN = 2.0          # of displacements [teeth]: narrower ones would show the valleys in which disks rest


def sweep_curves(table, key, field="quality", by=None, axes=None):
    """Means over the seeds with their standard errors, over a key.
    @param table of ratchet_sieve.sweep() or read_sweep(). @param key along x, such as "base.inclination"
    @param field a column, or "throughput" [1/s]. @param by one curve for each value of this key
    @throws ValueError there is no such column, or another key varies as well"""
    means = means_of(table, key, by, field)
    with drawing(axes, SIZE) as axes:
        draw_curves(axes, means, field, key, by)
    return axes


def sweep_map(table, x, y, field="quality", axes=None):
    """Means over the seeds, over two keys; see sweep_curves()."""
    means = means_of(table, x, y, field)
    with drawing(axes, SIZE) as axes:
        draw_map(axes, means, field, x, y)
    return axes


def means_of(table, x, y, field):
    rows = rows_of(table)
    for name in filter(None, (x, y, field)):
        if name not in rows.frame:
            raise ValueError(f"there is no column {name}; there are {', '.join(map(str, rows.frame))}")
    if not len(rows):
        raise ValueError("no case is done")
    place = [name for name in (x, y, "seed") if name]
    if rows.frame.duplicated(list(dict.fromkeys(place))).any():
        raise ValueError(f"several rows have the same {', '.join(place)}: choose one value of each other key")
    return Means(rows, x, y, [field])


def displacements(run, frame=-1, width=None, axes=None):
    """The distribution of the displacements of each species' disks at a frame, with the standard errors of independent
    disks. Disks that have left are not in it. @param width of the bins [m]; None: two teeth
    @throws ValueError the run has no frames"""
    run._require_frames()
    with drawing(axes, SIZE) as axes:
        disks = run.frames.disks[frame]
        width = width or BIN * run.scene.width / run.scene["base.teeth"]
        for kind, (colour, name) in enumerate(coloured(run.scene.species)):
            values = disks["displacement"][disks["species"] == kind]
            if len(values):
                distribution(axes, *density_of(values, width), color=colour, label=name)
        if len(disks):
            axes.legend(title="species", frameon=False)
        else:
            say_undefined(axes, "all disks have left")
        axes.axvline(0.0, color=GREY, linewidth=0.8, zorder=1)
        axes.set(xlabel="displacement [m]", ylabel="density [1/m]", title=f"after {run.frames.time[frame]:g} s")
        axes.set_ylim(bottom=0.0)
    return axes


def tracks(run, ids=None, axes=None):
    """The ways of disks through the frames, in mm. @param ids of the disks; None: the middle disk of each species.
    @param axes such as run.plot(0), to draw over the machine
    @throws ValueError the run has no frames, or no such disk"""
    run._require_frames()
    if ids is None:
        first = run.frames.disks[0]
        of_kinds = [first["id"][first["species"] == kind] for kind in sorted(set(first["species"]))]
        ids = [own[len(own) // 2] for own in of_kinds]  # ids go along the base
    ways, names = [], []
    for number in ids:
        places = [disks[disks["id"] == number] for disks in run.frames.disks]
        way = [place[0] for place in places if len(place)]
        if not way:
            raise ValueError(f"there is no disk {number} in the frames")
        ways.append(([float(place["x"]) for place in way], [float(place["y"]) for place in way]))
        names.append(f"{run.scene.species[way[0]['species']]}, disk {number}")
    with drawing(axes, SIZE) as axes:
        before = len(axes.lines)
        trajectories(axes, ways, run.scene.width if run.scene["boundary"] == "periodic" else None)
        for line, name in zip(axes.lines[before:], names):
            line.set_label(name)
        legend_above(axes)
    return axes


def bins(run, axes=None):
    """The numbers of disks that have left by the left and by the right end, of each species, over time.
    @throws ValueError the run has no frames"""
    run._require_frames()
    with drawing(axes, SIZE) as axes:
        for colour, (name, counts) in coloured(run.frames.bins.items()):
            for end, line in PLACES.items():
                axes.plot(run.frames.time, counts[end], line, color=colour, label=f"{name}, {end}")
        axes.set(xlabel="time [s]", ylabel="disks that left")
        legend_above(axes)
    return axes
