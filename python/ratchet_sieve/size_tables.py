"""Sieve analyses as laboratories send them."""
from __future__ import annotations

import csv
import dataclasses
import os
import re
import sys
from typing import Any, Iterator, NoReturn, Optional, Union

MILLI, MICRO = 1e-3, 1e-6
SUM = 2.0        # by which percentages may miss 100
AGREEMENT = 1.0  # of the columns of one table [percentage points]
DIGITS = 12      # of lengths [m]: a picometre
LARGEST = 1e12   # number of a table
LARGEST_FILE = 1 << 20  # [bytes]

# Names of columns, in German and English, in lower case.
MESH = r"maschen|sieb(weite|größe|groesse|öffnung)|lochweite|korngr|partikelgr|mesh|sieve|sieb\b|aperture|opening|" \
       r"(particle|grain) size"
PASSING = r"durchgang|durchlauf|unterkorn|pass|finer|undersize"
CUMULATIVE = r"summe|summiert|kum|cum"
RETAINED = r"r(ü|ue)ckst(a|ä|ae)nd|auswaage|masse|gew(icht|\.)|anteil|retained|mass\b|weight|fraction"
OTHER = r"leer|tara|tare|empty|brutto|gross|voll\b|full|\+|einwaage|loss|verlust"  # beside what is retained
PAN = r"boden|schale|pan\b|bottom|receiver|auffang"
END = r"summe|gesamt|total|sum\b|verlust|loss|einwaage|\bd_?\d\d"
LENGTHS = {"mm": MILLI, "µm": MICRO, "μm": MICRO, "um": MICRO, "micron": MICRO, "microns": MICRO}
LENGTH = r"(?<![a-zµμ])(mm|µm|μm|um|microns?)(?![a-z])"
UNIT_OF_AMOUNT = r"%|percent|prozent|(?<![a-z])(g|kg|mg)(?![a-z])"
UNITS = rf"[\[(]?({LENGTH}|(\w{{1,5}}[.-]+ ?)?({UNIT_OF_AMOUNT})|-|)[\])]?"  # cells of a line of units
NUMBER = r"[0-9][0-9.,]*|[.,][0-9]+"


class SizeTable(dict):
    """What `species.N.size` takes; `understood` is the line that says what was read."""

    understood: str


def size_table(path: Union[str, os.PathLike], *, column: Optional[str] = None, smallest: Optional[float] = None,
               largest: Optional[float] = None) -> SizeTable:
    """The sizes of a sieve analysis, from the text that a laboratory sends: {distribution: table, radii, weights,
    by: mass}. Says on stderr what it understood.

    path      of a table: semicolons, tabs or commas between its cells, decimal commas or points, UTF-8, UTF-16 or
              Latin-1, lines of any text before. A column of mesh widths in mm or µm, which are diameters, and one or more
              of what each mesh retains (g, %), of that summed up, or of what passes (%), named so in German or English.
              Several columns must agree
    column    the name of the one to read, where they do not
    smallest  diameter of the smallest grain in the pan [m]; None: what passes the finest mesh is as wide as that
    largest   diameter of the largest grain [m], where the widest mesh retains some
    Raises ValueError for what is not clear, with the column; OSError.
    """
    return _Analysis(os.fspath(path), column).table(smallest, largest)


@dataclasses.dataclass
class _Column:
    index: int
    name: str
    kind: Optional[str]  # retained, cumulative or passing; None: not clear
    unit: Optional[str]  # % or g; None: not said


@dataclasses.dataclass
class _Row:
    line: int
    width: float            # [m]; 0: the pan
    upper: Optional[float]  # of a class [m]
    cells: list[str]


