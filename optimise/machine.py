"""Machines and their measured results."""
import dataclasses
import pathlib

import yaml

from optimise.search_file import BadSearch
from reproduce.samples import Mean

TEETH = "base.teeth"
TOOTH_WIDTH = "base.tooth_width"


@dataclasses.dataclass(frozen=True)
class Machine:
    kind: str
    values: dict  # key of the scene -> value


@dataclasses.dataclass(frozen=True)
class Measured:
    """Means over the seeds; None where a seed has no value."""
    quality: Mean
    processed: Mean
    throughput: Mean  # disks that left, over time and the base's length [1/(s m)]

    def is_whole(self):
        return None not in (self.quality, self.processed, self.throughput)


def throughput_of(row, scene, machine):
    """Of a run [disks / (s m)]."""
    teeth = machine.values.get(TEETH, scene["base"]["teeth"])
    width = teeth * machine.values.get(TOOTH_WIDTH, scene["base"]["tooth_width"])
    poured = sum(value for key, value in row.items() if key.startswith("count."))
    return row["processed"] * poured / (row["simulated_time"] * width)


def measured(rows, scene, machine, seeds):
    """@param rows of this machine, one a seed"""
    whole = len(rows) == seeds.count and all(row["quality"] is not None for row in rows)
    if not whole:
        return Measured(None, None, None)
    return Measured(rows.mean("quality"), rows.mean("processed"),
                    rows.mean(lambda row: throughput_of(row, scene, machine)))


def read_scene(path):
    try:
        return yaml.safe_load(pathlib.Path(path).read_text(encoding="utf-8"))
    except (UnicodeDecodeError, yaml.YAMLError) as error:
        raise BadSearch(f"{path}: {' '.join(str(error).split())}") from error


def front(points):
    """The pairs (machine, Measured) that no other beats in both quality and throughput, by rising throughput."""
    def beaten(one):
        return any(other is not one and other.quality.value >= one.quality.value
                   and other.throughput.value >= one.throughput.value
                   and (other.quality.value, other.throughput.value) != (one.quality.value, one.throughput.value)
                   for _, other in points)
    return sorted((point for point in points if not beaten(point[1])), key=lambda point: point[1].throughput.value)
