"""Many sieves with the interface of gymnasium.vector.VectorEnv."""
from __future__ import annotations

from typing import Any, Iterable, Mapping, Optional, Sequence, Union

import numpy as np

from ..scene import Scene
from ..simulation import Simulation
from .interface import AutoresetMode, Box, VectorEnv
from .sieves import Sieves, episode_seed, generator
from .single import metadata_of, picture_of, require_render_mode
from .task import Task

AUTORESET = ("next_step", "same_step", "disabled")


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

    def __init__(self, scene: Scene, n: int, *, threads: int = 0,
                 autoreset: str = "next_step", render_mode: Optional[str] = None,
                 **settings: Any):
        """@param threads 0: one per processor @param settings see Task. Raises ValueError, SceneError."""
        if isinstance(n, bool) or not isinstance(n, (int, np.integer)) or n < 1:
            raise ValueError(f"n = {n!r}: must be an int of 1 or more")
        require_render_mode(render_mode)
        self.render_mode = render_mode
        self.autoreset = str(getattr(autoreset, "name", autoreset)).lower()  # Gymnasium's AutoresetMode has a name
        if self.autoreset not in AUTORESET:
            raise ValueError(f"autoreset = {autoreset!r}: must be {', '.join(AUTORESET)}")
        self.task = Task(scene, **settings)
        self.metadata = metadata_of(self.task)
        if AutoresetMode is not None:
            self.metadata["autoreset_mode"] = AutoresetMode[self.autoreset.upper()]
        self.closed = False
        self.num_envs = int(n)
        self.single_action_space = self.task.actions.space
        self.single_observation_space = self.task.observations.space
        self.action_space = _rows(self.single_action_space, self.num_envs)
        self.observation_space = _rows(self.single_observation_space, self.num_envs)
        self.observation_names = self.task.observations.names
        self._sieves = Sieves(self.task, self.num_envs, threads)
        self._generators = [generator(None) for _ in range(self.num_envs)]
        self._ended: Optional[np.ndarray] = None  # of each sieve, whether its episode has; None before the first reset

    def reset(self, *, seed: Union[int, Sequence[Optional[int]], None] = None,
              options: Optional[Mapping[str, Any]] = None) -> tuple[np.ndarray, dict[str, Any]]:
        """Begins an episode of every sieve.

        seed     of sieve k: seed + k, or seed[k]; None: its generator goes on
        options  scene: as in SieveEnv.reset(). reset_mask: bool array (n,), which sieves; the others go on
        Returns observations (n, elements) and infos. Raises ValueError, SceneError.
        """
        self._require_open()
        options = dict(options or {})
        which = np.flatnonzero(self._mask(options.pop("reset_mask", None)))
        generators = list(self._generators)
        for k, of_sieve in enumerate(self._seeds(seed)):
            if of_sieve is not None and k in which:
                generators[k] = generator(of_sieve)
        self._sieves.begin(which, [episode_seed(generators[k]) for k in which], options)
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
        self._require_open()
        self._require_episodes()
        actions = np.asarray(actions)
        wanted = (self.num_envs, *self.single_action_space.shape)
        if actions.shape != wanted:
            raise ValueError(f"actions of shape {actions.shape}: must be {wanted}")
        rewards = np.zeros(self.num_envs)
        terminated, truncated = np.zeros(self.num_envs, dtype=bool), np.zeros(self.num_envs, dtype=bool)
        going, again = np.flatnonzero(~self._ended), np.flatnonzero(self._ended)
        if len(going):
            rewards[going], terminated[going], truncated[going] = self._sieves.step(going, actions[going])
        self._begin_again(again)
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
        self._begin_again(which)
        self._ended = np.zeros(self.num_envs, dtype=bool)
        return infos

    def _begin_again(self, which: np.ndarray) -> None:
        if len(which):
            self._sieves.begin(which, [episode_seed(self._generators[k]) for k in which])

    @property
    def simulations(self) -> list[Optional[Simulation]]:
        """The sieves themselves; None before the first reset."""
        return list(self._sieves.simulations)

    def render(self) -> Optional[tuple[np.ndarray, ...]]:
        """A picture of each sieve; see SieveEnv.render()."""
        self._require_open()
        if self.render_mode is None:
            return None
        if self._ended is None:
            raise RuntimeError("there are no episodes: call reset() first")
        return tuple(picture_of(simulation) for simulation in self._sieves.simulations)

    def close(self, **keywords: Any) -> None:
        """Lets go of the simulations."""
        self.closed = True
        self._sieves.close()

    def _observations(self) -> np.ndarray:
        return self.task.observations.of(self._sieves.readings)

    def _infos(self, which: Iterable[int]) -> dict[str, Any]:
        """The infos of these sieves as Gymnasium batches them: of each key an array (n,), and with a _ before it
        whether sieve k has this key."""
        infos: dict[str, Any] = {}
        for k in which:
            for key, value in self._sieves.info(k).items():
                if key not in infos:
                    numbers = isinstance(value, (bool, int, float))
                    infos[key] = (np.zeros(self.num_envs, dtype=type(value)) if numbers
                                  else np.full(self.num_envs, None, dtype=object))
                    infos[f"_{key}"] = np.zeros(self.num_envs, dtype=bool)
                infos[key][k] = value
                infos[f"_{key}"][k] = True
        return infos

    def _seeds(self, seed: Union[int, Sequence[Optional[int]], None]) -> Sequence[Optional[int]]:
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

    def _require_open(self) -> None:
        if self.closed:
            raise RuntimeError("the environment is closed")

    def _require_episodes(self) -> None:
        if self._ended is None:
            raise RuntimeError("there are no episodes: call reset() first")
        if self.autoreset == "disabled" and self._ended.any():
            raise RuntimeError(f"the episode of sieve {np.flatnonzero(self._ended)[0]} has ended: call reset() with "
                               "options={\"reset_mask\": ...} first")

    def __repr__(self) -> str:
        return f"<SieveVectorEnv of {self.task.scene.source}: {self.num_envs} sieves>"


def _rows(space: Box, count: int) -> Box:
    return Box(np.tile(space.low, (count, 1)), np.tile(space.high, (count, 1)), dtype=space.dtype)
