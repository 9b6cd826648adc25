"""The simulation, step by step."""
from __future__ import annotations

import reprlib
from typing import Any, Optional, Union

import numpy as np

from . import _engine
from .arguments import integer, number
from .errors import StateError
from .scene import AnyScene, Scene, scene_of
from .values import Summary, Values


class Simulation:
    """A running machine. Ctrl-C stops a call within a tenth of a second, and the simulation goes on from there.

    One thread at a time may use it; others get a RuntimeError meanwhile. C++ runs without Python's lock (GIL).
    The same scene and commands give the same bits, however the time is divided.
    """

    def __init__(self, scene: AnyScene, start_time: float = 0.0):
        """Pours the disks of the scene at `start_time` [s]. Raises ValueError if disks of `initial` overlap."""
        scene = scene_of(scene)
        self._begin(scene, _engine.Simulation(scene._engine, number("start_time", start_time, 0.0, unit="s")))

    @classmethod
    def restore(cls, scene: AnyScene, state: bytes) -> Simulation:
        """Goes on from a saved state, bit for bit. Of the scene only `duration` and what ends a run early (mean_vx,
        quality, confidence of `accuracy`) may have changed. Raises StateError, which names the key that has."""
        scene = scene_of(scene)
        if not isinstance(state, bytes):
            raise StateError(f"state = {reprlib.repr(state)}: must be bytes, as Simulation.save() returns them")
        simulation = cls.__new__(cls)
        try:
            simulation._begin(scene, _engine.Simulation.restore(scene._engine, state))
        except StateError as error:
            raise StateError(f"the state cannot be restored: {error}") from None
        return simulation

    def __reduce__(self) -> tuple[Any, ...]:
        """A copy, or what was pickled, goes on by itself."""
        return type(self).restore, (self._scene, self.save())

    def _begin(self, scene: Scene, engine: _engine.Simulation) -> None:
        self._scene = scene
        self._engine = engine

    def save(self) -> bytes:
        """The state, for restore(); nothing changes."""
        return self._engine.save()

    @property
    def scene(self) -> Scene:
        return self._scene

    @property
    def time(self) -> float:
        """Simulated time [s]."""
        return self._engine.time()

    def advance(self, duration: float) -> None:
        """Advances by a duration >= 0 [s]. Raises StallError if a collapse ends the run."""
        self._engine.advance_to(self.time + number("duration", duration, 0.0, unit="s"))

    def advance_to(self, time: float) -> None:
        """Advances up to and including a time [s]. Raises ValueError if it has passed, StallError."""
        if number("time", time, unit="s") < self.time:
            raise ValueError(f"time = {time}: must be {self.time} s or more: a simulation does not go back")
        self._engine.advance_to(time)

    def command(self, *, inclination: Optional[float] = None, frequency: Optional[float] = None,
                amplitude: Optional[float] = None) -> None:
        """New setpoints of the base [rad], [Hz], [m], to which it moves from now on at its slew rates.
        Raises ValueError if one is not legal; none is then taken."""
        setpoints = {"inclination": inclination, "frequency": frequency, "amplitude": amplitude}
        self._engine.command({name: number(name, value) for name, value in setpoints.items() if value is not None})

    def set_slew_rates(self, *, inclination: float = 0.1, frequency: float = 10.0, amplitude: float = 0.002) -> None:
        """How fast the base follows its setpoints [rad/s], [Hz/s], [m/s]. Raises ValueError."""
        rates = {"inclination": inclination, "frequency": frequency, "amplitude": amplitude}
        self._engine.set_slew_rates(*(number(f"{name} (slew rate)", rate) for name, rate in rates.items()))

    def pour(self, species: Union[str, int], count: int, *, between: Optional[tuple[float, float]] = None) -> None:
        """Pours more disks of a species, by name or number, at the lowest free places; Ctrl-C cancels it.

        `between`: both ends of the stretch of the base that is poured onto, from its left end [m]; without it, that of
        the scene's pour. Raises ValueError, also if there would be more than 10^7 disks.
        """
        if isinstance(species, str):
            if species not in self._scene.species:
                raise ValueError(f"there is no species {species!r}; there are {', '.join(self._scene.species)}")
            species = self._scene.species.index(species)
        if between is not None:
            try:
                left, right = between
            except (TypeError, ValueError):
                raise ValueError(f"between = {between!r}: must be both ends of a stretch [m]") from None
            between = (number("between", left, 0, unit="m"), number("between", right, 0, unit="m"))
        self._engine.pour(integer("species", species), integer("count", count), between)

    @property
    def disks(self) -> np.ndarray:
        """The disks in the machine at this time: a structured array, a copy of its own.

        id, species (its number), radius [m], mass [kg], x, y [m], vx, vy [m/s], angle [rad], spin [rad/s],
        displacement (unwrapped path along x since the disk entered) [m]; world frame (docs/model.md).
        """
        return self._engine.disks()

    @property
    def active_disks(self) -> int:
        """The number of disks in the machine."""
        return self._engine.active_disks()

    @property
    def base(self) -> Values:
        """The base and its drive: inclination [rad], frequency [Hz], amplitude [m], the three setpoints as
        commanded_*, phase [rad], displacement, horizontal_displacement [m], velocity, horizontal_velocity [m/s]."""
        return Values(self._engine.base())

    @property
    def bins(self) -> Values:
        """Of each species, by name: left, right, on_base (numbers of disks), left_mass, right_mass [kg]."""
        return Values(zip(self._scene.species, map(Values, self._engine.bins())))

    @property
    def collisions(self) -> Values:
        """The numbers of collisions since the start, by kind."""
        return Values(self._engine.collisions())

    @property
    def events(self) -> int:
        """The number of all events since the start."""
        return self._engine.events()

    @property
    def energy(self) -> float:
        """Kinetic and potential energy of the disks in the machine [J]."""
        return self._engine.energy()

    @property
    def summary(self) -> Summary:
        """The results so far, as in the summary of a run."""
        summary: Summary = Summary.of(self._engine.summary())
        return summary

    def __repr__(self) -> str:
        return f"<Simulation of {self._scene.source} at {self.time:.6g} s: {self.active_disks} disks>"
