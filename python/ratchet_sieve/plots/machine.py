"""A machine at an instant, to scale, and the ways of its disks."""
import numpy as np
from matplotlib.collections import PatchCollection
from matplotlib.patches import Circle

from ratchet_sieve.base import in_world, surface
from ratchet_sieve.plots.style import COLOURS, GREY, MM, coloured

TEETH = "#BBBBBB"
DEPTH = 0.5    # of the drawn base below its lowest corner, in widths of a tooth
DETAILED = 0.004  # least radius of disks with an edge and a dot, which would cover smaller ones [lengths of the base]
DOT = (0.55, 0.25)  # distance from the centre and radius of the dot that shows a disk's rotation, in radii


def circles(axes, xs, ys, radii, **options):
    """To scale, in mm."""
    axes.add_collection(PatchCollection([Circle((MM * x, MM * y), MM * radius) for x, y, radius in zip(xs, ys, radii)],
                                        **options))


def machine(axes, base, disks, inclination=None, displacement=(0.0, 0.0), species=None):
    """Teeth and disks to scale, in mm, in the world's frame.
    @param base the part `base` of a scene: teeth, and tooth_width, tooth_height and asymmetry, or profile
    @param disks columns x, y, radius [m] and species, and angle [rad] where the rotation is to be seen: a DataFrame, or
    a map or an array of such names
    @param inclination of the instant [rad]; None: the scene's. @param displacement of the base at the instant [m]
    @param species all names, in the order of their colours; None: those of the disks, in their order"""
    theta = base.get("inclination", 0.0) if inclination is None else inclination
    corners = surface(base)
    bottom = min(n for _, n in corners) - DEPTH * corners[-1][0] / base["teeth"]
    closed = in_world([*corners, (corners[-1][0], bottom), (0.0, bottom)], theta, displacement)
    axes.fill([MM * x for x, _ in closed], [MM * y for _, y in closed], facecolor=TEETH, edgecolor=GREY, linewidth=0.6)
    columns = disks.dtype.names if isinstance(disks, np.ndarray) else disks
    kinds = np.array([str(kind) for kind in disks["species"]], dtype=str)
    xs, ys, radii = (np.array(disks[name], dtype=float) for name in ("x", "y", "radius"))
    for colour, kind in coloured(species or dict.fromkeys(kinds)):
        own = kinds == kind
        detailed = own.any() and radii[own].max() > DETAILED * corners[-1][0]
        circles(axes, xs[own], ys[own], radii[own], facecolor=colour, edgecolor="white",
                linewidth=0.3 if detailed else 0.0)
        axes.plot([], [], "o", color=colour, label=kind)
        if detailed and "angle" in columns:
            angles = np.array(disks["angle"], dtype=float)[own]
            away = DOT[0] * radii[own]
            circles(axes, xs[own] + away * np.cos(angles), ys[own] + away * np.sin(angles), DOT[1] * radii[own],
                    facecolor="white", linewidth=0.0)
    axes.set_aspect("equal", adjustable="datalim")
    axes.autoscale_view()
    axes.grid(False)
    axes.set_xlabel("$x$ [mm]")
    axes.set_ylabel("$y$ [mm]")


def trajectories(axes, tracks, period=None):
    """The ways of disks, in mm. @param tracks pairs (xs, ys) [m]
    @param period of the base [m]: a way that leaves it at one end goes on at the other; None: it has ends"""
    for k, (xs, ys) in enumerate(tracks):
        xs, ys = MM * np.array(xs, dtype=float), MM * np.array(ys, dtype=float)
        jumps = [] if period is None else np.flatnonzero(np.abs(np.diff(xs)) > 0.5 * MM * period) + 1
        axes.plot(np.insert(xs, jumps, np.nan), np.insert(ys, jumps, np.nan), color=COLOURS[k % len(COLOURS)],
                  linewidth=0.8)
    axes.set_xlabel("$x$ [mm]")
    axes.set_ylabel("$y$ [mm]")
