"""EDMD by F. Smallenburg (github.com/FSmallenburg/EDMD; Eur. Phys. J. E 45, 22 (2022)) beside this project: collisions
per second of processor time over the number of disks.

EDMD simulates elastic hard spheres in a periodic box. It is built from a checkout that the user brings, changed to a
plane: z = 0, one cell across, two degrees of freedom, no thermostat. There is no wall, gravity, friction or spin in it.
"""
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

import numpy

from ratchet_sieve import origin
from ratchet_sieve.places import SHARE
from ratchet_sieve.texts import counted, table
from sweeps import processor_time

VARIANT = "Single"  # one event a disk and neighbour lists: the fastest of its variants
FLAGS = ["-Ofast", "-funroll-loops", "-march=native"]  # of its own Makefile
AREA_FRACTION = 0.5
COLLISIONS = 6e6  # of a run, about
RATE = 3.3  # collisions of a disk per unit of time at this area fraction, about
DISKS_PER_TOOTH = 26.2  # of Fig. 8
COLLISION_RATE = 200.0  # per disk of Fig. 8 and simulated second, about
SIZES = ((1000, 20), (10_000, 382), (100_000, 3817))  # disks of EDMD, and teeth of Fig. 8
SHORT = 0.02  # of the length of a run that only shows that it runs

# What makes it a plane: each text stands once in mdSingle.c.
CHANGES = [
    ("const int usethermostat = 1;", "const int usethermostat = 0;"),
    ("double maxtime = 100; ", "double maxtime = {time}; "),
    ("double writeinterval = 1; ", "double writeinterval = {time}; "),
    ("        p->vz = imsq * random_gaussian();\n        vxtot", "        p->vz = 0.0;\n        vxtot"),
    ("sqrt(3.0 / (v2tot / N))", "sqrt(2.0 / (v2tot / N))"),
    ('    printf("Cells: %d', '    cz = 1;\n    printf("Cells: %d'),
    ("for (cdz = cellz - 1; cdz < cellz + 2; cdz++)", "for (cdz = cellz; cdz < cellz + 1; cdz++)"),
    ("celly == 0 || cellz == 0 || cellx", "celly == 0 || cellx"),
    ("celly == cy - 1 || cellz == cz - 1);", "celly == cy - 1);"),
]


def build(checkout, disks, length, folder):
    """The program for a number of disks, and its initial configuration, in a folder. Exits where the checkout is not
    as CHANGES know it."""
    source = checkout / VARIANT / "mdSingle.c"
    try:
        text = source.read_text(encoding="utf-8")
    except OSError as error:
        sys.exit(f"--edmd {checkout}: {error}")
    time = length * COLLISIONS / (0.5 * RATE * disks)
    for before, after in CHANGES:
        if text.count(before) != 1:
            sys.exit(f"{source}: has {before.strip()!r} {text.count(before)} times: must be once; "
                     "this is another version of EDMD")
        text = text.replace(before, after.replace("{time}", repr(time)))
    (folder / source.name).write_text(text, encoding="utf-8")
    for name in ("mdSingle.h", "mt19937ar.c"):
        (folder / name).write_bytes((source.parent / name).read_bytes())
    subprocess.run(["gcc", *FLAGS, source.name, "-o", "md", "-lm"], cwd=folder, check=True, stderr=subprocess.DEVNULL)
    side = math.sqrt(disks * math.pi / 4.0 / AREA_FRACTION)
    columns = math.ceil(math.sqrt(disks))
    rows = (f"a {(k % columns + 0.5) * side / columns} {(k // columns + 0.5) * side / columns} 0.0 0.5"
            for k in range(disks))
    (folder / "init.sph").write_text("\n".join([str(disks), f"{side} {side} 2.0", *rows, ""]), encoding="utf-8")


def processor_seconds(command, folder):
    """Of a whole process, and what it prints."""
    before = processor_time()
    ran = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    if ran.returncode != 0:
        sys.exit(f"{' '.join(command)}: exit status {ran.returncode}: {ran.stderr.strip()}")
    return processor_time() - before, ran.stdout


def run_edmd(checkout, disks, length):
    """@return how many disks, and collisions per second of processor time, start included"""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        build(checkout, disks, length, folder)
        seconds, output = processor_seconds(["./md"], folder)
    return disks, int(re.findall(r"Collisions: (\d+)", output)[-1]) / seconds


def run_ours(programs, teeth, length):
    """As run_edmd(), of the mixture of Fig. 8 on a base of so many teeth."""
    duration = length * COLLISIONS / (COLLISION_RATE * DISKS_PER_TOOTH * teeth)
    with tempfile.TemporaryDirectory() as name:
        seconds, output = processor_seconds(
            [str(programs.resolve() / "sieve_run"), str(SHARE / "config/paper_fig8.yaml"),
             "--set", f"base.teeth={teeth}", "--set", "settle=0", "--duration", repr(duration), "--threads", "1"], name)
    summary = json.loads(output)
    return sum(species["count"] for species in summary["species"]), sum(summary["collisions"].values()) / seconds


def in_turns(programs, checkout, repetitions, short):
    """Both programs in turns. @return of each repetition and of each of SIZES: this project's disks and rate, EDMD's"""
    rates = []
    for repetition in range(repetitions):
        of_sizes = []
        for disks, teeth in SIZES[:1] if short else SIZES:
            print(f"{repetition + 1}/{repetitions}: EDMD, {disks} disks", file=sys.stderr, flush=True)
            length = SHORT if short else 1.0
            of_sizes.append([*run_ours(programs, teeth, length), *run_edmd(checkout, disks, length)])
        rates.append(of_sizes)
    return numpy.array(rates)


def render(rates, about):
    """The rates as Markdown. @param about date, machine and version"""
    lines = [[f"{ours:g}, {theirs:g}", f"{a * 1e-6:.3g}", f"{b * 1e-6:.3g}", f"{a / b:.2f}"]
             for ours, a, theirs, b in numpy.median(rates, axis=0)]
    return (f"{origin.text(about)}. {counted(len(rates), 'run')} of each in turns on one core; medians. Millions of "
            "collisions per second of processor time, of whole processes.\n\n"
            + table(["disks: this project, EDMD", "this project, Fig. 8", "EDMD, elastic disks in a plane", "× EDMD"],
                    lines))


def figures(rates):
    """Those of performance.json."""
    known = {}
    for _, ours, disks, theirs in numpy.median(rates, axis=0):
        known[f"disks_{disks:g}.rate"] = f"{theirs * 1e-6:.3g} M"
        known[f"disks_{disks:g}.times"] = f"{ours / theirs:.2f}"
    return known
