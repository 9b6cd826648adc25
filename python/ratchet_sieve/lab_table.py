"""The table of a sieve analysis in a text that a laboratory sends."""
from __future__ import annotations

import csv
import dataclasses
import re
from typing import Iterator, NoReturn, Optional

MILLI, MICRO = 1e-3, 1e-6
DIGITS = 12      # of lengths [m]: a picometre
LARGEST = 1e12   # number of a table
LARGEST_FILE = 1 << 20  # [bytes]

# Names of columns, in German and English, in lower case.
MESH = r"maschen|sieb(weite|größe|groesse|öffnung)|lochweite|korngr|partikelgr|mesh|sieve|sieb\b|aperture|opening|" \
       r"(particle|grain) size"
PASSING = r"durchgang|durchlauf|unterkorn|pass|finer|undersize"
CUMULATIVE = r"summe|summiert|kum|cum"
RETAINED = r"r(ü|ue)ckst(a|ä|ae)nd|auswaage|masse|gew(icht|\.)|anteil|retained|mass\b|weight|fraction"
OTHER = r"leer|tara|tare|empty|brutto|gross|voll\b|full|\+|einwaage|loss|verlust|sieb(gewicht|masse)|" \
        r"sieve (weight|mass)|(weight|mass) of (the )?sieve"  # beside what is retained
MEAN = r"mitt(el|ler)|mean|median|average|nr\b|\bno\b|number|nummer|#"  # of a class, or a sieve's number
PAN = r"boden|schale|pan\b|bottom|receiver|auffang"
END = r"summe|gesamt|total|sum\b|verlust|loss|einwaage|\bd_?\d\d"
LENGTHS = {"mm": MILLI, "µm": MICRO, "μm": MICRO, "um": MICRO, "micron": MICRO, "microns": MICRO}
LENGTH = r"(?<![a-zµμ])(mm|µm|μm|um|microns?)(?![a-z])"
UNIT_OF_AMOUNT = r"%|percent|prozent|(?<![a-z])(g|kg|mg)(?![a-z])"
UNITS = rf"[\[(]?({LENGTH}|(\w{{1,5}}[.-]+ ?)?({UNIT_OF_AMOUNT})|-|)[\])]?"  # cells of a line of units
NUMBER = r"[0-9][0-9.,]*|[.,][0-9]+"


@dataclasses.dataclass
class Column:
    index: int
    name: str
    kind: Optional[str]  # retained, cumulative or passing; None: not clear
    unit: Optional[str]  # % or g; None: not said


@dataclasses.dataclass
class Row:
    line: int
    width: float            # [m]; 0: the pan
    upper: Optional[float]  # of a class [m]
    cells: list[str]


