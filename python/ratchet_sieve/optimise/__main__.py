"""Searches for the machine that separates two kinds best, with Optuna. Reports the front of quality (or another goal)
against throughput, and the best machine as a scene, from fresh seeds. sieve_sweep measures each machine once: the same
command continues a search that was interrupted."""
import argparse
import pathlib
import sys

from ratchet_sieve.places import SHARE, WORK, program

SEARCHES = SHARE / "config/searches"


def make_parser():
    parser = argparse.ArgumentParser(prog="optimise", description=__doc__)
    parser.add_argument("search", nargs="*", type=pathlib.Path, metavar="SEARCH",
                        help="search files (default: all of config/searches, for docs/machines.md)")
    parser.add_argument("--results", type=pathlib.Path, default=WORK / "out/optimise/results.db", metavar="FILE",
                        help="where the results are kept (default: out/optimise/results.db)")
    parser.add_argument("--goal", metavar="COLUMN",
                        help="maximise this number of the results in place of the searches' own goal (quality), beside "
                             "the throughput: any column of sieve_sweep export, such as purity.left.mass.A")
    parser.add_argument("--jobs", type=int, default=0, metavar="N", help="runs at a time (default: as many as cores)")
    parser.add_argument("--draw-only", action="store_true",
                        help="run nothing: draw the pictures and write the document from data/machines.csv")
    parser.add_argument("--out", type=pathlib.Path, metavar="DIR",
                        help="document, table, pictures and scenes into DIR (default: docs, docs/data, docs/images and "
                             "config; out/optimise where searches are named)")
    parser.add_argument("--program", type=pathlib.Path, default=program("sieve_sweep"),
                        metavar="FILE", help=argparse.SUPPRESS)
    return parser


def places(options):
    """@return the document, and where pictures and scenes go"""
    if options.out or options.search:
        out = options.out or WORK / "out/optimise"
        return out / "machines.md", out / "images", out
    return WORK / "docs/machines.md", WORK / "docs/images", WORK / "config"


def main():
    parser = make_parser()
    options = parser.parse_args()
    if options.jobs < 0:
        parser.error(f"--jobs {options.jobs}: 0 or more")
    if options.goal and not options.search:
        parser.error("--goal: needs a SEARCH: the pages of this package are by the searches' own goals")
    # What follows needs matplotlib, optuna and yaml, which --help does without.
    from ratchet_sieve.optimise import pipeline
    try:
        pipeline.run(options, options.search or sorted(SEARCHES.glob("*.yaml")), *places(options))
    except pipeline.BadSearch as error:
        sys.exit(f"optimise: {error}")
    except pipeline.SweepFailed as error:
        sys.exit(f"optimise: {error}")
    except OSError as error:
        sys.exit(f"optimise: {error.filename}: {error.strerror}")
    except KeyboardInterrupt:
        sys.exit(130)


if __name__ == "__main__":
    main()
