"""Several sieves with their episodes."""
from __future__ import annotations

from typing import Any, Mapping, Optional, Sequence

import numpy as np

from .. import _engine
from ..arguments import integer
from ..simulation import Simulation
from .task import Task


class Sieves:
    """n sieves of a task, each in an episode of its own.

    simulations  of each sieve its Simulation; None before its first episode
    readings     see Readings
    """

    def __init__(self, task: Task, count: int, threads: int):
        self.task = task
        self.simulations: list[Optional[Simulation]] = [None] * count
        self.readings = task.readings(count)
        self._threads = threads
        self._steps = np.zeros(count, dtype=np.int64)
        self._fed = np.zeros(count, dtype=bool)
        self._empty = np.zeros(count, dtype=bool)  # no disk is left, and none will come
        self._seeds = np.zeros(count, dtype=np.int64)
        self._collapses: list[Optional[str]] = [None] * count

    def begin(self, which: Sequence[int], seeds: Sequence[int], options: Optional[Mapping[str, Any]] = None) -> None:
        """Begins an episode of these sieves, each with its seed. Raises ValueError, SceneError; nothing has then
        changed."""
        for key in options or ():
            if key != "scene":
                raise ValueError(f"options: there is none of the name {key!r}; there is scene, a map of dotted keys")
        which = np.asarray(which, dtype=np.int64)
        scenes = [self.task.scene_of(seed, (options or {}).get("scene")) for seed in seeds]
        simulations = [Simulation(scene) for scene in scenes]
        for simulation in simulations:
            simulation.set_slew_rates(**self.task.actions.slew_rates)
        for k, simulation in zip(which, simulations):
            self.simulations[k] = simulation
            self._collapses[k] = None
        self._fed[which] = [scene["feed.rate"] > 0.0 for scene in scenes]
        self._seeds[which] = seeds
        self._steps[which] = 0
        read, _ = self._advance(which, (), np.empty((len(which), 0)))
        self.readings.begin(which, read)
        self._empty[which] = self._are_empty(which)

    def step(self, which: np.ndarray, actions: Any) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Commands and advances these sieves, all in one call of C++. Raises ValueError for an action outside the
        space; nothing has then changed.
        Returns rewards, which episodes terminated, and which were truncated: arrays (len(which),)."""
        setpoints = self.task.actions.checked(actions, which)
        self._steps[which] += 1
        try:
            read, collapses = self._advance(which, self.task.actions.names, setpoints)
        except BaseException:
            self._steps[which] -= 1  # the same step again goes on where this one was stopped
            raise
        self.readings.add(which, read)
        for k, collapse in zip(which, collapses):
            self._collapses[k] = collapse
        self._empty[which] = self._are_empty(which)
        rewards = self.task.rewards(self.readings, which)
        collapsed = np.array([collapse is not None for collapse in collapses], dtype=bool)
        terminated = collapsed | self._empty[which]
        return rewards, terminated, (self._steps[which] >= self.task.steps) & ~terminated

    def _advance(self, which: np.ndarray, names: Sequence[str], setpoints: np.ndarray) -> tuple[dict, list]:
        engines = [self.simulations[k]._engine for k in which]
        return _engine.step_many(engines, names, setpoints, self._steps[which] * self.task.step, self.task.cells,
                                 self._threads)

    def _are_empty(self, which: np.ndarray) -> np.ndarray:
        return ~self._fed[which] & (self.readings.histogram[which].sum(axis=(1, 2)) == 0)

    def info(self, k: int) -> dict[str, Any]:
        """Of a sieve: time [s] and seed of its episode; after a collapse `stalled`, its text; `empty` if no disk is
        left."""
        info = {"time": float(self.readings.time[k]), "seed": int(self._seeds[k])}
        if self._collapses[k] is not None:
            info["stalled"] = self._collapses[k]
        if self._empty[k]:
            info["empty"] = True
        return info

    def close(self) -> None:
        self.simulations = [None] * len(self.simulations)


def episode_seed(random: np.random.Generator) -> int:
    """The seed of a scene, drawn anew for each episode."""
    return int(random.integers(2 ** 31))


def generator(seed: Optional[int]) -> np.random.Generator:
    """The same as Gymnasium's. Raises ValueError."""
    return np.random.default_rng(None if seed is None else integer("seed", seed))
