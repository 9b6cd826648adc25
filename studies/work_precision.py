#!/usr/bin/python3
"""Measures error against processor time: of steps of time (accuracy.method), and of what the model may leave out, on
scenes with a known answer and on those of the paper. sieve_sweep runs each setting on one thread over many seeds. The
time is the processor time of the whole program over the simulated time, that of the best round.

Writes data/accuracy.csv, data/accuracy_costs.csv, data/accuracy.json and the tables in accuracy.md.
"""
import argparse
import pathlib

from ratchet_sieve import documents, origin
from precision import points, runs, tables

ROOT = pathlib.Path(__file__).resolve().parent.parent

FULL = 8.0     # times the seeds of --quick
SHORT = (1e-9, 0.3)  # one seed a round, so long [s]
MARKS = ("accuracy-bounds", "accuracy-claims", "accuracy-floors")


def read_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--programs", type=pathlib.Path, default=ROOT / "devel/lib/ratchet_sieve", metavar="DIR",
                        help="where sieve_sweep is")
    parser.add_argument("--quick", action="store_true",
                        help="about 40 minutes of one core; without it eight times as many seeds")
    parser.add_argument("--only", nargs="+", metavar="SCENE", help="measure these scenes alone; the others are kept")
    parser.add_argument("--errors-only", action="store_true",
                        help="keep the times: for a machine that is busy with other work")
    parser.add_argument("--short", action="store_true", help="test whether it runs: its figures mean nothing")
    parser.add_argument("--draw-only", action="store_true", help="measure nothing: write all from the CSV files")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "docs", metavar="DIR",
                        help="directory with accuracy.md (default: docs)")
    arguments = parser.parse_args()
    if not arguments.draw_only and not (arguments.programs / "sieve_sweep").exists():
        parser.error(f"{arguments.programs} holds no sieve_sweep")
    if arguments.draw_only and not (arguments.out / "data" / points.RESULTS).exists():
        parser.error(f"--draw-only: {arguments.out / 'data' / points.RESULTS} does not exist")
    for mark in MARKS:
        documents.require_place(parser, arguments.out / "accuracy.md", mark)
    return arguments


def measure(arguments):
    chosen = points.planned(arguments.only)
    effort, span = SHORT if arguments.short else (1.0 if arguments.quick else FULL, None)
    runs.run_all(arguments.programs / "sieve_sweep", chosen, effort, span)
    points.save(arguments.out / "data", chosen, points.Origin(*origin.describe().values(), origin.physics()),
                not arguments.errors_only)


def main():
    arguments = read_arguments()
    if not arguments.draw_only:
        measure(arguments)
    every = points.planned()
    results, costs = points.load(arguments.out / "data", every)
    development, held_out, large = (points.of_scenes(every, scenes)
                                    for scenes in (points.DEVELOPMENT, points.HELD_OUT, points.LARGE))
    figures = tables.figures({**development, **held_out}, large, results, costs)
    for mark, text in zip(MARKS, (tables.bounds(development, figures), tables.claims(held_out),
                                  tables.floors(development, figures))):
        documents.put(arguments.out / "accuracy.md", mark, text)
    documents.write_figures(arguments.out / "data/accuracy.json", figures)


if __name__ == "__main__":
    main()
