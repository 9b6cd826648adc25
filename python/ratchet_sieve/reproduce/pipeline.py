"""Runs studies, draws their pictures and writes their documents."""
import sys

from ratchet_sieve import plots
from ratchet_sieve.reproduce import document
from ratchet_sieve.reproduce.study import Outcome
from ratchet_sieve.reproduce.sweeps import Runner, SweepFailed

__all__ = ["SweepFailed", "run"]


def say(outcome):
    for claim in outcome.claims():
        print(f"  {claim.number} {claim.text}: {claim.verdict()}")
        for check in claim.checks:
            print(f"    {check.text()}")
    sys.stdout.flush()


def save(outcome, picture, path):
    """@return path"""
    with plots.styled():
        figure = picture.draw(outcome.numbers)
        if note := outcome.samples(picture):
            figure.supxlabel(note, x=0.995, ha="right", fontsize=7.5, color=plots.GREY)
        return plots.save(figure, path)[0]


def run_study(study, runner, directory, name):
    rows = runner.take(study)
    outcome = Outcome(study, study.evaluate(rows), rows)
    for picture in study.pictures:
        print(save(outcome, picture, directory / f"{name}_{picture.name}.png"))
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
