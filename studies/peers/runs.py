"""The rows of the table and the steps of the picture: each a program that is run, one after another on one core."""
import dataclasses
import json
import os
import pathlib
import shutil
import statistics
import subprocess
import sys

from ratchet_sieve.stats import mean_of

OURS = "ratchet_sieve"
ROW = "this project"
TIMEOUT = 900.0   # of wall time [s]: a longer run has hung
LAMMPS = "lmp"    # its program

# Box2D's clock runs faster than the scene's by the root of the scale of its lengths: see box2d_mixture.cpp.
BOX2D_CLOCK = 1000.0 ** 0.5

MAIN_STEP = 1e-4                      # where the drift has converged [s]
BOX2D_STEP = 1.0 / 60.0 / BOX2D_CLOCK  # its manual's 1/60 s, of its own clock [s]
CHIPMUNK_STEPS = (1.0 / 60.0, 1.0 / 240.0)  # as it is commonly run [s]

# Below this step a disk moves less than half its radius within a step. Contacts within a step, which cost Box2D time,
# are then not needed [s].
NO_TUNNELLING = 3e-4

# Below this step a disk cannot pass through teeth made of segments, which are cheaper than solid ones. Above it solid
# teeth lose fewer disks [s].
THIN_BASE = 2e-3

SWEEP = (1e-2, 1.0 / 240.0, 2e-3, 1e-3, BOX2D_STEP, 2e-4, MAIN_STEP, 3e-5)  # [s]
FINE = 5e-5  # what steps finer than this is run for a shorter time [s]


@dataclasses.dataclass
class Case:
    """One program with one set of options."""
    row: str       # "" if it is only in the picture
    command: list
    settle: float = 2.0     # [s]
    duration: float = 8.0   # [s]
    repeated: bool = True   # false: too slow

    def arguments(self, seed, short):
        settle, duration = (0.1, 0.5) if short else (self.settle, self.duration)
        return [*self.command, "--seed", str(seed), "--settle", str(settle), "--duration", str(duration)]


def chipmunk(programs, step, row="", **more):
    base = "segments" if step < THIN_BASE else "solid"
    return Case(row, [str(programs / "chipmunk_mixture"), "--step", repr(step), "--base", base], **more)


def box2d(programs, step, row="", **more):
    continuous = "off" if step < NO_TUNNELLING else "on"
    return Case(row, [str(programs / "box2d_mixture"), "--step", repr(step), "--continuous", continuous], **more)


def rows(programs):
    """@return the rows of the table, and the names of missing programs"""
    ours = str(programs / "ratchet_mixture")
    found = [Case(ROW, [ours], duration=40.0),
             Case("this project, β = 0 as the others", [ours, "--tangential", "none"], duration=40.0)]
    missing = []
    if (programs / "chipmunk_mixture").exists():
        found.append(chipmunk(programs, MAIN_STEP, "Chipmunk, 0.1 ms"))
        found += [chipmunk(programs, step, f"Chipmunk, 1/{round(1 / step)} s") for step in CHIPMUNK_STEPS]
    else:
        missing.append("Chipmunk")
    if (programs / "box2d_mixture").exists():
        found.append(box2d(programs, MAIN_STEP, "Box2D, 0.1 ms"))
        found.append(box2d(programs, BOX2D_STEP, "Box2D, 1/60 s of its clock: 0.53 ms"))
    else:
        missing.append("Box2D")
    if shutil.which(LAMMPS):
        script = pathlib.Path(__file__).resolve().with_name("lammps_mixture.py")
        found.append(Case("LAMMPS, 5 µs", [sys.executable, str(script), "--start", ours], settle=1.0, duration=3.0,
                          repeated=False))
    else:
        missing.append("LAMMPS")
    return found, missing


def sweep(programs):
    """The steps of the picture that are not in the table."""
    cases = []
    for step in SWEEP:
        length = {"settle": 1.0, "duration": 5.0} if step < FINE else {}
        if (programs / "chipmunk_mixture").exists() and step not in (MAIN_STEP, *CHIPMUNK_STEPS):
            cases.append(chipmunk(programs, step, **length))
        if (programs / "box2d_mixture").exists() and step not in (MAIN_STEP, BOX2D_STEP):
            cases.append(box2d(programs, step, **length))
    return cases


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
