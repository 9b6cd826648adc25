"""What a calibration found: coefficients of grains, or of the machine, with which the feeder does what was measured."""
from __future__ import annotations

import dataclasses
import itertools
from typing import Any, Optional

import numpy as np
import pandas

from ratchet_sieve.answers.answer import Interval
from ratchet_sieve.answers.proposal import text_of
from ratchet_sieve.answers.unknown import LEVEL, Prior, Unknown
from ratchet_sieve.texts import counted, shown
from ratchet_sieve.values import Values

TOGETHER = 0.7  # a correlation, above which two keys are known together only
LITTLE = 0.75   # of an interval over what was known before: hardly anything was learned


@dataclasses.dataclass(repr=False)
class Grains:
    """Coefficients with which measured and computed agree. grains[KEY] is an Interval, .value and .half_width at 95 %
    (None where they do not agree; what was given as unknown where the measurements tell little more). Goes where a
    scene goes; separate() averages over what is left unknown.

    keys         that were unknown
    agrees       whether any coefficients explain the measurements
    chi_squared  of the measured numbers, at the best coefficients
    table        DataFrame: of each measured number its row, what it is, as measured with its standard error, and as
                 computed with the surface's, and its part of chi_squared
    draws        DataFrame: values of the keys, each row as likely as another
    best         the likeliest values
    added        what the surfaces add to the errors of the measurements at most, as a share of these
    next_measurement  the setting that would narrow the intervals most: .setting, and .errors, of each key over what it
                 is now; None where `over` was not given, or nothing agrees
    cost         runs, simulated [s], processor [s] and seconds [s of wall time]
    """

    base: Any
    prior: Prior
    draws: pandas.DataFrame
    best: dict
    settings: list
    table: pandas.DataFrame
    agrees: bool
    added: float
    cost: Values
    next_measurement: Optional[Values] = None

    @property
    def keys(self) -> list[str]:
        return list(self.draws)

    @property
    def chi_squared(self) -> float:
        return float(self.table.chi_squared.sum())

    def __getitem__(self, key: str) -> Interval:
        """Raises KeyError."""
        if not self.agrees:
            return Interval(self.best[key], None, 0)
        low, high = self.prior.given[key]
        return Interval(0.5 * (low + high), 0.5 * (high - low), 0) if self.is_open(key) else _interval(self.draws[key])

    def is_open(self, key: str) -> bool:
        """Whether the measurements tell hardly more of a key than was known before."""
        low, high = self.prior.given[key]
        return _interval(self.draws[key]).half_width > LITTLE * 0.5 * (high - low)

    @property
    def scene(self) -> Any:
        """With the mean of each key; where nothing agrees with the best one."""
        return self.base.replace(self.unknown.middle if self.agrees else self.best)

    @property
    def unknown(self) -> Unknown:
        """What is left unknown. Raises ValueError where nothing agrees."""
        if not self.agrees:
            raise ValueError(f"grains: {self._agreement()}: nothing can be computed from them")
        return Unknown(self.keys, self.draws.to_numpy())

    def __str__(self) -> str:
        lines = []
        for key in self.keys if self.agrees else ():
            low, high = self.prior.given[key]
            lines.append(f"{key} {low:.3g} to {high:.3g}, as before: the measurements tell hardly more"
                         if self.is_open(key) else f"{key} {self[key]} (95 %)")
        lines += self._together() if self.agrees else []
        lines.append(self._agreement())
        if self.next_measurement:
            lines.append(text_of(self.next_measurement))
        lines.append(f"cost: {counted(self.cost.runs, 'run')}, {self.cost.simulated:.4g} s simulated, "
                     f"{self.cost.processor:.3g} s of processor time")
        return "\n".join(lines)

    __repr__ = __str__

    def _agreement(self) -> str:
        found = f"χ² = {self.chi_squared:.3g} of {counted(len(self.table), 'number')}"
        if self.agrees:
            return f"measured and computed agree: {found}"
        worst = self.table.loc[self.table.chi_squared.idxmax()]
        at = ", ".join(f"{key} = {value}" for key, value in self.settings[worst.row - 1].items())
        return f"measured and computed do not agree: {found}; worst: {worst.number} at {at or f'row {worst.row}'}"

    def _together(self) -> list[str]:
        """Of pairs that are known together only, what is known of both."""
        found = []
        for (first, x), (second, y) in itertools.combinations(self.draws.items(), 2):
            slope = -x.corr(y)
            if abs(slope) > TOGETHER:
                slope = float(f"{np.copysign(x.std() / y.std(), slope):.2g}")
                found.append(f"{first} and {second} cannot be told apart by these measurements: of both only {first} "
                             f"{'+' if slope > 0.0 else '−'} {shown(abs(slope))} {second} = {_interval(x + slope * y)}")
        return found

    def plot(self) -> Any:
        """Draws pairs of keys, and measured beside computed. Returns matplotlib's axes of these."""
        from ratchet_sieve.plots.grains import draw

        return draw(self)


def _interval(values: np.ndarray) -> Interval:
    """The mean, and the half width of what is as wide around it and holds 95 %."""
    mean = float(values.mean())
    return Interval(mean, float(np.quantile(np.abs(values - mean), LEVEL)), len(values))
