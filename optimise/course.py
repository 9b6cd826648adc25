"""From searches' files to pictures, scenes and the document."""
import string
import pathlib
import sys

from optimise import report
from optimise.outcome import find
from optimise.search_file import BadSearch, read_search
from optimise.trials import SweepFailed, Trials
from reproduce.document import machine, wrapped
from reproduce.drawing import STYLE, plt

__all__ = ["BadSearch", "SweepFailed", "run"]

TEMPLATE = pathlib.Path(__file__).resolve().parent / "template.md"


def say(text):
    print(text, file=sys.stderr, flush=True)


def save_picture(search, found, directory):
    directory.mkdir(parents=True, exist_ok=True)
    path = directory / f"machine_{search.path.stem}.png"
    with plt.rc_context({**STYLE, "svg.hashsalt": "ratchet_sieve"}):
        figure = report.draw(search, found)
        figure.savefig(path)
        figure.savefig(path.with_suffix(".svg"), metadata={"Date": None})
        plt.close(figure)
    return path


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
        picture = save_picture(search, found, pictures)
        print(picture)
        save_scene(search, found, scenes)
        sections.append(report.section(search, found, picture.name, pictures))
    about = machine.describe()
    known = {"about": f"{about['date']}, {about['processor']}, {about['cores']} cores, {about['system']}.",
             "searches": "\n\n".join(sections)}
    text = string.Template(TEMPLATE.read_text(encoding="utf-8")).substitute(known)
    document.write_text("\n\n".join(map(wrapped, text.strip().split("\n\n"))) + "\n", encoding="utf-8")
    print(document)
