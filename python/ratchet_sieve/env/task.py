"""The task of an environment: what is commanded, observed and rewarded, and how long."""
from __future__ import annotations

import functools
import json
import math
import operator
import warnings
from typing import Any, Callable, Mapping, NamedTuple, Optional, Sequence, Union

import numpy as np

from .. import _engine
from ..arguments import integer, number
from ..errors import SieveWarning
from ..goals import Goal
from ..scene import AnyScene, Scene, scene_of
from ..values import Values
from .readings import BASE_FIELDS, BIN_FIELDS, Readings

try:
    from gymnasium.spaces import Box
except ImportError:
    class Box(NamedTuple):
        """The bounds of the elements of an array."""

        low: np.ndarray
        high: np.ndarray
        dtype: Any

        @property
        def shape(self) -> tuple[int, ...]:
            return self.low.shape

Limits = Mapping[str, Sequence[float]]
Reward = Union[str, Callable[[Values], float]]

QUANTITIES = {quantity["name"]: quantity for quantity in _engine.COMMANDED_QUANTITIES}
"""What can be commanded: name, unit, legal and usual range, slew_rate (the usual one), slew_rates (legal ones)."""

DEFAULT_OBSERVATIONS = ("departures", "quality", "mean_vx", "histogram", "base")

# Of a limit's span: how far beyond it an action may be, because it was rounded to 32 bits. It is then the limit.
_ROUNDING = 1e-6
_SHARE, _COUNT, _ANY = (0.0, 1.0), (0.0, math.inf), (-math.inf, math.inf)


def box(bounds: Any) -> Box:
    """Of a list of the least and the largest value of each element."""
    low, high = np.array(bounds, dtype=np.float64).T
    return Box(low.copy(), high.copy(), dtype=np.float64)


class Actions:
    """The commanded quantities, in the order of an action's elements."""

    def __init__(self, names: Sequence[str], limits: Optional[Limits], slew_rates: Optional[Mapping[str, float]]):
        """Limits and slew rates that are left out are the usual ones, the defaults of the ROS node.
        Raises ValueError."""
        self.names = (names,) if isinstance(names, str) else tuple(names)
        for what, given, known in (("actions", self.names, QUANTITIES), ("limits", limits or (), self.names),
                                   ("slew_rates", slew_rates or (), QUANTITIES)):
            for name in given:
                if name not in known:
                    raise ValueError(f"{what}: there is no quantity {name!r}; there are {', '.join(known)}")
        if len(set(self.names)) != len(self.names) or not self.names:
            raise ValueError(f"actions = {self.names}: must be different quantities, one or more")
        self.limits = {name: _limits(QUANTITIES[name], (limits or {}).get(name)) for name in self.names}
        self.slew_rates = {name: _slew_rate(quantity, (slew_rates or {}).get(name))
                           for name, quantity in QUANTITIES.items()}
        self.space = box([self.limits[name] for name in self.names])

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


def _limits(quantity: Mapping[str, Any], given: Optional[Sequence[float]]) -> tuple[float, float]:
    if given is None:
        return quantity["usual"]
    least, most = quantity["legal"]
    try:
        low, high = map(float, given)
    except (TypeError, ValueError):
        low = high = math.nan
    if not least <= low < high <= most:
        raise ValueError(f"limits of {quantity['name']} = {given!r}: must be two, the lower one first, within "
                         f"{least:g} to {most:g} {quantity['unit']}")
    return low, high


def _slew_rate(quantity: Mapping[str, Any], given: Optional[float]) -> float:
    rate = quantity["slew_rate"] if given is None else given
    return number(f"slew rate of {quantity['name']}", rate, *quantity["slew_rates"], f"{quantity['unit']}/s")


class Part(NamedTuple):
    """A part of an observation: its elements with their bounds, and how they are read."""

    elements: Sequence[str]
    bounds: Sequence[tuple[float, float]]
    read: Callable[[Readings], np.ndarray]  # (n, ...) with one number for each element; can be pickled


class Observations:
    """The parts of an observation, one after the other: readings as a vector of numbers, all of them finite.

    space  a Box of float64
    names  of its elements, such as "mean_vx.A"
    """

    def __init__(self, names: Sequence[str], known: Mapping[str, Part]):
        """Raises ValueError."""
        names = (names,) if isinstance(names, str) else tuple(names)
        for name in names:
            if name not in known:
                raise ValueError(f"observations: there is none of the name {name!r}; there are {', '.join(known)}")
        if len(set(names)) != len(names) or not names:
            raise ValueError(f"observations = {names}: must be different names, one or more")
        self._parts = [known[name] for name in names]
        self.names = tuple(element for part in self._parts for element in part.elements)
        self.space = box([bounds for part in self._parts for bounds in part.bounds])

    def of(self, readings: Readings) -> np.ndarray:
        """A new array (n, elements)."""
        count = len(readings.time)
        return np.concatenate([part.read(readings).reshape(count, -1) for part in self._parts], axis=1,
                              dtype=np.float64)


