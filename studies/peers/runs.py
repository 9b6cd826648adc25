"""The rows of the table and the steps of the picture: each a program that is run, one after another on one core."""
import dataclasses
import functools
import json
import math
import os
import pathlib
import shutil
import statistics
import subprocess
import sys
import tempfile

import yaml

from ratchet_sieve.places import SHARE
from ratchet_sieve.stats import mean_of
from peers import samples

SCENE_FILE = SHARE / "config/paper_fig8.yaml"
SCENE = yaml.safe_load(SCENE_FILE.read_text(encoding="utf-8"))
OURS = "ratchet_sieve"
ROW = "this project"
TIMEOUT = 900.0   # of wall time [s]: a longer run has hung
LAMMPS = "lmp"    # its program
PROGRAMS = {OURS: "ratchet_mixture", "chipmunk": "chipmunk_mixture", "box2d": "box2d_mixture"}

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

EXTRA_TEETH = 2  # at either end, for disks that have passed it and are not yet moved

SWEEP = (1e-2, 1.0 / 240.0, 2e-3, 1e-3, BOX2D_STEP, 2e-4, MAIN_STEP, 3e-5)  # [s]
FINE = 5e-5  # what steps finer than this is run for a shorter time [s]


@dataclasses.dataclass
class Case:
    """One program with one set of options."""
    program: str
    row: str = ""           # "": only in the picture
    step: float = None      # [s]
    overrides: tuple = ()   # of the scene, as of sieve_run --set
    settle: float = 2.0     # [s]
    duration: float = 8.0   # [s]
    repeated: bool = True   # false: too slow

    def options(self):
        """What the program alone is asked for."""
        return {"step": self.step, "set": list(self.overrides), "solid": bool(self.step and self.step >= THIN_BASE),
                "continuous": bool(self.step and self.step >= NO_TUNNELLING)}


def is_there(programs, name):
    return bool(shutil.which(LAMMPS)) if name == "lammps" else (programs / PROGRAMS[name]).exists()


def rows(programs):
    """@return the rows of the table, and the names of missing programs"""
    cases = {
        "Chipmunk": [Case("chipmunk", "Chipmunk, 0.1 ms", MAIN_STEP),
                     *(Case("chipmunk", f"Chipmunk, 1/{round(1 / step)} s", step) for step in CHIPMUNK_STEPS)],
        "Box2D": [Case("box2d", "Box2D, 0.1 ms", MAIN_STEP),
                  Case("box2d", "Box2D, 1/60 s of its clock: 0.53 ms", BOX2D_STEP)],
        "LAMMPS": [Case("lammps", "LAMMPS, 5 µs", settle=1.0, duration=3.0, repeated=False)]}
    without_beta = tuple(f"species.{k}.tangential_restitution=0" for k in (0, 1))
    found = [Case(OURS, ROW, duration=40.0),
             Case(OURS, "this project, β = 0 as the others", overrides=without_beta, duration=40.0)]
    missing = [name for name in cases if not is_there(programs, name.lower())]
    return found + [case for name, own in cases.items() if name not in missing for case in own], missing


def sweep(programs):
    """The steps of the picture that are not in the table."""
    in_table = {"chipmunk": (MAIN_STEP, *CHIPMUNK_STEPS), "box2d": (MAIN_STEP, BOX2D_STEP)}
    return [Case(program, step=step, **({"settle": 1.0, "duration": 5.0} if step < FINE else {}))
            for step in SWEEP for program, taken in in_table.items()
            if step not in taken and is_there(programs, program)]


def pinned(command):
    """On the last core that this process may use: the first one serves the system."""
    if not shutil.which("taskset"):
        return command
    return ["taskset", "-c", str(max(os.sched_getaffinity(0))), *command]


