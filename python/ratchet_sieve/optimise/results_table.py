"""The table of results: a line for each machine. Its part is `tried` (by the search's seeds, all allowed machines),
`front` (by fresh seeds) or `best` (the chosen machine, by fresh seeds)."""
import dataclasses

from ratchet_sieve.optimise.machine import Machine, Measured
from ratchet_sieve.optimise.outcome import Found
from ratchet_sieve.stats import Mean
from ratchet_sieve.tables import read_csv, write_csv

FIXED = ["search", "kind", "part",
         *(f"{name}{ending}" for name in ("quality", "throughput", "processed") for ending in ("", "_error")), "seeds",
         "measured", "machine", "version"]


def columns_of(search):
    """@return map from the fields of Measured to their columns"""
    return {"goal": search.goal, "throughput": "throughput", "processed": "processed"}


@dataclasses.dataclass(frozen=True)
class Origin:
    measured: str  # date
    machine: str
    version: str


def digits(value):
    return "" if value is None else f"{value:.6g}"


def lines(search, found, origin):
    for one in found:
        for part, pairs in (("tried", one.tried), ("front", one.front), ("best", [one.best] if one.best else [])):
            for machine, measured in pairs:
                line = {"search": search.path.stem, "kind": one.kind.name, "part": part,
                        **dataclasses.asdict(origin), **machine.values}
                for field, column in columns_of(search).items():
                    mean = getattr(measured, field)
                    if mean:
                        line.update({column: digits(mean.value), f"{column}_error": digits(mean.error),
                                     "seeds": mean.count})
                yield line


def write(path, all_lines):
    write_csv(path, FIXED + sorted({key for line in all_lines for key in line} - set(FIXED)), all_lines)


def mean(line, name):
    if not line[name]:
        return None
    error = line[f"{name}_error"]
    return Mean(float(line[name]), float(error) if error else None, int(line["seeds"]))


def pair(line, search):
    values = {key: (int if bounds.is_whole else float)(line[key]) for key, bounds in search.ranges.items()
              if line.get(key)}
    return Machine(line["kind"], values), Measured(**{field: mean(line, column)
                                                      for field, column in columns_of(search).items()})


def read(path, search):
    """@return a Found for each kind, and their Origin; None where the table has none of this search and
    its goal"""
    own = [line for line in read_csv(path).to_dict("records")
           if line["search"] == search.path.stem and line.get(search.goal)]
    if not own:
        return None, None
    found = []
    for kind in search.kinds:
        parts = {part: [pair(line, search) for line in own if (line["kind"], line["part"]) == (kind.name, part)]
                 for part in ("tried", "front", "best")}
        found.append(Found(kind, parts["tried"], parts["front"], next(iter(parts["best"]), None)))
    return found, Origin(*(own[-1][name] for name in ("measured", "machine", "version")))