def _parts(species: list[str], cells: int, episode: float, limits: Mapping[str, tuple[float, float]]
           ) -> dict[str, Part]:
    """All that can be observed, by name."""
    def of_bins(name: str) -> Part:
        elements = [f"{name}.{field}.{kind}" for kind in species for field in BIN_FIELDS]
        return Part(elements, [_COUNT] * len(elements), operator.attrgetter(name))

    def share(name: str) -> Part:
        return Part([name, f"{name}_defined"], [_SHARE] * 2, functools.partial(_with_defined, name=name))

    def of_base(field: str) -> tuple[float, float]:
        quantity = field.replace("commanded_", "")
        if quantity in QUANTITIES:
            return limits.get(quantity, QUANTITIES[quantity]["legal"])
        return (0.0, 2.0 * math.pi) if field == "phase" else _ANY

    cells_of = [f"histogram.{kind}.{cell}" for kind in species for cell in range(cells)]
    return {
        "time": Part(["time"], [(0.0, episode)], operator.attrgetter("time")),
        "bins": of_bins("bins"),
        "departures": of_bins("departures"),
        "quality": share("quality"),
        "processed": share("processed"),
        "mean_vx": Part([f"{field}.{kind}" for kind in species for field in ("mean_vx", "mean_vx_defined")],
                        [_ANY, _SHARE] * len(species), functools.partial(_with_defined, name="mean_vx")),
        "histogram": Part(cells_of, [_COUNT] * len(cells_of), operator.attrgetter("histogram")),
        "base": Part([f"base.{field}" for field in BASE_FIELDS], [of_base(field) for field in BASE_FIELDS],
                     operator.attrgetter("base")),
    }


def _with_defined(readings: Readings, name: str) -> np.ndarray:
    """Each number followed by whether it is defined."""
    return np.stack([getattr(readings, name), getattr(readings, f"{name}_defined")], axis=-1)


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
    sensors       what the ROS node's sensors would read, with their settings, such as {"count": {"miss": 0.05}}: scale,
                  count, level; see docs/node.md. The observation "sensors" is what they sent last
    Times are taken as whole steps.
    """

    def __init__(self, scene: AnyScene, *, actions: Sequence[str] = ("inclination",), limits: Optional[Limits] = None,
                 slew_rates: Optional[Mapping[str, float]] = None, observations: Sequence[str] = DEFAULT_OBSERVATIONS,
                 reward: Reward = "quality", step: float = 1.0, episode: Optional[float] = None, window: float = 10.0,
                 cells: int = 10, sensors: Optional[Mapping[str, Mapping[str, float]]] = None):
        """Raises ValueError, SceneError."""
        scene = scene_of(scene)
        episode = scene["duration"] if episode is None else episode
        for name, value in (("step", step), ("episode", episode), ("window", window)):
            if number(name, value, 0.0, unit="s") == 0.0:
                raise ValueError(f"{name} = {value}: must be a time of more than 0 s")
        self.step = float(step)
        self.steps = max(1, round(episode / step))
        self.window_steps = max(1, round(window / step))
        self.cells = integer("cells", cells, 1, 10000)
        # A duration beyond the episode, so that its settings hold; nothing of the means of a run is read.
        self.scene = scene.replace({"duration": self.steps * self.step, "settle": 0.0})
        self.actions = Actions(actions, limits, slew_rates)
        self.actions.require_start(self.scene)
        self.sensors = json.dumps(sensors) if sensors is not None else None
        self.sensed = _engine.sensed_names(self.sensors, scene._engine) if self.sensors else []
        known = _parts(scene.species, self.cells, self.steps * self.step, self.actions.limits)
        if self.sensors:
            known["sensors"] = Part(self.sensed, [_ANY] * len(self.sensed), operator.attrgetter("sensors"))
        self.observations = Observations(observations, known)
        self.reward = reward
        self._goal = None if callable(reward) else self._goal_of(reward)

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
        rewards = np.array([float(self.reward(readings.of(k))) for k in which])
        for reward in rewards[~np.isfinite(rewards)]:
            raise ValueError(f"reward = {reward}: the function must return a finite number")
        return rewards

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
