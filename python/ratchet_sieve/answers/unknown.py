"""What is not known of grains or of a machine: values of keys of a scene, each as likely as another."""
from __future__ import annotations

import warnings
from typing import Any, Iterable, Mapping

import numpy as np
from scipy import stats

from ratchet_sieve.answers.places import spread
from ratchet_sieve.arguments import mapping, number
from ratchet_sieve.errors import SceneError, SieveWarning

EXAMPLE = '{"species.0.restitution": (0.9, 0.98)}'
NOT_UNKNOWN = ("seed", "duration", "settle")
LEVEL = 0.95     # of an interval
Z_95 = 1.96      # standard deviations of half of one
SIGMAS = 3.0     # where a normal distribution is cut, in standard deviations
ROWS = 4096      # of a table of draws
BISECTIONS = 30  # of the last legal value
INNER = 0.618    # of a range, within which whole numbers are refused


class Unknown:
    """@ivar keys of a scene @ivar table (n, d) of their values, each row as likely as another"""

    def __init__(self, keys: list[str], table: np.ndarray):
        self.keys, self.table = keys, table

    @property
    def middle(self) -> dict[str, float]:
        """The mean of each key."""
        return self.settings(self.table.mean(axis=0))

    def settings(self, values: np.ndarray) -> dict[str, float]:
        """@param values (d,)"""
        return {key: float(f"{value:.6g}") for key, value in zip(self.keys, values)}

    def draw(self, seed: int) -> dict[str, float]:
        """The values of a run with this seed. Seeds in a row fill what is unknown evenly."""
        return self.settings(self.table[seed % len(self.table)])

    def cases_of(self, case: dict, seeds: Iterable[int], shift: int = 0) -> list[dict]:
        """A case with each seed, and values of its own. @param shift of the draws, for runs that share a seed"""
        return [{**case, **self.draw(seed + shift), "seed": seed} for seed in seeds]


class Prior(Unknown):
    """Ranges, in which a value is anywhere; or values with errors: then normal, cut at three standard deviations and at
    what is legal. The keys are independent. @ivar given key -> (low, high), of a normal one at 95 %"""

    def __init__(self, scene: Any, unknown: Mapping[str, Any]):
        """@param unknown key -> (low, high), or (value, "±", half the width of its interval at 95 %). Raises
        ValueError, SceneError."""
        if not mapping("unknown", unknown, EXAMPLE):
            raise ValueError(f"unknown: must name a key, such as {EXAMPLE}")
        self._distributions = [_distribution(scene, key, ends) for key, ends in unknown.items()]
        self.given = {key: of.interval(1.0 if len(unknown[key]) == 2 else LEVEL)
                      for key, of in zip(unknown, self._distributions)}
        super().__init__(list(unknown), self.values(spread(len(unknown), ROWS, 0)))
        scene.replace(self.middle)  # warns of what is implausible

    def values(self, places: np.ndarray) -> np.ndarray:
        """@param places (n, d) from 0 to 1, of which equal parts are equally likely @return (n, d)"""
        return np.stack([of.ppf(place) for of, place in zip(self._distributions, places.T)], axis=1)


def prior_of(scene: Any, unknown: Any) -> Any:
    """@param unknown as Prior takes it, an Unknown itself, or None"""
    return unknown if unknown is None or isinstance(unknown, Unknown) else Prior(scene, unknown)


def _distribution(scene: Any, key: str, ends: Any) -> Any:
    """@return scipy's. Raises ValueError, SceneError."""
    name = f"unknown[{key!r}]"
    if key in NOT_UNKNOWN:
        raise ValueError(f"{name}: must be another key than {', '.join(NOT_UNKNOWN)}")
    is_normal = isinstance(ends, (tuple, list)) and len(ends) == 3 and ends[1] in ("±", "+-")
    if not is_normal and (not isinstance(ends, (tuple, list)) or len(ends) != 2):
        raise ValueError(f'{name} = {ends!r}: must be a pair (low, high), or (value, "±", error)')
    if is_normal:
        value, sigma = number(f"{name}, value", ends[0]), number(f"{name}, error", ends[2]) / Z_95
        if sigma <= 0.0:
            raise ValueError(f"{name}, error = {ends[2]!r}: must be above 0")
        _require(scene, key, value)
        legal = [_legal(scene, key, value, value + side * SIGMAS * sigma) for side in (-1.0, 1.0)]
        return stats.truncnorm(*((end - value) / sigma for end in legal), loc=value, scale=sigma)
    low, high = number(f"{name}, low", ends[0]), number(f"{name}, high", ends[1])
    if not low < high:
        raise ValueError(f"{name} = {ends[0]!r} to {ends[1]!r}: must have a width: low below high")
    for value in (low, high, low + INNER * (high - low)):
        _require(scene, key, value)
    return stats.uniform(low, high - low)


def _require(scene: Any, key: str, value: float) -> None:
    """Raises SceneError for a value that a scene does not take."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", SieveWarning)
        scene.replace({key: value})


def _legal(scene: Any, key: str, value: float, end: float) -> float:
    """The last legal value from a legal one to an end."""
    tried = end
    for _ in range(BISECTIONS):
        try:
            _require(scene, key, tried)
            if tried == end:
                return end
            value = tried
        except SceneError:
            end = tried
        tried = 0.5 * (value + end)
    return value
