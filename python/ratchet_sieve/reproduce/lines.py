"""Straight lines through measured points."""
import dataclasses
import math

import numpy

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
    xs, ys, errors = (numpy.array(column) for column in zip(*((x, mean.value, mean.error) for x, mean in known)))
    values, covariance = numpy.polyfit(xs, ys, 1, w=1.0 / errors, cov="unscaled")
    count = min(mean.count for _, mean in known)
    slope, intercept = (Mean(float(value), math.sqrt(variance), count)
                        for value, variance in zip(values, covariance.diagonal()))
    squares = float((((ys - numpy.polyval(values, xs)) / errors) ** 2).sum())
    return Line(intercept, slope, squares, len(known) - 2)
