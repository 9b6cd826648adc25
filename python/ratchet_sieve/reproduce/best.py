"""The greatest value of a field over a key. One half of the seeds chooses the place and the other gives the value, so
that the choice does not bias the value."""
import dataclasses
import math

import numpy

from ratchet_sieve.reproduce.crossings import curve_of
from ratchet_sieve.stats import jackknife, mean_of
from ratchet_sieve.tables import Rows


@dataclasses.dataclass(frozen=True)
class Best:
    at: float       # the key's value that is best in the mean over all seeds
    mean: object    # Mean of the field: each half of the seeds at the value that is best for the other half
    peak: object    # Mean: height of a parabola through the best value and its neighbours; None at an end


def halves(seeds):
    return seeds[0::2], seeds[1::2]


def highest(curve):
    return max(range(len(curve)), key=lambda k: curve[k][1])


def vertex(points):
    """The height of the parabola through three points. @return None where it has no maximum between the outer two"""
    xs, ys = zip(*points)
    parabola = numpy.polyfit(xs, ys, 2)
    x = -0.5 * parabola[1] / parabola[0] if parabola[0] < 0.0 else math.nan
    return float(numpy.polyval(parabola, x)) if xs[0] <= x <= xs[-1] else None


def peak_of(rows, key, field):
    """With its jackknife error over the seeds. The three places are those of all seeds."""
    seeds = rows.values("seed")
    curve = curve_of(rows, key, field, seeds)
    k = highest(curve)
    if k in (0, len(curve) - 1):
        return None
    places = [x for x, _ in curve[k - 1:k + 2]]
    near = Rows(rows.frame[rows.frame[key].isin(places)])

    def estimate(chosen):
        points = curve_of(near, key, field, chosen)
        return vertex(points) if len(points) == len(places) else None
    return jackknife(estimate, near.values("seed"))


def best_of(rows, key, field):
    """@return None where the field is defined nowhere, or there is one seed alone"""
    seeds = rows.values("seed")
    samples = []
    first, second = halves(seeds)
    for chosen, measured in ((first, second), (second, first)):
        curve = curve_of(rows, key, field, chosen)
        if curve:
            own = rows.where({key: curve[highest(curve)][0]}).frame
            samples += Rows(own[own["seed"].isin(measured)]).samples(field)
    curve = curve_of(rows, key, field, seeds)
    if not samples or not curve:
        return None
    return Best(curve[highest(curve)][0], mean_of(samples), peak_of(rows, key, field))
