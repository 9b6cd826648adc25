"""The runs as Markdown, with the versions of the other programs."""
import os
import pathlib
import re
import shutil
import subprocess

from ratchet_sieve import origin
from ratchet_sieve.texts import table
from peers import lammps_mixture, runs

MM = 1e3  # per m
NEAR = 0.05  # of a drift, within which it counts as the same
BUSY = 0.95  # a run with a smaller share of its core did not have it alone
HEAD = ("", "s per simulated s", "× this project", "Collisions per simulated s", "Drift of A, mm/s", "of B, mm/s",
        "Both within 5 %", "Disks lost", "Largest overlap, mm: two disks, disk and base")
KEYS = {"Chipmunk, 0.1 ms": "chipmunk_0_1ms", "Chipmunk, 1/60 s": "chipmunk_1_60s",
        "Chipmunk, 1/240 s": "chipmunk_1_240s", "Box2D, 0.1 ms": "box2d_0_1ms",
        "Box2D, 1/60 s of its clock: 0.53 ms": "box2d_manual", "LAMMPS, 5 µs": "lammps"}


def output(*command):
    return subprocess.run(command, capture_output=True, text=True, check=False).stdout


def package_of(path):
    """The package that a file belongs to, with its version."""
    for name in (path, os.path.realpath(path)) if shutil.which("dpkg-query") else ():
        if owner := output("dpkg-query", "-S", name):
            package = owner.split(": ", 1)[0]
            return f"{package.split(':')[0]} {output('dpkg-query', '-W', '-f', '${Version}', package)}"
    return "not from a package"


def libraries(programs, taken):
    """One line for each other program."""
    for name, title in (("chipmunk", "Chipmunk"), ("box2d", "Box2D"), ("lammps", "LAMMPS")):
        own = [run for run in taken if run["program"] == name]
        if not own:
            continue
        if name == "lammps":
            about = f"{package_of(shutil.which(lammps_mixture.PROGRAM))}; one process"
        else:
            loaded = re.search(rf"lib{name}\S* => (\S+)", output("ldd", str(programs / runs.PROGRAMS[name])))
            about = package_of(loaded.group(1)) if loaded else "not from a package"
            if any(run["debug"] for run in own):
                about += "; a debug build, by its own message"
            elif loaded and b"__assert_fail" in pathlib.Path(loaded.group(1)).read_bytes():
                about += "; with its assertions compiled in"
        yield f"- {title} {own[0]['version']} ({about})"


def is_near(own, alike):
    """Whether both drifts are those of this project without tangential restitution, in words; of its own rows none."""
    if own[0]["program"] == runs.OURS:
        return "—"
    near = (abs(mean.value / expected.value - 1.0) <= NEAR for mean, expected in zip(runs.drift(own), alike))
    return "yes" if all(near) else "no"


def row(name, own, ours, alike):
    speed = runs.speed(own)
    rate = runs.collision_rate(own)
    drifts = [f"{MM * mean.value:+.1f}" + ("" if mean.error is None else f" ± {MM * mean.error:.1f}")
              for mean in runs.drift(own)]
    lost = sum(run["lost"] for run in own) / sum(run["duration"] for run in own)
    overlaps = [max(run[key] for run in own) for key in ("overlap", "base_overlap")]
    return [name, f"{speed:.3g}", f"{speed / ours:.3g}", "—" if rate is None else f"{rate:,.0f}", *drifts,
            is_near(own, alike), f"{lost:.2g} per s" if lost else "0",
            ", ".join(f"{MM * overlap:.2g}" for overlap in overlaps)]


def shared(own):
    share = min(run["processor_seconds"] / run["wall_seconds"] for run in own)
    if share >= BUSY:
        return "Nothing else had the core: wall and processor time are the same within 5 %."
    return (f"The core was shared with other work (one run had {100.0 * share:.0f} % of it): times are processor "
            "time; on an idle core wall time is the same.")


def by_row(taken):
    """@return each row of the table with its runs; this project's first"""
    found = {}
    for run in taken:
        if run["row"]:
            found.setdefault(run["row"], []).append(run)
    return found


def render(programs, taken, missing, about):
    """@param missing names of programs. @param about date and machine"""
    own = by_row(taken)
    ours = own[runs.ROW]
    lines = [f"{origin.text(about)}. {max(map(len, own.values()))} runs of each row in turns "
             f"(LAMMPS: one), on one core; medians. {shared(sum(own.values(), []))}", *libraries(programs, taken)]
    if missing:
        lines.append(f"- Not installed, and left out: {', '.join(missing)}")
    alike = runs.drift(own[runs.ALIKE_ROW])
    return "\n".join([*lines, "", table(HEAD, [row(name, of_row, runs.speed(ours), alike)
                                               for name, of_row in own.items()])])


def figures(taken):
    """Those of performance.json."""
    own = by_row(taken)
    ours = runs.speed(own[runs.ROW])
    known = {"ours.cost": f"{ours:.3g}", "ours.collisions": f"{runs.collision_rate(own[runs.ROW]):,.0f}"}
    for name, key in KEYS.items():
        if name in own:
            known[f"{key}.times"] = f"{runs.speed(own[name]) / ours:.3g}"
    return known
