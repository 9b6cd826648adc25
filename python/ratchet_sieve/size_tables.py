"""Sieve analyses as laboratories send them."""
from __future__ import annotations

import os
import sys
from typing import Optional, Union

from .arguments import number
from .lab_table import DIGITS, Column, LabTable

SUM = 2.0        # by which percentages may miss 100
AGREEMENT = 1.0  # of the columns of one table [percentage points]
KINDS = {"retained": "what each mesh retains", "cumulative": "what the meshes retain, summed up,",
         "passing": "what passes"}


class SizeTable(dict):
    """What `species.N.size` takes; `understood` is the line that says what was read."""

    understood: str


def size_table(path: Union[str, os.PathLike], *, column: Optional[str] = None, smallest: Optional[float] = None,
               largest: Optional[float] = None) -> SizeTable:
    """The sizes of a sieve analysis, from the text that a laboratory sends: {distribution: table, radii, weights,
    by: mass}. Says on stderr what it understood.

    path      of a table: semicolons, tabs or commas between its cells, decimal commas or points, UTF-8, UTF-16 or
              Latin-1, lines of any text before. A column of mesh widths in mm or µm, which are diameters, and one or
              more of what each mesh retains (g, %), of that summed up, or of what passes (%), named so in German or
              English. Several columns must agree
    column    the name of the one to read, where they do not
    smallest  diameter of the smallest grain in the pan [m]; None: what passes the finest mesh is as wide as that
    largest   diameter of the largest grain [m], where the widest mesh retains some
    Raises ValueError for what is not clear, with the column; OSError.
    """
    return _sizes(LabTable(os.fspath(path), column), smallest, largest)


def _shares(table: LabTable, column: Column) -> list[float]:
    """Of all the mass what each mesh retains, from the finest on, after what is in the pan [%]."""
    if column.kind is None:
        table.refuse(column.name, "is it what each mesh retains, that summed up (cumulative), or what passes?")
    if column.unit is None:
        table.refuse(column.name, "has no unit: must be g or %")
    values = [table.amount(column, row) for row in table.rows]
    pan = values.pop(0) if table.has_pan else None
    if column.kind == "retained":
        shares = [pan or 0.0, *values]
        if column.unit == "%" and abs(sum(shares) - 100.0) > SUM:
            table.refuse(column.name, f"sums to {sum(shares):.4g} %: must be 100; is the pan missing, or are they "
                                      "cumulative?")
    elif column.unit != "%" and (column.kind == "passing" or pan is None):
        table.refuse(column.name, "must be in %, or nothing says what the whole is")
    else:
        whole = 100.0 if column.unit == "%" or pan is None else pan
        beyond = values if column.kind == "cumulative" else [whole - value for value in values]
        steps = [whole, *beyond, 0.0]
        shares = [before - after for before, after in zip(steps, steps[1:])]
    if min(shares) < -1e-4 * sum(shares) or sum(shares) <= 0.0:
        table.refuse(column.name, f"must {'fall' if column.kind == 'passing' else 'grow'} from mesh to finer mesh"
                     if column.kind != "retained" else "retains nothing")
    shares = [max(share, 0.0) for share in shares]
    return [100.0 * share / sum(shares) for share in shares]


def _agreed(table: LabTable) -> tuple[list[float], Column, list[str]]:
    """@return shares, the column that they are from, and the names of those that agree"""
    clear = [column for column in table.columns if column.kind and column.unit] or table.columns
    clear = sorted(clear, key=lambda column: (column.unit != "g", list(KINDS).index(column.kind or "retained")))
    found = [_shares(table, column) for column in clear]
    for column, shares in zip(clear[1:], found[1:]):
        apart = max(abs(a - b) for a, b in zip(found[0], shares))
        if apart > AGREEMENT:
            table.refuse(column.name, f'differs from "{clear[0].name}" by {apart:.3g} % of the mass: which is '
                                      "meant (column=)?")
    return found[0], clear[0], [column.name for column in clear[1:]]


def _sizes(table: LabTable, smallest: Optional[float], largest: Optional[float]) -> SizeTable:
    shares, column, others = _agreed(table)
    widths = [row.width for row in table.rows if row.width > 0.0]
    pan, meshes = shares[0], len(widths)
    largest = table.rows[-1].upper if largest is None else largest
    if largest is None and shares[-1] > 0.0:
        table.refuse(column.name, f"{shares[-1]:.3g} % do not pass the widest mesh, {1e3 * widths[-1]:g} mm: how "
                                  "large are they (largest=)?")
    if smallest is None and not any(shares[1:]):
        table.refuse(column.name, f"all pass the finest mesh, {1e3 * widths[0]:g} mm: how small are they (smallest=)?")
    ends = [(name, number(name, given, unit="m")) for name, given in (("smallest", smallest), ("largest", largest))
            if given is not None]
    for name, given in ends:
        if not (0.0 < given < widths[0] if name == "smallest" else given > widths[-1]):
            raise ValueError(f"{name} = {given:g}: must be a diameter [m] beyond the meshes, {widths[0]:g} to "
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
    said = [f'{table.path}: {meshes} meshes, "{table.mesh_name}"', f'{KINDS[column.kind]} from "{column.name}"',
            f"diameters {1e3 * widths[0]:g} to {1e3 * widths[-1]:g} mm"]
    if others:
        said[1] += f", as {_names(others)} say{'s' * (len(others) == 1)}"
    if pan and smallest is None:
        said.append(f"{pan:.3g} % pass the finest mesh and are taken to be as wide as it")
    if column.kind == "retained" and not table.has_pan:
        said.append("there is no pan")
    sizes.understood = "; ".join(said)
    print(sizes.understood, file=sys.stderr)
    return sizes


def _names(names: list[str]) -> str:
    return " and ".join(f'"{name}"' for name in names)
