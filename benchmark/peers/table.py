"""The runs as Markdown."""
from peers import cases, measure

MM = 1e3  # per m
BUSY = 0.95  # a run that had less of the processor than this shared it

HEAD = ("| | s per simulated s | × this project | Collisions per simulated s | Drift of A, mm/s | of B, mm/s "
        "| Disks lost | Largest overlap, mm: two disks, disk and base |\n|---|---|---|---|---|---|---|---|\n")


def row(name, runs, ours):
    speed = measure.speed(runs)
    rate = measure.collision_rate(runs)
    drifts = [f"{MM * mean:+.1f} ± {MM * error:.1f}" if error is not None else f"{MM * mean:+.1f}"
              for mean, error in measure.drift(runs)]
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
    machine = taken["machine"]
    compiler = next(run["compiler"] for run in runs if run["program"] == cases.OURS)
    repetitions = max(map(len, by_row.values()))
    lines = [f"{machine['date']}, {machine['processor']}, {machine['cores']} virtual cores, {machine['system']}, "
             f"{compiler}. {repetitions} runs of each row in turns (LAMMPS: one), on one core; "
             f"medians. {shared(runs)}\n"]
    lines += [f"- {library}\n" for library in taken["libraries"]]
    if taken["missing"]:
        lines.append(f"- Not installed, and left out: {', '.join(taken['missing'])}\n")
    lines += ["\n", HEAD]
    lines += [row(name, of_row, ours) for name, of_row in by_row.items()]
    return "".join(lines)