@functools.lru_cache(maxsize=None)
def start_of(programs, seed):
    """Of each disk its species, x and y at t = 0, for all programs: this project's pour."""
    with tempfile.TemporaryDirectory() as folder:
        return call(programs, Case(OURS, settle=0.0, duration=0.0), seed, None, folder)[0]["disks"]


def mixture_of(disks):
    """The scene for programs that know neither teeth nor species [SI units]."""
    base, species = SCENE["base"], SCENE["species"]
    end = base["teeth"] + EXTRA_TEETH
    outline = [*samples.corners_of(base, range(-EXTRA_TEETH, end)), (end * base["tooth_width"], 0.0)]
    return {"width": base["teeth"] * base["tooth_width"], "gravity": SCENE["gravity"],
            "clear_height": base["tooth_height"] + base["amplitude"] + SCENE["pour"]["drop_height"],
            "amplitude": base["amplitude"], "omega": 2.0 * math.pi * base["frequency"],
            **{key: species[0][key] for key in ("restitution", "friction")},
            "outline": [{"x": x, "y": y} for x, y in outline],
            "disks": [{"x": x, "y": y, **{key: species[kind][key] for key in ("radius", "mass")}}
                      for kind, x, y in disks]}


def call(programs, case, seed, disks, folder):
    """@return the line that the program prints, and whatever it or its library has printed besides"""
    given = {"scene": SCENE, "file": str(SCENE_FILE), "disks": disks, "mixture": mixture_of(disks or ()),
             "samples": f"{folder}/samples", "settle": case.settle, "duration": case.duration, "look": samples.LOOK,
             **case.options()}
    given["set"].append(f"seed={seed}")
    file = pathlib.Path(folder) / "run.json"
    file.write_text(json.dumps(given), encoding="utf-8")
    command = ([sys.executable, str(pathlib.Path(__file__).with_name("lammps_mixture.py"))]
               if case.program == "lammps" else [str(programs / PROGRAMS[case.program])])
    ran = subprocess.run(pinned([*command, str(file)]), capture_output=True, text=True, timeout=TIMEOUT, check=False)
    if ran.returncode != 0:
        sys.exit(f"{case.row or case.program}: exit status {ran.returncode}: {ran.stderr.strip()}")
    *said, line = ran.stdout.strip().splitlines()
    return json.loads(line), "\n".join((*said, ran.stderr))


def run(programs, case, seed):
    disks = start_of(programs, seed)
    with tempfile.TemporaryDirectory() as folder:
        result, said = call(programs, case, seed, disks, folder)
        result.pop("disks", None)
        result.update(samples.measured(f"{folder}/samples", SCENE, [kind for kind, _, _ in disks]))
    return {"program": case.program, "row": case.row, "step": case.step, "seed": seed, "settle": case.settle,
            "duration": case.duration, "debug": "Debug Enabled" in said,  # which Chipmunk prints
            **result}


def in_turns(programs, cases, repetitions, short):
    """Every case once, then every case again, so that a load on the machine affects all alike. Each repetition has
    another seed, for the scatter of the drift."""
    runs = []
    for repetition in range(1, repetitions + 1):
        for case in cases:
            if repetition == 1 or case.repeated:
                print(f"{repetition}/{repetitions}: {case.row or f'{case.program}, {case.step:g} s'}", file=sys.stderr,
                      flush=True)
                runs.append(run(programs, dataclasses.replace(case, settle=0.1, duration=0.5) if short else case,
                                repetition))
    return runs


def speed(runs):
    """Median of the processor time [s] per simulated second."""
    return statistics.median(run["processor_seconds"] / run["duration"] for run in runs)


def collision_rate(runs):
    """Collisions per simulated second; None if the program does not count them."""
    if runs[0]["collisions"] is None:
        return None
    return statistics.median(run["collisions"] / run["duration"] for run in runs)


def drift(runs):
    """For each species the Mean over all blocks of time of all runs [m/s]."""
    return [mean_of(values) for values in zip(*(block for run in runs for block in run["drift_blocks"]))]
