"""The file of a search: a scene, the keys that it varies, the kinds of machines. And what is measured of a machine."""
import copy
import dataclasses
import difflib

import yaml

from ratchet_sieve.base import length
from ratchet_sieve.stats import Mean
from ratchet_sieve.tables import Refusal, throughput

SAWTOOTH = ("tooth_width", "tooth_height", "asymmetry")
MOST_ON_FRONT = 8  # machines that are measured anew: of a longer front both ends and some between, evenly


class BadSearch(Refusal):
    """File, key, value and what is allowed."""


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
    vary: list
    trials: int
    start: dict = dataclasses.field(default_factory=dict)  # values of keys that the kind before does not vary


@dataclasses.dataclass(frozen=True)
class Search:
    path: object
    title: str
    scene: str         # absolute
    settings: dict     # keys of the scene that are the same for all
    ranges: dict       # key -> (low, high), both whole numbers where all values are
    kinds: list        # of Kind
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
        """A machine as a scene of its own. @param machine map from the scene's keys to values"""
        return changed(read_yaml(self.scene), {**self.settings, **machine})


@dataclasses.dataclass(frozen=True)
class Measured:
    """Means over the seeds."""
    goal: Mean        # what the search maximises
    throughput: Mean  # over the base's length [1/(s m)]
    processed: Mean


@dataclasses.dataclass(frozen=True)
class Found:
    """The results of one kind of machine: pairs (machine, Measured)."""
    kind: Kind
    tried: list    # of all that are allowed, by the search's seeds
    front: list    # by held-out seeds
    best: object   # the highest goal by the search's seeds, at the search's throughput, by held-out ones; None: none


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


def read_search(path, goal=None):
    """@param goal in place of the file's own. @throws BadSearch"""
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
    ranges = {key: (bounds["from"], bounds["to"]) for key, bounds in definition["search"].items()}
    kinds = [Kind(name, **value) for name, value in definition["machines"].items()]
    for before, kind in zip([None, *kinds], kinds):
        for key in (*kind.vary, *kind.start):
            if key not in ranges:
                raise BadSearch(f"{path}: machines.{kind.name}: {key} has no range in search; there are "
                                f"{', '.join(ranges)}")
        missing = set(kind.vary) - {*kind.start, *(before.vary if before else ranges)}
        if missing:
            raise BadSearch(f"{path}: machines.{kind.name}.start: has no {', '.join(sorted(missing))}, which the kind "
                            "before does not vary")
    return Search(path, definition["title"], str((path.parent / definition["scene"]).resolve()), definition["set"],
                  ranges, kinds, definition["least_processed"], definition["throughput"],
                  goal or definition["goal"], seeds, held_out)


def changed(scene, values):
    """@param values map from dotted paths, as `--set` of sieve_run: a profile takes the place of the sawtooth's keys.
    @return a copy with them"""
    scene = copy.deepcopy(scene)
    for path, value in values.items():
        place, (*parents, last) = scene, path.split(".")
        for name in parents:
            place = place[int(name)] if isinstance(place, list) else place.setdefault(name, {})
        place[int(last) if isinstance(place, list) else last] = value
        if path == "base.profile":
            for key in SAWTOOTH:
                place.pop(key, None)
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
    """@param rows of a machine, one a seed. @param base of its scene. @param goal the column that is maximised
    @return None where a seed has no value"""
    if any(len(rows.samples(field)) != seeds.count for field in (goal, "processed")):
        return None
    return Measured(rows.mean(goal), rows.mean(throughput).scaled(1.0 / length(base)), rows.mean("processed"))


def front(points):
    """The pairs (machine, Measured) that no other beats in both goal and throughput, by rising throughput."""
    places = [(one.goal.value, one.throughput.value) for _, one in points]
    beaten = [any(goal >= own[0] and throughput >= own[1] and (goal, throughput) != own for goal, throughput in places)
              for own in places]
    return sorted((point for point, is_beaten in zip(points, beaten) if not is_beaten),
                  key=lambda point: point[1].throughput.value)


def thinned(points):
    count = len(points)
    if count <= MOST_ON_FRONT:
        return points
    return [points[round(k * (count - 1) / (MOST_ON_FRONT - 1))] for k in range(MOST_ON_FRONT)]


def best_at(points, throughput_wanted):
    enough = [point for point in points if point[1].throughput.value >= throughput_wanted]
    return max(enough, key=lambda point: point[1].goal.value, default=None)
