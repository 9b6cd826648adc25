"""Means of independent samples, their standard errors, and how sure a comparison of them is."""
import dataclasses
import math
import statistics

# Two-sided 95 % of Student's t, for 1, 2, ... degrees of freedom.
STUDENT = (12.71, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228, 2.201, 2.179, 2.160, 2.145, 2.131,
           2.120, 2.110, 2.101, 2.093, 2.086, 2.080, 2.074, 2.069, 2.064, 2.060, 2.056, 2.052, 2.048, 2.045, 2.042)
NORMAL = 1.960   # the same for infinitely many ...
ROUNDING = 1e-9  # of degrees of freedom that were worked out
SLOPE = 2.5      # ... which t approaches by this over the degrees of freedom, to 0.2 %


def student(freedom):
    """Half-width of the interval of 95 % over the standard error, of so many degrees of freedom (rounded down); None of
    fewer than one."""
    whole = math.floor(freedom + ROUNDING)
    if whole < 1:
        return None
    return STUDENT[whole - 1] if whole <= len(STUDENT) else NORMAL + SLOPE / whole


def rounded(value, decimals):
    """With a true minus sign, and no minus before a nought."""
    text = f"{value:.{decimals}f}"
    if float(text) == 0.0:
        text = text.lstrip("-")
    return text.replace("-", "−")


def decimals_of(error):
    """That show an error with two digits where the first is a one, else with one."""
    exponent = math.floor(math.log10(error))
    if error / 10.0 ** exponent < 1.95:
        exponent -= 1
    return max(0, -exponent)


@dataclasses.dataclass(frozen=True)
class Mean:
    """A mean and its standard error, None of one sample; an estimate of another kind with its jackknife error."""
    value: float
    error: float
    count: int  # independent samples; of a difference, the fewer
    freedom: float = None  # degrees of freedom; None: one less than samples

    def degrees(self):
        return self.count - 1 if self.freedom is None else self.freedom

    def surely_above(self, bound):
        """@return True and False where the interval of 95 % says so, None where the bound lies within it"""
        factor = student(self.degrees())
        if factor is None or self.error is None:
            return None
        if self.value - factor * self.error > bound:
            return True
        return False if self.value + factor * self.error < bound else None

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
        """As 12.3 ± 0.4, the value times a scale; an error that is not defined is a dash."""
        if self.error is None:
            return f"{rounded(scale * self.value, 3)} ± —"
        if self.error == 0.0:
            return f"{scale * self.value:.4g} ± 0".replace("-", "−")
        decimals = decimals_of(scale * self.error)
        return f"{rounded(scale * self.value, decimals)} ± {rounded(scale * self.error, decimals)}"


def mean_of(values):
    """@return None where there is no sample"""
    values = list(values)
    if not values:
        return None
    error = statistics.stdev(values) / math.sqrt(len(values)) if len(values) > 1 else None
    return Mean(statistics.fmean(values), error, len(values))


def jackknife(estimate, samples):
    """Of an estimate from samples (a list of anything, one a seed): its value and its error, from leaving out one
    after the other (Quenouille; Tukey). @return None where the estimate, of all or of any but one, is not defined"""
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
