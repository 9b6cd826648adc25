"""Repeats published experiments: runs their sweeps by sieve_sweep, draws each with error bars, tests each printed
claim, and writes docs/paper.md, docs/validation.md and docs/data. Existing results are not computed again."""
import argparse
import functools
import importlib
import pathlib

from ratchet_sieve.places import WORK, program

DOCUMENTS = ("paper", "validation")  # each a package with STUDIES in their order, and template.md


def read_arguments():
    parser = argparse.ArgumentParser(prog="reproduce", description=__doc__)
    parser.add_argument("--only", nargs="+", metavar="NAME",
                        help="only these studies, without a document; --list names them")
    parser.add_argument("--list", action="store_true", help="list the studies and their sweeps")
    parser.add_argument("--results", type=pathlib.Path, default=WORK / "out/reproduce/results.db", metavar="FILE",
                        help="where the results are kept (default: out/reproduce/results.db)")
    parser.add_argument("--jobs", type=int, default=0, metavar="N", help="runs at a time (default: as many as cores)")
    parser.add_argument("--draw-only", action="store_true", help="run nothing; draw and write what the results have")
    parser.add_argument("--out", type=pathlib.Path, metavar="DIR",
                        help="documents into DIR, pictures into DIR/images, data into DIR/data (default: docs, but "
                             "out/reproduce with --only)")
    parser.add_argument("--program", type=pathlib.Path, default=program("sieve_sweep"),
                        metavar="FILE", help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.jobs < 0:
        parser.error(f"--jobs {options.jobs}: 0 or more")
    if options.draw_only and not options.results.exists():
        parser.error(f"--draw-only: {options.results} does not exist")
    options.out = options.out or WORK / ("out/reproduce" if options.only else "docs")
    return parser, options


def run_study(study, rows_of, directory, name):
    """Runs and draws a study, and says what came out."""
    from ratchet_sieve import plots
    from study import Outcome

    rows = {name: rows_of(name) for name in study.sweeps}
    outcome = Outcome(study, study.evaluate(rows), rows)
    for picture in study.pictures:
        with plots.styled():
            figure = picture.figure(outcome.numbers)
            if note := outcome.samples(picture):
                figure.supxlabel(note, x=0.995, ha="right", fontsize=7.5, color=plots.GREY)
            print(plots.save(figure, directory / f"{name}_{picture.name}.png", svg=False)[0])
    for claim in outcome.claims():
        print(f"  {claim.number} {claim.text}: {claim.verdict()}", *(f"    {check.text()}" for check in claim.checks),
              sep="\n", flush=True)
    return outcome


def run(options, studies):
    """All studies of each document, or only those that the options name: then no document is written."""
    import document
    import sweeps

    options.results.parent.mkdir(parents=True, exist_ok=True)
    rows_of = functools.lru_cache(maxsize=None)(functools.partial(sweeps.rows_of, options))  # studies may share one
    for name, own in studies.items():
        outcomes = [run_study(study, rows_of, options.out / "images", name) for study in own
                    if not options.only or study.name in options.only]
        if outcomes and not options.only:
            path = options.out / f"{name}.md"
            document.write(path, pathlib.Path(__file__).with_name(name) / "template.md", outcomes,
                           "scripts/reproduce")
            print(path)


def main():
    parser, options = read_arguments()
    # What follows needs matplotlib and yaml, which --help does without.
    from sweeps import run_program

    studies = {name: importlib.import_module(name).STUDIES for name in DOCUMENTS}
    known = [study.name for own in studies.values() for study in own]
    for name in options.only or ():
        if name not in known:
            parser.error(f"--only {name}: no such study; there are {', '.join(known)}")
    if options.list:
        for name, own in studies.items():
            for study in own:
                print(f"{name}: {study.name}: {study.title} ({', '.join(study.sweeps)})")
        return
    run_program(parser.prog, lambda: run(options, studies))


if __name__ == "__main__":
    main()
