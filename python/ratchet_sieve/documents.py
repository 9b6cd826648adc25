"""Holds the figures that documents quote to the files that studies write.

A study writes its figures to docs/data/STUDY.json: key -> the text as it is printed. A document quotes one of them by a
comment right behind it, `1.6<!--STUDY:KEY-->` with STUDY and KEY as they are named there. Exit status: 0 if every
quoted figure is what the study's file says, else 1; of a release also if a document names an old version of the
physics. Before it, while the change log begins with what is forthcoming, a page may say that it was measured with one.
"""
import argparse
import json
import pathlib
import re
import sys

from ratchet_sieve.origin import physics
from ratchet_sieve.places import WORK

DOCUMENTS = ("*.md", "docs/**/*.md", "studies/**/*.md")
MEASURED = re.compile(r"physics\s+version\s+(\d+)")
QUOTED = re.compile(r"<!--([\w-]+):([\w.-]+)-->")
KEY = re.compile(r"[a-z0-9_]+(\.[a-z0-9_]+)*")
RESERVED = ("date", "version", "machine")
NUMBER = r"[-+−]?\d+(?:[.,]\d+)*"
BEGINS = r"(?<![\w.,+−-])"  # what stands before a figure is no part of it


def write_figures(path, figures):
    """Writes docs/data/STUDY.json.
    @param figures key, dotted and in lower case, -> the text as it is printed; with the keys date, version, machine
    @throws ValueError a key or a value is none"""
    for key, text in figures.items():
        if not KEY.fullmatch(key) or not isinstance(text, str) or not text:
            raise ValueError(f"{path}: {key}: {text!r}: a key in lower case and a text are allowed")
    for key in RESERVED:
        if key not in figures:
            raise ValueError(f"{path}: {key} is missing")
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps(figures, ensure_ascii=False, indent=1, sort_keys=True) + "\n", encoding="utf-8")


def marks(name):
    return f"<!-- {name} -->", f"<!-- end of {name} -->"


def require_place(parser, path, name):
    """Ends the program, before it measures anything, if the document has no place for the table."""
    begin, end = marks(name)
    if not path.is_file() or end not in path.read_text(encoding="utf-8").partition(begin)[2]:
        parser.error(f"{path} has no lines {begin} and {end}")


def put(path, name, text):
    begin, end = marks(name)
    before, _, rest = path.read_text(encoding="utf-8").partition(begin)
    after = rest.partition(end)[2]
    path.write_text(f"{before}{begin}\n{text.rstrip()}\n{end}{after}", encoding="utf-8")


def quote(path, name, figures, about):
    """Writes the figures of one table as NAME.KEY into the document's data/*.json, and keeps those of its other tables.
    @param about the table's date, machine and version"""
    data = path.parent / "data" / f"{path.stem}.json"
    known = json.loads(data.read_text(encoding="utf-8")) if data.exists() else {}
    kept = {key: text for key, text in known.items() if not key.startswith(name + ".")}
    write_figures(data, {**kept, **about, **{f"{name}.{key}": text for key, text in {**figures, **about}.items()}})


def replaced(before, text):
    """The end of `before` put right: a figure of the form of `text`, or a number with or without an error.
    @return None where `before` ends with no figure"""
    form = re.sub(NUMBER, lambda _: NUMBER, re.escape(text).replace("\\-", "-"))
    found = [match for pattern in (form, rf"{NUMBER}(?: ± {NUMBER})?")
             if (match := re.search(rf"{BEGINS}(?:{pattern})$", before))]
    return before[:min(match.start() for match in found)] + text if found else None


def is_released(root):
    return "\nForthcoming\n" not in (root / "CHANGELOG.rst").read_text(encoding="utf-8")


def hold(document, studies, update, old_allowed):
    """Yields an error for each quoted figure that is none or stale, and for each version of the physics that is not
    this checkout's, or later if old ones are allowed; with `update` stale figures are put right."""
    source = document.read_text(encoding="utf-8")
    for match in MEASURED.finditer(source):
        if match.group(1) != physics() and not (old_allowed and int(match.group(1)) < int(physics())):
            line = source.count("\n", 0, match.start()) + 1
            yield f"{document}:{line}: physics version {match.group(1)} is not {physics()}"
    result, end = "", 0
    for match in QUOTED.finditer(source):
        study, key = match.groups()
        before, end = result + source[end:match.start()], match.end()
        place = f"{document}:{source.count(chr(10), 0, match.start()) + 1}: {study}:{key}"
        text = studies.get(study, {}).get(key)
        if text is None:
            yield f"{place}: docs/data/{study}.json has no such key" if study in studies else \
                f"{place}: there is no docs/data/{study}.json"
        elif not re.search(BEGINS + re.escape(text) + "$", before):
            right = replaced(before, text) if update else None
            if right is None:
                yield f"{place} is {text}, the document has {before.splitlines()[-1][-40:].strip()!r}"
            before = right or before
        result = before + match.group()
    if result + source[end:] != source:
        document.write_text(result + source[end:], encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(prog="ratchet_sieve.documents", description=__doc__.splitlines()[0])
    parser.add_argument("--update", action="store_true", help="write the current figures into the documents")
    parser.add_argument("--root", type=pathlib.Path, default=WORK, help="of the package (default: this one)")
    options = parser.parse_args()
    studies = {path.stem: json.loads(path.read_text(encoding="utf-8"))
               for path in (options.root / "docs/data").glob("*.json")}
    documents = sorted({path for pattern in DOCUMENTS for path in options.root.glob(pattern)})
    old_allowed = not is_released(options.root)
    errors = [error for document in documents for error in hold(document, studies, options.update, old_allowed)]
    for error in errors:
        print(error, file=sys.stderr)
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main())
