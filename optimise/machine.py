"""Machines and their measured results."""
import copy
import dataclasses
import difflib
import pathlib

import yaml

from optimise.search_file import BadSearch
from reproduce.samples import Mean

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
    throughput: Mean  # disks that left, over time and the base's length [1/(s m)]

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


def throughput_of(row, scene, machine):
    """Of a run [disks / (s m)]."""
    base = changed(scene, machine.values)["base"]
    width = base["teeth"] * (base["profile"][-1][0] if "profile" in base else base["tooth_width"])
    poured = sum(value for key, value in row.items() if key.startswith("count."))
    return row["processed"] * poured / (row["simulated_time"] * width)


def require_goal(goal, row, path):
    """Checks that the goal is a number of the results, or undefined. @param row of a run"""
    if goal in row and not isinstance(row[goal], str):
        return
    names = [name for name, value in row.items() if isinstance(value, float)]
    near = difflib.get_close_matches(goal, names, 1)
    raise BadSearch(f"{path}: goal: {goal}: must be a number of the results of sieve_sweep, "
                    + (f"did you mean {near[0]}?" if near else "such as quality or purity.left.mass.A"))


def measured(rows, scene, machine, seeds, goal):
    """@param rows of this machine, one a seed. @param goal the column that is maximised"""
    whole = len(rows) == seeds.count and all(None not in (row[goal], row["processed"]) for row in rows)
    if not whole:
        return Measured(None, None, None)
    return Measured(rows.mean(goal), rows.mean("processed"),
                    rows.mean(lambda row: throughput_of(row, scene, machine)))


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
