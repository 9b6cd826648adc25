"""Whole runs, from the pour to the end."""
from __future__ import annotations

import json
import math
import os
from typing import Any, Mapping, Optional, Union

import numpy as np

from . import _engine
from .arguments import integer, mapping, number, path_of
from .errors import warn
from .pages import show_page
from .progress import Progress
from .scene import AnyScene, Scene, scene_of
from .simulation import Simulation
from .values import Summary, Values

KINDS: tuple = _engine.COLLISION_KINDS
"""The kinds of collisions, in the order of the numbers of Collisions.records["kind"]."""


class Frames:
    """The frames of a run, at equal steps of time and at its end.

    time    array (frames,) [s]
    disks   list of structured arrays, one a frame; see Simulation.disks
    base    structured array (frames,): see Simulation.base
    bins    of each species, by name, a structured array (frames,): see Simulation.bins
    """

    def __init__(self, species: list[str], lists: Mapping[str, list]):
        self.time = np.array([time for time, _ in lists["disks"]])
        self.disks = [disks for _, disks in lists["disks"]]
        self.base = _columns([base for _, base in lists["base"]])
        self.bins = Values((name, _columns([bins[k] for _, bins in lists["bins"]]))
                           for k, name in enumerate(species))
        self._others = lists.get("others", [])

    def __len__(self) -> int:
        return len(self.time)

    def _tuples(self) -> list[tuple]:
        """Of each frame, what the engine writes files from."""
        names = self.base.dtype.names
        bins = [[dict(zip(of.dtype.names, row)) for row in of.tolist()] for of in self.bins.values()]
        return [(float(time), disks, dict(zip(names, base)), list(of_species))
                for time, disks, base, of_species in zip(self.time, self.disks, self.base.tolist(), zip(*bins))]

    def __repr__(self) -> str:
        return f"<{len(self)} frames>"


class Collisions(Values):
    """The numbers of collisions of a run, by kind.

    records  None, or with run(..., collisions=True) each collision: a structured array of time [s], kind (its
             number in KINDS), i, j (ids of the disks; j is -1 for the base), normal_speed [m/s], normal_impulse,
             tangential_impulse [N s]
    """

    records: Optional[np.ndarray] = None


class Exits(np.ndarray):
    """The disks that have left a machine, in the order of time: a structured array of time [s], id, species (its name),
    radius [m], mass [kg], side ("left" or "right") and place (of the centre along the world's x [m])."""

    @property
    def left(self) -> Exits:
        return self._of("left")

    @property
    def right(self) -> Exits:
        return self._of("right")

    def _of(self, side: str) -> Exits:
        part: Exits = self[self["side"] == side]
        return part


class Recording:
    """What pictures need: the frames of a run, and its scene."""

    _page_summary: Mapping[str, Any] = {}  # of the summary, what its page shows beside its frames

    def __init__(self, scene: Scene, frames: Frames, title: str = ""):
        self.scene = scene
        self.frames = frames
        self.title = title or scene.source

    def plot(self, frame: int = -1, axes: Any = None) -> Any:
        """Draws the machine at a frame, or of a run without frames at its end. Returns matplotlib's axes."""
        from .plots import pictures

        return pictures.machine_of(self, frame, axes)

    def animate(self, speed: float = 1.0) -> Any:
        """The frames as matplotlib's FuncAnimation, `speed` times as fast as the machine. Jupyter shows it as a video
        (`from IPython.display import HTML; HTML(run.animate().to_jshtml())`); `.save("run.gif")` keeps it.
        Raises ValueError if the run has no frames."""
        self._require_frames()
        from .plots import pictures

        return pictures.animation_of(self, speed)

    def write(self, path: Union[str, os.PathLike], *, megabytes: float = 3.0) -> None:
        """Writes the frames for other programs; the ending selects the format: .html for one page that any browser
        shows, .xyz and .extxyz for OVITO and ASE, .pvd for ParaView (needs meshio); see docs/recording.md.

        megabytes  size of the page at most: its frames are thinned to it
        Raises ValueError without frames or with another ending, OSError, ImportError without meshio.
        """
        self._require_frames()
        file = path_of("path", path)
        self.scene.require_other(("path", file))
        ending = os.path.splitext(file)[1]
        if ending == ".html":
            _engine.write_page(file, os.path.basename(self.title), self.scene._engine, self.frames._tuples(),
                               self.frames._others, json.dumps(self._page_summary), megabytes)
        elif ending == ".pvd":
            from .paraview import write_pvd

            write_pvd(self, file)
        else:
            if ending not in (".xyz", ".extxyz"):
                raise ValueError(f"path = {file!r}: must end in .html, .xyz, .extxyz or .pvd")
            _engine.write_trajectory(file, self.scene._engine, self.frames._tuples())

    def show(self, *, height: int = 900, megabytes: float = 3.0) -> Any:
        """Shows the page of write("run.html"): in a notebook below the cell, else in the browser.

        height  in a notebook [pixels]
        Raises ValueError without frames.
        """
        return show_page(lambda page: self.write(page, megabytes=megabytes), self.title, height)

    def _require_frames(self) -> None:
        """Raises ValueError if the run has none."""
        if not len(self.frames):
            raise ValueError("the run has no frames: call run(..., frames=60)")

    def __repr__(self) -> str:
        return f"<Recording of {self.scene.source}: {len(self.frames)} frames>"


