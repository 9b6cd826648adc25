"""Runs programs one after another on one core, and computes means over their runs."""
import json
import shutil
import os
import statistics
import subprocess
import sys

from ratchet_sieve.stats import mean_of

TIMEOUT = 900.0  # of wall time [s]: a longer run has hung


def pinned(command):
    """On the last core that this process may use: the first one serves the system."""
    if not shutil.which("taskset"):
        return command
    return ["taskset", "-c", str(max(os.sched_getaffinity(0))), *command]


def run(case, seed, short):
    ran = subprocess.run(pinned(case.arguments(seed, short)), capture_output=True, text=True, timeout=TIMEOUT,
                         check=False)
    if ran.returncode != 0:
        sys.exit(f"{' '.join(case.command)}: exit status {ran.returncode}: {ran.stderr.strip()}")
    *said, line = ran.stdout.strip().splitlines()
    result = json.loads(line)
    result["row"] = case.row
    result["debug"] = any("Debug Enabled" in text for text in (*said, ran.stderr))  # printed by Chipmunk
    return result


def in_turns(cases, repetitions, short):
    """Every case once, then every case again, so that a load on the machine affects all alike. Each repetition has
    another seed, for the scatter of the drift."""
    runs = []
    for repetition in range(repetitions):
        for case in cases:
            if repetition and not case.repeated:
                continue
            print(f"{repetition + 1}/{repetitions}: {' '.join(case.command)}", file=sys.stderr, flush=True)
            runs.append(run(case, repetition + 1, short))
    return runs


def speed(runs, key="processor_seconds"):
    """Median of the seconds per simulated second."""
    return statistics.median(run[key] / run["duration"] for run in runs)


def collision_rate(runs):
    """Collisions per simulated second; None if the program does not count them."""
    if runs[0]["collisions"] is None:
        return None
    return statistics.median(run["collisions"] / run["duration"] for run in runs)


def drift(runs):
    """For each species the Mean over all blocks of time of all runs [m/s]."""
    return [mean_of(values) for values in zip(*(block for run in runs for block in run["drift_blocks"]))]
