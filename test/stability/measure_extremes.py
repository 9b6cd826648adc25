#!/usr/bin/env python3
"""Runs sieve_run on extreme scenes and reports the results; exit status 1 if one is not as expected."""
import argparse
import concurrent.futures
import csv
import datetime
import json
import os
import pathlib
import platform
import subprocess
import sys
import tempfile

import extremes
import long_run

LARGEST_OVERLAP = 1e-9  # of the smallest radius
TIMEOUT = 1500.0        # timeout, wall time [s]

EXIT_STATUS = {extremes.RUNS: 0, extremes.GOES_ON: 0, extremes.STOPS: 1, extremes.REFUSED: 2}


def finite(text):
    raise ValueError(f"the summary holds {text}")


def complaints(extreme, run, summary):
    """The errors of a run."""
    if run.returncode != EXIT_STATUS[extreme.comes_to]:
        yield f"exit status {run.returncode}: {run.stderr.strip()}"
        return
    if extreme.comes_to == extremes.REFUSED:
        if run.stdout or run.stderr.count("\n") != 1:
            yield "a refusal is one line and no summary"
        return
    if summary["through_base"]:
        yield f"{summary['through_base']} disks behind the base"
    if relative_overlap(extreme, summary) > LARGEST_OVERLAP:
        yield f"overlap {relative_overlap(extreme, summary):.2g} r"
    said = any("inelastic collapse" in warning for warning in summary["warnings"])
    wanted = extreme.comes_to != extremes.RUNS
    if said != wanted or (summary["collapses"] > 0) != wanted:
        yield f"{summary['collapses']} collapses, warnings {summary['warnings']}"


def relative_overlap(extreme, summary):
    return summary["max_overlap"] / extremes.smallest_radius(extreme.scene)


def measure(program, extreme, duration, timeout=TIMEOUT):
    """Runs a scene. Returns the summary (None for a refusal), the result in words, and the errors."""
    scene = dict(extreme.scene, duration=duration)
    with tempfile.NamedTemporaryFile("w", suffix=".yaml") as file:
        json.dump(scene, file)
        file.flush()
        run = subprocess.run([program, file.name], capture_output=True, text=True, timeout=timeout, check=False)
        said = run.stderr.strip().replace(file.name, "scene")
    summary = json.loads(run.stdout, parse_constant=finite) if run.stdout else None
    return summary, said, list(complaints(extreme, run, summary))


def outcome(extreme, summary, said):
    if summary is None:
        return "refused: " + said.split(": ", 2)[2].split(":")[0]
    if extreme.comes_to == extremes.STOPS:
        return f"stopped at {summary['simulated_time']:.3g} s and said so"
    if extreme.comes_to == extremes.GOES_ON:
        return f"ran, {summary['collapses']} collapses counted"
    over = sum(species["left"] + species["right"] for species in summary["species"])
    if extreme.scene.get("boundary") == "walled" and over:
        return f"ran, {over} over the walls"
    return "ran"


HEAD = ("group", "what", "result", "simulated_time", "collisions", "overlap", "events", "origin")


def row(extreme, summary, said):
    """One line of the table: times in s, the overlap over the smallest radius, events in millions per second."""
    cells = [extreme.group, extreme.what, outcome(extreme, summary, said)]
    if summary is None:
        return [*cells, "", "", "", ""]
    rate = summary["events"] / summary["wall_time"] * 1e-6 if summary["events"] > 1000 else None
    return cells + [f"{summary['simulated_time']:.3g}", str(sum(summary["collisions"].values())),
                    f"{relative_overlap(extreme, summary):.1e}" if summary["max_overlap"] else "0",
                    "" if rate is None else f"{rate:.2f}"]


def machine():
    names = [line.split(":", 1)[1].strip() for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines()
             if line.startswith("model name")]
    return f"{names[0] if names else platform.machine()}, {len(names)} virtual cores, {platform.system()}"


def measure_all(program, short, jobs):
    """The rows of the table, and the number of failures."""
    rows, failed = [], 0
    everything = list(extremes.extremes())
    if short:  # Scenes that start slowly run in full only in the long form.
        everything = [e for e in everything if "100,000" not in e.what]
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        results = pool.map(lambda extreme: measure(program, extreme, extreme.short if short else
                                                   extreme.scene["duration"]), everything)
        for extreme, (summary, said, wrong) in zip(everything, results):
            rows.append(row(extreme, summary, said))
            failed += bool(wrong)
            print(", ".join(rows[-1]), *(f"  WRONG: {w}" for w in wrong), sep="\n", flush=True)
    return rows, failed


def replace_between(path, begin, end, text):
    document = path.read_text()
    before, rest = document.split(begin, 1)
    path.write_text(before + begin + "\n" + text + end + rest.split(end, 1)[1])


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", help="sieve_run")
    parser.add_argument("--short", action="store_true", help="a twentieth of the time")
    parser.add_argument("--jobs", type=int, default=len(os.sched_getaffinity(0)), help="runs side by side")
    parser.add_argument("--write", type=pathlib.Path, metavar="FILE",
                        help="put the long run's table into this document, the others into data/extremes.csv beside it")
    arguments = parser.parse_args()
    rows, failed = measure_all(arguments.program, arguments.short, arguments.jobs)
    long_rows, long_failed = long_run.measure(arguments.program, 1e4 if arguments.short else 1e6)
    if arguments.write:
        where = f"{datetime.date.today()}, {machine()}, {arguments.jobs} at a time"
        with open(arguments.write.parent / "data/extremes.csv", "w", encoding="utf-8", newline="") as file:
            csv.writer(file, lineterminator="\n").writerows([HEAD, *([*cells, where] for cells in rows)])
        replace_between(arguments.write, "<!-- long run -->", "<!-- end -->",
                        where + ".\n\n" + long_run.HEAD + "\n".join(long_rows) + "\n")
    sys.exit(1 if failed or long_failed else 0)


if __name__ == "__main__":
    main()
