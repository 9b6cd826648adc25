#!/usr/bin/python3
"""Measures what accuracy costs: error against processor time, of steps of time (accuracy.method) and of what the model
may leave out, on scenes with a known answer and on those of the paper. Every point is run by sieve_sweep, one thread
each, over many seeds; its time is the processor time of the whole program over the simulated time, the best of the
rounds, and its error bars are standard errors over the seeds. What loses disks, or does not come to its end, is drawn
as such. Drawing needs matplotlib.
"""
import argparse
import json
import pathlib

import document
from peers import machine
from precision import published, rungs, runs, scenes, tables

ROOT = pathlib.Path(__file__).resolve().parent.parent
MARKS = ("accuracy-method", "accuracy-model", "accuracy-claims", "accuracy-large")
FULL = 8.0     # times the seeds of --quick
SHORT = (1e-9, 0.3)  # one seed a round, so long [s]


def read_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--programs", type=pathlib.Path, default=ROOT / "devel/lib/ratchet_sieve", metavar="DIR",
                        help="where sieve_sweep is")
    parser.add_argument("--quick", action="store_true",
                        help="some twenty minutes of one core; else eight times as many seeds")
    parser.add_argument("--rounds", type=int, default=2, help="that the seeds are divided into (default: 2)")
    parser.add_argument("--jobs", type=int, default=1, help="points at a time (default: 1)")
    parser.add_argument("--limit", type=float, default=120.0, metavar="S", help="of a point's round, in wall time")
    parser.add_argument("--only", nargs="+", metavar="SCENE", help="run these scenes alone")
    parser.add_argument("--short", action="store_true", help="only whether it runs: its figures mean nothing")
    parser.add_argument("--from", type=pathlib.Path, metavar="FILE", dest="source",
                        help="run nothing: take the runs of this")
    parser.add_argument("--out", type=pathlib.Path, metavar="DIR",
                        help="pictures, and every run as work_precision.json, into DIR")
    parser.add_argument("--write", type=pathlib.Path, metavar="FILE",
                        help="put the tables between the marks of this document")
    arguments = parser.parse_args()
    if not arguments.source and not (arguments.programs / "sieve_sweep").exists():
        parser.error(f"{arguments.programs} holds no sieve_sweep")
    for mark in MARKS if arguments.write else ():
        document.require_place(parser, arguments.write, mark)
    return arguments


def all_points(only):
    points = []
    for scene in scenes.development():
        for family, settings in rungs.of(scene).items():
            points += [runs.Point(scene, family, label, rung) for label, rung in settings]
    for scene in (*scenes.held_out(), *scenes.large()):
        points.append(runs.Point(scene, "exact", "exact", {}))
        steps = (0.002, 0.001, 0.0005) if scene.name.startswith("large") else rungs.CLAIMS
        points += [runs.Point(scene, "steps", f"{1e3 * step:g} ms", rungs.steps(step)) for step in steps]
    return [point for point in points if not only or point.scene.name in only]


def take_runs(arguments):
    points = all_points(arguments.only)
    if arguments.source:
        taken = json.loads(arguments.source.read_text(encoding="utf-8"))
        return runs.restore(points, taken["points"]), taken["about"]
    about = {**machine.describe(), "rounds": arguments.rounds, "jobs": arguments.jobs}

    def save():
        if arguments.out:
            arguments.out.mkdir(parents=True, exist_ok=True)
            (arguments.out / "work_precision.json").write_text(
                json.dumps({"about": about, "points": runs.saved(points)}) + "\n", encoding="utf-8")

    effort, span = SHORT if arguments.short else (1.0 if arguments.quick else FULL, None)
    plan = runs.Plan(effort, arguments.rounds, arguments.jobs, arguments.limit, span)
    runs.run_all(arguments.programs / "sieve_sweep", points, plan, save)
    return points, about


def group(points):
    by_scene = {}
    for point in points:
        by_scene.setdefault(point.scene.name, []).append(point)
    return by_scene


def texts(by_scene, about):
    head = (f'{about["date"]}, {about["processor"]}, {about["cores"]} cores, {about["system"]}; one thread a run, '
            f'{about["jobs"]} at a time; processor time, the best of {about["rounds"]} rounds.\n\n')
    held_out = {scene.name for scene in scenes.held_out()}
    development = {n: p for n, p in by_scene.items() if n not in held_out and not n.startswith("large")}
    yield head + tables.method(development)
    yield head + tables.model(development)
    yield head + tables.claims({n: p for n, p in by_scene.items() if n in held_out})
    large = [p for n, p in by_scene.items() if n.startswith("large")]
    yield head + (tables.large(*large) if large else "")


def main():
    arguments = read_arguments()
    points, about = take_runs(arguments)
    by_scene = group(points)
    for mark, text in zip(MARKS, texts(by_scene, about)):
        print(text)
        if arguments.write:
            document.put(arguments.write, mark, text)
    if arguments.out:
        from precision import picture
        peers = published.read(ROOT / "docs/performance.md")
        picture.draw_method(by_scene, peers, arguments.out / "accuracy_method.png")
        picture.draw_model(by_scene, arguments.out / "accuracy_model.png")


if __name__ == "__main__":
    main()
