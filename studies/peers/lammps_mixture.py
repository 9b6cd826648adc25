"""Runs the mixture of Fig. 8 in LAMMPS."""
import math
import pathlib
import subprocess
import sys
import tempfile

import numpy

from peers.samples import LOOK, SCENE, TIMEOUT
from sweeps import processor_time

PROGRAM = "lmp"
INPUT = pathlib.Path(__file__).resolve().with_name("mixture.lmp")

BASE, SPECIES = SCENE["base"], SCENE["species"]
TEETH, TOOTH_WIDTH, TOOTH_HEIGHT, ASYMMETRY = (BASE[key] for key in ("teeth", "tooth_width", "tooth_height",
                                                                     "asymmetry"))
WIDTH = TEETH * TOOTH_WIDTH
RADII, MASSES = ([species[key] for species in SPECIES] for key in ("radius", "mass"))
RESTITUTION, FRICTION = SPECIES[0]["restitution"], SPECIES[0]["friction"]
APEX_RADIUS = 1e-5   # of the particles that stand in the apices, which walls of regions do not have [m]
TOP = 0.5            # of the box [m]
COLUMN = 4           # teeth that are one wall
NEAR = 0.010         # centres below this can touch the base before their groups are looked at again [m]
LOW_EVERY = 50       # steps between two such looks

CONTACT_TIME = 2e-4  # soft enough for overlaps of a few per cent of a radius [s]
STEPS_PER_CONTACT = 40
TANGENTIAL_RATIO = 2.0  # of tangential to normal damping: a contact that sticks has stopped its sliding by its end
STEP = CONTACT_TIME / STEPS_PER_CONTACT


def contact(mass):
    """A linear contact of that effective mass, with exact e and contact time, from the solution of the oscillator."""
    damping = -2.0 * math.log(RESTITUTION) / CONTACT_TIME  # per mass [1/s]
    stiffness = mass * ((math.pi / CONTACT_TIME) ** 2 + damping ** 2 / 4.0)
    return (f"hooke {stiffness:.9g} {damping:.9g} tangential linear_nohistory "
            f"{TANGENTIAL_RATIO} {FRICTION} damping mass_velocity")


def contacts():
    a, b = MASSES
    pairs = {"1 1": a / 2, "1 2": a * b / (a + b), "2 2": b / 2, "1 3": a, "2 3": b, "3 3": a}
    return "".join(f"pair_coeff {pair} {contact(mass)}\n" for pair, mass in pairs.items())


def tooth(k):
    """The region that is not below both slopes of tooth k."""
    apex = (k + ASYMMETRY) * TOOTH_WIDTH
    left, right = ASYMMETRY * TOOTH_WIDTH, (1.0 - ASYMMETRY) * TOOTH_WIDTH
    name = f"t{k + 1}"
    return [f"region {name}l plane {apex:.9g} {TOOTH_HEIGHT} 0 {TOOTH_HEIGHT} {-left:.9g} 0",
            f"region {name}r plane {apex:.9g} {TOOTH_HEIGHT} 0 {-TOOTH_HEIGHT} {-right:.9g} 0",
            f"region {name} intersect 2 {name}l {name}r side out"]


def base():
    """The walls. A and B have their own, since their masses differ. Each column of teeth is a wall for the low disks
    above it alone, so that a disk does not test every tooth."""
    lines = [f"group kind{kind} type {kind}" for kind in range(1, len(MASSES) + 1)]
    for k in range(-1, TEETH + 1):
        lines += tooth(k)
    for column, first in enumerate(range(0, TEETH, COLUMN)):
        begin = first * TOOTH_WIDTH if first else "INF"
        end = (first + COLUMN) * TOOTH_WIDTH if first + COLUMN < TEETH else "INF"
        lines.append(f"region over{column} block {begin} {end} INF {NEAR} INF INF")
        names = " ".join(f"t{k + 1}" for k in range(first - 1, first + COLUMN + 1))
        lines.append(f"region base{column} intersect {COLUMN + 2} {names}")
        for kind, mass in enumerate(MASSES, 1):
            group = f"low{kind}at{column}"
            lines += [f"group {group} empty", *find_low(group, kind, column)]
            lines.append(f"fix wall{group} {group} wall/gran/region granular {contact(mass)} region base{column}")
    return "\n".join(lines) + "\n"


