"""What was measured of a feeder, at some settings, and what a run says of the same."""
from __future__ import annotations

import dataclasses
import math
import os
import re
import warnings
from typing import Any, Optional

import numpy as np
import pandas

from ratchet_sieve.arguments import number
from ratchet_sieve.bags import read_bins
from ratchet_sieve.errors import SceneError
from ratchet_sieve.texts import counted
from ratchet_sieve.values import OF_SPECIES, unit_of

PLACES = {"left": "the share of {} that left to the left", "right": "", "on_base": "the share of {} still on the deck"}
STDERR = ".stderr"  # ending of a column with the standard error of another one
OBSERVED = ("height_profile", "mass_flow", "residence_times")
EXAMPLE = '[{"base.inclination": 0.1, "left.A": 310, "right.A": 480, "on_base.A": 12}]'


@dataclasses.dataclass(frozen=True)
class Number:
    """One number that was measured.

    row       of its setting
    name      a column of results; or left.A and on_base.A, the shares of A that left to the left and are on the deck
    value     as measured
    variance  of a share that of independent grains, else its own; None: as that of one run
    """

    row: int
    name: str
    value: float
    variance: Optional[float]

    @property
    def is_share(self) -> bool:
        return _is_count(self.name)

    def __str__(self) -> str:
        place, _, species = self.name.partition(".")
        return PLACES[place].format(species) if self.is_share else self.name

    def of(self, rows: pandas.DataFrame) -> tuple[np.ndarray, np.ndarray]:
        """What runs say of it. @return values, NaN where undefined, and variances, of shares alone, else 1"""
        if not self.is_share:
            values = rows[self.name] if self.name in rows else np.full(len(rows), np.nan)
            return np.asarray(values, dtype=float), np.ones(len(rows))
        place, _, species = self.name.partition(".")
        left, right, count = (rows[f"{name}.{species}"].to_numpy(float) for name in ("left", "right", "count"))
        return _share(left, left + right) if place == "left" else _share(count - left - right, count)


class Measured:
    """@ivar settings of each row: keys of the scene @ivar numbers all that was measured"""

    def __init__(self, scene: Any, measured: Any, unknown: list[str]):
        """@param measured path of a CSV file or of a bag, a list of bags or of mappings, or a DataFrame
        @param unknown keys that no row may set. Raises ValueError, SceneError, OSError, BagError."""
        self.settings, self.numbers = [], []
        for k, row in enumerate(_rows(measured, unknown)):
            name = f"measured, row {k + 1}"
            self.settings.append({key: value for key, value in row.items() if not _is_result(key)})
            for key in self.settings[k]:
                if key in (*unknown, "seed"):
                    raise ValueError(f"{name}: {key}: must not be set: " +
                                     ("each run has its own" if key == "seed" else "it is unknown"))
            try:
                scene.replace(self.settings[k])
            except SceneError as error:
                raise ValueError(f"{name}: neither a number of results nor a setting: {error}") from None
            cells = {key: value for key, value in row.items() if _is_result(key)}
            self.numbers += _numbers(k, name, cells, scene.species)

    @property
    def observed(self) -> set[str]:
        """What a scene must observe that the runs have these numbers."""
        return {each.name.partition(".")[0] for each in self.numbers} & set(OBSERVED)

    def __str__(self) -> str:
        """What was understood."""
        names = dict.fromkeys(map(str, self.numbers))
        return f"measured at {counted(len(self.settings), 'setting')}, {counted(len(self.numbers), 'number')}: " \
               f"{'; '.join(names)}"


def _share(part: Any, whole: Any) -> tuple[Any, Any]:
    """@return the share and its variance of independent grains, with half a grain more on either side"""
    with np.errstate(divide="ignore", invalid="ignore"):
        smoothed = (part + 0.5) / (whole + 1.0)
        return part / whole, smoothed * (1.0 - smoothed) / whole


def _is_count(key: str) -> bool:
    return key.partition(".")[0] in PLACES


