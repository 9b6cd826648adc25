"""Student's t distribution."""
import math

ITERATIONS = 300
TINY = 1e-300
PRECISION = 1e-13


def continued_fraction(a, b, x):
    """Of the incomplete beta function, by Lentz's method (Press et al., Numerical Recipes, betacf)."""
    c, d = 1.0, 1.0 / (1.0 - (a + b) * x / (a + 1.0) or TINY)
    result = d
    for m in range(1, ITERATIONS):
        even = m * (b - m) * x / ((a + 2 * m - 1.0) * (a + 2 * m))
        odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1.0))
        for term in (even, odd):
            d = 1.0 / (1.0 + term * d or TINY)
            c = 1.0 + term / c or TINY
            result *= c * d
        if abs(c * d - 1.0) < PRECISION:
            break
    return result


def incomplete_beta(a, b, x):
    """Regularised: I_x(a, b)."""
    if x <= 0.0 or x >= 1.0:
        return float(x >= 1.0)
    front = math.exp(math.lgamma(a + b) - math.lgamma(a) - math.lgamma(b) + a * math.log(x) + b * math.log1p(-x))
    if x < (a + 1.0) / (a + b + 2.0):
        return front * continued_fraction(a, b, x) / a
    return 1.0 - front * continued_fraction(b, a, 1.0 - x) / b


def two_sided(t, freedom):
    """The probability of a value at least as far from 0 as t."""
    return incomplete_beta(0.5 * freedom, 0.5, freedom / (freedom + t * t))


def quantile(freedom, level=0.05):
    """@return t with two_sided(t, freedom) = level: 1 - level of the distribution lies between -t and t"""
    low, high = 0.0, 1.0
    while two_sided(high, freedom) > level:
        high *= 2.0
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if two_sided(middle, freedom) > level else (low, middle)
    return high
