"""The runs as Markdown, with the versions of the other programs."""
import os
import pathlib
import re
import shutil
import subprocess

from ratchet_sieve import origin
from peers import runs

LIBRARIES = {"chipmunk": ("chipmunk_mixture", "Chipmunk"), "box2d": ("box2d_mixture", "Box2D")}


def package_version(path):
    """The package that a file belongs to, with its version; None if there is none."""
    if not shutil.which("dpkg-query"):
        return None
    for name in (path, os.path.realpath(path)):
        owner = subprocess.run(["dpkg-query", "-S", name], capture_output=True, text=True, check=False).stdout
        if owner:
            package = owner.split(": ", 1)[0]
            version = subprocess.run(["dpkg-query", "-W", "-f", "${Version}", package], capture_output=True, text=True,
                                     check=True).stdout
            return f"{package.split(':')[0]} {version}"
    return None


def linked_library(program, name):
    """The path of the shared library of that name that a program loads."""
    listing = subprocess.run(["ldd", str(program)], capture_output=True, text=True, check=False).stdout
    found = re.search(rf"lib{name}\S* => (\S+)", listing)
    return found.group(1) if found else None


def libraries(programs, taken):
    """One line for each other program."""
    lines = []
    for name, (program, title) in LIBRARIES.items():
        own = [run for run in taken if run["program"] == name]
        library = linked_library(programs / program, name) if own else None
        if not own:
            continue
        line = f"{title} {own[0]['version']} ({library and package_version(library) or 'not from a package'}"
        if any(run["debug"] for run in own):
            line += "; a debug build, by its own message"
        elif library and b"__assert_fail" in pathlib.Path(library).read_bytes():
            line += "; with its assertions compiled in"
        lines.append(line + ")")
    own = [run for run in taken if run["program"] == "lammps"]
    if own:
        package = package_version(shutil.which(runs.LAMMPS)) or "not from a package"
        lines.append(f"LAMMPS {own[0]['version']} ({package}; one process)")
    return lines


MM = 1e3  # per m
BUSY = 0.95  # a run with a smaller share of its core did not have it alone

HEAD = ("| | s per simulated s | × this project | Collisions per simulated s | Drift of A, mm/s | of B, mm/s "
        "| Disks lost | Largest overlap, mm: two disks, disk and base |\n|---|---|---|---|---|---|---|---|\n")


def row(name, own, ours):
    speed = runs.speed(own)
    rate = runs.collision_rate(own)
    drifts = [f"{MM * mean.value:+.1f}" + ("" if mean.error is None else f" ± {MM * mean.error:.1f}")
              for mean in runs.drift(own)]
    lost = sum(run["lost"] for run in own) / sum(run["duration"] for run in own)
    overlaps = [max(0.0, max(run[key] for run in own)) for key in ("overlap", "base_overlap")]
    cells = [name, f"{speed:.3g}", f"{speed / ours:.3g}", "—" if rate is None else f"{rate:,.0f}", *drifts,
             "0" if not lost else f"{lost:.2g} per s", ", ".join(f"{MM * o:.2g}" if o else "0" for o in overlaps)]
    return "| " + " | ".join(cells) + " |\n"


def shared(own):
    share = min(run["processor_seconds"] / run["wall_seconds"] for run in own)
    if share >= BUSY:
        return "Nothing else had the core: wall and processor time are the same within 5 %."
    return (f"The core was shared with other work (one run had {100.0 * share:.0f} % of it): times are processor "
            "time; on an idle core wall time is the same.")


def render(taken):
    own = [run for run in taken["runs"] if run["row"]]
    by_row = {}
    for run in own:
        by_row.setdefault(run["row"], []).append(run)
    ours = runs.speed(next(iter(by_row.values())))
    compiler = next(run["compiler"] for run in own if run["program"] == runs.OURS)
    repetitions = max(map(len, by_row.values()))
    lines = [f"{origin.text(taken['machine'])}, "
             f"{compiler}. {repetitions} runs of each row in turns (LAMMPS: one), on one core; "
             f"medians. {shared(own)}\n"]
    lines += [f"- {library}\n" for library in taken["libraries"]]
    if taken["missing"]:
        lines.append(f"- Not installed, and left out: {', '.join(taken['missing'])}\n")
    lines += ["\n", HEAD]
    lines += [row(name, of_row, ours) for name, of_row in by_row.items()]
    return "".join(lines)


KEYS = {"Chipmunk, 0.1 ms": "chipmunk_0_1ms", "Chipmunk, 1/60 s": "chipmunk_1_60s",
        "Chipmunk, 1/240 s": "chipmunk_1_240s", "Box2D, 0.1 ms": "box2d_0_1ms", "Box2D, 1/60 s of its clock: 0.53 ms": "box2d_manual", "LAMMPS, 5 µs": "lammps"}


def figures(taken):
    """Those of performance.json."""
    speeds = {}
    for run in taken["runs"]:
        speeds.setdefault(run["row"], []).append(run)
    ours = runs.speed(speeds[runs.ROW])
    known = {"ours.cost": f"{ours:.3g}", "ours.collisions": f"{runs.collision_rate(speeds[runs.ROW]):,.0f}"}
    for row, key in KEYS.items():
        if row in speeds:
            known[f"{key}.times"] = f"{runs.speed(speeds[row]) / ours:.3g}"
    return known
