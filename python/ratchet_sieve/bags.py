"""Bags of ROS, which sieve_node and `sieve_run --bag` record."""
from __future__ import annotations

import os
from typing import Any, Iterator, Union

import numpy as np

from . import _engine
from .errors import BagError
from .runs import Frames, Recording
from .scene import Scene

# Of each message that a bag needs, its type.
SCENE, DISKS, BASE, BINS = (f"ratchet_sieve/{name}"
                            for name in ("SceneDescription", "ParticleStates", "BaseState", "BinCounts"))


def read_bag(path: Union[str, os.PathLike]) -> Recording:
    """The scene and the frames of one run, at the times at which disks, base and bins were all recorded.

    Needs ROS's Python module rosbag (Debian: python3-rosbag), but neither a master nor this package's messages.
    Raises BagError.
    """
    try:
        import rosbag
    except ImportError as error:
        raise BagError(f"{os.fspath(path)}: bags are read by ROS's Python module rosbag (Debian: python3-rosbag): "
                       f"{error}") from error
    try:
        with rosbag.Bag(os.fspath(path)) as bag:
            return _read(bag, os.fspath(path))
    except BagError:
        raise
    except OSError as error:
        raise BagError(f"{os.fspath(path)}: {error.strerror or error}") from error
    except Exception as error:  # rosbag raises errors of all kinds at a damaged file
        raise BagError(f"{os.fspath(path)}: {str(error) or type(error).__name__}") from error


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
