"""Straight lines through measured points."""
import dataclasses
import math

from ratchet_sieve.stats import Mean, chi_squared_tail


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
    s = sx = sy = sxx = sxy = 0.0
    for x, mean in known:
        w = 1.0 / mean.error ** 2
        s, sx, sy, sxx, sxy = s + w, sx + w * x, sy + w * mean.value, sxx + w * x * x, sxy + w * x * mean.value
    determinant = s * sxx - sx * sx
    count = min(mean.count for _, mean in known)
    intercept = Mean((sxx * sy - sx * sxy) / determinant, math.sqrt(sxx / determinant), count)
    slope = Mean((s * sxy - sx * sy) / determinant, math.sqrt(s / determinant), count)
    squares = sum(((mean.value - intercept.value - slope.value * x) / mean.error) ** 2 for x, mean in known)
    return Line(intercept, slope, squares, len(known) - 2)
