"""The file of a search: a scene, the keys that it varies, the kinds of machines."""
import dataclasses

import yaml


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
        return "Q" if self.goal == DEFAULTS["goal"] else self.goal


REQUIRED = {"title", "scene", "set", "search", "machines", "least_processed", "throughput", "seeds", "held_out"}
DEFAULTS = {"goal": "quality"}


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def require_parts(path, definition):
    """Checks the type of each part. The contents are checked where they are read."""
    for key, is_right, what in (
            ("title", lambda value: isinstance(value, str), "a text"),
            ("scene", lambda value: isinstance(value, str) and (path.parent / value).is_file(),
             "a scene's file, by its path from here"),
            ("set", lambda value: isinstance(value, dict), "a map, may be empty"),
            ("search", lambda value: isinstance(value, dict) and value, "a map from keys to ranges"),
            ("machines", lambda value: isinstance(value, dict) and value, "a map from names to kinds of machines"),
            ("least_processed", lambda value: is_number(value) and 0.0 <= value <= 1.0, "a number from 0 to 1"),
            ("throughput", lambda value: is_number(value) and value >= 0.0, "a number, 0 or more"),
            ("goal", lambda value: isinstance(value, str), "the name of a number of the results, such as quality")):
        if not is_right(definition[key]):
            raise BadSearch(f"{path}: {key}: {definition[key]}: must be {what}")


def read_range(path, key, value):
    if not (isinstance(value, dict) and set(value) == {"from", "to"} and all(map(is_number, value.values()))
            and value["from"] < value["to"]):
        raise BadSearch(f"{path}: search.{key}: {value}: must be {{from: LOW, to: HIGH}}, LOW below HIGH")
    low, high = value["from"], value["to"]
    return Range(low, high, isinstance(low, int) and isinstance(high, int))


def read_kind(path, name, value, ranges):
    if not isinstance(value, dict) or not {"vary", "trials"} <= set(value) <= {"vary", "trials", "start"}:
        raise BadSearch(f"{path}: machines.{name}: must have vary and trials, and may have start")
    for key in (*value["vary"], *value.get("start", {})):
        if key not in ranges:
            raise BadSearch(f"{path}: machines.{name}: {key} has no range in search; there are {', '.join(ranges)}")
    if not isinstance(value["trials"], int) or value["trials"] < 1:
        raise BadSearch(f"{path}: machines.{name}.trials: {value['trials']}: must be a whole number above 0")
    return Kind(name, tuple(value["vary"]), value["trials"], dict(value.get("start", {})))


def read_seeds(path, key, value):
    if not (isinstance(value, dict) and set(value) == {"first", "count"}
            and all(isinstance(number, int) and number > 0 for number in value.values())):
        raise BadSearch(f"{path}: {key}: {value}: must be {{first: N, count: N}}, whole numbers above 0")
    return Seeds(value["first"], value["count"])


def read_search(path):
    try:
        definition = yaml.safe_load(path.read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError, yaml.YAMLError) as error:
        raise BadSearch(f"{path}: {' '.join(str(error).split())}") from error
    if not isinstance(definition, dict) or set(definition) - set(DEFAULTS) != REQUIRED:
        wrong = sorted((set(definition if isinstance(definition, dict) else ()) - set(DEFAULTS)) ^ REQUIRED)
        raise BadSearch(f"{path}: must have {', '.join(sorted(REQUIRED))}, each once, may have "
                        f"{', '.join(DEFAULTS)}, and nothing else; look at {', '.join(wrong)}")
    definition = {**DEFAULTS, **definition}
    require_parts(path, definition)
    ranges = {key: read_range(path, key, value) for key, value in definition["search"].items()}
    seeds, held_out = (read_seeds(path, key, definition[key]) for key in ("seeds", "held_out"))
    if max(seeds.first, held_out.first) < min(seeds.first + seeds.count, held_out.first + held_out.count):
        raise BadSearch(f"{path}: held_out: {held_out.first}: must not overlap seeds")
    kinds = tuple(read_kind(path, name, value, ranges) for name, value in definition["machines"].items())
    for before, kind in zip(kinds, kinds[1:]):
        missing = set(kind.keys) - set(before.keys) - set(kind.start)
        if missing:
            raise BadSearch(f"{path}: machines.{kind.name}.start: has no {', '.join(sorted(missing))}, which "
                            f"{before.name} does not vary")
    return Search(path, definition["title"], str((path.parent / definition["scene"]).resolve()), definition["set"],
                  ranges, kinds, definition["least_processed"], definition["throughput"], definition["goal"], seeds,
                  held_out)
