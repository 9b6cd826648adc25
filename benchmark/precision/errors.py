"""How far a point is off its reference, with the error of both."""
import dataclasses
import math

from precision import rungs
from precision.points import find
from ratchet_sieve.stats import Mean
from ratchet_sieve.texts import decimals_of, rounded

PERCENT = 100.0
LEAST = 1e-3  # that is printed [%]


def exact(points, name):
    """The value that is known, or that of the exact engine on the same scene; None where it was not measured."""
    point = find(points, "exact")
    if point is None:
        return None
    known = point.scene.known.get(name)
    return point.means.get(name) if known is None else Mean(known, 0.0, 2)


def least_floor(points, name):
    """That of the exact engine at the least rebound floor; None where it was not measured."""
    point = find(points, "rebound floor", f"{rungs.REFERENCE_FLOOR:g} m/s")
    return point and point.means.get(name)


def relative(observed, reference):
    """@return the error over the reference's value, as a Mean with the standard error of both; None where one is
    missing or has no standard error"""
    if observed is None or reference is None or None in (observed.error, reference.error):
        return None
    ratio = observed.value / reference.value
    spread = observed.minus(reference.scaled(ratio)).scaled(1.0 / reference.value)
    return dataclasses.replace(spread, value=math.copysign(ratio - 1.0, (ratio - 1.0) * reference.value))


def bound(error):
    """What the error is at most, at 95 %: its estimate and the half-width of its interval."""
    return abs(error.value) + error.half_width()


def largest(found):
    """The largest bound of several errors; None where there is none."""
    return max((bound(error) for error in found if error is not None), default=None)


def is_seen(error):
    """Whether the interval of 95 % leaves 0 out."""
    return abs(error.value) > error.half_width()


def text(error):
    """As +1.2 ± 0.4, in per cent with the half-width at 95 %."""
    if error is None:
        return "—"
    half = PERCENT * error.half_width()
    if half < LEAST:
        return f"{PERCENT * error.value:+.2g}".replace("-", "−") if PERCENT * abs(error.value) >= LEAST else "0"
    value = rounded(PERCENT * error.value, decimals_of(half))
    return f"{value if value.startswith('−') else '+' + value} ± {rounded(half, decimals_of(half))}"


def bound_text(value):
    """In per cent, rounded up to two digits."""
    if value is None:
        return "—"
    percent = PERCENT * value
    if percent < 0.01:
        return "0.01"
    decimals = max(0, 1 - math.floor(math.log10(percent)))
    rounded_up = math.ceil(percent * 10 ** decimals - 1e-9) / 10 ** decimals
    return f"{rounded_up:.{0 if rounded_up >= 10.0 else decimals}f}"
