"""What is read of sieves at the end of a step."""
from __future__ import annotations

from typing import Any, Mapping, Optional, Sequence

import numpy as np

from .. import _engine
from ..goals import LEFT, ON_BASE, RIGHT, Goal
from ..values import Values

BIN_FIELDS: tuple = _engine.BIN_FIELDS
BASE_FIELDS: tuple = _engine.BASE_FIELDS
_COUNTED = [k for k in range(len(BIN_FIELDS)) if k != ON_BASE]  # what only grows


class Readings:
    """Columns of numpy arrays with a row for each of n sieves with S species.

    time         (n,)            since the episode began [s]
    bins         (n, S, fields)  since the episode began, by BIN_FIELDS (left, right, on_base [disks], masses [kg])
    departures   (n, S, fields)  likewise, of what left within the window; on_base is at its end
    window       (n,)            the length of the window [s]; at the start of an episode it is shorter
    quality      (n,)            Q of the departures; 0 where it is undefined, see quality_defined
    processed    (n,)            P: departures over these and what is on the base; see processed_defined
    mean_vx      (n, S)          mean velocity in x during the step, of the disks that were in the machine for all of it
                                 [m/s]; 0 where it is undefined, see mean_vx_defined
    histogram    (n, S, cells)   numbers of disks in equal cells along the base, from the left
    base         (n, fields)     by BASE_FIELDS; see Simulation.base
    sensors      (n, values)     what the sensors sent last, by `sensed`; 0 before
    """

    def __init__(self, species: list[str], count: int, cells: int, window_steps: int, sensed: Sequence[str] = ()):
        self.species, self.sensed = species, sensed
        self.sensors = np.zeros((count, len(sensed)))
        self.time = np.zeros(count)
        self.bins = np.zeros((count, len(species), len(BIN_FIELDS)))
        self.mean_vx = np.zeros((count, len(species)))
        self.mean_vx_defined = np.zeros((count, len(species)), dtype=bool)
        self.histogram = np.zeros((count, len(species), cells))
        self.base = np.zeros((count, len(BASE_FIELDS)))
        self.departures = self.bins.copy()
        self.window = np.zeros(count)
        self._quality = Goal("quality", species)
        self.quality, self.quality_defined = self.measured(self._quality, slice(None))
        self.processed, self.processed_defined = np.zeros(count), np.zeros(count, dtype=bool)
        # The bins and times at the ends of the last steps: rings, of each sieve with the place of the oldest.
        self._past_bins = np.zeros((count, window_steps + 1, *self.bins.shape[1:]))
        self._past_times = np.zeros((count, window_steps + 1))
        self._oldest = np.zeros(count, dtype=np.int64)

    def begin(self, which: np.ndarray, read: Mapping[str, np.ndarray]) -> None:
        """Takes what was read of these sieves at the start of their episodes."""
        self._past_bins[which] = read["bins"][:, np.newaxis]
        self._past_times[which] = read["time"][:, np.newaxis]
        self._take(which, read)

    def add(self, which: np.ndarray, read: Mapping[str, np.ndarray]) -> None:
        """Takes what was read of these sieves at the end of a step."""
        oldest = self._oldest[which]
        self._past_bins[which, oldest] = read["bins"]
        self._past_times[which, oldest] = read["time"]
        self._oldest[which] = (oldest + 1) % self._past_times.shape[1]
        self._take(which, read)

    def _take(self, which: np.ndarray, read: Mapping[str, np.ndarray]) -> None:
        for name in ("time", "bins", "histogram", "base", "sensors"):
            getattr(self, name)[which] = read[name]
        self.mean_vx_defined[which] = np.isfinite(read["mean_vx"])
        self.mean_vx[which] = np.nan_to_num(read["mean_vx"])
        departures = read["bins"].copy()
        departures[..., _COUNTED] -= self._past_bins[which, self._oldest[which]][..., _COUNTED]
        self.departures[which] = departures
        self.window[which] = read["time"] - self._past_times[which, self._oldest[which]]
        self.quality[which], self.quality_defined[which] = self.measured(self._quality, which)
        left = departures[..., (LEFT, RIGHT)].sum(axis=(1, 2))
        every = left + departures[..., ON_BASE].sum(axis=1)
        self.processed_defined[which] = left > 0.0
        self.processed[which] = np.divide(left, every, out=np.zeros(len(left)), where=left > 0.0)

    def measured(self, goal: Goal, which: Any) -> tuple[np.ndarray, np.ndarray]:
        """A goal, of the departures: values, 0 where it is undefined, and whether it is defined."""
        value, _, defined = goal.measured(self.departures[which], self.window[which])
        return value, defined

    def of(self, k: int) -> Values:
        """All of one sieve, by name; undefined values are None."""
        def bins(table: np.ndarray) -> Values:
            return Values((name, Values(zip(BIN_FIELDS, row.tolist()))) for name, row in zip(self.species, table[k]))

        def optional(value: Any, defined: Any) -> Optional[float]:
            return float(value) if defined else None

        return Values(
            time=float(self.time[k]), bins=bins(self.bins), departures=bins(self.departures),
            window=float(self.window[k]), quality=optional(self.quality[k], self.quality_defined[k]),
            processed=optional(self.processed[k], self.processed_defined[k]),
            mean_vx=Values(zip(self.species, map(optional, self.mean_vx[k], self.mean_vx_defined[k]))),
            histogram=Values(zip(self.species, self.histogram[k].copy())),
            base=Values(zip(BASE_FIELDS, self.base[k].tolist())),
            sensors=Values(zip(self.sensed, self.sensors[k].tolist())))
