"""Runs points by sieve_sweep, one thread each."""
import dataclasses
import json
import os
import pathlib
import sqlite3
import subprocess
import tempfile

from precision.points import effort_of

LIMIT = 600.0    # of a point's round [s of wall time]
TIMED_OUT = 124  # exit status of timeout(1)
ROUNDS = 2       # that the seeds are divided into


@dataclasses.dataclass
class Results:
    """Of one point."""
    summaries: list = dataclasses.field(default_factory=list)
    failures: list = dataclasses.field(default_factory=list)
    costs: list = dataclasses.field(default_factory=list)  # of each round [processor s per simulated s]


def run_sweep(program, sweep):
    """@return the rows (status, error, summary), the processor time [s] including the start, and the exit status"""
    with tempfile.TemporaryDirectory() as directory:
        file = pathlib.Path(directory) / "point.yaml"
        file.write_text(json.dumps(sweep))  # JSON is YAML
        table = file.with_suffix(".db")
        command = ["timeout", str(LIMIT), str(program), "run", str(file), "--db", str(table), "--threads", "1",
                   "--checkpoint-every", "0"]
        with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as process:
            errors = process.stderr.read()
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode == 2 or not table.exists():
            raise SystemExit(f"sieve_sweep: {errors.strip()}")
        with sqlite3.connect(table) as results:
            rows = results.execute("SELECT status, error, summary FROM cases").fetchall()
    return rows, usage.ru_utime + usage.ru_stime, process.returncode


def run_part(program, point, seeds, span, results):
    rows, seconds, code = run_sweep(program, point.scene.sweep(point.rung, seeds, span))
    completed = [json.loads(summary) for status, _, summary in rows if status == "done"]
    failures = [error for status, error, _ in rows if status == "failed"]
    if code == TIMED_OUT:
        failures.append(f"not completed within {LIMIT:g} s")
    simulated = sum(summary["simulated_time"] for summary in completed)
    if simulated > 0.0 and not failures:
        results.costs.append(seconds / simulated)
    results.summaries += completed
    results.failures += failures


def parts(seeds, rounds):
    """Seeds from 1, divided into rounds."""
    bounds = [1 + seeds * k // rounds for k in range(rounds + 1)]
    return [range(a, b) for a, b in zip(bounds, bounds[1:]) if b > a]


def run_all(program, points, effort, span):
    """Round by round, all points in each, so that a load on the machine affects all of them alike. The cost of a point
    is that of its best round.
    @param effort times the seeds of --quick. @param span simulated time of each run, without settling; None: the
    scene's [s]"""
    results = [Results() for _ in points]
    for number in range(ROUNDS):
        for point, of_point in zip(points, results):
            seeds = round(point.scene.seeds * effort * effort_of(point))
            run_part(program, point, parts(max(ROUNDS, seeds), ROUNDS)[number], span, of_point)
    for point, of_point in zip(points, results):
        point.take(of_point.summaries, len(of_point.failures))
        point.cost = min(of_point.costs, default=None)
