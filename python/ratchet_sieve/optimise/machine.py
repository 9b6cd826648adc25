"""Machines and their measured results."""
import copy
import dataclasses
import difflib
import pathlib

import yaml

from ratchet_sieve.base import length
from ratchet_sieve.optimise.search_file import BadSearch
from ratchet_sieve.stats import Mean
from ratchet_sieve.tables import throughput

SAWTOOTH = ("tooth_width", "tooth_height", "asymmetry")


@dataclasses.dataclass(frozen=True)
class Machine:
    kind: str
    values: dict  # key of the scene -> value


@dataclasses.dataclass(frozen=True)
class Measured:
    """Means over the seeds; None where a seed has no value."""
    goal: Mean        # what the search maximises
    processed: Mean
    throughput: Mean  # over the base's length [1/(s m)]

    def is_whole(self):
        return None not in (self.goal, self.processed, self.throughput)


def put(scene, path, value):
    """Sets a key by its dotted path, as `--set` of sieve_run: a profile takes the place of the sawtooth's keys."""
    *parents, last = path.split(".")
    place = scene
    for name in parents:
        place = place[int(name)] if isinstance(place, list) else place.setdefault(name, {})
    place[int(last) if isinstance(place, list) else last] = value
    if path == "base.profile":
        for key in SAWTOOTH:
            place.pop(key, None)


def changed(scene, values):
    """@param values map from dotted paths. @return a copy with them"""
    scene = copy.deepcopy(scene)
    for path, value in values.items():
        put(scene, path, value)
    return scene


def require_goal(goal, rows, path):
    """Checks that the goal is a number of the results, or undefined."""
    numbers = rows.frame.select_dtypes("number")
    if goal in numbers or goal in rows.frame and not rows.frame[goal].notna().any():
        return
    names = list(numbers)
    near = difflib.get_close_matches(goal, names, 1)
    raise BadSearch(f"{path}: goal: {goal}: must be a number of the results of sieve_sweep, "
                    + (f"did you mean {near[0]}?" if near else "such as quality or purity.left.mass.A"))


def measured(rows, scene, machine, seeds, goal):
    """@param rows of this machine, one a seed. @param goal the column that is maximised"""
    if any(len(rows.samples(field)) != seeds.count for field in (goal, "processed")):
        return Measured(None, None, None)
    width = length(changed(scene, machine.values)["base"])
    return Measured(rows.mean(goal), rows.mean("processed"), rows.mean(throughput).scaled(1.0 / width))


def read_scene(path):
    try:
        return yaml.safe_load(pathlib.Path(path).read_text(encoding="utf-8"))
    except (UnicodeDecodeError, yaml.YAMLError) as error:
        raise BadSearch(f"{path}: {' '.join(str(error).split())}") from error


def front(points):
    """The pairs (machine, Measured) that no other beats in both goal and throughput, by rising throughput."""
    def beaten(one):
        return any(other is not one and other.goal.value >= one.goal.value
                   and other.throughput.value >= one.throughput.value
                   and (other.goal.value, other.throughput.value) != (one.goal.value, one.throughput.value)
                   for _, other in points)
    return sorted((point for point in points if not beaten(point[1])), key=lambda point: point[1].throughput.value)
