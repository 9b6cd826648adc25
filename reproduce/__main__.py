"""Reproduces published figures: runs the sweeps behind them by sieve_sweep, draws each as PNG and SVG with error bars,
holds the numbers against each printed claim, and writes docs/paper.md and docs/validation.md from all that. A result that
is there is not computed again."""
import argparse
import pathlib
import sys

from reproduce import document, sweeps
from reproduce.documents import DOCUMENTS
from reproduce.study import Outcome

ROOT = pathlib.Path(__file__).resolve().parent.parent


def read_arguments(arguments=None):
    parser = argparse.ArgumentParser(prog="scripts/reproduce", description=__doc__)
    parser.add_argument("--quick", action="store_true", help=f"some minutes: {sweeps.QUICK_RULE}")
    parser.add_argument("--only", nargs="+", metavar="NAME", help="these studies alone, and no document; --list has them")
    parser.add_argument("--list", action="store_true", help="list the studies and their sweeps")
    parser.add_argument("--results", type=pathlib.Path, default=ROOT / "out/reproduce/results.db", metavar="FILE",
                        help="where the results are kept (default: out/reproduce/results.db)")
    parser.add_argument("--jobs", type=int, default=0, metavar="N", help="runs at a time (default: as many as cores)")
    parser.add_argument("--draw-only", action="store_true", help="run nothing: draw and write what is in the results")
    parser.add_argument("--out", type=pathlib.Path, metavar="DIR",
                        help="documents into DIR, pictures into DIR/images (default: docs, but out/reproduce with --quick "
                             "or --only)")
    parser.add_argument("--program", type=pathlib.Path, metavar="FILE", required=True, help=argparse.SUPPRESS)
    options = parser.parse_args(arguments)
    if options.jobs < 0:
        parser.error(f"--jobs {options.jobs}: 0 or more")
    known = [study.name for doc in DOCUMENTS for study in doc.studies]
    for name in options.only or ():
        if name not in known:
            parser.error(f"--only {name}: no such study; there are {', '.join(known)}")
    if options.draw_only and not options.results.exists():
        parser.error(f"--draw-only: {options.results} does not exist")
    options.out = options.out or ROOT / ("out/reproduce" if options.quick or options.only else "docs")
    return options


def list_studies():
    for doc in DOCUMENTS:
        for study in doc.studies:
            print(f"{doc.name}: {study.name}: {study.title} ({', '.join(sweep.name for sweep in study.sweeps)})")


def run_study(study, runner, directory, name):
    from reproduce import drawing  # needs matplotlib, which --list and --help do without
    rows = runner.take(study)
    outcome = Outcome(study, study.evaluate(rows), rows)
    for path in drawing.save_all(outcome, directory, name):
        print(path)
    for claim in outcome.claims():
        print(f"  {claim.number} {claim.text}: {claim.verdict()}")
        for check in claim.checks:
            print(f"    {check.text()}")
    sys.stdout.flush()
    return outcome


def reproduce(options):
    options.results.parent.mkdir(parents=True, exist_ok=True)
    runner = sweeps.Runner(options.program, options.results, options.jobs, options.quick, options.draw_only)
    command = "scripts/reproduce" + (" --quick" if options.quick else "")
    for doc in DOCUMENTS:
        studies = [study for study in doc.studies if not options.only or study.name in options.only]
        outcomes = [run_study(study, runner, options.out / "images", doc.name) for study in studies]
        if outcomes and not options.only:
            path = options.out / f"{doc.name}.md"
            document.write(path, doc.template, outcomes, command, runner.costs)
            print(path)


def main():
    options = read_arguments()
    if options.list:
        list_studies()
        return
    try:
        reproduce(options)
    except sweeps.SweepFailed as error:
        sys.exit(f"reproduce: {error}")
    except KeyboardInterrupt:
        sys.exit(130)


if __name__ == "__main__":
    main()
