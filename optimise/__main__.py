"""Searches for the machine that separates two kinds best, with Optuna. Reports the front of quality against throughput,
and the best machine as a scene, from fresh seeds. sieve_sweep measures each machine once: the same command continues a
search that was interrupted."""
import argparse
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
SEARCHES = ROOT / "config/searches"


def make_parser():
    parser = argparse.ArgumentParser(prog="optimise", description=__doc__)
    parser.add_argument("search", nargs="*", type=pathlib.Path, metavar="SEARCH",
                        help="search files (default: all of config/searches, for docs/machines.md)")
    parser.add_argument("--results", type=pathlib.Path, default=ROOT / "out/optimise/results.db", metavar="FILE",
                        help="where the results are kept (default: out/optimise/results.db)")
    parser.add_argument("--jobs", type=int, default=0, metavar="N", help="runs at a time (default: as many as cores)")
    parser.add_argument("--draw-only", action="store_true",
                        help="run nothing: draw the pictures and write the document from data/machines.csv")
    parser.add_argument("--out", type=pathlib.Path, metavar="DIR",
                        help="document, table, pictures and scenes into DIR (default: docs, docs/data, docs/images and "
                             "config; out/optimise where searches are named)")
    parser.add_argument("--program", type=pathlib.Path, metavar="FILE", help=argparse.SUPPRESS)
    return parser


def places(options):
    """@return the document, and where pictures and scenes go"""
    if options.out or options.search:
        out = options.out or ROOT / "out/optimise"
        return out / "machines.md", out / "images", out
    return ROOT / "docs/machines.md", ROOT / "docs/images", ROOT / "config"


def main():
    parser = make_parser()
    options = parser.parse_args()
    if options.jobs < 0:
        parser.error(f"--jobs {options.jobs}: 0 or more")
    # What follows needs matplotlib, optuna and yaml, which --help does without.
    from optimise import pipeline
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
