"""Bags of ROS, which sieve_node and `sieve_run --bag` record."""
from __future__ import annotations

import os
from typing import Any, Callable, Iterator, Union

import numpy as np

from . import _engine
from .errors import BagError
from .runs import Frames, Recording
from .scene import Scene

# Of each message that a bag needs, its type.
SCENE, DISKS, BASE, BINS = (f"ratchet_sieve/{name}"
                            for name in ("SceneDescription", "ParticleStates", "BaseState", "BinCounts"))
SETTING = ("inclination", "frequency", "amplitude")  # of a base, with what was applied


def read_bag(path: Union[str, os.PathLike]) -> Recording:
    """The scene and the frames of one run, at the times at which disks, base and bins were all recorded.

    Needs ROS's Python module rosbag (Debian: python3-rosbag), but neither a master nor this package's messages.
    Raises BagError.
    """
    return _opened(os.fspath(path), _read)


def _opened(path: str, read: Callable) -> Any:
    """What a function of a bag and its path reads. Raises BagError."""
    try:
        import rosbag
    except ImportError as error:
        raise BagError(f"{path}: bags are read by ROS's Python module rosbag (Debian: python3-rosbag): "
                       f"{error}") from error
    try:
        with rosbag.Bag(path) as bag:
            return read(bag, path)
    except BagError:
        raise
    except OSError as error:
        raise BagError(f"{path}: {error.strerror or error}") from error
    except Exception as error:  # rosbag raises errors of all kinds at a damaged file
        raise BagError(f"{path}: {str(error) or type(error).__name__}") from error


def read_bins(path: str) -> dict:
    """The last counts of a bag's bins, as left.A, right.A and on_base.A, and what they belong to: `duration` and, where
    the bag has the base, its setting. Raises BagError, also where the setting changed."""
    return _opened(path, _read_bins)


def _read_bins(bag: Any, path: str) -> dict:
    *_, last = _messages(bag, BINS, path)
    row: dict[str, Any] = {"duration": last.time}
    if BASE in {about.msg_type for about in bag.get_type_and_topic_info().topics.values()}:
        base = list(_messages(bag, BASE, path))
        for name in SETTING:
            found = {getattr(message, name) for message in base}
            if len(found) > 1:
                raise BagError(f"{path}: {name} changed while it was recorded, from {min(found):g} to {max(found):g}: "
                               "record one setting")
            row[f"base.{name}"] = found.pop()
    for k, species in enumerate(last.species):
        row.update({f"{place}.{species}": int(getattr(last, place)[k]) for place in ("left", "right", "on_base")})
    return row


def _read(bag: Any, path: str) -> Recording:
    scenes = list(_messages(bag, SCENE, path))
    if len(scenes) != 1:
        raise BagError(f"{path}: holds {len(scenes)} runs: must be one")
    scene = Scene(scenes[0].yaml, source=path)
    lists: dict[str, dict[float, Any]] = {
        "disks": {message.time: scene._engine.disks_of({name: getattr(message, name) for name in _engine.DISK_FIELDS})
                  for message in _messages(bag, DISKS, path)},
        "base": {message.time: {name: getattr(message, name) for name in _engine.BASE_FIELDS}
                 for message in _messages(bag, BASE, path)},
        "bins": {message.time: [{name: getattr(message, name)[k].item() for name in _engine.BIN_FIELDS}
                                for k in range(len(message.species))] for message in _messages(bag, BINS, path)}}
    times = sorted(set.intersection(*(set(frames) for frames in lists.values())))
    if not times:
        raise BagError(f"{path}: at no time disks, base and bins were all recorded")
    return Recording(scene, Frames(scene.species, {kind: [(time, frames[time]) for time in times]
                                                   for kind, frames in lists.items()}), path)


def _messages(bag: Any, datatype: str, path: str) -> Iterator[Any]:
    """Those of a type, of the one topic that has it; arrays are numpy's."""
    topics = [topic for topic, about in bag.get_type_and_topic_info().topics.items() if about.msg_type == datatype]
    if len(topics) != 1:
        raise BagError(f"{path}: holds no run of a sieve: no topic of type {datatype}" if not topics else
                       f"{path}: holds several runs: {', '.join(sorted(topics))}")
    for _, (_, content, _, _, message_type), _ in bag.read_messages(topics=topics, raw=True):
        yield message_type().deserialize_numpy(content, np)
