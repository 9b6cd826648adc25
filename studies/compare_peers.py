#!/usr/bin/python3
"""Runs one scene in this project and in other programs, one after another, and writes the table.

The scene is the mixture of Fig. 8 at theta = 0. The table names programs that are not installed. In full it takes less
than ten minutes. Drawing needs matplotlib.
"""
import argparse
import json
import os
import pathlib
import sys

from ratchet_sieve import documents, origin
from peers import edmd, picture, runs, table

ROOT = pathlib.Path(__file__).resolve().parent.parent
REPETITIONS = 3  # of each row, taken in turns


def read_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", type=pathlib.Path, metavar="DIR",
                        help="where the programs are: devel/lib/ratchet_sieve after scripts/build --benchmarks")
    parser.add_argument("--edmd", type=pathlib.Path, metavar="DIR",
                        help="a checkout of github.com/FSmallenburg/EDMD: compare collisions per second with it, "
                             "too; some minutes more")
    parser.add_argument("--write", type=pathlib.Path, metavar="FILE",
                        help="put the table between the marks of this document")
    parser.add_argument("--out", type=pathlib.Path, metavar="DIR", help="write every run as JSON into DIR/peers.json")
    parser.add_argument("--picture", type=pathlib.Path, metavar="FILE",
                        help="draw costs, and drift over time for many steps, which ../data/peers.csv beside it gets: "
                             "some minutes more")
    parser.add_argument("--short", action="store_true", help="test whether it runs: its figures mean nothing")
    parser.add_argument("--draw-only", action="store_true",
                        help="run nothing: draw docs/images/cost.png from docs/data")
    arguments = parser.parse_args()
    if arguments.write:
        documents.require_place(parser, arguments.write, "peers")
    return arguments


def main():
    arguments = read_arguments()
    if arguments.draw_only:
        picture.draw(ROOT / "docs/data", arguments.picture or ROOT / "docs/images/cost.png")
        return
    os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})  # The first core serves the system.
    cases, missing = runs.rows(arguments.programs)
    if arguments.write and missing and not arguments.short:
        sys.exit(f"{arguments.write} would lose rows: not installed are {', '.join(missing)}")
    repetitions, about = 1 if arguments.short else REPETITIONS, origin.describe_physics()
    taken = runs.in_turns(arguments.programs, cases, repetitions, arguments.short)
    if arguments.picture:
        taken += runs.in_turns(arguments.programs, runs.sweep(arguments.programs), 1, arguments.short)
    rates = edmd.in_turns(arguments.programs, arguments.edmd, repetitions, arguments.short) if arguments.edmd else None
    if arguments.out:
        arguments.out.mkdir(parents=True, exist_ok=True)
        (arguments.out / "peers.json").write_text(
            json.dumps({"machine": about, "missing": missing, "runs": taken, "edmd": None if rates is None else rates.tolist()},
                       indent=1) + "\n", encoding="utf-8")
    text = table.render(arguments.programs, taken, missing, about)
    print(text)
    if arguments.write:
        documents.put(arguments.write, "peers", text)
        documents.quote(arguments.write, "peers", table.figures(taken), about)
    if arguments.edmd:
        print(edmd.render(rates, about))
    if arguments.edmd and arguments.write:
        documents.quote(arguments.write, "edmd", edmd.figures(rates), about)
    if arguments.picture:
        data = arguments.picture.parent.parent / "data"
        picture.write(data / "peers.csv", taken, about)
        picture.draw(data, arguments.picture)
    if any(run["program"] == runs.OURS and (run["lost"] or run["behind_base"]) for run in taken):
        sys.exit("this project has lost a disk")


if __name__ == "__main__":
    main()
