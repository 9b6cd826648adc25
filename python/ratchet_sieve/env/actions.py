"""Actions: setpoints of the base."""
from __future__ import annotations

from typing import Any, Mapping, Optional, Sequence

import numpy as np

from .. import _engine
from ..scene import Scene
from .interface import Box

QUANTITIES = {quantity["name"]: quantity for quantity in _engine.COMMANDED_QUANTITIES}
"""What can be commanded: name, unit, legal and usual range, slew_rate (the usual one), slew_rates (legal ones)."""

# Of a limit's span: how far beyond it an action may be, because it was rounded to 32 bits. It is then the limit.
_ROUNDING = 1e-6


class Actions:
    """The commanded quantities, in the order of an action's elements."""

    def __init__(self, names: Sequence[str], limits: Optional[Mapping[str, Sequence[float]]],
                 slew_rates: Optional[Mapping[str, float]]):
        """Limits and slew rates that are left out are the usual ones, the defaults of the ROS node.
        Raises ValueError."""
        self.names = (names,) if isinstance(names, str) else tuple(names)
        _require_known("actions", self.names, QUANTITIES)
        if len(set(self.names)) != len(self.names) or not self.names:
            raise ValueError(f"actions = {self.names}: must be different quantities, one or more")
        _require_known("limits", limits or (), self.names)
        _require_known("slew_rates", slew_rates or (), QUANTITIES)
        self.limits = {name: _limits(QUANTITIES[name], (limits or {}).get(name)) for name in self.names}
        self.slew_rates = {name: _slew_rate(quantity, (slew_rates or {}).get(name))
                           for name, quantity in QUANTITIES.items()}
        low, high = np.array([self.limits[name] for name in self.names], dtype=np.float64).T
        self.space = Box(low.copy(), high.copy(), dtype=np.float64)

    def require_start(self, scene: Scene) -> None:
        """Raises ValueError if the base of a scene is outside the limits at the start."""
        for name, (low, high) in self.limits.items():
            if not low <= scene[f"base.{name}"] <= high:
                raise ValueError(f"base.{name} = {scene[f'base.{name}']}: must be within the limits of the actions, "
                                 f"{low:g} to {high:g} {QUANTITIES[name]['unit']}")

    def checked(self, actions: Any, sieves: Sequence[int]) -> np.ndarray:
        """Actions (sieves, quantities) as setpoints. Raises ValueError for one outside the space."""
        setpoints = np.array(actions, dtype=np.float64)
        if setpoints.shape != (len(sieves), len(self.names)):
            raise ValueError(f"action of shape {setpoints.shape[1:] if len(sieves) == 1 else setpoints.shape}: must be "
                             f"({', '.join(self.names)}){'' if len(sieves) == 1 else ' for each sieve'}")
        low, high = self.space.low, self.space.high
        margin = _ROUNDING * (high - low)
        wrong = np.argwhere(~((setpoints >= low - margin) & (setpoints <= high + margin)))
        if len(wrong):
            row, column = wrong[0]
            name = self.names[column]
            of_sieve = f" of sieve {sieves[row]}" if len(sieves) > 1 else ""
            raise ValueError(f"action{of_sieve}: {name} = {setpoints[row, column]:g}: must be {low[column]:g} to "
                             f"{high[column]:g} {QUANTITIES[name]['unit']}")
        return np.clip(setpoints, low, high)


def _require_known(what: str, names: Any, known: Any) -> None:
    for name in names:
        if name not in known:
            raise ValueError(f"{what}: there is no quantity {name!r}; there are {', '.join(known)}")


def _limits(quantity: Mapping[str, Any], given: Optional[Sequence[float]]) -> tuple[float, float]:
    if given is None:
        return quantity["usual"]
    least, most = quantity["legal"]
    low, high = (float(limit) for limit in given)
    if not least <= low < high <= most:
        raise ValueError(f"limits of {quantity['name']} = {low:g}, {high:g}: must be two, the lower one first, within "
                         f"{least:g} to {most:g} {quantity['unit']}")
    return low, high


def _slew_rate(quantity: Mapping[str, Any], given: Optional[float]) -> float:
    if given is None:
        return quantity["slew_rate"]
    least, most = quantity["slew_rates"]
    if not least <= given <= most:
        raise ValueError(f"slew rate of {quantity['name']} = {given:g}: must be {least:g} to {most:g} "
                         f"{quantity['unit']}/s")
    return float(given)
