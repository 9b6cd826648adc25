"""Observations: readings as a vector of numbers, all of them finite."""
from __future__ import annotations

import dataclasses
import math
from typing import Callable, Sequence

import numpy as np

from .actions import QUANTITIES
from .interface import Box
from .readings import BASE_FIELDS, BIN_FIELDS, Readings

NAMES = ("time", "bins", "departures", "quality", "processed", "mean_vx", "histogram", "base")
DEFAULT = ("departures", "quality", "mean_vx", "histogram", "base")
_SHARE = (0.0, 1.0)
_COUNT = (0.0, math.inf)
_ANY = (-math.inf, math.inf)


@dataclasses.dataclass(frozen=True)
class Part:
    """A part of an observation: its elements with their bounds, and how they are read."""

    elements: Sequence[str]
    bounds: Sequence[tuple[float, float]]
    read: Callable[[Readings], np.ndarray]  # (n, ...) with one number for each element


class Observations:
    """The parts of an observation, one after the other.

    space  a Box of float64
    names  of its elements, such as "mean_vx.A"
    """

    def __init__(self, parts: Sequence[str], species: list[str], cells: int, episode: float,
                 limits: dict[str, tuple[float, float]]):
        """Raises ValueError."""
        parts = (parts,) if isinstance(parts, str) else tuple(parts)
        known = _parts(species, cells, episode, limits)
        for name in parts:
            if name not in known:
                raise ValueError(f"observations: there is none of the name {name!r}; there are {', '.join(NAMES)}")
        if len(set(parts)) != len(parts) or not parts:
            raise ValueError(f"observations = {parts}: must be different names, one or more")
        self._parts = [known[name] for name in parts]
        self.names = tuple(element for part in self._parts for element in part.elements)
        low, high = np.array([bounds for part in self._parts for bounds in part.bounds]).T
        self.space = Box(low.copy(), high.copy(), dtype=np.float64)

    def of(self, readings: Readings) -> np.ndarray:
        """A new array (n, elements)."""
        count = len(readings.time)
        return np.concatenate([part.read(readings).reshape(count, -1) for part in self._parts], axis=1,
                              dtype=np.float64)


def _parts(species: list[str], cells: int, episode: float,
           limits: dict[str, tuple[float, float]]) -> dict[str, Part]:
    def of_bins(name: str) -> Part:
        return Part([f"{name}.{field}.{kind}" for kind in species for field in BIN_FIELDS],
                    [_COUNT] * (len(species) * len(BIN_FIELDS)), lambda readings: getattr(readings, name))

    def share(name: str) -> Part:
        return Part([name, f"{name}_defined"], [_SHARE] * 2,
                    lambda readings: np.stack([getattr(readings, name), getattr(readings, f"{name}_defined")], axis=1))

    return {
        "time": Part(["time"], [(0.0, episode)], lambda readings: readings.time),
        "bins": of_bins("bins"),
        "departures": of_bins("departures"),
        "quality": share("quality"),
        "processed": share("processed"),
        "mean_vx": Part([f"{field}.{kind}" for kind in species for field in ("mean_vx", "mean_vx_defined")],
                        [_ANY, _SHARE] * len(species),
                        lambda readings: np.stack([readings.mean_vx, readings.mean_vx_defined], axis=2)),
        "histogram": Part([f"histogram.{kind}.{cell}" for kind in species for cell in range(cells)],
                          [_COUNT] * (len(species) * cells), lambda readings: readings.histogram),
        "base": Part([f"base.{field}" for field in BASE_FIELDS], [_base_bounds(field, limits) for field in BASE_FIELDS],
                     lambda readings: readings.base),
    }


def _base_bounds(field: str, limits: dict[str, tuple[float, float]]) -> tuple[float, float]:
    quantity = field.replace("commanded_", "")
    if quantity in QUANTITIES:
        return limits.get(quantity, QUANTITIES[quantity]["legal"])
    return (0.0, 2.0 * math.pi) if field == "phase" else _ANY
