"""What measured curves say, with errors: where one passes through zero, its greatest value, a line through it."""
import dataclasses
import math

import numpy

from ratchet_sieve.stats import Mean, chi_squared_tail, jackknife, mean_of
from ratchet_sieve.tables import Rows


def curve_of(rows, key, field, seeds):
    """Pairs of the key's value and the field's mean over these seeds, where it is defined."""
    chosen = rows.frame[rows.column("seed").isin(seeds)]
    if not len(chosen):
        return []
    return list(chosen.groupby(key)[field].mean().dropna().items())


def zero_crossing(points, nearest=1):
    """The least x at which y changes its sign, by a parabola through the points beside it and the nearest other one.
    @param points three or more pairs (x, y) in the order of x. @param nearest 0: by the line through the points beside
    @return None where there is no change of sign"""
    for k in range(len(points) - 1):
        (x0, y0), (x1, y1) = points[k], points[k + 1]
        if y0 == 0.0:
            return x0
        if y0 * y1 < 0.0:
            middle = 0.5 * (x0 + x1)
            others = sorted((abs(x - middle), x, y) for x, y in points if x not in (x0, x1))
            through = [(x0, y0), (x1, y1), *((x, y) for _, x, y in others[:nearest])]
            roots = numpy.roots(numpy.polyfit(*zip(*through), len(through) - 1)).real
            return float(min(roots, key=lambda x, middle=middle: abs(x - middle)))
    return None


def interpolated(estimate, seeds):
    """@param estimate of some seeds, by a parabola (nearest = 1) or a line (nearest = 0)
    @return that of all by the parabola. Its error is that of the jackknife over the seeds and, for the interpolation,
    the distance to the line's. None where it is not defined, with all seeds or without one of them"""
    mean = jackknife(lambda chosen: estimate(chosen, 1), seeds)
    if mean is None or mean.error is None:
        return mean
    return dataclasses.replace(mean, error=math.hypot(mean.error, mean.value - estimate(seeds, 0)))


def crossing_of(rows, key, field):
    """@return the value of the key at which the field changes its sign; None where it does not"""
    return interpolated(lambda seeds, nearest: zero_crossing(curve_of(rows, key, field, seeds), nearest),
                        rows.values("seed"))


TURNS = {"B": "theta_b_reverses", "A": "theta_a_reverses", "window": "interval_rad"}  # columns in a CSV file


def turns_of(rows, key):
    """@return the values of the key at which A and B turn, and A's less B's as `window`; None where there is none"""
    def window(seeds, nearest):
        a, b = (zero_crossing(curve_of(rows, key, f"mean_vx.{kind}", seeds), nearest) for kind in "AB")
        return None if None in (a, b) else a - b
    return {**{kind: crossing_of(rows, key, f"mean_vx.{kind}") for kind in "AB"},
            "window": interpolated(window, rows.values("seed"))}


@dataclasses.dataclass(frozen=True)
class Best:
    """The greatest value of a field over a key. One half of the seeds chooses the place and the other gives the value,
    so that the choice does not bias the value."""
    at: float       # the key's value that is best in the mean over all seeds
    mean: object    # Mean of the field: each half of the seeds at the value that is best for the other half


def highest(curve):
    return max(range(len(curve)), key=lambda k: curve[k][1])


def best_of(rows, key, field):
    """Among the values of the key that all seeds ran: where fewer did, chance would choose, and few would measure.
    @return None where the field is defined nowhere, or there is one seed alone"""
    counts = rows.frame.groupby(key)[field].count()
    rows = Rows(rows.frame[rows.frame[key].isin(counts[counts == counts.max()].index)])
    seeds, samples = rows.values("seed"), []
    first, second = seeds[0::2], seeds[1::2]
    for chosen, measured in ((first, second), (second, first)):
        curve = curve_of(rows, key, field, chosen)
        if curve:
            own = rows.where({key: curve[highest(curve)][0]}).frame
            samples += Rows(own[own["seed"].isin(measured)]).samples(field)
    curve = curve_of(rows, key, field, seeds)
    if not samples or not curve:
        return None
    return Best(curve[highest(curve)][0], mean_of(samples))


@dataclasses.dataclass(frozen=True)
class Line:
    intercept: Mean
    slope: Mean
    chi_squared: float
    freedom: int  # of chi_squared

    def probability(self):
        """Of a chi squared at least as large, where the line is true."""
        return chi_squared_tail(self.chi_squared, self.freedom)

    def at(self, x):
        return self.intercept.value + self.slope.value * x


def line_through(points):
    """Weighted by the points' errors. @param points pairs of x and Mean
    @return None where there are fewer than three points with an error above 0"""
    known = [(x, mean) for x, mean in points if mean is not None and mean.error]
    if len(known) < 3:
        return None
    xs, ys, errors = (numpy.array(column) for column in zip(*((x, mean.value, mean.error) for x, mean in known)))
    values, covariance = numpy.polyfit(xs, ys, 1, w=1.0 / errors, cov="unscaled")
    count = min(mean.count for _, mean in known)
    slope, intercept = (Mean(float(value), math.sqrt(variance), count)
                        for value, variance in zip(values, covariance.diagonal()))
    squares = float((((ys - numpy.polyval(values, xs)) / errors) ** 2).sum())
    return Line(intercept, slope, squares, len(known) - 2)
