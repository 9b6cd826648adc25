"""Which coefficients make a feeder do what was measured: a surface over the coefficients for each measured number, and
the places of them at which all numbers agree (Kennedy and O'Hagan, J. R. Stat. Soc. B 63, 425 (2001), without a
discrepancy of the model: where there is one, the measurements are refused instead)."""
from __future__ import annotations

import time
import warnings
from typing import Any, Iterable, Mapping

import numpy as np
import pandas

from ratchet_sieve import stats, sweeps
from ratchet_sieve.answers.grains import Grains
from ratchet_sieve.answers.measured import Measured, Number
from ratchet_sieve.answers.places import spread
from ratchet_sieve.answers.posterior import drawn
from ratchet_sieve.answers.proposal import proposed, settings_of
from ratchet_sieve.answers.search import seed_of
from ratchet_sieve.answers.surface import Surface
from ratchet_sieve.answers.unknown import Prior
from ratchet_sieve.arguments import integer
from ratchet_sieve.errors import SieveWarning
from ratchet_sieve.progress import Progress
from ratchet_sieve.scene import AnyScene, scene_of
from ratchet_sieve.values import Values

FIRST = 10         # places for each unknown key that are run first (Loeppky et al., Technometrics 51, 366 (2009))
MORE = 32          # places that are run where the weights are, each time
MOST_ROUNDS = 8    # of these
REFUSED_AFTER = 3  # of them, where nothing agrees
SURE = 1.0 / 3.0   # what the surfaces may add to the errors of the measurements
AROUND = 1.3       # by what these places are wider spread than the weights
LEVEL = 0.0027     # of the test whether measured and computed agree: three standard deviations, as Vernon et al.,
#                    Bayesian Anal. 5, 619 (2010), take it
WIDE_ERRORS = 2.0  # standard deviation of the logarithm of how the variances of runs differ from what is stated
DRAWS = 2000       # that the answer keeps


def calibrate(scene: AnyScene, unknown: Mapping[str, Any], measured: Any, *, over: Any = None, seed: int = 1,
              results: Any = None, threads: int = 0, progress: bool = True) -> Grains:
    """Which coefficients make a feeder do what was measured, and how surely.

    scene     a Scene, the path of a scene file, or a mapping: the feeder and its grains
    unknown   key of the scene -> (low, high), or (value, "±", error at 95 %)
    measured  a CSV file, rows as a list of mappings or a DataFrame, or bags of ROS. Of each setting: keys of the scene,
              and of each kind the counts left.A, right.A and on_base.A at the end of `duration`; or numbers as columns
              of a sweep's results, such as mean_vx.A, with their standard errors, mean_vx.A.stderr: without one the
              error is that of a run
    over      ranges of keys, of which the next measurement is proposed; None: none is
    seed      the same gives the same answer, with any number of threads
    results   file that keeps the runs (SQLite): the same call continues. None: kept nowhere
    Raises SceneError, ValueError before anything runs, OSError, BagError; RuntimeError where the runs say nothing.
    """
    scene = scene_of(scene)
    search = Calibration(scene, unknown, measured, seed, threads=integer("threads", threads), results=results)
    more = settings_of(scene, over, unknown) if over else []
    clocks = time.monotonic(), time.process_time()
    with Progress(progress, "calibrate") as bar:
        bar.say(str(search.data))
        search.run(spread(len(search.keys), FIRST * len(search.keys), seed), range(len(search.data.settings)))
        for k in range(MOST_ROUNDS + 1):
            search.fit()
            bar.show(0.2 + 0.8 * k / MOST_ROUNDS, f"{search.runs} runs: surfaces add {search.added.max():.2g} of errors")
            unsure = {number.row for number, added in zip(search.data.numbers, search.added) if added > SURE}
            if not unsure or k == MOST_ROUNDS or k >= REFUSED_AFTER and not search.agrees:
                break
            search.run(search.near(k), sorted(unsure))
        return search.answer(more, clocks)


