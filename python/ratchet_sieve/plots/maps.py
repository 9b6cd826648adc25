"""Maps over two keys: of values, and of the class of each place."""
import math

import matplotlib
import numpy
from matplotlib.colors import BoundaryNorm, ListedColormap
from matplotlib.patches import Patch, Rectangle
from matplotlib.ticker import MaxNLocator

from ratchet_sieve.plots.curves import RAMP, SIGNED, STEPS, has_signs
from ratchet_sieve.plots.style import GREY

MIDST = (0.08, 0.92)  # of a scale whose ends are nearly black
VEIL = (1.0, 1.0, 1.0, 0.6)  # over marked cells


def shown(value):
    return value if isinstance(value, str) else f"{value:g}"


def colour_steps(values):
    """Colour map and norm of STEPS steps at most at round numbers; diverging around 0 where values have both signs."""
    low, high = min(values), max(values)
    colours = matplotlib.colormaps[RAMP if high > 0.0 else RAMP + "_r"]  # the largest ones are not the darkest
    if has_signs(values):
        colours = ListedColormap(matplotlib.colormaps[SIGNED](numpy.linspace(*MIDST, colours.N)))
        high = max(-low, high)
        low = -high
    levels = MaxNLocator(STEPS, steps=[1, 2, 2.5, 5, 10]).tick_values(low, high)
    if len(levels) < 3:
        levels = [low - 0.5, low, low + 0.5]
    return {"cmap": colours, "norm": BoundaryNorm(levels, colours.N)}


def value_map(axes, x_edges, y_edges, values, label):
    """@param values rows from below, NaN where undefined. @param label of the colours"""
    defined = [value for row in values for value in row if math.isfinite(value)]
    axes.grid(False)
    mesh = axes.pcolormesh(x_edges, y_edges, values, rasterized=True, **(colour_steps(defined) if defined else {}))
    axes.figure.colorbar(mesh, ax=axes, label=label)


def mark_cells(axes, x_edges, y_edges, cells):
    """Hatches them. @param cells pairs of the numbers of column and row"""
    for i, k in cells:
        axes.add_patch(Rectangle((x_edges[i], y_edges[k]), x_edges[i + 1] - x_edges[i], y_edges[k + 1] - y_edges[k],
                                 facecolor=VEIL, edgecolor=GREY, hatch="////", linewidth=0.0))


def class_map(axes, xs, ys, class_of, colours):
    """Cells of one size, since the values are not evenly spaced.
    @param class_of (x, y) -> the name of its class. @param colours map from name to colour"""
    names = list(colours)
    cells = [[names.index(class_of(x, y)) for x in xs] for y in ys]
    edges = [k - 0.5 for k in range(len(names) + 1)]
    axes.pcolormesh(range(len(xs) + 1), range(len(ys) + 1), cells, cmap=ListedColormap(list(colours.values())),
                    norm=BoundaryNorm(edges, len(names)), edgecolors="white", linewidth=0.5)
    axes.set_xticks([k + 0.5 for k in range(len(xs))], map(shown, xs))
    axes.set_yticks([k + 0.5 for k in range(len(ys))], map(shown, ys))
    axes.grid(False)


def class_legend(axes, colours):
    """Beside the axes."""
    return axes.legend(handles=[Patch(facecolor=colour, edgecolor="#999999", label=name)
                                for name, colour in colours.items()], loc="center left", bbox_to_anchor=(1.0, 0.5))
