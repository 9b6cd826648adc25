"""From searches' files to the table of results, pictures, scenes and the document."""
import dataclasses
import pathlib
import string
import sys

from ratchet_sieve import origin, plots
from ratchet_sieve.documents import write_figures
from ratchet_sieve.optimise import report, results_table
from ratchet_sieve.optimise.outcome import find
from ratchet_sieve.optimise.search_file import BadSearch, read_search
from ratchet_sieve.optimise.trials import Trials
from ratchet_sieve.reproduce.sweeps import SweepFailed
from ratchet_sieve.texts import wrapped

__all__ = ["BadSearch", "SweepFailed", "run"]

TEMPLATE = pathlib.Path(__file__).resolve().parent / "template.md"


def say(text):
    print(text, file=sys.stderr, flush=True)


def save_scene(search, found, directory):
    """The best machine of the last kind; nothing where there is none."""
    if found[-1].best is None:
        return
    path = directory / f"machine_{search.path.stem}.yaml"
    path.write_text(report.scene_of(search, found[-1].best[0]), encoding="utf-8")
    print(path)


def measure(options, searches, table):
    """Runs the searches and writes the table."""
    about = origin.describe()
    options.results.parent.mkdir(parents=True, exist_ok=True)
    lines = []
    for search in searches:
        say(f"{search.path.name}:")
        trials = Trials(options.program, options.results, options.jobs, search)
        found = find(search, trials, say)
        lines += results_table.lines(search, found, results_table.Origin(*about.values(), trials.version))
    results_table.write(table, lines)


def draw(search, found, pictures):
    with plots.styled():
        path, _ = plots.save(report.draw(search, found), pictures / f"machine_{search.path.stem}.png")
    print(path)
    return report.section(search, found, path.name, pictures)


def run(options, paths, document, pictures, scenes):
    """@throws BadSearch, SweepFailed, OSError"""
    searches = [read_search(path) for path in paths]
    if options.goal:
        searches = [dataclasses.replace(search, goal=options.goal) for search in searches]
    table = document.parent / "data/machines.csv"
    if not options.draw_only:
        measure(options, searches, table)
    results, measured = [], None
    for search in searches:
        found, measured = results_table.read(table, search)
        if found is None:
            raise BadSearch(f"{table}: has no line of {search.path.stem} with {search.goal}")
        results.append((search, found))
    sections = [draw(search, found, pictures) for search, found in results]
    if not options.draw_only:
        for search, found in results:
            save_scene(search, found, scenes)
    write_figures(document.parent / "data/machines.json", {
        "date": measured.measured, "machine": measured.machine, "version": measured.version, **report.figures(results)})
    known = {"about": f"{measured.measured}, {measured.machine}, ratchet_sieve {measured.version}",
             "summary": report.summary(results), "searches": "\n\n".join(sections)}
    text = string.Template(TEMPLATE.read_text(encoding="utf-8")).substitute(known)
    document.write_text(wrapped(text), encoding="utf-8")
    print(document)
