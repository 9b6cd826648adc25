"""Where a measured curve passes through zero, and the error of that place."""
from ratchet_sieve.stats import jackknife

BISECTIONS = 60  # of an interval: below the last bit


def parabola(points, x):
    """Through three points (Lagrange)."""
    total = 0.0
    for i, (xi, yi) in enumerate(points):
        term = yi
        for j, (xj, _) in enumerate(points):
            if i != j:
                term *= (x - xj) / (xi - xj)
        total += term
    return total


def zero_crossing(points):
    """The least x at which y changes its sign, by a parabola through the points beside it and the nearest other one.
    @param points three or more pairs (x, y) in the order of x. @return None where there is no change of sign"""
    for k in range(len(points) - 1):
        (x0, y0), (x1, y1) = points[k], points[k + 1]
        if y0 == 0.0:
            return x0
        if y0 * y1 < 0.0:
            others = [point for point in points if point not in (points[k], points[k + 1])]
            middle = 0.5 * (x0 + x1)
            third = min(others, key=lambda point: abs(point[0] - middle), default=None)
            curve = sorted([points[k], points[k + 1]] + ([third] if third else []))
            if third is None:
                return x0 - y0 * (x1 - x0) / (y1 - y0)
            low, high = x0, x1
            for _ in range(BISECTIONS):
                middle = 0.5 * (low + high)
                if parabola(curve, middle) * y0 > 0.0:
                    low = middle
                else:
                    high = middle
            return 0.5 * (low + high)
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
    for (x0, y0), (x1, y1) in zip(points, points[1:]):
        if x0 <= x <= x1:
            return y0 + (y1 - y0) * (x - x0) / (x1 - x0)
    return None


def apart_between(rows, key, first, second):
    """The first field less the second in the middle between their crossings, with its jackknife error."""
    def estimate(seeds):
        curves = [curve_of(rows, key, field, seeds) for field in (first, second)]
        found = [zero_crossing(curve) for curve in curves]
        if None in found:
            return None
        return value_between(curves[0], sum(found) / 2.0) - value_between(curves[1], sum(found) / 2.0)
    return jackknife(estimate, rows.values("seed"))