class LabTable:
    """The columns of amounts, and the rows by their mesh widths, the finest first."""

    def __init__(self, path: str, wanted: Optional[str]) -> None:
        self.path = path
        text = _text(path)
        for delimiter in ";\t,":
            try:
                self.lines = list(csv.reader(text.splitlines(), delimiter=delimiter, skipinitialspace=True))
            except csv.Error as error:
                raise ValueError(f"{path}: is no table: {error}") from None
            start = self._header(wanted)
            if start is not None:
                break
        else:
            raise ValueError(f'{path}: no line with the name of a column of mesh widths, such as "Maschenweite [mm]" '
                             'or "Sieve size (mm)", and that of ' +
                             (f'"{wanted}"' if wanted else 'one of what they retain or what passes'))
        self.comma = self._has_commas(start)
        self.rows = sorted(self._rows(start), key=lambda row: row.width)
        self._require_rows()

    @property
    def has_pan(self) -> bool:
        return self.rows[0].width == 0.0

    def refuse(self, name: str, reason: str, line: Optional[int] = None) -> NoReturn:
        raise ValueError(f'{self.path}{f":{line}" if line else ""}: column "{name}": {reason}')

    def _header(self, wanted: Optional[str]) -> Optional[int]:
        """Finds the names of the columns. @return the number of the line after them"""
        for k, line in enumerate(self.lines):
            below = self.lines[k + 1] if k + 1 < len(self.lines) else []
            units = any(below) and all(re.fullmatch(UNITS, cell.strip().lower()) for cell in below)
            names = [" ".join(f"{name} {below[i] if units and i < len(below) else ''}".split())
                     for i, name in enumerate(line)]
            likely = [0 if _is_amount(name) or re.search(MEAN, name.lower()) else
                      bool(re.search(MESH, name.lower())) + 2 * bool(re.search(LENGTH, name.lower())) for name in names]
            meshes = [i for i, score in enumerate(likely) if score and score == max(likely)]
            others = [Column(i, name, *_meaning(name)) for i, name in enumerate(names)
                      if name and (_is_amount(name) or name == wanted)]
            if wanted is not None:
                others = [other for other in others if other.name == wanted]
            if others and len(meshes) > 1:
                self.refuse(names[meshes[1]], f'is one of mesh widths, as "{names[meshes[0]]}": which is meant?')
            if meshes and others:
                self.mesh, self.columns, self.width = meshes[0], others, len(names)
                self.mesh_name = names[self.mesh]
                return k + 1 + units
        return None

    def _has_commas(self, start: int) -> bool:
        """Whether commas are decimal ones."""
        cells = [cell for line in self.lines[start:] for cell in line]
        return any(re.search(r"[0-9],[0-9]", cell) for cell in cells) and not (
            any(re.search(r"[0-9],[0-9]{3}\.[0-9]", cell) for cell in cells))

    def _rows(self, start: int) -> Iterator[Row]:
        begun = False
        for at, line in enumerate(self.lines[start:], start + 1):
            cells = [cell.strip() for cell in line]
            if not any(cells):
                if begun:
                    return
                continue
            first = next(filter(None, cells)).lower()
            cells += [""] * (self.width - len(cells))
            mesh = first if re.search(PAN, first) else cells[self.mesh].lower() or first
            is_text = not re.search(f"{PAN}|[0-9]", mesh) and not any(cells[c.index] for c in self.columns)
            if re.search(END, first) or begun and is_text:
                return
            if any(cells[self.width:]):
                self.refuse(self.mesh_name, f"its line has {len(cells)} cells, that of the names has {self.width}",
                             at)
            begun = True
            yield Row(at, *self._class(at, mesh), cells)

    def _class(self, line: int, cell: str) -> tuple[float, Optional[float]]:
        """@return the mesh width [m], 0: the pan; the width of the next wider mesh [m], where the row has it"""
        match = re.fullmatch(rf"([<>≥≤]?)\s*({NUMBER})\s*(?:[-–]\s*({NUMBER})\s*)?({LENGTH})?", cell)
        if re.search(PAN, cell) or match and match[1] and match[1] in "<≤":
            return 0.0, None
        if not match:
            self.refuse(self.mesh_name, f'"{cell}" is no mesh width, pan or sum', line)
        unit = match[4] or next(iter(re.findall(LENGTH, self.mesh_name.lower())), None)
        if unit is None:
            self.refuse(self.mesh_name, "has no unit: must be mm or µm")
        ends = sorted(round(LENGTHS[unit] * self._number(line, self.mesh_name, text), DIGITS)
                      for text in (match[2], match[3]) if text)
        return ends[0], ends[1] if len(ends) > 1 else None

    def _number(self, line: int, name: str, text: str) -> float:
        """Of decimal commas and of points only one sort is clear, but for 1.234,5 and 1,234.5."""
        decimal, thousands = (",", r"\.") if self.comma else (r"\.", ",")
        whole = rf"[0-9]*|[0-9]{{1,3}}({thousands}[0-9]{{3}})+(?={decimal})"
        if not re.fullmatch(rf"({whole})({decimal}[0-9]*)?", text) or not re.search("[0-9]", text):
            self.refuse(name, f'"{text}" is no number from 0 on with decimal {"commas" if self.comma else "points"}, '
                               "as the others are", line)
        value = float(text.replace("." if self.comma else ",", "").replace(",", "."))
        if value > LARGEST:
            self.refuse(name, f"{text[:20]}... is too large", line)
        return value

    def _require_rows(self) -> None:
        if sum(row.width > 0.0 for row in self.rows) < 2:
            self.refuse(self.mesh_name, "must have two mesh widths or more")
        for row, wider in zip(self.rows, self.rows[1:]):
            if row.width == wider.width:
                self.refuse(self.mesh_name, f"{1e3 * row.width:g} mm is there twice" if row.width else
                             "the pan is there twice", wider.line)
            if row.upper is not None and row.upper != wider.width:
                self.refuse(self.mesh_name, f"the class up to {1e3 * row.upper:g} mm does not end where the next one, "
                                             f"from {1e3 * wider.width:g} mm, begins", row.line)

    def amount(self, column: Column, row: Row) -> float:
        text = re.sub(UNIT_OF_AMOUNT, "", row.cells[column.index].lower()).strip()
        if text in ("", "-", "–") and row.width == 0.0:
            return 0.0
        if not text:
            self.refuse(column.name, f"has no value at {1e3 * row.width:g} mm", row.line)
        return self._number(row.line, column.name, text)

def _is_amount(name: str) -> bool:
    """Whether a column tells of what is retained or passes, by its name or its unit."""
    name = name.lower()
    said = re.search(f"{PASSING}|{CUMULATIVE}|{RETAINED}|{UNIT_OF_AMOUNT}", name)
    return bool(said) and not re.search(OTHER, name) and not re.search(LENGTH, name)


def _meaning(name: str) -> tuple[Optional[str], Optional[str]]:
    """@return the kind and the unit of a column"""
    name = name.lower()
    found = re.search(UNIT_OF_AMOUNT, name)
    unit = "%" if found and found[0] in ("%", "percent", "prozent") else "g" if found else None
    for kind, words in (("passing", PASSING), ("cumulative", CUMULATIVE), ("retained", RETAINED)):
        if re.search(words, name):
            return kind, unit
    return "retained" if unit == "g" else None, unit


def _text(path: str) -> str:
    """Raises ValueError for a file that is no text."""
    with open(path, "rb") as file:
        data = file.read(LARGEST_FILE + 1)
    if len(data) > LARGEST_FILE:
        raise ValueError(f"{path}: is larger than any sieve analysis: must have at most {LARGEST_FILE} bytes")
    for mark, encoding in ((b"\xff\xfe", "utf-16"), (b"\xfe\xff", "utf-16"), (b"\xef\xbb\xbf", "utf-8-sig")):
        if data.startswith(mark):
            return data.decode(encoding, "replace")
    if b"\0" in data:
        raise ValueError(f"{path}: is no text: save the table as CSV")
    try:
        return data.decode("utf-8")
    except UnicodeDecodeError:
        return data.decode("cp1252", "replace")
