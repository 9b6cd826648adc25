"""Means of independent samples, their standard errors, and tests of them."""
import dataclasses
import math
import statistics

import numpy
from scipy import special

from ratchet_sieve.arguments import number
from ratchet_sieve.texts import plus_minus, rounded

LEVEL = 0.05  # of a test: an interval of 95 %


def two_sided(t, freedom):
    """The probability of a value at least as far from 0 as t, of Student's distribution."""
    return float(2.0 * special.stdtr(freedom, -abs(t)))


def quantile(freedom, level=LEVEL):
    """@return t with two_sided(t, freedom) = level: 1 - level of the distribution lies between -t and t"""
    return float(special.stdtrit(freedom, 1.0 - 0.5 * level))


def wilson(part, whole, level=LEVEL):
    """The interval of a share of which `part` of `whole` were seen (Wilson, J. Am. Stat. Assoc. 22, 209 (1927)). It has
    a width where all or none were.
    @return (low, high)"""
    z = float(special.ndtri(1.0 - 0.5 * level))
    share, scale = part / whole, 1.0 + z * z / whole
    half = z * math.sqrt(share * (1.0 - share) / whole + 0.25 * (z / whole) ** 2) / scale
    centre = (share + 0.5 * z * z / whole) / scale
    return (0.0 if part == 0 else centre - half), (1.0 if part == whole else centre + half)


def chi_squared_tail(x, freedom):
    """The probability of more than x."""
    return float(special.chdtrc(freedom, x))


@dataclasses.dataclass(frozen=True)
class Mean:
    """A mean and its standard error (None for one sample), or another estimate and its jackknife error."""
    value: float
    error: float
    count: int  # independent samples; of a difference, the smaller number
    freedom: float = None  # degrees of freedom; None: one less than samples

    def degrees(self):
        return self.count - 1 if self.freedom is None else self.freedom

    def p_value(self, bound):
        """Of the two-sided test that the true mean is the bound (Student's t). 1 where there is no error."""
        if self.error is None or self.degrees() <= 0.0:
            return 1.0
        distance = abs(self.value - bound)
        if self.error == 0.0:
            return 0.0 if distance else 1.0
        return two_sided(distance / self.error, self.degrees())

    def half_width(self):
        """Of the interval of 95 %; None where there is no error, as of one sample."""
        if self.error is None or self.degrees() <= 0.0:
            return None
        return quantile(self.degrees()) * self.error

    def surely_above(self, bound):
        """@return True and False where the interval of 95 % says so, None where the bound lies within it"""
        return self.value > bound if self.p_value(bound) < LEVEL else None

    def surely_below(self, bound):
        above = self.surely_above(bound)
        return None if above is None else not above

    def scaled(self, factor):
        return dataclasses.replace(self, value=factor * self.value,
                                   error=None if self.error is None else abs(factor) * self.error)

    def minus(self, other):
        """Of two independent means, with the degrees of freedom of Welch and Satterthwaite."""
        value, count = self.value - other.value, min(self.count, other.count)
        if self.error is None or other.error is None:
            return Mean(value, None, count)
        a, b = self.error ** 2, other.error ** 2
        parts = a * a / self.degrees() + b * b / other.degrees()
        return Mean(value, math.sqrt(a + b), count, (a + b) ** 2 / parts if parts > 0.0 else count - 1)

    def text(self, scale=1.0):
        """As 12.3 ± 0.4, times a scale. An undefined error is a dash."""
        if self.error is None:
            return f"{rounded(scale * self.value, 3)} ± —"
        if self.error == 0.0:
            return f"{scale * self.value:.4g} ± 0".replace("-", "−")
        return plus_minus(scale * self.value, scale * self.error)


def holm(p_values, level=LEVEL):
    """Which of several hypotheses are rejected, so that a true one is among them with this probability at most (Holm,
    Scand. J. Statist. 6, 65 (1979)). @return a truth value for each"""
    p_values = list(p_values)
    order = sorted(range(len(p_values)), key=p_values.__getitem__)
    rejected = [False] * len(p_values)
    for rank, k in enumerate(order):
        if p_values[k] > level / (len(p_values) - rank):
            break
        rejected[k] = True
    return rejected


def signs(means):
    """Of each mean: True where it is surely above 0, False where it is surely below, else None; by Holm's method."""
    means = list(means)
    sure = holm(1.0 if mean is None else mean.p_value(0.0) for mean in means)
    return [mean.value > 0.0 if is_sure else None for mean, is_sure in zip(means, sure)]


def mean_of(values):
    """@return None where there is no sample @throws ValueError one is no finite number: leave out what is undefined"""
    values = [number(f"values[{k}]", value) for k, value in enumerate(values)]
    if not values:
        return None
    error = statistics.stdev(values) / math.sqrt(len(values)) if len(values) > 1 else None
    return Mean(statistics.fmean(values), error, len(values))


def jackknife(estimate, samples):
    """An estimate and its error, from leaving out one sample after the other (Quenouille; Tukey).
    @param samples a list of anything, one for each seed
    @return None where the estimate is not defined, for all samples or without one of them"""
    samples = list(samples)
    value = estimate(samples)
    if value is None:
        return None
    if len(samples) < 2:
        return Mean(value, None, len(samples))
    without = [estimate(samples[:k] + samples[k + 1:]) for k in range(len(samples))]
    if any(other is None for other in without):
        return None
    count, centre = len(samples), statistics.fmean(without)
    return Mean(value, math.sqrt((count - 1) / count * sum((w - centre) ** 2 for w in without)), count)


def variance_of(values):
    """The samples' variance and its standard error, for samples of any distribution. @return None of fewer than four"""
    values = list(values)
    count = len(values)
    if count < 4:
        return None
    centre = statistics.fmean(values)
    second = sum((v - centre) ** 2 for v in values) / (count - 1)
    fourth = sum((v - centre) ** 4 for v in values) / count
    error = math.sqrt(max(0.0, fourth - second ** 2 * (count - 3) / (count - 1)) / count)
    return Mean(second, error, count)


def density_of(values, width):
    """The distribution of independent values in bins of a width, one of which begins at 0.
    @return edges of the bins from the first that holds a value to the last, and of their neighbours; densities;
    standard errors of these"""
    bins = numpy.floor(numpy.asarray(values) / width).astype(int)
    first = bins.min() - 1
    shares = numpy.bincount(bins - first, minlength=bins.max() - first + 2) / len(bins)
    errors = numpy.sqrt(shares * (1.0 - shares) / len(bins))
    return width * (first + numpy.arange(len(shares) + 1)), shares / width, errors / width
