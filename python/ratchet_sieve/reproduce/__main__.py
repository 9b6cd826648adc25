"""Repeats published experiments: runs their sweeps by sieve_sweep, draws each as PNG and SVG with error bars, tests
each printed claim, and writes docs/paper.md, docs/validation.md and docs/data. Existing results are not computed
again."""
import argparse
import pathlib
import sys

from ratchet_sieve.places import WORK, program
from ratchet_sieve.reproduce.quick import QUICK_RULE


def make_parser():
    parser = argparse.ArgumentParser(prog="reproduce", description=__doc__)
    parser.add_argument("--quick", action="store_true", help=f"takes minutes: {QUICK_RULE}")
    parser.add_argument("--only", nargs="+", metavar="NAME",
                        help="only these studies, without a document; --list names them")
    parser.add_argument("--list", action="store_true", help="list the studies and their sweeps")
    parser.add_argument("--results", type=pathlib.Path, default=WORK / "out/reproduce/results.db", metavar="FILE",
                        help="where the results are kept (default: out/reproduce/results.db)")
    parser.add_argument("--jobs", type=int, default=0, metavar="N", help="runs at a time (default: as many as cores)")
    parser.add_argument("--draw-only", action="store_true", help="run nothing; draw and write what the results have")
    parser.add_argument("--out", type=pathlib.Path, metavar="DIR",
                        help="documents into DIR, pictures into DIR/images, data into DIR/data (default: docs, but "
                             "out/reproduce with --quick or --only)")
    parser.add_argument("--program", type=pathlib.Path, default=program("sieve_sweep"),
                        metavar="FILE", help=argparse.SUPPRESS)
    return parser


def check(parser, options, documents):
    if options.jobs < 0:
        parser.error(f"--jobs {options.jobs}: 0 or more")
    known = [study.name for doc in documents for study in doc.studies]
    for name in options.only or ():
        if name not in known:
            parser.error(f"--only {name}: no such study; there are {', '.join(known)}")
    if options.draw_only and not options.results.exists():
        parser.error(f"--draw-only: {options.results} does not exist")
    options.out = options.out or WORK / ("out/reproduce" if options.quick or options.only else "docs")


def list_studies(documents):
    for doc in documents:
        for study in doc.studies:
            print(f"{doc.name}: {study.name}: {study.title} ({', '.join(sweep.name for sweep in study.sweeps)})")


def main():
    parser = make_parser()
    options = parser.parse_args()
    # What follows needs matplotlib and yaml, which --help does without.
    from ratchet_sieve.reproduce.documents import DOCUMENTS
    check(parser, options, DOCUMENTS)
    if options.list:
        list_studies(DOCUMENTS)
        return
    from ratchet_sieve.reproduce import pipeline
    try:
        pipeline.run(options, DOCUMENTS)
    except pipeline.SweepFailed as error:
        sys.exit(f"reproduce: {error}")
    except OSError as error:
        sys.exit(f"reproduce: {error.filename}: {error.strerror}")
    except KeyboardInterrupt:
        sys.exit(130)


if __name__ == "__main__":
    main()
