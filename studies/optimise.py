"""Searches for the machine that separates two kinds best, with Optuna. Reports the front of quality (or another goal)
against throughput, and the best machine as a scene, from fresh seeds. sieve_sweep measures each machine once: the same
command continues a search that was interrupted."""
import argparse
import pathlib
import string
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


def say(text):
    print(text, file=sys.stderr, flush=True)


def measure(options, searches, table):
    """Runs the searches and writes the table."""
    from machines import optimiser, report
    from ratchet_sieve import origin

    about = origin.describe()
    options.results.parent.mkdir(parents=True, exist_ok=True)
    lines = []
    for search in searches:
        say(f"{search.path.name}:")
        trials = optimiser.Trials(options, search)
        found = optimiser.find(search, trials, say)
        lines += report.lines(search, found, {"measured": about["date"], "machine": about["machine"],
                                              "version": trials.version})
    report.write_table(table, lines)


def run(options):
    """From searches' files to the table of results, pictures, scenes and the document."""
    from machines import report
    from machines.search import read_search
    from ratchet_sieve.texts import wrapped

    searches = [read_search(path, options.goal) for path in options.search or sorted(SEARCHES.glob("*.yaml"))]
    document, pictures, scenes = places(options)
    table = document.parent / "data/machines.csv"
    if not options.draw_only:
        measure(options, searches, table)
    results, sections = [], []
    for search in searches:
        found, measured = report.read_table(table, search)
        results.append((search, found))
        name = f"machine_{search.path.stem}"
        print(report.save(search, found, pictures / f"{name}.png"))
        sections.append(report.section(search, found, f"{name}.png"))
        if found[-1].best and not options.draw_only:
            path = scenes / f"{name}.yaml"
            path.write_text(report.scene_of(search, found[-1].best[0]), encoding="utf-8")
            print(path)
    known = {"about": "{measured}, {machine}, ratchet_sieve {version}".format(**measured),
             "summary": report.summary(results), "searches": "\n\n".join(sections)}
    template = string.Template((pathlib.Path(report.__file__).with_name("template.md")).read_text(encoding="utf-8"))
    document.write_text(wrapped(template.substitute(known)), encoding="utf-8")
    print(document)


def main():
    parser = make_parser()
    options = parser.parse_args()
    if options.jobs < 0:
        parser.error(f"--jobs {options.jobs}: 0 or more")
    if options.goal and not options.search:
        parser.error("--goal: needs a SEARCH: the pages of this package are by the searches' own goals")
    # What follows needs matplotlib, optuna and yaml, which --help does without.
    from sweeps import run_program

    run_program(parser.prog, lambda: run(options))


if __name__ == "__main__":
    main()
