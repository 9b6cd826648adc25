#!/usr/bin/python3
"""Runs the mixture of Fig. 8 in LAMMPS, and prints one line of JSON as the other programs of the comparison do."""
import argparse
import json
import math
import pathlib
import resource
import subprocess
import sys
import tempfile

INPUT = pathlib.Path(__file__).resolve().with_name("mixture.lmp")

# The scene: mixture_scene.cpp.
TEETH, TOOTH_WIDTH, TOOTH_HEIGHT, ASYMMETRY = 20, 0.020, 0.006, 0.3
AMPLITUDE, OMEGA, GRAVITY = 0.002, 2.0 * math.pi * 23.0, 9.81
RADII, MASSES = (0.001, 0.002), (0.010, 0.001)
RESTITUTION, FRICTION = 0.6, 0.1
WIDTH = TEETH * TOOTH_WIDTH
APEX_RADIUS = 1e-5   # of the particles that stand in the apices, which walls of regions do not have [m]
TOP = 0.5            # of the box [m]
COLUMN = 4           # teeth that are one wall
NEAR = 0.010         # centres below this can touch the base before their groups are looked at again [m]
LOW_EVERY = 50       # steps between two such looks

CONTACT_TIME = 2e-4  # soft enough for overlaps of a few per cent of a radius [s]
STEPS_PER_CONTACT = 40
TANGENTIAL_RATIO = 2.0  # of tangential to normal damping: a contact that sticks has stopped its sliding by its end
LOOK, BLOCK = 0.01, 0.5      # [s], as in mixture_run.h


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


def frames(path):
    """Per frame of the dump: the disks as (type, unwrapped x, y)."""
    frame = None
    for line in path.read_text().splitlines():
        if line.startswith("ITEM: ATOMS"):
            frame = []
        elif line.startswith("ITEM: TIMESTEP"):
            if frame:
                yield frame
            frame = None
        elif frame is not None:
            _, kind, x, y = line.split()
            frame.append((int(kind) - 1, float(x), float(y)))
    if frame:
        yield frame


def height_above(x, y):
    """Distance from a point to the base's surface, > 0 above it."""
    s = x % TOOTH_WIDTH
    feet_and_apices = [((k + part) * TOOTH_WIDTH, n) for k in (-1, 0, 1, 2) for part, n in
                       ((0.0, 0.0), (ASYMMETRY, TOOTH_HEIGHT))]
    nearest, surface = math.inf, 0.0
    for (s1, n1), (s2, n2) in zip(feet_and_apices, feet_and_apices[1:]):
        along_s, along_n = s2 - s1, n2 - n1
        part = ((s - s1) * along_s + (y - n1) * along_n) / (along_s ** 2 + along_n ** 2)
        part = min(1.0, max(0.0, part))
        nearest = min(nearest, math.hypot(s - s1 - part * along_s, y - n1 - part * along_n))
        if s1 <= s <= s2:
            surface = n1 + (s - s1) / along_s * along_n
    return math.copysign(nearest, y - surface)


def overlap(frame):
    disks = sorted((x % WIDTH, y, RADII[kind]) for kind, x, y in frame)
    most = 0.0
    for i, (x, y, radius) in enumerate(disks):
        for other_x, other_y, other_radius in disks[i + 1:]:
            if other_x - x > 2.0 * max(RADII):
                break
            most = max(most, radius + other_radius - math.hypot(other_x - x, other_y - y))
    return most


def drift(earlier, later, seconds):
    return [sum(b[1] - a[1] for a, b in zip(earlier, later) if a[0] == kind)
            / sum(a[0] == kind for a in earlier) / seconds for kind in range(len(RADII))]


def run(arguments, directory):
    step = CONTACT_TIME / STEPS_PER_CONTACT
    disks = json.loads(subprocess.run([arguments.start, "--print", "start", "--seed", str(arguments.seed)],
                                      capture_output=True, text=True, check=True).stdout)
    (directory / "start.data").write_text(start(disks))
    (directory / "base.lmp").write_text(base())
    (directory / "low.lmp").write_text(low())
    (directory / "contacts.lmp").write_text(contacts())
    variables = {"amplitude": AMPLITUDE, "omega": OMEGA, "gravity": GRAVITY, "step": step,
                 "settle_steps": round(arguments.settle / step), "count_steps": round(arguments.duration / step),
                 "look_steps": round(LOOK / step), "low_every": LOW_EVERY}
    command = ["lmp", "-in", str(INPUT), "-screen", "none", "-log", "log"]
    for name, value in variables.items():
        command += ["-var", name, repr(value)]
    ran = subprocess.run(command, cwd=directory, capture_output=True, text=True, check=False)
    log = (directory / "log").read_text()
    if ran.returncode != 0:
        said = [line for line in log.splitlines() if line.startswith("ERROR")]
        sys.exit(f"lammps: {said[0] if said else ran.stderr.strip()}")
    begun, settled, ended = (float((directory / name).read_text()) for name in ("begun", "settled", "ended"))
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    share = min(1.0, (used.ru_utime + used.ru_stime) / (ended - begun))
    return disks, log, step, ended - settled, (ended - settled) * share


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--start", required=True, help="ratchet_mixture, which prints where the disks start")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--settle", type=float, default=2.0, help="simulated time before counting [s]")
    parser.add_argument("--duration", type=float, default=8.0, help="simulated time of counting [s]")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        disks, log, step, wall, processor = run(arguments, pathlib.Path(name))
        looks = list(frames(pathlib.Path(name) / "look.dump"))
    stride = round(BLOCK / LOOK)
    print(json.dumps({
        "program": "lammps", "version": log.split("(", 1)[1].split(")", 1)[0],
        "configuration": f"contact time {CONTACT_TIME} s", "step": step, "seed": arguments.seed,
        "settle": arguments.settle, "duration": arguments.duration, "wall_seconds": wall,
        "processor_seconds": processor, "collisions": None,
        "lost": len(disks) - len(looks[-1]),
        "behind_base": max(sum(height_above(x, y) < 0.0 for _, x, y in look) for look in looks),
        "overlap": max(map(overlap, looks)),
        "base_overlap": max(RADII[kind] - height_above(x, y) for look in looks for kind, x, y in look),
        "drift_blocks": [drift(a, b, BLOCK) for a, b in zip(looks[::stride], looks[stride::stride])]}))


if __name__ == "__main__":
    main()
