"""Runs points by sieve_sweep, one thread each, and sums up what came of them."""
import concurrent.futures
import dataclasses
import json
import math
import os
import pathlib
import sqlite3
import statistics
import subprocess
import tempfile

from precision import rungs

TIMED_OUT = 124  # what timeout(1) ends with


@dataclasses.dataclass
class Point:
    """A scene with one setting, over its seeds."""
    scene: object
    family: str
    label: str
    rung: dict
    summaries: list = dataclasses.field(default_factory=list)
    costs: list = dataclasses.field(default_factory=list)  # of each round [processor s per simulated s]
    failures: list = dataclasses.field(default_factory=list)

    def cost(self):
        """Of the best round: what others do on the machine is in it least. None where no run came to its end."""
        return min(self.costs) if self.costs else None

    def observed(self, name):
        """@return mean over the seeds and its standard error, 0 of one seed; None where nothing was observed"""
        values = [self.scene.observables[name](summary) for summary in self.summaries]
        values = [value for value in values if value is not None]
        if not values:
            return None
        error = statistics.stdev(values) / math.sqrt(len(values)) if len(values) > 1 else 0.0
        return statistics.fmean(values), error

    def leaked(self):
        return sum(summary["through_base"] for summary in self.summaries)

    def pushed_out(self):
        """Disks that a missed contact had left behind the base's surface, each time."""
        return sum(summary.get("pushed_out", 0) for summary in self.summaries)

    def overlap(self):
        """The largest that was met [m]."""
        return max((summary["max_overlap"] for summary in self.summaries), default=math.nan)

    def fails(self):
        return bool(self.failures) or self.leaked() > 0


@dataclasses.dataclass
class Plan:
    effort: float  # times the seeds of --quick
    rounds: int
    jobs: int      # points at a time
    limit: float   # of a point's round [s of wall time]
    span: object = None  # run so long only after settling [s]


def run_sweep(program, sweep, limit):
    """@return the rows (status, error, summary) and the processor time [s], start and all"""
    with tempfile.TemporaryDirectory() as directory:
        file = pathlib.Path(directory) / "point.yaml"
        file.write_text(json.dumps(sweep))  # JSON is YAML
        table = file.with_suffix(".db")
        command = ["timeout", str(limit), str(program), "run", str(file), "--db", str(table), "--threads", "1",
                   "--checkpoint-every", "0"]
        with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as process:
            said = process.stderr.read()
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode == 2 or not table.exists():
            raise SystemExit(f"sieve_sweep: {said.strip()}")
        with sqlite3.connect(table) as results:
            rows = results.execute("SELECT status, error, summary FROM cases").fetchall()
    return rows, usage.ru_utime + usage.ru_stime, process.returncode


def run_part(program, point, seeds, plan):
    rows, seconds, code = run_sweep(program, point.scene.sweep(point.rung, seeds, plan.span), plan.limit)
    done = [json.loads(summary) for status, _, summary in rows if status == "done"]
    failures = [error for status, error, _ in rows if status == "failed"]
    if code == TIMED_OUT:
        failures.append(f"not at its end within {plan.limit} s")
    simulated = sum(summary["simulated_time"] for summary in done)
    if simulated > 0.0 and not failures:
        point.costs.append(seconds / simulated)
    point.summaries += done
    point.failures += failures


def parts(seeds, rounds):
    """Seeds from 1, divided into rounds."""
    bounds = [1 + seeds * k // rounds for k in range(rounds + 1)]
    return [range(a, b) for a, b in zip(bounds, bounds[1:]) if b > a]


def run_all(program, points, plan, after_round):
    """Round by round, all points in each, so that what slows the machine for a while slows all of them alike."""
    with concurrent.futures.ThreadPoolExecutor(plan.jobs) as pool:
        for number in range(plan.rounds):
            started = []
            for point in points:
                seeds = round(point.scene.seeds * plan.effort * rungs.effort(point))
                divided = parts(max(plan.rounds, seeds), plan.rounds)
                started.append(pool.submit(run_part, program, point, divided[number], plan))
            for job in started:
                job.result()
            after_round()


def saved(points):
    return [{"scene": p.scene.name, "family": p.family, "label": p.label, "rung": p.rung, "costs": p.costs,
             "failures": p.failures, "summaries": p.summaries} for p in points]


def restore(points, entries):
    """Puts saved runs into the points that they are of. @return the points that have runs"""
    by_name = {(e["scene"], e["family"], e["label"]): e for e in entries}
    found = []
    for point in points:
        entry = by_name.get((point.scene.name, point.family, point.label))
        if entry and entry["rung"] == point.rung:
            point.summaries, point.costs = entry["summaries"], entry["costs"]
            point.failures = entry["failures"]
            found.append(point)
    return found