class Run(Recording):
    """A run that has ended.

    scene, summary, frames (empty unless asked for), collisions, exits
    """

    def __init__(self, simulation: Simulation, summary: Summary, frames: Frames, collisions: Collisions, exits: Exits):
        super().__init__(simulation.scene, frames)
        self.simulation = simulation
        self.summary = summary
        self.collisions = collisions
        self.exits = exits

    def separation(self, since: float = 0.0, until: float = math.inf) -> Optional[float]:
        """s of the disks that left after `since` until `until` [s], as the summary has it of all: above 0 the first
        species of the scene (of more than two, of the best pair) left on the left. None until one of each has left."""
        since, until = number("since", since), until if until == math.inf else number("until", until)
        left = self.exits[(self.exits["time"] > since) & (self.exits["time"] <= until)].view(Exits)
        return _engine.separation([tuple(np.count_nonzero(side["species"] == name) for side in (left.left, left.right))
                                   for name in self.scene.species])

    def __repr__(self) -> str:
        return f"<Run of {self.scene.source}, {self.summary.simulated_time:.6g} s>\n{self.summary!r}"


def run(scene: AnyScene, *, until: Optional[Mapping[str, float]] = None, frames: float = 0.0, collisions: bool = False,
        feed: Any = None, threads: int = 0, progress: bool = True) -> Run:
    """Runs a scene to its end, as `sieve_run` does.

    scene       a Scene, the path of a scene file, or a mapping
    until       ends the run once its means are known so well: {"mean_vx": 0.001} [m/s], {"quality": 0.02}
    frames      frames per simulated second; 0: none
    collisions  whether to keep each collision: 48 bytes each
    feed        disks that are fed at their times, in place of the scene's feed.rate or feed.file: the `exits` of another
                run, its `exits.right`, or columns time, species, radius and mass of any table
    threads     at most; 0: one per processor. A run takes as many as its disks are worth. The bits depend on none
                of these.
    progress    whether to show a bar, in a terminal or a notebook
    Raises SceneError, ValueError. Warns (SieveWarning) as sieve_run does. Ctrl-C raises KeyboardInterrupt.
    """
    scene = scene_of(scene)
    rate = number("frames", frames, 0.0, 1e5, "1/s")
    threads = integer("threads", threads)
    if not isinstance(collisions, (bool, np.bool_, int)):
        raise ValueError(f"collisions = {collisions!r}: must be True or False")
    if until is not None:
        wanted = mapping("until", until, '{"mean_vx": 0.001}')
        scene = scene.replace({f"accuracy.{key}": value for key, value in wanted.items()})
    if feed is not None:
        others = {"rate", "file", "side"} & set(scene.given.get("feed") or {})
        scene = scene.replace({**{f"feed.{key}": None for key in others}, "feed.disks": _rows(feed)})
    simulation = Simulation(scene)
    duration = scene["duration"]
    with Progress(progress, "run") as bar:
        summary, lists, records, left = _engine.run(
            simulation._engine, rate, bool(collisions), threads,
            lambda time: bar.show(time / duration if duration else 1.0, f"{time:.4g} of {duration:.4g} s"))
    for warning in summary["warnings"]:
        warn(warning)
    counts = Collisions(summary["collisions"])
    counts.__dict__["records"] = records
    found = Run(simulation, Summary.of(summary), Frames(scene.species, lists), counts, _exits(left, scene.species))
    found._page_summary = {key: summary[key] for key in ("warnings", "steady", "steady_reason")}
    return found


def _exits(rows: np.ndarray, species: list[str]) -> Exits:
    """The engine's rows with names in place of numbers."""
    names = {"species": np.array(species), "side": np.array(["left", "right"])}
    kinds = [(name, names[name].dtype if name in names else rows.dtype[name]) for name in rows.dtype.names]
    exits = np.empty(len(rows), dtype=kinds)
    for name in rows.dtype.names:
        exits[name] = names[name][rows[name]] if name in names else rows[name]
    return exits.view(Exits)


def _rows(feed: Any) -> list[dict[str, Any]]:
    """Disks as feed.disks has them."""
    names = ("time", "species", "radius", "mass")
    try:
        columns = [np.asarray(feed[name]).tolist() for name in names]
    except (KeyError, IndexError, TypeError, ValueError):
        raise ValueError(f"feed = {feed!r}: must have columns time, species, radius and mass, as run.exits") from None
    return [dict(zip(names, row)) for row in zip(*columns)]


def _columns(rows: list[Mapping[str, Any]]) -> np.ndarray:
    """Rows with the same keys as a structured array."""
    if not rows:
        return np.empty(0)
    kinds = [(name, np.int64 if isinstance(value, int) else np.float64) for name, value in rows[0].items()]
    return np.array([tuple(row.values()) for row in rows], dtype=kinds)
