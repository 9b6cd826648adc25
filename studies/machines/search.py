"""The file of a search: a scene, the keys that it varies, the kinds of machines. And what is measured of a machine."""
import copy
import dataclasses
import difflib

import yaml

from ratchet_sieve.base import length
from ratchet_sieve.stats import Mean
from ratchet_sieve.tables import throughput

SAWTOOTH = ("tooth_width", "tooth_height", "asymmetry")
MOST_ON_FRONT = 8  # machines that are measured anew: of a longer front both ends and some between, evenly


class BadSearch(Exception):
    """One line: file, key, value and what is allowed."""


@dataclasses.dataclass(frozen=True)
class Range:
    low: float
    high: float
    is_whole: bool  # both bounds are whole numbers, and so are all values


@dataclasses.dataclass(frozen=True)
class Seeds:
    first: int
    count: int

    def text(self):
        return f"{self.first} to {self.first + self.count - 1}"


@dataclasses.dataclass(frozen=True)
class Kind:
    """A kind of machine: the keys that are varied, and the number of trials."""
    name: str
    keys: tuple
    trials: int
    start: dict  # values of keys that the kind before does not vary


@dataclasses.dataclass(frozen=True)
class Search:
    path: object
    title: str
    scene: str         # absolute
    settings: dict     # keys of the scene that are the same for all
    ranges: dict       # key -> Range
    kinds: tuple       # of Kind
    least_processed: float   # P of an allowed machine
    throughput: float  # of the best machine, at least [disks / (s m)]
    goal: str          # the column of the results that is maximised, beside the throughput
    seeds: Seeds       # of the search
    held_out: Seeds    # of the reported results

    @property
    def label(self):
        """The goal's name in texts."""
        return "Q" if self.goal == "quality" else self.goal

    def scene_of(self, machine):
        """A machine as a scene of its own."""
        return changed(read_yaml(self.scene), {**self.settings, **machine.values})


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


@dataclasses.dataclass(frozen=True)
class Found:
    """The results of one kind of machine."""
    kind: object
    tried: list   # pairs (machine, Measured by the search's seeds) of all that are allowed
    front: list   # pairs (machine, Measured by held-out seeds)
    best: object  # such a pair: the highest goal by the search's seeds, at the search's throughput; None: there is none


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def is_seeds(value):
    return (isinstance(value, dict) and set(value) == {"first", "count"}
            and all(isinstance(number, int) and number > 0 for number in value.values()))


def is_range(value):
    return (isinstance(value, dict) and set(value) == {"from", "to"} and all(map(is_number, value.values()))
            and value["from"] < value["to"])


def is_kind(value):
    return (isinstance(value, dict) and {"vary", "trials"} <= set(value) <= {"vary", "trials", "start"}
            and isinstance(value["trials"], int) and value["trials"] > 0)


# Of each key, whether a value is right, and what it must be.
SEEDS = (is_seeds, "{first: N, count: N}, whole numbers above 0")
PARTS = {
    "title": (lambda value: isinstance(value, str), "a text"),
    "scene": (lambda value: isinstance(value, str), "a scene's file, by its path from here"),
    "set": (lambda value: isinstance(value, dict), "a map, may be empty"),
    "search": (lambda value: isinstance(value, dict) and value and all(map(is_range, value.values())),
               "a map from keys to ranges, each {from: LOW, to: HIGH}, LOW below HIGH"),
    "machines": (lambda value: isinstance(value, dict) and value and all(map(is_kind, value.values())),
                 "a map from names to kinds of machines, each with vary, trials (a whole number above 0) and perhaps "
                 "start"),
    "least_processed": (lambda value: is_number(value) and 0.0 <= value <= 1.0, "a number from 0 to 1"),
    "throughput": (lambda value: is_number(value) and value >= 0.0, "a number, 0 or more"),
    "goal": (lambda value: isinstance(value, str), "the name of a number of the results, such as quality"),
    "seeds": SEEDS, "held_out": SEEDS}


def read_yaml(path):
    try:
        with open(path, encoding="utf-8") as file:
            return yaml.safe_load(file)
    except (OSError, UnicodeDecodeError, yaml.YAMLError) as error:
        raise BadSearch(f"{path}: {' '.join(str(error).split())}") from error


def read_search(path):
    definition = read_yaml(path)
    definition = {"goal": "quality", **definition} if isinstance(definition, dict) else {}
    if set(definition) != set(PARTS):
        raise BadSearch(f"{path}: must have {', '.join(sorted(PARTS))}, each once (goal may be left out), and nothing "
                        f"else; look at {', '.join(sorted(set(definition) ^ set(PARTS)))}")
    for key, (is_right, what) in PARTS.items():
        if not is_right(definition[key]):
            raise BadSearch(f"{path}: {key}: {definition[key]}: must be {what}")
    seeds, held_out = (Seeds(**definition[key]) for key in ("seeds", "held_out"))
    if max(seeds.first, held_out.first) < min(seeds.first + seeds.count, held_out.first + held_out.count):
        raise BadSearch(f"{path}: held_out: {held_out.first}: must not overlap seeds")
    ranges = {key: Range(value["from"], value["to"], all(isinstance(bound, int) for bound in value.values()))
              for key, value in definition["search"].items()}
    kinds = [Kind(name, tuple(value["vary"]), value["trials"], dict(value.get("start", {})))
             for name, value in definition["machines"].items()]
    known = ranges
    for kind in kinds:
        for key in (*kind.keys, *kind.start):
            if key not in ranges:
                raise BadSearch(f"{path}: machines.{kind.name}: {key} has no range in search; there are "
                                f"{', '.join(ranges)}")
        missing = set(kind.keys) - set(known) - set(kind.start)
        if missing:
            raise BadSearch(f"{path}: machines.{kind.name}.start: has no {', '.join(sorted(missing))}, which the kind "
                            "before does not vary")
        known = kind.keys
    return Search(path, definition["title"], str((path.parent / definition["scene"]).resolve()), definition["set"],
                  ranges, tuple(kinds), definition["least_processed"], definition["throughput"], definition["goal"],
                  seeds, held_out)


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
    near = difflib.get_close_matches(goal, list(numbers), 1)
    raise BadSearch(f"{path}: goal: {goal}: must be a number of the results of sieve_sweep, "
                    + (f"did you mean {near[0]}?" if near else "such as quality or purity.left.mass.A"))


def measured(rows, base, seeds, goal):
    """@param rows of a machine, one a seed. @param base of its scene. @param goal the column that is maximised"""
    if any(len(rows.samples(field)) != seeds.count for field in (goal, "processed")):
        return Measured(None, None, None)
    return Measured(rows.mean(goal), rows.mean("processed"), rows.mean(throughput).scaled(1.0 / length(base)))


def front(points):
    """The pairs (machine, Measured) that no other beats in both goal and throughput, by rising throughput."""
    def beaten(one):
        return any(other is not one and other.goal.value >= one.goal.value
                   and other.throughput.value >= one.throughput.value
                   and (other.goal.value, other.throughput.value) != (one.goal.value, one.throughput.value)
                   for _, other in points)
    return sorted((point for point in points if not beaten(point[1])), key=lambda point: point[1].throughput.value)


def thinned(points):
    count = len(points)
    if count <= MOST_ON_FRONT:
        return points
    return [points[round(k * (count - 1) / (MOST_ON_FRONT - 1))] for k in range(MOST_ON_FRONT)]


def best_at(points, throughput_wanted):
    enough = [point for point in points if point[1].throughput.value >= throughput_wanted]
    return max(enough, key=lambda point: point[1].goal.value, default=None)