class Calibration:
    """@ivar runs so far @ivar simulated [s] @ivar added of each number by its surface to the error of the measurement,
    where the weights are @ivar parts of chi squared, of each number at the best place"""

    def __init__(self, scene: Any, unknown: Any, measured: Any, seed: int, **options: Any):
        """@param options of sweep()"""
        self.scene, self.prior = scene, Prior(scene, unknown)
        self.keys, self.data = self.prior.keys, Measured(scene, measured, self.prior.keys)
        self.seed, self._options = seed_of(seed), options
        stop = {"feed.on_choke": "stop"} if scene["feed.rate"] > 0.0 else {}
        observed = {*scene.values.get("observe", ()), *self.data.observed}
        self._running = scene.replace({**stop, "observe": sorted(observed)})
        self.runs, self.simulated = 0, 0.0
        self._places = [np.empty((0, len(self.keys)))] * len(self.data.settings)
        self._rows = [pandas.DataFrame()] * len(self.data.settings)
        self._surfaces: list = [None] * len(self.data.numbers)

    def run(self, places: np.ndarray, measured: Iterable[int]) -> None:
        """@param measured rows, at whose settings all places are run"""
        found = self.rows_of(places, [self.data.settings[row] for row in measured])
        for row, rows in zip(measured, found):
            self._places[row] = np.vstack([self._places[row], places])
            self._rows[row] = pandas.concat([self._rows[row], rows], ignore_index=True)

    def rows_of(self, places: np.ndarray, settings: list) -> list[pandas.DataFrame]:
        """@return of each setting a row for each place; all with seeds of their own"""
        cases = [{**setting, **self.prior.settings(values)}
                 for setting in settings for values in self.prior.values(places)]
        for k, case in enumerate(cases, self.runs):
            case["seed"] = self.seed + k
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", SieveWarning)
            rows = sweeps.sweep(self._running, cases=cases, progress=False, **self._options)
        self.runs, self.simulated = self.runs + len(rows), self.simulated + float(rows["simulated_time"].sum())
        return [rows.iloc[k * len(places):(k + 1) * len(places)] for k in range(len(settings))]

    @staticmethod
    def values_of(number: Number, rows: pandas.DataFrame) -> tuple[np.ndarray, np.ndarray]:
        """What runs of a setting say of a number, NaN where one ended early, and the variances of that."""
        values, variances = number.of(rows)
        ended = rows["simulated_time"] < (1.0 - 1e-9) * rows["simulated_time"].max()
        return np.where(ended, np.nan, values), variances

    def fit(self) -> None:
        """The surfaces, and draws from what agrees with the measurements."""
        for j, number in enumerate(self.data.numbers):
            values, variances = self.values_of(number, self._rows[number.row])
            defined = np.isfinite(values) & np.isfinite(variances)
            if defined.sum() < len(self.keys) + 2:
                raise RuntimeError(f"measured, row {number.row + 1}: too few runs tell {number}")
            if not number.is_share:
                variances = np.full(len(values), values[defined].var())
            self._surfaces[j] = self._surfaces[j] or Surface(len(self.keys), 10.0 * values[defined].std() or 1.0,
                                                             error_spread=WIDE_ERRORS)
            self._surfaces[j].fit(self._places[number.row][defined], values[defined], variances[defined])
        self._errors = np.array([self._error(j) for j in range(len(self._surfaces))])
        self.draws, self.best = drawn(self.log_likelihood, len(self.keys), DRAWS, self.seed)
        self._computed, self._variances = self.computed(self.draws)
        value, variance = self.computed(self.best[None])
        measured = np.array([number.value for number in self.data.numbers])
        self.parts = (measured - value[:, 0]) ** 2 / (self._errors + variance[:, 0])
        self.added = np.sqrt(self._variances.mean(axis=1) / self._errors)

    @property
    def agrees(self) -> bool:
        freedom = max(len(self.parts) - len(self.keys), 1)
        return stats.chi_squared_tail(float(self.parts.sum()), freedom) >= LEVEL

    def _error(self, j: int) -> float:
        """The variance of a measured number: its own, or that of a run with as many grains."""
        number = self.data.numbers[j]
        if number.variance is None or number.is_share:
            return (number.variance or self._surfaces[j].stated) * self._surfaces[j].excess
        return number.variance

    def computed(self, places: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """@return what the surfaces say of all numbers, and their variances, both (numbers, n)"""
        found = [surface.at(places)[:2] for surface in self._surfaces]
        return np.array([value for value, _ in found]), np.array([variance for _, variance in found])

    def log_likelihood(self, places: np.ndarray) -> np.ndarray:
        values, variances = self.computed(places)
        variances = variances + self._errors[:, None]
        away = np.array([number.value for number in self.data.numbers])[:, None] - values
        return -0.5 * (away ** 2 / variances + np.log(variances)).sum(axis=0)

    def near(self, k: int) -> np.ndarray:
        """Places where the weights are, and somewhat beyond."""
        picked = self.draws[np.random.default_rng(self.seed + k).choice(len(self.draws), MORE, replace=False)]
        wider = self.draws.mean(axis=0) + AROUND * (picked - self.draws.mean(axis=0))
        return np.where((wider > 0.0) & (wider < 1.0), wider, picked)

    def answer(self, over: list, clocks: tuple[float, float]) -> Grains:
        """@param over settings, of which the next measurement is proposed"""
        numbers = self.data.numbers
        table = pandas.DataFrame({
            "row": [number.row + 1 for number in numbers], "number": [str(number) for number in numbers],
            "measured": [number.value for number in numbers], "error": np.sqrt(self._errors),
            "computed": self._computed.mean(axis=1), "computed_error": np.sqrt(self._variances.mean(axis=1)),
            "chi_squared": self.parts})
        following = proposed(self, over) if over and self.agrees else None
        cost = Values(runs=self.runs, simulated=self.simulated, processor=time.process_time() - clocks[1],
                      seconds=time.monotonic() - clocks[0])
        return Grains(base=self.scene, prior=self.prior, settings=self.data.settings, table=table, agrees=self.agrees,
                      draws=pandas.DataFrame(self.prior.values(self.draws), columns=self.keys),
                      best=self.prior.settings(self.prior.values(self.best[None])[0]),
                      added=float(self.added.max()), cost=cost, next_measurement=following)
