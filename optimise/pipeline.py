"""From searches' files to the table of results, pictures, scenes and the document."""
import pathlib
import string
import sys

from documents.figures import write_figures
from optimise import report, results_table
from optimise.outcome import find
from optimise.search_file import BadSearch, read_search
from optimise.trials import Trials
from reproduce import drawing
from reproduce.document import machine, wrapped
from reproduce.sweeps import SweepFailed

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
    about = machine.describe()
    where = f"{about['processor']}, {about['cores']} cores, {about['system']}"
    options.results.parent.mkdir(parents=True, exist_ok=True)
    lines = []
    for search in searches:
        say(f"{search.path.name}:")
        trials = Trials(options.program, options.results, options.jobs, search)
        found = find(search, trials, say)
        lines += results_table.lines(search, found, results_table.Origin(about["date"], where, trials.version))
    results_table.write(table, lines)


def draw(search, found, pictures):
    path = drawing.save(lambda: report.draw(search, found), pictures / f"machine_{search.path.stem}.png")
    print(path)
    return report.section(search, found, path.name, pictures)


def run(options, paths, document, pictures, scenes):
    """@throws BadSearch, SweepFailed, OSError"""
    searches = [read_search(path) for path in paths]
    table = document.parent / "data/machines.csv"
    if not options.draw_only:
        measure(options, searches, table)
    results, origin = [], None
    for search in searches:
        found, origin = results_table.read(table, search)
        if found is None:
            raise BadSearch(f"{table}: has no line of {search.path.stem}")
        results.append((search, found))
    sections = [draw(search, found, pictures) for search, found in results]
    if not options.draw_only:
        for search, found in results:
            save_scene(search, found, scenes)
    write_figures(document.parent / "data/machines.json", {
        "date": origin.measured, "machine": origin.machine, "version": origin.version, **report.figures(results)})
    known = {"about": f"{origin.measured}, {origin.machine}, ratchet_sieve {origin.version}",
             "summary": report.summary(results), "searches": "\n\n".join(sections)}
    text = string.Template(TEMPLATE.read_text(encoding="utf-8")).substitute(known)
    document.write_text("\n\n".join(map(wrapped, text.strip().split("\n\n"))) + "\n", encoding="utf-8")
    print(document)
