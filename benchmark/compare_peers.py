#!/usr/bin/python3
"""Runs one scene in this project and in other programs, one after another, and writes the table.

The scene is the mixture of Fig. 8 at theta = 0: peers/mixture_scene.cpp. The table names programs that are not
installed. In full it takes less than ten minutes. Drawing needs matplotlib.
"""
import argparse
import json
import pathlib
import sys

import physics
from peers import cases, edmd, libraries, measure, points, table
from ratchet_sieve import documents

ROOT = pathlib.Path(__file__).resolve().parent.parent


def read_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", type=pathlib.Path, metavar="DIR",
                        help="where ratchet_mixture and the others are: devel/lib/ratchet_sieve after scripts/build")
    parser.add_argument("--repetitions", type=int, default=3, help="of each row, taken in turns (default: 3)")
    parser.add_argument("--lammps", default="lmp", help="LAMMPS's program (default: lmp)")
    parser.add_argument("--edmd", type=pathlib.Path, metavar="DIR",
                        help="a checkout of github.com/FSmallenburg/EDMD: compare collisions per second with it, "
                             "too; some minutes more")
    parser.add_argument("--write", type=pathlib.Path, metavar="FILE",
                        help="put the table between the marks of this document")
    parser.add_argument("--out", type=pathlib.Path, metavar="DIR", help="write every run as JSON into DIR/peers.json")
    parser.add_argument("--picture", type=pathlib.Path, metavar="FILE",
                        help="draw drift over time for many steps, and write ../data/peers.csv beside it: some minutes "
                             "more")
    parser.add_argument("--short", action="store_true", help="test whether it runs: its figures mean nothing")
    parser.add_argument("--from", type=pathlib.Path, metavar="FILE", dest="source",
                        help="run nothing: take the runs of a peers.json")
    parser.add_argument("--draw-only", action="store_true",
                        help="run nothing: draw docs/images/peers.png from docs/data/peers.csv")
    arguments = parser.parse_args()
    if not (arguments.programs / "ratchet_mixture").exists() and not (arguments.source or arguments.draw_only):
        parser.error(f"{arguments.programs} holds no ratchet_mixture: build with -DRATCHET_SIEVE_BENCHMARKS=ON")
    if arguments.write:
        for place in ["peers"] + (["edmd"] if arguments.edmd else []):
            documents.require_place(parser, arguments.write, place)
    return arguments


def take_runs(arguments):
    if arguments.source:
        return json.loads(arguments.source.read_text())
    found, missing = cases.rows(arguments.programs, arguments.lammps)
    runs = measure.in_turns(found, 1 if arguments.short else arguments.repetitions, arguments.short)
    if arguments.picture:
        runs += measure.in_turns(cases.sweep(arguments.programs), 1, arguments.short)
    beside_edmd = edmd.in_turns(arguments.programs, arguments.edmd, arguments.repetitions,
                                arguments.short) if arguments.edmd else []
    return {"machine": physics.describe(), "missing": missing, "runs": runs, "edmd": beside_edmd,
            "libraries": libraries.libraries(arguments.programs, arguments.lammps, runs)}


def draw(data, path):
    from peers import picture
    picture.draw(points.read(data), path)


def main():
    arguments = read_arguments()
    if arguments.draw_only:
        draw(ROOT / "docs/data/peers.csv", ROOT / "docs/images/peers.png")
        return
    taken = take_runs(arguments)
    if arguments.out:
        arguments.out.mkdir(parents=True, exist_ok=True)
        (arguments.out / "peers.json").write_text(json.dumps(taken, indent=1) + "\n")
    text = table.render(taken)
    if arguments.write:
        documents.put(arguments.write, "peers", text)
        documents.quote(arguments.write, "peers", table.figures(taken), taken["machine"])
    print(text)
    if taken.get("edmd"):
        beside_edmd = edmd.render(taken["edmd"], taken["machine"])
        if arguments.write:
            documents.put(arguments.write, "edmd", beside_edmd)
            documents.quote(arguments.write, "edmd", edmd.figures(taken["edmd"]), taken["machine"])
        print(beside_edmd)
    if arguments.picture:
        data = arguments.picture.parent.parent / "data/peers.csv"
        points.write(data, points.of_runs(taken["runs"], taken["machine"]))
        draw(data, arguments.picture)
    if any(run["program"] == cases.OURS and (run["lost"] or run["behind_base"]) for run in taken["runs"]):
        sys.exit("this project has lost a disk")


if __name__ == "__main__":
    main()
