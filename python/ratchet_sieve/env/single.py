"""One sieve with the interface of gymnasium.Env."""
from __future__ import annotations

from typing import Any, Mapping, Optional

import numpy as np

from ..scene import Scene
from ..simulation import Simulation
from ..values import Values
from .interface import Env
from .sieves import Sieves, episode_seed, generator
from .task import Task

ONE = np.zeros(1, dtype=np.int64)
RENDER_MODES = ("rgb_array",)


class SieveEnv(Env):
    """A sieve under command, with the interface of gymnasium.Env.

    action_space       low and high of its elements (quantities,), SI units: setpoints of the base. An action outside
                       is refused
    observation_space  low and high of its elements (elements,), SI units; finite always. Where Gymnasium is installed,
                       both are its Box
    observation_names  of the elements of an observation
    """

    metadata = {"render_modes": list(RENDER_MODES)}

    def __init__(self, scene: Scene, *, render_mode: Optional[str] = None, **settings: Any):
        """@param settings actions, limits, slew_rates, observations, reward, step, episode, window, cells: see Task.
        Raises ValueError, SceneError."""
        require_render_mode(render_mode)
        self.render_mode = render_mode
        self.task = Task(scene, **settings)
        self.metadata = metadata_of(self.task)
        self.action_space = self.task.actions.space
        self.observation_space = self.task.observations.space
        self.observation_names = self.task.observations.names
        self._sieves = Sieves(self.task, 1, 1)
        self._closed = False
        self._ended = True
        self._np_random = generator(None)  # Gymnasium's np_random

    def reset(self, *, seed: Optional[int] = None,
              options: Optional[Mapping[str, Any]] = None) -> tuple[np.ndarray, dict[str, Any]]:
        """Begins an episode.

        seed     of the generator from which the seed of each episode is drawn; None: it goes on
        options  {"scene": {dotted key: value}} changes the scene for this episode
        Returns the observation and {"time": 0.0, "seed": of the episode's scene}. Raises ValueError, SceneError.
        """
        self._require_open()
        if seed is not None:
            self._np_random, self._np_random_seed = generator(seed), seed
        self._sieves.begin(ONE, [episode_seed(self._np_random)], options)
        self._ended = False
        return self._observation(), self._sieves.info(0)

    def step(self, action: Any) -> tuple[np.ndarray, float, bool, bool, dict[str, Any]]:
        """Commands setpoints (quantities,), and advances by a step.

        Returns observation, reward, terminated, truncated, info. Terminated: an inelastic collapse ended the run
        (info["stalled"] has its text), or no disk is left and none is fed (info["empty"]). Truncated: the episode
        has lasted its time. Raises ValueError for an action outside the space, RuntimeError without an episode.
        """
        self._require_open()
        if self._ended:
            raise RuntimeError("there is no episode: call reset() first")
        rewards, terminated, truncated = self._sieves.step(ONE, np.asarray(action)[np.newaxis])
        self._ended = bool(terminated[0] or truncated[0])
        return self._observation(), float(rewards[0]), bool(terminated[0]), bool(truncated[0]), self._sieves.info(0)

    @property
    def readings(self) -> Values:
        """All that is read at the end of the last step, by name; undefined values are None. See Readings."""
        return self._sieves.readings.of(0)

    @property
    def simulation(self) -> Optional[Simulation]:
        """The sieve itself; None before the first episode."""
        return self._sieves.simulations[0]

    def render(self) -> Optional[np.ndarray]:
        """The machine as an array (height, width, 3) of uint8, with render_mode="rgb_array"; otherwise None."""
        self._require_open()
        if self.render_mode is None:
            return None
        if self.simulation is None:
            raise RuntimeError("there is no episode: call reset() first")
        return picture_of(self.simulation)

    def close(self) -> None:
        """Lets go of the simulation."""
        self._closed = True
        self._sieves.close()

    def _observation(self) -> np.ndarray:
        return self.task.observations.of(self._sieves.readings)[0]

    def _require_open(self) -> None:
        if self._closed:
            raise RuntimeError("the environment is closed")

    def __repr__(self) -> str:
        return f"<SieveEnv of {self.task.scene.source}: {', '.join(self.task.actions.names)}>"


def require_render_mode(mode: Optional[str]) -> None:
    if mode is not None and mode not in RENDER_MODES:
        raise ValueError(f"render_mode = {mode!r}: must be None or {', '.join(RENDER_MODES)}")


def metadata_of(task: Task) -> dict[str, Any]:
    """One picture a step."""
    return {"render_modes": list(RENDER_MODES), "render_fps": 1.0 / task.step}


def picture_of(simulation: Simulation) -> np.ndarray:
    """The machine at its time: an array (height, width, 3) of uint8."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    from ..plots import pictures

    figure = Figure(figsize=(8.0, 4.0), dpi=100)
    canvas = FigureCanvasAgg(figure)
    axes = figure.subplots()
    pictures.draw(Values(frames=(), simulation=simulation, scene=simulation.scene), -1, axes)
    axes.set_title(f"{simulation.time:.3f} s")
    canvas.draw()
    return np.asarray(canvas.buffer_rgba())[..., :3].copy()
