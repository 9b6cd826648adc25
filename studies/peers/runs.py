"""The rows of the table and the steps of the picture: each a program that is run, one after another on one core."""
import dataclasses
import json
import math
import pathlib
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

import numpy

import ratchet_sieve as rs
from ratchet_sieve.stats import mean_of
from peers import lammps_mixture, samples
from peers.samples import LOOK, SCENE, SCENE_FILE, TIMEOUT

OURS = "ratchet_sieve"
ROW = "this project"
ALIKE_ROW = "this project, β = 0 as the others"  # the others have no tangential restitution
PROGRAMS = {"chipmunk": "chipmunk_mixture", "box2d": "box2d_mixture"}

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
    overrides: dict = dataclasses.field(default_factory=dict)  # of the scene
    settle: float = 2.0     # [s]
    duration: float = 8.0   # [s]
    repeated: bool = True   # false: too slow


def is_there(programs, name):
    return bool(shutil.which(lammps_mixture.PROGRAM)) if name == "lammps" else (programs / PROGRAMS[name]).exists()


def rows(programs):
    """@return the rows of the table, and the names of missing programs"""
    cases = {
        "Chipmunk": [Case("chipmunk", "Chipmunk, 0.1 ms", MAIN_STEP),
                     *(Case("chipmunk", f"Chipmunk, 1/{round(1 / step)} s", step) for step in CHIPMUNK_STEPS)],
        "Box2D": [Case("box2d", "Box2D, 0.1 ms", MAIN_STEP),
                  Case("box2d", "Box2D, 1/60 s of its clock: 0.53 ms", BOX2D_STEP)],
        "LAMMPS": [Case("lammps", "LAMMPS, 5 µs", settle=1.0, duration=3.0, repeated=False)]}
    without_beta = {f"species.{k}.tangential_restitution": 0 for k in (0, 1)}
    found = [Case(OURS, ROW, duration=40.0),
             Case(OURS, ALIKE_ROW, overrides=without_beta, duration=40.0)]
    missing = [name for name in cases if not is_there(programs, name.lower())]
    return found + [case for name, own in cases.items() if name not in missing for case in own], missing


def sweep(programs):
    """The steps of the picture that are not in the table."""
    in_table = {"chipmunk": (MAIN_STEP, *CHIPMUNK_STEPS), "box2d": (MAIN_STEP, BOX2D_STEP)}
    return [Case(program, step=step, **({"settle": 1.0, "duration": 5.0} if step < FINE else {}))
            for step in SWEEP for program, taken in in_table.items()
            if step not in taken and is_there(programs, program)]


def simulation_of(case, seed):
    return rs.Simulation(rs.Scene.load(SCENE_FILE, {**case.overrides, "seed": seed}))


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


def ours(case, seed):
    """@return what the other programs print, and the samples"""
    simulation, lines = simulation_of(case, seed), []
    start = simulation.disks["x"]

    def look():
        disks = simulation.disks
        places = numpy.column_stack((start + disks["displacement"], disks["y"]))
        lines.append([simulation.time, simulation.base.displacement, *places.flat])

    simulation.advance_to(case.settle)
    look()
    before, wall, processor = sum(simulation.collisions.values()), 0.0, 0.0
    for k in range(1, round(case.duration / LOOK) + 1):
        begin = time.perf_counter(), time.process_time()
        simulation.advance_to(case.settle + k * LOOK)
        wall += time.perf_counter() - begin[0]
        processor += time.process_time() - begin[1]
        look()
    return {"version": "", "wall_seconds": wall, "processor_seconds": processor, "lost": 0,
            "collisions": sum(simulation.collisions.values()) - before}, numpy.array(lines)


def other(programs, case, disks):
    """@return what the program prints, and the samples"""
    with tempfile.TemporaryDirectory() as folder:
        given = {"mixture": mixture_of(disks), "samples": f"{folder}/samples", "look": LOOK, "step": case.step,
                 "settle": case.settle, "duration": case.duration, "solid": case.step >= THIN_BASE,
                 "continuous": case.step >= NO_TUNNELLING}
        file = pathlib.Path(folder) / "run.json"
        file.write_text(json.dumps(given), encoding="utf-8")
        ran = subprocess.run([str(programs / PROGRAMS[case.program]), str(file)], capture_output=True, text=True,
                             timeout=TIMEOUT, check=False)
        if ran.returncode != 0:
            sys.exit(f"{case.row or case.program}: exit status {ran.returncode}: {ran.stderr.strip()}")
        lines = numpy.fromfile(given["samples"]).reshape(-1, 2 + 2 * len(disks))
    said = json.loads(ran.stdout.strip().splitlines()[-1])
    return {**said, "debug": "Debug Enabled" in ran.stdout + ran.stderr}, lines  # which Chipmunk prints


def run(programs, case, seed):
    """All programs begin with this project's pour."""
    disks = simulation_of(case, seed).disks[["species", "x", "y"]].tolist()
    result, lines = (ours(case, seed) if case.program == OURS else lammps_mixture.run(case, disks)
                     if case.program == "lammps" else other(programs, case, disks))
    return {"program": case.program, "row": case.row, "step": case.step, "seed": seed, "settle": case.settle,
            "duration": case.duration, **result, **samples.measured(lines, [kind for kind, _, _ in disks])}


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
