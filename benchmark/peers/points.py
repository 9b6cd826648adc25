"""The points of the picture, as a table: docs/data/peers.csv."""
import dataclasses

from peers import cases, measure
from ratchet_sieve import origin
from ratchet_sieve.tables import read_csv, write_csv

ALIKE = "β = 0 "  # in the row of this project's run without tangential restitution, which the others do not have either


@dataclasses.dataclass
class Point:
    """A program with one step. Undefined: None."""
    program: str
    step: float     # [s]; None for this project
    cost: float     # processor time over simulated time
    drift_a: float  # [m/s], as the following
    error_a: float
    drift_b: float
    error_b: float
    loses_disks: bool
    runs: int
    origin: str     # date and machine

    def drift(self, species):
        return (self.drift_a, self.error_a) if species == 0 else (self.drift_b, self.error_b)


def of_runs(runs, about):
    """@param about date and machine. @return this project without tangential restitution, and every
    program and step."""
    where = origin.text(about)
    groups = {}
    for run in runs:
        if run["program"] != cases.OURS or ALIKE in run["row"]:
            groups.setdefault((run["program"], run.get("step")), []).append(run)
    found = []
    for (program, step), own in groups.items():
        a, b = measure.drift(own)
        found.append(Point(program, step, measure.speed(own), a.value, a.error, b.value, b.error,
                           any(run["lost"] for run in own), len(own), where))
    return found


COLUMNS = [field.name for field in dataclasses.fields(Point)]


def write(path, points):
    write_csv(path, COLUMNS, ([f"{value:.4g}" if isinstance(value, float) else value
                               for value in dataclasses.astuple(point)] for point in points))


def read(path):
    def number(text):
        return float(text) if text else None

    return [Point(line["program"], *(number(line[name]) for name in COLUMNS[1:7]), line["loses_disks"] == "True",
                  int(line["runs"]), line["origin"]) for line in read_csv(path).to_dict("records")]
