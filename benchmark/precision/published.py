"""The table of other programs that compare_peers.py has put into docs/performance.md: measured there, read here."""
import dataclasses
import re

import document

MM = 1e-3  # m
TITLES = {"Chipmunk": "chipmunk", "Box2D": "box2d", "LAMMPS": "lammps"}


@dataclasses.dataclass
class Row:
    program: str
    title: str
    cost: float    # processor s per simulated s
    drifts: list   # of A and B, with their standard errors [m/s]
    lost: bool


@dataclasses.dataclass
class Peers:
    reference: list  # drifts of this project, as the others have it: without tangential restitution [m/s]
    rows: list


def drift(cell):
    value, error = cell.split("±")
    return float(value) * MM, float(error) * MM


def read(path):
    """@return None where the document has no such table"""
    begin, end = document.marks("peers")
    text = path.read_text(encoding="utf-8").partition(begin)[2].partition(end)[0]
    reference, rows = None, []
    for line in text.splitlines():
        cells = [cell.strip() for cell in line.strip("| ").split("|")]
        if len(cells) != 8 or "±" not in cells[4]:
            continue
        drifts = [drift(cells[4]), drift(cells[5])]
        if "β = 0" in cells[0]:
            reference = drifts
        program = TITLES.get(re.split(r"[ ,]", cells[0])[0])
        if program:
            rows.append(Row(program, cells[0], float(cells[1]), drifts, cells[6] != "0"))
    rows.sort(key=lambda row: row.cost)
    return Peers(reference, rows) if reference and rows else None
