"""Runs points by sieve_sweep, one thread each."""
import json
import pathlib
import tempfile

from ratchet_sieve.tables import joined
from precision.points import effort_of
from sweeps import call, export, processor_time

LIMIT = 600.0    # of a point's round [s of wall time]
TIMED_OUT = 124  # exit status of timeout(1)
ROUNDS = 2       # that the seeds are divided into


def run_round(program, sweep):
    """@return the Rows of the completed runs, how many others there are, and the processor time over the simulated
    time, the program's start included; None where not all were completed"""
    with tempfile.TemporaryDirectory() as directory:
        file, results = (pathlib.Path(directory) / name for name in ("point.yaml", "point.db"))
        file.write_text(json.dumps(sweep), encoding="utf-8")  # JSON is YAML
        before = processor_time()
        call("timeout", [str(LIMIT), str(program), "run", str(file), "--db", str(results), "--threads", "1",
                         "--checkpoint-every", "0"], (0, 1, TIMED_OUT), None)
        seconds = processor_time() - before
        rows = export(program, file, results, 1, draw_only=True)
    simulated = sum(rows.samples("simulated_time"))
    failed = sweep["seed"]["count"] - len(rows)
    return rows, failed, None if failed or not simulated else seconds / simulated


def run_all(program, points, effort, span):
    """Round by round, all points in each, so that a load on the machine affects all of them alike. The cost of a point
    is that of its best round.
    @param effort times the seeds of --quick. @param span simulated time of each run, without settling; None: the
    scene's [s]"""
    rounds = [[] for _ in points]
    for k in range(ROUNDS):
        for point, own in zip(points, rounds):
            count = max(ROUNDS, round(point.scene.seeds * effort * effort_of(point)))
            seeds = range(1 + count * k // ROUNDS, 1 + count * (k + 1) // ROUNDS)
            own.append(run_round(program, point.scene.sweep(point.rung, seeds, span)))
    for point, own in zip(points, rounds):
        rows, failed, costs = zip(*own)
        point.set_results(joined(*rows), sum(failed))
        point.cost = min((cost for cost in costs if cost is not None), default=None)
