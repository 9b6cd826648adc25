"""The frames of a run for ParaView, by meshio: one VTU file a frame, and collections (PVD) that list them."""
from __future__ import annotations

import pathlib
import tempfile
from typing import TYPE_CHECKING, Any, Sequence
from xml.sax.saxutils import quoteattr

import numpy as np

from .base import in_world, surface
from .tables import write_text, writing

if TYPE_CHECKING:
    from .runs import Recording
    from .scene import Scene


def write_pvd(recording: Recording, path: str) -> None:
    """Writes RUN.pvd (the disks), RUN_base.pvd, and the frames of both into RUN_frames, in place of those of an earlier
    run. Raises ImportError without meshio, OSError."""
    try:
        import meshio
    except ImportError as error:
        raise ImportError(f"{path}: is written by meshio (Debian: python3-meshio): {error}") from error
    frames = recording.frames
    collection = pathlib.Path(path)
    folder = collection.with_name(collection.stem + "_frames")
    of_base = collection.with_name(collection.stem + "_base.pvd")
    with writing(path) as part, tempfile.TemporaryDirectory(".sieve_part", dir=collection.parent) as scratch:
        for k, (disks, base) in enumerate(zip(frames.disks, frames.base)):
            for series, parts in (("disks", _disks(disks)), ("base", _base(recording.scene, base))):
                meshio.write(pathlib.Path(scratch, f"{series}_{k:06}.vtu"), meshio.Mesh(**parts))
        folder.mkdir(exist_ok=True)
        for old in (*folder.glob("disks_*.vtu"), *folder.glob("base_*.vtu")):
            old.unlink()
        for new in pathlib.Path(scratch).iterdir():
            new.rename(folder / new.name)
        write_text(of_base, _list(folder.name, "base", frames.time))
        part.write_text(_list(folder.name, "disks", frames.time), encoding="utf-8")


def _disks(disks: np.ndarray) -> dict[str, Any]:
    """A point a disk, with all its numbers."""
    point_data = {name: disks[name] for name in ("id", "species", "radius", "mass", "angle", "spin", "displacement")}
    return {"points": _in_space(disks["x"], disks["y"]), "cells": [("vertex", np.arange(len(disks)).reshape(-1, 1))],
            "point_data": {**point_data, "velocity": _in_space(disks["vx"], disks["vy"])}}


def _base(scene: Scene, base: np.void) -> dict[str, Any]:
    """A line through the corners of the base and, where the scene gives their height, its walls."""
    shape = scene["base"]
    corners = surface(shape)
    height = shape.get("wall_height", 0.0)
    if scene["boundary"] == "walled" and height > 0.0:
        corners = [(corners[0][0], height), *corners, (corners[-1][0], height)]
    x, y = zip(*in_world(corners, base["inclination"], (base["horizontal_displacement"], base["displacement"])))
    ends = np.arange(len(corners))
    return {"points": _in_space(x, y), "cells": [("line", np.column_stack([ends[:-1], ends[1:]]))]}


def _in_space(x: Sequence[float], y: Sequence[float]) -> np.ndarray:
    return np.column_stack([x, y, np.zeros(len(x))])


def _list(folder: str, series: str, times: np.ndarray) -> str:
    """The frames of a series, with their times."""
    files = (quoteattr(f"{folder}/{series}_{k:06}.vtu") for k in range(len(times)))
    sets = "".join(f'<DataSet timestep="{float(time)!r}" file={file}/>\n' for time, file in zip(times, files))
    return ('<?xml version="1.0"?>\n<VTKFile type="Collection" version="1.0">\n<Collection>\n'
            f"{sets}</Collection>\n</VTKFile>\n")
