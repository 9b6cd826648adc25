"""The measured tables: accuracy.csv has the results of each setting, accuracy_costs.csv its processor time. The results
are the same on every machine, the times are not: each file says when, and the second where, a line was measured."""
import dataclasses

from ratchet_sieve.stats import Mean
from ratchet_sieve.tables import read_csv, write_csv

RESULTS, COSTS = "accuracy.csv", "accuracy_costs.csv"
KEY = ["scene", "family", "setting"]
RESULT_COLUMNS = [*KEY, "quantity", "runs", "mean", "standard_error", "measured", "physics"]
COST_COLUMNS = [*KEY, "processor_s_per_simulated_s", "measured", "machine", "physics"]
COUNTS = ("overlap", "pushed_out", "through_base", "ended_early")  # quantities that are no means over runs


@dataclasses.dataclass(frozen=True, order=True)
class Origin:
    date: str
    machine: str
    physics: str  # version


def read(path):
    """@return the file's lines as maps from column to text; none where there is no file"""
    return read_csv(path).to_dict("records") if path.exists() else []


def key_of(line):
    return tuple(line[column] for column in KEY)


def result_lines(point, origin):
    common = {**dict(zip(KEY, point.key())), "measured": origin.date, "physics": origin.physics}
    for name, mean in point.means.items():
        yield {**common, "quantity": name, "runs": mean.count, "mean": f"{mean.value:.10g}",
               "standard_error": "" if mean.error is None else f"{mean.error:.4g}"}
    for name in COUNTS:
        yield {**common, "quantity": name, "runs": "", "mean": f"{getattr(point, name):.4g}", "standard_error": ""}


def save(directory, points, origin, with_costs):
    """Replaces the lines of these points, and keeps the others."""
    keys = {point.key() for point in points}
    kept = [line for line in read(directory / RESULTS) if key_of(line) not in keys]
    write_csv(directory / RESULTS, RESULT_COLUMNS,
              kept + [line for point in points for line in result_lines(point, origin)])
    if with_costs:
        kept = [line for line in read(directory / COSTS) if key_of(line) not in keys]
        write_csv(directory / COSTS, COST_COLUMNS, kept + [
            {**dict(zip(KEY, point.key())), "processor_s_per_simulated_s": f"{point.cost:.3g}",
             "measured": origin.date, "machine": origin.machine, "physics": origin.physics}
            for point in points if point.cost is not None])


def load(directory, points):
    """Puts the results in the files into the points. @return the origins of the results and of the costs, the newest
    last"""
    known = {point.key(): point for point in points}
    results = [line for line in read(directory / RESULTS) if key_of(line) in known]
    costs = [line for line in read(directory / COSTS) if key_of(line) in known]
    for line in results:
        point, name = known[key_of(line)], line["quantity"]
        if name in COUNTS:
            setattr(point, name, float(line["mean"]))
        else:
            error = float(line["standard_error"]) if line["standard_error"] else None
            point.means[name] = Mean(float(line["mean"]), error, int(line["runs"]))
    for line in costs:
        known[key_of(line)].cost = float(line["processor_s_per_simulated_s"])
    return [sorted({Origin(line["measured"], line.get("machine", ""), line["physics"]) for line in lines})
            for lines in (results, costs)]
