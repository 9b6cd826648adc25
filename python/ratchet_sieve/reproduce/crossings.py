"""Where a measured curve passes through zero, and the error of that place."""
import numpy

from ratchet_sieve.stats import jackknife


def zero_crossing(points):
    """The least x at which y changes its sign, by a parabola through the points beside it and the nearest other one.
    @param points three or more pairs (x, y) in the order of x. @return None where there is no change of sign"""
    for k in range(len(points) - 1):
        (x0, y0), (x1, y1) = points[k], points[k + 1]
        if y0 == 0.0:
            return x0
        if y0 * y1 < 0.0:
            middle = 0.5 * (x0 + x1)
            others = sorted((abs(x - middle), x, y) for x, y in points if x not in (x0, x1))
            through = [(x0, y0), (x1, y1), *((x, y) for _, x, y in others[:1])]
            roots = numpy.roots(numpy.polyfit(*zip(*through), len(through) - 1)).real
            return float(min(roots, key=lambda x, middle=middle: abs(x - middle)))
    return None


def curve_of(rows, key, field, seeds):
    """Pairs of the key's value and the field's mean over these seeds, where it is defined."""
    chosen = rows.frame[rows.column("seed").isin(seeds)]
    if not len(chosen):
        return []
    return list(chosen.groupby(key)[field].mean().dropna().items())


def crossing_of(rows, key, field):
    """@return the value of the key at which the field changes its sign, with its jackknife error over the seeds; None
    where it does not change, with all seeds or without one of them"""
    return jackknife(lambda seeds: zero_crossing(curve_of(rows, key, field, seeds)), rows.values("seed"))


def distance_of(rows, key, first, second):
    """The crossing of the first field less that of the second, with its jackknife error."""
    def estimate(seeds):
        found = [zero_crossing(curve_of(rows, key, field, seeds)) for field in (first, second)]
        return None if None in found else found[0] - found[1]
    return jackknife(estimate, rows.values("seed"))


def value_between(points, x):
    """On straight lines from point to point. @return None outside the points"""
    return float(numpy.interp(x, *zip(*points))) if points[0][0] <= x <= points[-1][0] else None


def apart_between(rows, key, first, second):
    """The first field less the second in the middle between their crossings, with its jackknife error."""
    def estimate(seeds):
        curves = [curve_of(rows, key, field, seeds) for field in (first, second)]
        found = [zero_crossing(curve) for curve in curves]
        if None in found:
            return None
        return value_between(curves[0], sum(found) / 2.0) - value_between(curves[1], sum(found) / 2.0)
    return jackknife(estimate, rows.values("seed"))
