"""From searches' files to pictures, scenes and the document."""
import pathlib
import string
import sys

from optimise import report
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
    """Of the best machine of the last kind, the freest; nothing where there is none."""
    if found[-1].best is None:
        return
    path = directory / f"machine_{search.path.stem}.yaml"
    path.write_text(report.scene_of(search, found[-1].best[0]), encoding="utf-8")
    print(path)


def run(options, paths, document, pictures, scenes):
    searches = [read_search(path) for path in paths]
    options.results.parent.mkdir(parents=True, exist_ok=True)
    sections = []
    for search in searches:
        say(f"{search.path.name}:")
        found = find(search, Trials(options.program, options.results, options.jobs, search), say)
        picture = drawing.save(lambda: report.draw(search, found), pictures / f"machine_{search.path.stem}.png")
        print(picture)
        save_scene(search, found, scenes)
        sections.append(report.section(search, found, picture.name, pictures))
    about = machine.describe()
    known = {"about": f"{about['date']}, {about['processor']}, {about['cores']} cores, {about['system']}.",
             "searches": "\n\n".join(sections)}
    text = string.Template(TEMPLATE.read_text(encoding="utf-8")).substitute(known)
    document.write_text("\n\n".join(map(wrapped, text.strip().split("\n\n"))) + "\n", encoding="utf-8")
    print(document)
