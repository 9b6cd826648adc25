"""Tables in a document, between the lines <!-- NAME --> and <!-- end of NAME -->, and the figures that others quote."""
import json
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))
from documents.figures import write_figures  # noqa: E402


def marks(name):
    return f'<!-- {name} -->', f'<!-- end of {name} -->'


def require_place(parser, path, name):
    """Ends the program, before it measures anything, if the document has no place for the table."""
    begin, end = marks(name)
    if not path.is_file() or end not in path.read_text(encoding='utf-8').partition(begin)[2]:
        parser.error(f'{path} has no lines {begin} and {end}')


def put(path, name, text):
    begin, end = marks(name)
    before, _, rest = path.read_text(encoding='utf-8').partition(begin)
    after = rest.partition(end)[2]
    path.write_text(f'{before}{begin}\n{text.rstrip()}\n{end}{after}', encoding='utf-8')


def physics_version():
    header = ROOT / 'include/ratchet_sieve/core/physics_version.h'
    return re.search(r'PHYSICS_VERSION = (\d+)', header.read_text(encoding='utf-8')).group(1)


def quote(path, name, figures, about):
    """Writes the figures of one table as NAME.KEY into the document's data/*.json, and keeps those of its other tables.
    @param about what machine.describe() gives"""
    data = path.parent / 'data' / f'{path.stem}.json'
    known = json.loads(data.read_text(encoding='utf-8')) if data.exists() else {}
    kept = {key: text for key, text in known.items() if not key.startswith(name + '.')}
    origin = {'date': about['date'], 'machine': f"{about['processor']}, {about['cores']} cores, {about['system']}",
              'version': f'physics version {physics_version()}'}
    write_figures(data, {**kept, **origin, **{f'{name}.{key}': text for key, text in {**figures, **origin}.items()}})
