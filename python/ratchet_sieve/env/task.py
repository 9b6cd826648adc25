"""The task of an environment: what is commanded, observed and rewarded, and how long."""
from __future__ import annotations

import math
import warnings
from typing import Any, Callable, Mapping, Optional, Sequence, Union

import numpy as np

from ..errors import SieveWarning
from ..goals import Goal
from ..scene import Scene
from ..values import Values
from . import observations as observed
from .actions import Actions
from .readings import Readings

Reward = Union[str, Callable[[Values], float]]


class Task:
    """The settings that SieveEnv and SieveVectorEnv have in common.

    actions       names of the commanded quantities, in the order of an action's elements: inclination [rad],
                  frequency [Hz], amplitude [m]
    limits        name -> (min, max) of an action. Default: the ROS node's limits, such as -0.5 to 0.5 rad
    slew_rates    name -> how fast the base follows [rad/s], [Hz/s], [m/s]. Default: 0.1, 10, 0.002
    observations  names of the parts of an observation; see docs/python_env.md
    reward        a goal (ratchet_sieve.goals), of what left within the window, 0 where it is undefined: quality,
                  purity:SPECIES:BIN, recovery:SPECIES:BIN, flow:SPECIES:BIN [1/s] or throughput [1/s], BIN left or
                  right; all but quality may end in :mass [kg/s]. Or a function of the readings (see Readings.of)
                  that returns a finite number
    step          length of a step [s]
    episode       length of an episode [s], after which it is truncated. Default: the scene's duration
    window        what left lately, left within this time [s]
    cells         number of cells of the histograms along the base
    Times are taken as whole steps.
    """

    def __init__(self, scene: Scene, *, actions: Sequence[str] = ("inclination",),
                 limits: Optional[Mapping[str, Sequence[float]]] = None,
                 slew_rates: Optional[Mapping[str, float]] = None, observations: Sequence[str] = observed.DEFAULT,
                 reward: Reward = "quality", step: float = 1.0, episode: Optional[float] = None, window: float = 10.0,
                 cells: int = 10):
        """Raises ValueError, SceneError."""
        episode = scene["duration"] if episode is None else episode
        for name, value in (("step", step), ("episode", episode), ("window", window)):
            if not 0.0 < value < math.inf:
                raise ValueError(f"{name} = {value}: must be a time of more than 0 s")
        if isinstance(cells, bool) or not isinstance(cells, (int, np.integer)) or not 1 <= cells <= 10000:
            raise ValueError(f"cells = {cells!r}: must be an int, 1 to 10000")
        self.step = float(step)
        self.steps = max(1, round(episode / step))
        self.window_steps = max(1, round(window / step))
        self.cells = int(cells)
        # A duration beyond the episode, so that its settings hold; nothing of the means of a run is read.
        self.scene = scene.replace({"duration": self.steps * self.step, "settle": 0.0})
        self.actions = Actions(actions, limits, slew_rates)
        self.actions.require_start(self.scene)
        self.observations = observed.Observations(observations, scene.species, self.cells, self.steps * self.step,
                                                  self.actions.limits)
        self.reward = reward
        self._goal = None if callable(reward) else self._goal_of(reward)

    def readings(self, count: int) -> Readings:
        return Readings(self.scene.species, count, self.cells, self.window_steps)

    def scene_of(self, seed: int, overrides: Optional[Mapping[str, Any]]) -> Scene:
        """The scene of an episode. Raises SceneError, ValueError."""
        if not overrides:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", SieveWarning)  # said of the scene already
                return self.scene.replace(seed=seed)
        scene = self.scene.replace({"seed": seed, **overrides})
        for what, given, wanted in (("species", scene.species, self.scene.species),
                                    ("boundary", scene["boundary"], self.scene["boundary"])):
            if given != wanted:
                raise ValueError(f"options: {what} = {given}: must be that of the environment's scene, {wanted}")
        self.actions.require_start(scene)
        return scene

    def rewards(self, readings: Readings, which: np.ndarray) -> np.ndarray:
        """Of these sieves. Raises ValueError if the function returns no finite number."""
        if self._goal:
            return readings.measured(self._goal, which)[0]
        return np.array([_finite(self.reward(readings.of(k))) for k in which])

    def _goal_of(self, reward: Any) -> Goal:
        if not isinstance(reward, str):
            raise ValueError(f"reward = {reward!r}: must be a text or a function of the readings")
        try:
            goal = Goal(reward, self.scene.species)
        except ValueError as error:
            raise ValueError(f"reward: {error}; or a function of the readings") from None
        if self.scene["boundary"] == "periodic":
            raise ValueError(f"reward = {reward}: nothing leaves a periodic base; give a function of the readings "
                             "or a scene with boundary: open")
        return goal


def _finite(value: Any) -> float:
    number = float(value)
    if not math.isfinite(number):
        raise ValueError(f"reward = {number}: the function must return a finite number")
    return number
