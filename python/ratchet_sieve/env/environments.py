"""Sieves with the interfaces of gymnasium.Env and gymnasium.vector.VectorEnv."""
from __future__ import annotations

from typing import Any, Iterable, Mapping, Optional, Sequence, Union

import numpy as np

from .. import _engine
from ..arguments import integer
from ..scene import AnyScene
from ..simulation import Simulation
from ..values import Values
from .readings import Readings
from .task import Box, Task

try:
    from gymnasium import Env
    from gymnasium.vector import VectorEnv
except ImportError:
    Env = VectorEnv = object
try:
    from gymnasium.vector import AutoresetMode
except ImportError:
    AutoresetMode = None

AUTORESET = ("next_step", "same_step", "disabled")
RENDER_MODES = ("rgb_array",)


class SieveVectorEnv(VectorEnv):
    """n sieves on all cores, with the interface of gymnasium.vector.VectorEnv. A step is one call of C++.

    Sieve k after reset(seed=s) is a SieveEnv after reset(seed=s + k), bit for bit, with any number of threads.

    num_envs                                        n
    single_action_space, single_observation_space   those of a SieveEnv
    action_space, observation_space                 the same with a row for each sieve
    observation_names                               of the elements of a row

    A sieve whose episode has ended, by autoreset:
    next_step  its next step is the reset: the action is ignored, the reward 0, the observation the first of the new
               episode. Gymnasium's default
    same_step  the step that ends an episode returns the first observation of the next one; the last observation and
               info are infos["final_obs"][k] and infos["final_info"]
    disabled   it must be reset by reset(options={"reset_mask": mask}) before the next step
    """

    def __init__(self, scene: AnyScene, n: int, *, threads: int = 0,
                 autoreset: str = "next_step", render_mode: Optional[str] = None,
                 **settings: Any):
        """@param threads 0: one per processor @param settings see Task. Raises ValueError, SceneError."""
        if render_mode not in (None, *RENDER_MODES):
            raise ValueError(f"render_mode = {render_mode!r}: must be None or {', '.join(RENDER_MODES)}")
        self.render_mode = render_mode
        self.autoreset = str(getattr(autoreset, "name", autoreset)).lower()  # Gymnasium's AutoresetMode has a name
        if self.autoreset not in AUTORESET:
            raise ValueError(f"autoreset = {autoreset!r}: must be {', '.join(AUTORESET)}")
        self.task = Task(scene, **settings)
        self.metadata = {"render_modes": list(RENDER_MODES), "render_fps": 1.0 / self.task.step}
        if AutoresetMode is not None:
            self.metadata["autoreset_mode"] = AutoresetMode[self.autoreset.upper()]
        self.closed = False
        self.num_envs = integer("n", n, 1)
        self.single_action_space = self.task.actions.space
        self.single_observation_space = self.task.observations.space
        self.action_space = _rows(self.single_action_space, self.num_envs)
        self.observation_space = _rows(self.single_observation_space, self.num_envs)
        self.observation_names = self.task.observations.names
        self._threads = integer("threads", threads)
        self._generators = [generator(None) for _ in range(self.num_envs)]
        self._simulations: list[Optional[Simulation]] = [None] * self.num_envs
        self._readings = Readings(self.task.scene.species, self.num_envs, self.task.cells, self.task.window_steps,
                                  self.task.sensed)
        # Of each sieve in its episode: steps, whether it is fed, whether no disk is left and none will come, the seed,
        # the text of a collapse. Whether the episode has ended; None before the first reset.
        self._steps = np.zeros(self.num_envs, dtype=np.int64)
        self._fed = np.zeros(self.num_envs, dtype=bool)
        self._empty = np.zeros(self.num_envs, dtype=bool)
        self._seeds = np.zeros(self.num_envs, dtype=np.int64)
        self._collapses = np.full(self.num_envs, None, dtype=object)
        self._ended: Optional[np.ndarray] = None

    def reset(self, *, seed: Union[int, Sequence[Optional[int]], None] = None,
              options: Optional[Mapping[str, Any]] = None) -> tuple[np.ndarray, dict[str, Any]]:
        """Begins an episode of every sieve.

        seed     of sieve k: seed + k, or seed[k]; None: its generator goes on
        options  scene: as in SieveEnv.reset(). reset_mask: bool array (n,), which sieves; the others go on
        Returns observations (n, elements) and infos. Raises ValueError, SceneError.
        """
        self.require_open()
        options = dict(options or {})
        which = np.flatnonzero(self._mask(options.pop("reset_mask", None)))
        generators = list(self._generators)
        for k, of_sieve in enumerate(self._seeds_of(seed)):
            if of_sieve is not None and k in which:
                generators[k] = generator(of_sieve)
        self._begin(which, generators, options)
        self._generators = generators
        if self._ended is None:
            self._ended = np.zeros(self.num_envs, dtype=bool)
        self._ended[which] = False
        return self._observations(), self._infos(which)

    def step(self, actions: Any) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, dict[str, Any]]:
        """Commands setpoints (n, quantities), and advances all sieves by a step.

        Returns observations (n, elements), rewards (n,) of float64, terminations (n,), truncations (n,) of bool, and
        infos. See SieveEnv.step(). Raises ValueError for an action outside the space, RuntimeError without episodes.
        """
        self.require_open()
        if self._ended is None:
            raise RuntimeError("there are no episodes: call reset() first")
        if self.autoreset == "disabled" and self._ended.any():
            raise RuntimeError(f"the episode of sieve {np.flatnonzero(self._ended)[0]} has ended: call reset() with "
                               "options={\"reset_mask\": ...} first")
        actions = np.asarray(actions)
        if actions.shape != self.action_space.shape:
            raise ValueError(f"actions of shape {actions.shape}: must be {self.action_space.shape}")
        rewards = np.zeros(self.num_envs)
        terminated, truncated = np.zeros(self.num_envs, dtype=bool), np.zeros(self.num_envs, dtype=bool)
        going, again = np.flatnonzero(~self._ended), np.flatnonzero(self._ended)
        if len(going):
            rewards[going], terminated[going], truncated[going] = self._step(going, actions[going])
        self._begin(again, self._generators)
        self._ended = terminated | truncated
        last = {}
        if self.autoreset == "same_step" and self._ended.any():
            last = self._end_now(np.flatnonzero(self._ended))
        return self._observations(), rewards, terminated, truncated, {**self._infos(range(self.num_envs)), **last}

    def _end_now(self, which: np.ndarray) -> dict[str, Any]:
        """Begins anew; the infos of what has ended."""
        mask = self._ended.copy()
        observations = self._observations()
        final = np.full(self.num_envs, None, dtype=object)
        for k in which:
            final[k] = observations[k].copy()
        infos = {"final_obs": final, "_final_obs": mask, "final_info": self._infos(which), "_final_info": mask.copy()}
        self._begin(which, self._generators)
        self._ended = np.zeros(self.num_envs, dtype=bool)
        return infos

    def _begin(self, which: np.ndarray, generators: Sequence[np.random.Generator],
               options: Optional[Mapping[str, Any]] = None) -> None:
        """Begins an episode of these sieves. Raises ValueError, SceneError; nothing has then changed."""
        for key in options or ():
            if key != "scene":
                raise ValueError(f"options: there is none of the name {key!r}; there is scene, a map of dotted keys")
        if not len(which):
            return
        seeds = [int(generators[k].integers(2 ** 31)) for k in which]
        scenes = [self.task.scene_of(seed, (options or {}).get("scene")) for seed in seeds]
        simulations = [Simulation(scene) for scene in scenes]
        for k, simulation in zip(which, simulations):
            simulation.set_slew_rates(**self.task.actions.slew_rates)
            if self.task.sensors:
                simulation._engine.sense(self.task.sensors)
            self._simulations[k] = simulation
        self._collapses[which] = None
        self._fed[which] = [scene["feed.rate"] > 0.0 or bool(scene.values["feed"].get("disks")) for scene in scenes]
        self._seeds[which] = seeds
        self._steps[which] = 0
        read, _ = self._advance(which, (), np.empty((len(which), 0)))
        self._readings.begin(which, read)
        self._empty[which] = self._are_empty(which)

    def _step(self, which: np.ndarray, actions: Any) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Commands and advances these sieves. Raises ValueError for an action outside the space; nothing has then
        changed. Returns rewards, which episodes terminated, and which were truncated: arrays (len(which),)."""
        setpoints = self.task.actions.checked(actions, which)
        self._steps[which] += 1
        try:
            read, collapses = self._advance(which, self.task.actions.names, setpoints)
        except BaseException:
            self._steps[which] -= 1  # the same step again goes on where this one was stopped
            raise
        self._readings.add(which, read)
        self._collapses[which] = collapses
        self._empty[which] = self._are_empty(which)
        rewards = self.task.rewards(self._readings, which)
        terminated = np.array([collapse is not None for collapse in collapses], dtype=bool) | self._empty[which]
        return rewards, terminated, (self._steps[which] >= self.task.steps) & ~terminated

    def _advance(self, which: np.ndarray, names: Sequence[str], setpoints: np.ndarray) -> tuple[dict, list]:
        return _engine.step_many([self._simulations[k]._engine for k in which], names, setpoints,
                                 self._steps[which] * self.task.step, self.task.cells, self._threads)

    def _are_empty(self, which: np.ndarray) -> np.ndarray:
        return ~self._fed[which] & (self._readings.histogram[which].sum(axis=(1, 2)) == 0)

    @property
    def simulations(self) -> list[Optional[Simulation]]:
        """The sieves themselves; None before the first reset."""
        return list(self._simulations)

    def render(self) -> Optional[tuple[np.ndarray, ...]]:
        """A picture of each sieve; see SieveEnv.render()."""
        self.require_open()
        if self.render_mode is None:
            return None
        if self._ended is None:
            raise RuntimeError("there are no episodes: call reset() first")
        from ..plots.pictures import pixels_of

        return tuple(pixels_of(simulation) for simulation in self._simulations)

    def close(self, **keywords: Any) -> None:
        """Lets go of the simulations."""
        self.closed = True
        self._simulations = [None] * self.num_envs

    def require_open(self) -> None:
        if self.closed:
            raise RuntimeError("the environment is closed")

    def __getstate__(self) -> dict[str, Any]:
        if self.task.sensors and self._ended is not None:
            raise TypeError("an environment with sensors can be pickled before its first reset() alone")
        return self.__dict__

    def _observations(self) -> np.ndarray:
        return self.task.observations.of(self._readings)

    def info(self, k: int) -> dict[str, Any]:
        """Of a sieve: time [s] and seed of its episode; after a collapse `stalled`, its text; `empty` if no disk is
        left."""
        info = {"time": float(self._readings.time[k]), "seed": int(self._seeds[k])}
        if self._collapses[k] is not None:
            info["stalled"] = self._collapses[k]
        if self._empty[k]:
            info["empty"] = True
        return info

    def _infos(self, which: Iterable[int]) -> dict[str, Any]:
        """The infos of these sieves as Gymnasium batches them: of each key an array (n,), and with a _ before it
        whether sieve k has this key."""
        infos: dict[str, Any] = {}
        for k in which:
            for key, value in self.info(k).items():
                if key not in infos:
                    numbers = isinstance(value, (bool, int, float))
                    infos[key] = (np.zeros(self.num_envs, dtype=type(value)) if numbers
                                  else np.full(self.num_envs, None, dtype=object))
                    infos[f"_{key}"] = np.zeros(self.num_envs, dtype=bool)
                infos[key][k] = value
                infos[f"_{key}"][k] = True
        return infos

    def _seeds_of(self, seed: Union[int, Sequence[Optional[int]], None]) -> Sequence[Optional[int]]:
        if seed is None:
            return [None] * self.num_envs
        if isinstance(seed, int):
            return [seed + k for k in range(self.num_envs)]
        if len(seed) != self.num_envs:
            raise ValueError(f"{len(seed)} seeds: must be {self.num_envs}, one for each sieve")
        return seed

    def _mask(self, mask: Any) -> np.ndarray:
        if mask is None:
            return np.ones(self.num_envs, dtype=bool)
        if not isinstance(mask, np.ndarray) or mask.dtype != bool or mask.shape != (self.num_envs,) or not mask.any():
            raise ValueError(f"reset_mask: must be an array ({self.num_envs},) of bool with at least one True")
        if self._ended is None and not mask.all():
            raise RuntimeError("reset_mask: the first reset must be of all sieves")
        return mask

    def __repr__(self) -> str:
        return f"<SieveVectorEnv of {self.task.scene.source}: {self.num_envs} sieves>"


class SieveEnv(Env):
    """A sieve under command, with the interface of gymnasium.Env.

    action_space       low and high of its elements (quantities,), SI units: setpoints of the base. An action outside
                       is refused
    observation_space  low and high of its elements (elements,), SI units; finite always. Where Gymnasium is installed,
                       both are its Box
    observation_names  of the elements of an observation
    """

    metadata = {"render_modes": list(RENDER_MODES)}

    def __init__(self, scene: AnyScene, *, render_mode: Optional[str] = None, **settings: Any):
        """@param settings actions, limits, slew_rates, observations, reward, step, episode, window, cells, sensors: see
        Task.
        Raises ValueError, SceneError."""
        self._one = SieveVectorEnv(scene, 1, threads=1, autoreset="disabled", render_mode=render_mode, **settings)
        self.render_mode = render_mode
        self.task = self._one.task
        self.metadata = {key: value for key, value in self._one.metadata.items() if key != "autoreset_mode"}
        self.action_space = self._one.single_action_space
        self.observation_space = self._one.single_observation_space
        self.observation_names = self._one.observation_names
        self._np_random = self._one._generators[0]  # Gymnasium's np_random

    def reset(self, *, seed: Optional[int] = None,
              options: Optional[Mapping[str, Any]] = None) -> tuple[np.ndarray, dict[str, Any]]:
        """Begins an episode.

        seed     of the generator from which the seed of each episode is drawn; None: it goes on
        options  {"scene": {dotted key: value}} changes the scene for this episode
        Returns the observation and {"time": 0.0, "seed": of the episode's scene}. Raises ValueError, SceneError.
        """
        observations, _ = self._one.reset(seed=[seed], options=options)
        self._np_random = self._one._generators[0]
        if seed is not None:
            self._np_random_seed = seed
        return observations[0], self._one.info(0)

    def step(self, action: Any) -> tuple[np.ndarray, float, bool, bool, dict[str, Any]]:
        """Commands setpoints (quantities,), and advances by a step.

        Returns observation, reward, terminated, truncated, info. Terminated: an inelastic collapse ended the run
        (info["stalled"] has its text), or no disk is left and none is fed (info["empty"]). Truncated: the episode
        has lasted its time. Raises ValueError for an action outside the space, RuntimeError without an episode.
        """
        self._require_episode(self._one._ended is not None and not self._one._ended[0])
        setpoints = self.task.actions.checked(np.asarray(action)[np.newaxis], [0])
        observations, rewards, terminated, truncated, _ = self._one.step(setpoints)
        return observations[0], float(rewards[0]), bool(terminated[0]), bool(truncated[0]), self._one.info(0)

    @property
    def readings(self) -> Values:
        """All that is read at the end of the last step, by name; undefined values are None. See Readings."""
        return self._one._readings.of(0)

    @property
    def simulation(self) -> Optional[Simulation]:
        """The sieve itself; None before the first episode."""
        return self._one.simulations[0]

    def render(self) -> Optional[np.ndarray]:
        """The machine as an array (height, width, 3) of uint8, with render_mode="rgb_array"; otherwise None."""
        self._require_episode(self.render_mode is None or self.simulation is not None)
        pictures = self._one.render()
        return pictures and pictures[0]

    def close(self) -> None:
        """Lets go of the simulation."""
        self._one.close()

    def _require_episode(self, there_is_one: bool) -> None:
        self._one.require_open()
        if not there_is_one:
            raise RuntimeError("there is no episode: call reset() first")

    def __repr__(self) -> str:
        return f"<SieveEnv of {self.task.scene.source}: {', '.join(self.task.actions.names)}>"


def generator(seed: Optional[int]) -> np.random.Generator:
    """The generator that Gymnasium makes of a seed. Raises ValueError."""
    return np.random.default_rng(None if seed is None else integer("seed", seed))


def _rows(space: Box, count: int) -> Box:
    return Box(np.tile(space.low, (count, 1)), np.tile(space.high, (count, 1)), dtype=space.dtype)
