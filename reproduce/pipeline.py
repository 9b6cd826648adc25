"""Runs studies, draws their pictures and writes their documents."""
import sys

from reproduce import document, drawing
from reproduce.study import Outcome
from reproduce.sweeps import Runner, SweepFailed

__all__ = ["SweepFailed", "run"]


def say(outcome):
    for claim in outcome.claims():
        print(f"  {claim.number} {claim.text}: {claim.verdict()}")
        for check in claim.checks:
            print(f"    {check.text()}")
    sys.stdout.flush()


def run_study(study, runner, directory, name):
    rows = runner.take(study)
    outcome = Outcome(study, study.evaluate(rows), rows)
    for path in drawing.save_all(outcome, directory, name):
        print(path)
    say(outcome)
    return outcome


def run(options, documents):
    """All studies of each document, or only those that the options name: then no document is written."""
    options.results.parent.mkdir(parents=True, exist_ok=True)
    runner = Runner(options.program, options.results, options.jobs, options.quick, options.draw_only)
    command = "scripts/reproduce" + (" --quick" if options.quick else "")
    for doc in documents:
        studies = [study for study in doc.studies if not options.only or study.name in options.only]
        outcomes = [run_study(study, runner, options.out / "images", doc.name) for study in studies]
        if outcomes and not options.only:
            path = options.out / f"{doc.name}.md"
            document.write(path, doc.template, outcomes, command, runner.costs)
            print(path)