def find_low(group, kind, column):
    return [f"group {group} clear", f"group {group}at region over{column}",
            f"group {group} intersect kind{kind} {group}at", f"group {group}at delete"]


def low():
    """Run every LOW_EVERY steps."""
    lines = []
    for column in range(TEETH // COLUMN):
        for kind in range(1, len(MASSES) + 1):
            lines += find_low(f"low{kind}at{column}", kind, column)
    return "\n".join(lines) + "\n"


def start(disks):
    apices = [((k + ASYMMETRY) * TOOTH_WIDTH, TOOTH_HEIGHT - APEX_RADIUS) for k in range(TEETH)]
    lines = ["the mixture of Fig. 8\n", f"{len(disks) + len(apices)} atoms", "3 atom types",
             f"0 {WIDTH} xlo xhi", f"-0.02 {TOP} ylo yhi", "-0.004 0.004 zlo zhi\n", "Atoms # sphere\n"]
    for number, (kind, x, y) in enumerate(disks, 1):
        lines.append(f"{number} {kind + 1} {2 * RADII[kind]} 1000 {x % WIDTH:.12g} {y:.12g} 0")
    for number, (x, y) in enumerate(apices, len(disks) + 1):
        lines.append(f"{number} 3 {2 * APEX_RADIUS} 1000 {x:.12g} {y:.12g} 0")
    return "\n".join(lines) + "\n"


def samples(path, disks):
    """Those of LAMMPS's dump: in the base's own frame, whose displacement is 0."""
    lines = []
    with open(path, encoding="utf-8") as dump:
        for line in dump:
            if line.startswith("ITEM: TIMESTEP"):
                time = STEP * int(next(dump))
            elif line.startswith("ITEM: ATOMS"):
                places = [float(number) for _ in range(disks) for number in next(dump).split()[2:]]
                lines.append([time, 0.0, *places])
    return numpy.array(lines)


def run(case, disks):
    """@return what the other programs print, and the samples"""
    with tempfile.TemporaryDirectory() as name:
        return run_in(pathlib.Path(name), case, disks)


def run_in(directory, case, disks):
    for name, text in (("start.data", start(disks)), ("base.lmp", base()), ("low.lmp", low()),
                       ("contacts.lmp", contacts())):
        (directory / name).write_text(text, encoding="utf-8")
    variables = {"amplitude": BASE["amplitude"], "omega": 2.0 * math.pi * BASE["frequency"],
                 "gravity": SCENE["gravity"], "step": STEP, "settle_steps": round(case.settle / STEP),
                 "count_steps": round(case.duration / STEP), "look_steps": round(LOOK / STEP), "low_every": LOW_EVERY}
    command = [PROGRAM, "-in", str(INPUT), "-screen", "none", "-log", "log"]
    for name, value in variables.items():
        command += ["-var", name, repr(value)]
    before = processor_time()
    ran = subprocess.run(command, cwd=directory, capture_output=True, text=True, timeout=TIMEOUT,
                         check=False)
    log = (directory / "log").read_text(encoding="utf-8")
    if ran.returncode != 0:  # as where it has lost a disk
        said = [line for line in log.splitlines() if line.startswith("ERROR")]
        sys.exit(f"lammps: {said[0] if said else ran.stderr.strip()}")
    begun, settled, ended = (float((directory / name).read_text()) for name in ("begun", "settled", "ended"))
    share = min(1.0, (processor_time() - before) / (ended - begun))
    return {"version": log.split("(", 1)[1].split(")", 1)[0], "wall_seconds": ended - settled,
            "processor_seconds": (ended - settled) * share, "collisions": None,
            "lost": 0}, samples(directory / "look.dump", len(disks))
