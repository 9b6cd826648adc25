"""The runs as Markdown."""
from peers import cases, measure
from ratchet_sieve import origin

MM = 1e3  # per m
BUSY = 0.95  # a run with a smaller share of its core did not have it alone

HEAD = ("| | s per simulated s | × this project | Collisions per simulated s | Drift of A, mm/s | of B, mm/s "
        "| Disks lost | Largest overlap, mm: two disks, disk and base |\n|---|---|---|---|---|---|---|---|\n")


def row(name, runs, ours):
    speed = measure.speed(runs)
    rate = measure.collision_rate(runs)
    drifts = [f"{MM * mean.value:+.1f}" + ("" if mean.error is None else f" ± {MM * mean.error:.1f}")
              for mean in measure.drift(runs)]
    lost = sum(run["lost"] for run in runs) / sum(run["duration"] for run in runs)
    overlaps = [max(0.0, max(run[key] for run in runs)) for key in ("overlap", "base_overlap")]
    cells = [name, f"{speed:.3g}", f"{speed / ours:.3g}", "—" if rate is None else f"{rate:,.0f}", *drifts,
             "0" if not lost else f"{lost:.2g} per s", ", ".join(f"{MM * o:.2g}" if o else "0" for o in overlaps)]
    return "| " + " | ".join(cells) + " |\n"


def shared(runs):
    share = min(run["processor_seconds"] / run["wall_seconds"] for run in runs)
    if share >= BUSY:
        return "Nothing else had the core: wall and processor time are the same within 5 %."
    return (f"The core was shared with other work (one run had {100.0 * share:.0f} % of it): times are processor "
            "time; on an idle core wall time is the same.")


def render(taken):
    runs = [run for run in taken["runs"] if run["row"]]
    by_row = {}
    for run in runs:
        by_row.setdefault(run["row"], []).append(run)
    ours = measure.speed(next(iter(by_row.values())))
    compiler = next(run["compiler"] for run in runs if run["program"] == cases.OURS)
    repetitions = max(map(len, by_row.values()))
    lines = [f"{origin.text(taken['machine'])}, "
             f"{compiler}. {repetitions} runs of each row in turns (LAMMPS: one), on one core; "
             f"medians. {shared(runs)}\n"]
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
    ours = measure.speed(speeds[cases.ROW])
    known = {"ours.cost": f"{ours:.3g}", "ours.collisions": f"{measure.collision_rate(speeds[cases.ROW]):,.0f}"}
    for row, key in KEYS.items():
        if row in speeds:
            known[f"{key}.times"] = f"{measure.speed(speeds[row]) / ours:.3g}"
    return known
