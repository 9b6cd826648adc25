"""Means over the seeds of a sweep: as curves over one key, and as maps over two."""
import dataclasses
import math

from ratchet_sieve.plots.curves import curve, end_labels, key_colours
from ratchet_sieve.plots.maps import mark_cells, shown, value_map
from ratchet_sieve.tables import QUALITIES, species_of
from ratchet_sieve.values import unit_of

SMALLEST_DIFFERENCE = 1e-6  # of an axis: steps that differ by a smaller part are taken as equal

LABELS = {
    'base.inclination': r'$\theta$ [rad]',
    'base.frequency': '$f$ [Hz]',
    'base.amplitude': '$A$ [m]',
    'base.length': 'length $W$ [m]',
    'density': 'density $d$',
    'quality': 'quality $Q$',
    'steady.quality.value': 'quality $Q$ of the filled machine',
    'processed': 'processed ratio $P$',
    'throughput': 'throughput [disks/s]',
}


def label(name, species=()):
    """@param species of two the separation's label says which way its sign is"""
    if name is None:
        return ''
    if name == 'separation' and len(species) == 2:
        return f'separation $s$, above 0: more {species[0]} to the left'
    if name == 'difference of mean_vx' and len(species) == 2:
        return f'difference of mean_vx [m/s], above 0: {species[0]} to the right'
    if name.startswith('mean_vx.'):
        return rf"$\langle V_x \rangle$ of {name.split('.', 1)[1]} [m/s]"
    return LABELS.get(name, name)


def plain_label(name, species=()):
    """A label without the signs of mathtext. @return it, and its unit"""
    if name == 'separation':
        return label(name, species).replace('$', ''), ''
    if name.startswith('mean_vx.'):
        return f"\u27e8V_x\u27e9 of {name.split('.', 1)[1]}", 'm/s'
    if name not in LABELS:
        return name, unit_of(name) or ''
    text, _, unit = LABELS[name].partition(' [')
    return text.replace(r'$\theta$', '\u03b8').replace('$', ''), unit.rstrip(']')


def of_all(rows, field):
    """The mean in which an undefined value counts as 0: no disk has left."""
    return sum(rows.samples(field)) / len(rows)


@dataclasses.dataclass(frozen=True)
class Limits:
    """Of what is compared by its Q: with few disks, |s| is large by chance."""
    processed: float = 0.0  # P
    counted: float = 0.0    # disks that left

    def hold(self, rows):
        return of_all(rows, 'processed') >= self.processed and of_all(rows, 'counted') >= self.counted


class Means:
    """The mean of each field over the seeds at each (x, y), and the places that are below the limits.
    @param best one of the places, if it is known"""

    def __init__(self, rows, x, y, fields, limits=Limits(), best=None):
        groups = rows.by(x, y) if y else {(place, None): group for place, group in rows.by(x).items()}
        self.fields = fields
        self.groups = groups
        self.counts = {place: len(group) for place, group in groups.items()}
        self.below = {place for place, group in groups.items() if not limits.hold(group)}
        self.best = best
        self.species = species_of(rows.frame)
        self.at = {(field, place): group.mean(field) for field in fields for place, group in groups.items()}
        self.xs = rows.values(x)
        self.ys = rows.values(y) if y else [None]

    def get(self, field, x, y):
        """@return a Mean, or None"""
        return self.at.get((field, (x, y)))

    def value(self, field, x, y):
        mean = self.get(field, x, y)
        return mean.value if mean else math.nan


def is_even(values):
    """Whether they are evenly spaced numbers."""
    if len(values) < 2 or any(isinstance(v, str) for v in values):
        return False
    steps = [b - a for a, b in zip(values, values[1:])]
    return max(steps) - min(steps) <= SMALLEST_DIFFERENCE * (values[-1] - values[0])


def draw_curves(axes, means, field, x, y):
    places = means.xs
    if any(isinstance(v, str) for v in means.xs):
        places = list(range(len(means.xs)))
        axes.set_xticks(places, map(shown, means.xs))
    ends = []
    for colour, other in zip(key_colours(means.ys), means.ys):
        points = [(place, means.get(field, v, other)) for place, v in zip(places, means.xs)]
        curve(axes, points, color=colour)
        known = [mean.value for _, mean in points if mean]
        if known and y is not None:
            ends.append((known[-1], shown(other), colour))
        if field in QUALITIES:
            mark_curve(axes, means, field, dict(zip(means.xs, places)), other, colour)
    end_labels(axes, ends, label(y))
    axes.set_xlabel(label(x))
    axes.set_ylabel(label(field, means.species))


def mark_curve(axes, means, field, places, other, colour):
    """Hollow points where Q is not comparable, and a star at the best. @param places map from x to its place"""
    hollow = [(place, means.value(field, v, other)) for v, place in places.items() if (v, other) in means.below]
    axes.plot([place for place, _ in hollow], [mean for _, mean in hollow], 'o', color=colour, markersize=5,
              markerfacecolor='white', zorder=3)
    if means.best and means.best[1] == other:
        axes.plot(places[means.best[0]], means.value(field, *means.best), '*', color=colour, markersize=11,
                  zorder=4)


def cells(axis, values):
    """The edges of a map's cells, and their places: the values if they are evenly spaced, else 0, 1, 2, …"""
    places = values if is_even(values) else list(range(len(values)))
    if places is not values:
        axis.set_ticks(places, map(shown, values))
    inner = [(a + b) / 2 for a, b in zip(places, places[1:])]
    return [2 * places[0] - inner[0], *inner, 2 * places[-1] - inner[-1]], places


def draw_map(axes, means, field, x, y):
    (x_edges, xs), (y_edges, ys) = cells(axes.xaxis, means.xs), cells(axes.yaxis, means.ys)
    value_map(axes, x_edges, y_edges, [[means.value(field, u, v) for u in means.xs] for v in means.ys],
              label(field, means.species))
    if field in QUALITIES:
        mark_cells(axes, x_edges, y_edges, [(means.xs.index(u), means.ys.index(v)) for u, v in means.below])
        if means.best:
            axes.plot(xs[means.xs.index(means.best[0])], ys[means.ys.index(means.best[1])], '*', color='white',
                      markeredgecolor='black', markersize=12)
    axes.set_xlabel(label(x))
    axes.set_ylabel(label(y))
