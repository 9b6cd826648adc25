"""The answer of a search: its surface over the ranges, the settings that are as good as the best, and the runs."""
import numpy as np

from ratchet_sieve.plots.maps import value_map
from ratchet_sieve.plots.means import label
from ratchet_sieve.plots.style import COLOURS, GREY, drawing

SIZE = (6.4, 4.2)  # [inches]
ABOVE = 42.0  # of a title, for the legend [points]
SILENT = ("x", "+", "1", "2", "3", "4")  # markers of runs that give no answer
RUNS = {"marker": "o", "linestyle": "", "color": GREY, "markersize": 4, "markeredgecolor": "white",
        "markeredgewidth": 0.6}


def draw(answer, axes=None):
    """Over one key a curve with its band, over two a map, over more the runs over the first key.
    @return matplotlib's axes"""
    with drawing(axes, SIZE) as axes:
        keys = answer.machine.keys
        {1: _curve, 2: _map}.get(len(keys), _points)(axes, answer, *keys[:2])
        axes.set_xlabel(label(keys[0]))
        if not answer.separated:
            axes.set_title(str(answer).splitlines()[0], pad=6.0 if len(keys) == 1 else ABOVE)
        return axes


def draw_front(front, axes=None, color=COLOURS[0], name="front, fresh seeds"):
    """The value over the throughput: settings that were tried, by one run each, and the front with its intervals.
    @return matplotlib's axes"""
    with drawing(axes, SIZE) as axes:
        axes.plot(front.tried.throughput, front.tried.value, **{**RUNS, "color": color, "alpha": 0.3})
        axes.errorbar(front.table.throughput, front.table.value, front.table.value_half_width,
                      front.table.throughput_half_width, fmt="o-", capsize=2, color=color, label=name)
        goal = front.machine.goal
        axes.set(xlabel="throughput [disks/s]", ylabel=f"|{goal}|" if front.machine.is_signed else label(goal))
        axes.autoscale(axis="x")
        axes.set_xlim(left=0.0)
        axes.legend()
        return axes


def _silent(axes, answer, x, y=None):
    """The settings of which no run gives an answer, by why the last one does not; or at the lower edge."""
    works = answer.seen.why == ""
    keys = answer.machine.keys
    silent = ~works.groupby([answer.runs[key] for key in keys]).transform("any")
    last = answer.runs[silent].drop_duplicates(keys, keep="last")
    for k, (why, rows) in enumerate(last.groupby(answer.seen.why[last.index])):
        at = {} if y else {"transform": axes.get_xaxis_transform()}
        axes.plot(rows[x], rows[y] if y else np.full(len(rows), 0.02), SILENT[k % len(SILENT)], color="black",
                  markersize=5, label=why, **at)


def _best(axes, *place):
    axes.plot(*place, "*", color="white", markeredgecolor="black", markersize=13, zorder=5, label="best", clip_on=False)


def _curve(axes, answer, key):
    surface, good = answer.map, answer.map.as_good
    axes.fill_between(surface[key], surface.value - surface.half_width, surface.value + surface.half_width,
                      color=COLOURS[0], alpha=0.2, linewidth=0.0)
    axes.plot(surface[key], surface.value, color=COLOURS[0])
    if answer.best:
        axes.plot(surface[key][good], surface.value[good], color=COLOURS[1], linewidth=4, label="as good as the best")
        axes.errorbar(answer.best[key], answer.separation.value, answer.separation.half_width, color="black", fmt="*",
                      markersize=9, capsize=2, zorder=5, label="fresh seeds")
    axes.plot(answer.runs[key], answer.seen.value, label="settled", **RUNS)
    _silent(axes, answer, key)
    axes.set_ylabel(_goal(answer))
    axes.legend()


def _goal(answer):
    return label(answer.machine.goal, answer.machine.scene.species)


def _map(axes, answer, x, y):
    table = answer.map.pivot(index=y, columns=x, values="value")
    xs, ys = table.columns.to_numpy(float), table.index.to_numpy(float)
    value_map(axes, _edges(xs), _edges(ys), table.to_numpy(), _goal(answer))
    works = answer.seen.why == ""
    axes.plot(answer.runs[x][works], answer.runs[y][works], label="settled", **RUNS)
    _silent(axes, answer, x, y)
    if answer.best:
        good = answer.map.pivot(index=y, columns=x, values="as_good").to_numpy(float)
        axes.contour(xs, ys, good, [0.5], colors="black", linewidths=1.5)
        axes.plot([], [], color="black", label="as good as the best")
        _best(axes, answer.best[x], answer.best[y])
    axes.set_xlim(xs[0], xs[-1])
    axes.set_ylim(ys[0], ys[-1])
    axes.set_ylabel(label(y))
    axes.legend(loc="lower left", bbox_to_anchor=(0.0, 1.0), ncol=3, borderaxespad=0.2)


def _points(axes, answer, key, *_):
    axes.plot(answer.runs[key], answer.seen.value, label="runs", **RUNS)
    if answer.best:
        _best(axes, answer.best[key], answer.separation.value)
    axes.set_ylabel(_goal(answer))
    axes.legend()


def _edges(values):
    middles = 0.5 * (values[1:] + values[:-1])
    return np.concatenate([[values[0]], middles, [values[-1]]])
