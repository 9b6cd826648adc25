"""What a calibration found: pairs of coefficients, and measured beside computed."""
import numpy as np
from matplotlib.ticker import MaxNLocator

from ratchet_sieve.plots.means import label
from ratchet_sieve.plots.style import COLOURS, GREY, drawing

CELL = 1.7   # side of a pair's panel [inches]
BESIDE = 3.6  # width of the panel of numbers [inches]
SHOWN = 600  # draws of a pair
BINS = 24


def draw(grains):
    """@return matplotlib's axes of the numbers"""
    keys = len(grains.keys)
    with drawing(None, (CELL * keys + BESIDE + 0.6, max(CELL * keys, 2.6) + 0.6)) as axes:
        figure = axes.figure
        axes.remove()
        grid = figure.add_gridspec(keys, keys + 1, width_ratios=[CELL] * keys + [BESIDE])
        for row in range(keys):
            for column in range(row + 1):
                _pair(figure.add_subplot(grid[row, column]), grains, row, column)
        axes = figure.add_subplot(grid[:, keys])
        _numbers(axes, grains)
        return axes


def _pair(axes, grains, row, column):
    """The two keys' draws within what was known before; of one key their density."""
    x, y = grains.draws.iloc[:, column], grains.draws.iloc[:, row]
    before = grains.prior.table
    axes.set_xlim(before[:, column].min(), before[:, column].max())
    axes.xaxis.set_major_locator(MaxNLocator(2))
    if row == column:
        axes.hist(x, BINS, range=axes.get_xlim(), color=COLOURS[0], alpha=0.6)
        axes.set_yticks([])
    else:
        axes.plot(x[:SHOWN], y[:SHOWN], ".", color=COLOURS[0], markersize=2, alpha=0.4)
        axes.set_ylim(before[:, row].min(), before[:, row].max())
    if row == len(grains.keys) - 1:
        axes.set_xlabel(_label(grains, column))
    else:
        axes.set_xticklabels([])
    if column == 0 and row:
        axes.set_ylabel(_label(grains, row))
    elif row != column:
        axes.set_yticklabels([])


def _label(grains, k):
    """Of a species' key its name and the key's, in two lines."""
    first, *rest = grains.keys[k].split(".")
    return "\n".join((grains.base.species[int(rest[0])], *rest[1:])) if first == "species" else label(grains.keys[k])


def _numbers(axes, grains):
    """In standard errors of what was measured, around what was computed."""
    table = grains.table
    places = np.arange(len(table))[::-1]
    away = (table.measured - table.computed) / table.error
    axes.axvline(0.0, color=GREY, linewidth=1.0)
    axes.errorbar(np.zeros(len(table)), places, xerr=1.96 * table.computed_error / table.error, fmt="none",
                  ecolor=COLOURS[1], elinewidth=4, alpha=0.6, label="computed, 95 %")
    axes.errorbar(away, places, xerr=1.96, fmt="o", color=COLOURS[0], markersize=4, capsize=2, label="measured, 95 %")
    axes.set_yticks(places, [f"{row.number}, row {row.row}" for row in table.itertuples()])
    axes.set_xlabel("(measured − computed) / error")
    axes.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), ncol=2, borderaxespad=0.2)
    if not grains.agrees:
        axes.set_title("do not agree", loc="left")