class _Analysis:
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
            raise ValueError(f'{path}: no line with the name of a column of mesh widths, such as "Maschenweite [mm]" or '
                             '"Sieve size (mm)", and that of ' +
                             (f'"{wanted}"' if wanted else 'one of what they retain or what passes'))
        self.comma = self._has_commas(start)
        self.rows = sorted(self._rows(start), key=lambda row: row.width)
        self._require_rows()

    @property
    def has_pan(self) -> bool:
        return self.rows[0].width == 0.0

    def _refuse(self, name: str, reason: str, line: Optional[int] = None) -> NoReturn:
        raise ValueError(f'{self.path}{f":{line}" if line else ""}: column "{name}": {reason}')

    def _header(self, wanted: Optional[str]) -> Optional[int]:
        """Finds the names of the columns. @return the number of the line after them"""
        for k, line in enumerate(self.lines):
            below = self.lines[k + 1] if k + 1 < len(self.lines) else []
            units = any(below) and all(re.fullmatch(UNITS, cell.strip().lower()) for cell in below)
            names = [" ".join(f"{name} {below[i] if units and i < len(below) else ''}".split())
                     for i, name in enumerate(line)]
            meshes = [i for i, name in enumerate(names) if re.search(MESH, name.lower()) and not _is_amount(name)]
            others = [_Column(i, name, *_meaning(name)) for i, name in enumerate(names)
                      if i not in meshes and name and (_is_amount(name) or name == wanted)]
            if wanted is not None:
                others = [other for other in others if other.name == wanted]
            with_unit = [i for i in meshes if re.search(LENGTH, names[i].lower())]
            if others and len(with_unit) > 1:
                self._refuse(names[with_unit[1]], f'is one of mesh widths, as "{names[with_unit[0]]}": which is meant?')
            if meshes and others:
                self.mesh, self.columns, self.width = (with_unit or meshes)[0], others, len(names)
                self.mesh_name = names[self.mesh]
                return k + 1 + units
        return None

    def _has_commas(self, start: int) -> bool:
        """Whether commas are decimal ones."""
        cells = [cell for line in self.lines[start:] for cell in line]
        return any(re.search(r"[0-9],[0-9]", cell) for cell in cells) and not (
            any(re.search(r"[0-9],[0-9]{3}\.[0-9]", cell) for cell in cells))

    def _rows(self, start: int) -> Iterator[_Row]:
        begun = False
        for number, line in enumerate(self.lines[start:], start + 1):
            cells = [cell.strip() for cell in line]
            if not any(cells):
                if begun:
                    return
                continue
            first = next(filter(None, cells)).lower()
            mesh = cells[self.mesh].lower() if self.mesh < len(cells) else ""
            if re.search(END, first):
                return
            if len(cells) > self.width and any(cells[self.width:]):
                self._refuse(self.mesh_name, f"its line has {len(cells)} cells, that of the names has {self.width}", number)
            begun = True
            yield _Row(number, *self._class(number, mesh or first), cells + [""] * (self.width - len(cells)))

    def _class(self, number: int, cell: str) -> tuple[float, Optional[float]]:
        """@return the mesh width [m], 0: the pan; the width of the next wider mesh [m], where the row has it"""
        match = re.fullmatch(rf"([<>≥≤]?)\s*({NUMBER})\s*(?:[-–]\s*({NUMBER})\s*)?({LENGTH})?", cell)
        if re.search(PAN, cell) or match and match[1] and match[1] in "<≤":
            return 0.0, None
        if not match:
            self._refuse(self.mesh_name, f'"{cell}" is no mesh width, pan or sum', number)
        unit = match[4] or next(iter(re.findall(LENGTH, self.mesh_name.lower())), None)
        if unit is None:
            self._refuse(self.mesh_name, "has no unit: must be mm or µm")
        ends = sorted(round(LENGTHS[unit] * self._number(number, self.mesh_name, text), DIGITS)
                      for text in (match[2], match[3]) if text)
        return ends[0], ends[1] if len(ends) > 1 else None

    def _number(self, line: int, name: str, text: str) -> float:
        """Of decimal commas and of points only one sort is clear, but for 1.234,5 and 1,234.5."""
        decimal, thousands = (",", r"\.") if self.comma else (r"\.", ",")
        whole = rf"[0-9]*|[0-9]{{1,3}}({thousands}[0-9]{{3}})+(?={decimal})"
        if not re.fullmatch(rf"({whole})({decimal}[0-9]*)?", text) or not re.search("[0-9]", text):
            self._refuse(name, f'"{text}" is no number from 0 on with decimal {"commas" if self.comma else "points"}, as '
                               "the others are", line)
        value = float(text.replace("." if self.comma else ",", "").replace(",", "."))
        if value > LARGEST:
            self._refuse(name, f"{text[:20]}... is too large", line)
        return value

    def _require_rows(self) -> None:
        if sum(row.width > 0.0 for row in self.rows) < 2:
            self._refuse(self.mesh_name, "must have two mesh widths or more")
        for row, wider in zip(self.rows, self.rows[1:]):
            if row.width == wider.width:
                self._refuse(self.mesh_name, f"{1e3 * row.width:g} mm is there twice" if row.width else
                             "the pan is there twice", wider.line)
            if row.upper is not None and row.upper != wider.width:
                self._refuse(self.mesh_name, f"the class up to {1e3 * row.upper:g} mm does not end where the next one, "
                                             f"from {1e3 * wider.width:g} mm, begins", row.line)

    def _shares(self, column: _Column) -> list[float]:
        """Of all the mass what each mesh retains, from the finest on, after what is in the pan [%]."""
        if column.kind is None:
            self._refuse(column.name, "is it what each mesh retains, that summed up (cumulative), or what passes?")
        if column.unit is None:
            self._refuse(column.name, "has no unit: must be g or %")
        values = [self._amount(column, row) for row in self.rows]
        pan = values.pop(0) if self.has_pan else None
        if column.kind == "retained":
            shares = [pan or 0.0, *values]
            if column.unit == "%" and abs(sum(shares) - 100.0) > SUM:
                self._refuse(column.name, f"sums to {sum(shares):.4g} %: must be 100; is the pan missing, or are they "
                                          "cumulative?")
        elif column.unit != "%" and (column.kind == "passing" or pan is None):
            self._refuse(column.name, "must be in %, or nothing says what the whole is")
        else:
            whole = 100.0 if column.unit == "%" or pan is None else pan
            beyond = values if column.kind == "cumulative" else [whole - value for value in values]
            steps = [whole, *beyond, 0.0]
            shares = [before - after for before, after in zip(steps, steps[1:])]
        if min(shares) < -1e-4 * sum(shares) or sum(shares) <= 0.0:
            self._refuse(column.name, f"must {'fall' if column.kind == 'passing' else 'grow'} from mesh to finer mesh"
                         if column.kind != "retained" else "retains nothing")
        shares = [max(share, 0.0) for share in shares]
        return [100.0 * share / sum(shares) for share in shares]

    def _amount(self, column: _Column, row: _Row) -> float:
        text = re.sub(UNIT_OF_AMOUNT, "", row.cells[column.index].lower()).strip()
        if text in ("", "-", "–") and row.width == 0.0:
            return 0.0
        if not text:
            self._refuse(column.name, f"has no value at {1e3 * row.width:g} mm", row.line)
        return self._number(row.line, column.name, text)

    def _agreed(self) -> tuple[list[float], _Column, list[str]]:
        """@return shares, the column that they are from, and the names of those that agree"""
        clear = [column for column in self.columns if column.kind and column.unit]
        order = ["retained", "cumulative", "passing"]
        clear = sorted(clear or self.columns, key=lambda column: (column.unit != "g", order.index(column.kind or order[0])))
        found = [self._shares(column) for column in clear]
        for column, shares in zip(clear[1:], found[1:]):
            apart = max(abs(a - b) for a, b in zip(found[0], shares))
            if apart > AGREEMENT:
                self._refuse(column.name, f'differs from "{clear[0].name}" by {apart:.3g} % of the mass: which is meant '
                                          "(column=)?")
        return found[0], clear[0], [column.name for column in clear[1:]]

    def table(self, smallest: Optional[float], largest: Optional[float]) -> SizeTable:
        shares, column, others = self._agreed()
        widths = [row.width for row in self.rows if row.width > 0.0]
        pan, meshes = shares[0], len(widths)
        largest = self.rows[-1].upper if largest is None else largest
        if largest is None and shares[-1] > 0.0:
            self._refuse(column.name, f"{shares[-1]:.3g} % do not pass the widest mesh, {1e3 * widths[-1]:g} mm: how large "
                                      "are they (largest=)?")
        for name, given, wrong in (("smallest", smallest, smallest is not None and not 0.0 < smallest < widths[0]),
                                   ("largest", largest, largest is not None and not largest > widths[-1])):
            if wrong:
                raise ValueError(f"{name} = {given!r}: must be a diameter [m] beyond the meshes, {widths[0]:g} to "
                                 f"{widths[-1]:g} m")
        if smallest is not None:
            widths, shares = [smallest, *widths], [0.0, *shares]
        if largest is not None:
            widths.append(largest)
        else:
            shares.pop()
        while shares[-1] == 0.0:
            del shares[-1], widths[-1]
        while shares[0] == shares[1] == 0.0:
            del shares[0], widths[0]
        sizes = SizeTable(distribution="table", radii=[round(0.5 * width, DIGITS) for width in widths],
                          weights=[round(share, 6) for share in shares], by="mass")
        sizes.understood = (f'{self.path}: {meshes} meshes, "{self.mesh_name}"; {_KINDS[column.kind]} from "{column.name}"'
                            + (f", as {_names(others)} say{'s' * (len(others) == 1)}" if others else "")
                            + f"; diameters {1e3 * widths[0]:g} to {1e3 * widths[-1]:g} mm"
                            + (f"; {pan:.3g} % pass the finest mesh and are taken to be as wide as it"
                               if pan and smallest is None else "") + ("" if self.has_pan else "; there is no pan"))
        print(sizes.understood, file=sys.stderr)
        return sizes


_KINDS: dict[Any, str] = {"retained": "what each mesh retains", "cumulative": "what the meshes retain, summed up,",
                          "passing": "what passes"}


def _names(names: list[str]) -> str:
    return " and ".join(f'"{name}"' for name in names)


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