def _is_result(key: str) -> bool:
    return _is_count(key) or key.endswith(STDERR) or key != "seed" and unit_of(key) is not None


def _numbers(row: int, name: str, cells: dict, species: list[str]) -> list[Number]:
    """@param cells of results. Raises ValueError."""
    for key, value in cells.items():
        place, _, kind = key.partition(".")
        if (place in PLACES or place in OF_SPECIES) and not any(f"{kind}.".startswith(f"{each}.") for each in species):
            raise ValueError(f"{name}: {key}: there is no such species; there are {', '.join(species)}")
        if number(f"{name}: {key}", value, 0.0 if _is_count(key) else -math.inf) <= 0.0 and key.endswith(STDERR):
            raise ValueError(f"{name}: {key} = {value}: must be above 0")
    found = []
    for kind in species:
        left, right, deck = (cells.get(f"{place}.{kind}") for place in PLACES)
        if left is right is deck is None:
            continue
        if left is None or right is None:
            raise ValueError(f"{name}: left.{kind} and right.{kind} must be given, both")
        for place, part, whole in (("left", left, left + right), ("on_base", deck, left + right + (deck or 0))):
            if whole == 0 and not deck:
                raise ValueError(f"{name}: no {kind} was counted")
            if part is not None and whole > 0:
                found.append(Number(row, f"{place}.{kind}", *map(float, _share(part, whole))))
    for key, value in cells.items():
        if not _is_count(key) and not key.endswith(STDERR):
            error = cells.get(key + STDERR)
            found.append(Number(row, key, float(value), None if error is None else error ** 2))
    if not found:
        raise ValueError(f"{name}: nothing was measured: give counts, such as left.{species[0]}, right.{species[0]}")
    return found


def _rows(measured: Any, unknown: list[str]) -> list[dict]:
    """Of a bag without what is unknown: its base has what was commanded. Raises ValueError, OSError, BagError."""
    if isinstance(measured, (str, os.PathLike)):
        measured = [measured] if os.fspath(measured).endswith(".bag") else _table(measured)
    if isinstance(measured, pandas.DataFrame):
        if any(name is not None for name in measured.index.names):  # as of groupby() and set_index()
            measured = measured.reset_index()
        measured = measured.astype(object).to_dict("records")
    if not isinstance(measured, (list, tuple)) or not len(measured):
        raise ValueError(f"measured = {measured!r}: must be the path of a CSV file or a bag, or rows such as {EXAMPLE}")
    rows = [{key: value for key, value in read_bins(os.fspath(row)).items() if key not in unknown}
            if isinstance(row, (str, os.PathLike)) else row for row in measured]
    for k, row in enumerate(rows):
        if not isinstance(row, dict):
            raise ValueError(f"measured[{k}] = {row!r}: must be a mapping, such as {EXAMPLE[1:-1]}")
        for key in row:
            if not isinstance(key, str):
                raise ValueError(f"measured, row {k + 1}: {key!r}: must be the name of a column, such as left.A")
    return [{re.sub("^mean_vx_stderr(.*)", rf"mean_vx\1{STDERR}", key): value for key, value in row.items()
             if value is not None and value == value} for row in rows]


def _table(path: Any) -> pandas.DataFrame:
    """With semicolons between its cells numbers have decimal commas. Raises ValueError, OSError."""
    try:
        with open(path, encoding="utf-8-sig") as file:
            form = {"sep": ";", "decimal": ","} if ";" in file.readline() else {}
        with warnings.catch_warnings():
            warnings.simplefilter("error", pandas.errors.ParserWarning)  # of cells beyond the names of columns
            return pandas.read_csv(path, skipinitialspace=True, index_col=False, encoding="utf-8-sig", **form)
    except pandas.errors.ParserWarning:
        raise ValueError(f"measured = {os.fspath(path)!r}: no table: a line has more cells than there are names of "
                         "columns; decimal commas need semicolons between the cells") from None
    except ValueError as error:
        raise ValueError(f"measured = {os.fspath(path)!r}: no table: {' '.join(str(error).split())}") from None
