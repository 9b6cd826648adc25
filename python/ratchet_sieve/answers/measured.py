"""What was measured of a feeder, at some settings, and what a run says of the same."""
from __future__ import annotations

import dataclasses
import math
import os
from typing import Any

import numpy as np
import pandas

from ratchet_sieve.arguments import number
from ratchet_sieve.bags import read_bins
from ratchet_sieve.errors import SceneError
from ratchet_sieve.tables import Refusal, column_of, read_csv, seed_of
from ratchet_sieve.values import unit_of

PLACES = ("left", "right", "on_base")
STDERR = ".stderr"          # ending of a column with the standard error of another one
OBSERVED = ("height_profile", "mass_flow", "residence_times")
VELOCITY, VELOCITY_STDERR = "mean_vx.", "mean_vx_stderr."  # of which both are columns of results
EXAMPLE = '[{"base.inclination": 0.1, "left.A": 310, "right.A": 480, "on_base.A": 12}]'


@dataclasses.dataclass(frozen=True)
class Number:
    """One number that was measured at a setting.

    row, name  of the setting; what it is: share.left.A or share.on_base.A, or a column of results
    value      as measured
    variance   of its own; of a share that of independent grains, else None: as that of one run
    grains     that were counted
    """

    row: int
    name: str
    value: float
    variance: Any
    grains: float = 0.0

    @property
    def is_share(self) -> bool:
        return self.name.startswith("share.")

    def text(self) -> str:
        if not self.is_share:
            return self.name
        _, place, species = self.name.split(".", 2)
        return f"the share of {species} that left to the left" if place == "left" else \
            f"the share of {species} still on the deck"

    def of(self, rows: pandas.DataFrame) -> tuple[np.ndarray, np.ndarray]:
        """What runs say of it. @return values, NaN where undefined, and variances, of shares alone, else 1"""
        if not self.is_share:
            values = rows[self.name] if self.name in rows else np.full(len(rows), np.nan)
            return np.asarray(values, dtype=float), np.ones(len(rows))
        _, place, species = self.name.split(".", 2)
        left, right, count = (rows[f"{name}.{species}"].to_numpy(float) for name in ("left", "right", "count"))
        return _share(left, left + right) if place == "left" else _share(count - left - right, count)


class Measured:
    """@ivar settings of each row: keys of the scene @ivar numbers all that was measured"""

    def __init__(self, scene: Any, measured: Any, unknown: list[str]):
        """@param measured path of a CSV file or of a bag, a list of bags or of mappings, or a DataFrame
        @param unknown keys that no row may set. Raises ValueError, SceneError, OSError, BagError."""
        self.settings, self.numbers = [], []
        rows = _rows(measured, unknown)
        if not rows:
            raise ValueError(f"measured: must have a row or more, such as {EXAMPLE}")
        for k, row in enumerate(rows):
            name = f"measured, row {k + 1}"
            keys = {key: value for key, value in row.items() if not _is_result(key)}
            for key in keys:
                if key in unknown:
                    raise ValueError(f"{name}: {key} is set, but it is unknown")
            _require(scene, name, keys)
            self.settings.append(keys)
            self.numbers += _numbers(k, name, {key: row[key] for key in row if key not in keys}, scene.species)

    @property
    def observed(self) -> list[str]:
        """What a scene must observe that the runs have these numbers."""
        return sorted({each.name.partition(".")[0] for each in self.numbers} & set(OBSERVED))

    def lines(self) -> list[str]:
        """What was understood."""
        names = dict.fromkeys(each.text() for each in self.numbers)
        grains = sum(each.grains for each in self.numbers if each.name.startswith("share.left"))
        return [f"measured at {len(self.settings)} settings, {len(self.numbers)} numbers"
                + (f" of {grains:.0f} grains" if grains else "") + f": {'; '.join(names)}"]


def _share(part: Any, whole: Any) -> tuple[Any, Any]:
    """@return the share and its variance of independent grains, with half a grain more on either side"""
    with np.errstate(divide="ignore", invalid="ignore"):
        smoothed = (part + 0.5) / (whole + 1.0)
        return part / whole, smoothed * (1.0 - smoothed) / whole


def _is_error(key: str) -> bool:
    return key.endswith(STDERR) or key.startswith(VELOCITY_STDERR)


def _is_result(key: str) -> bool:
    return key.split(".")[0] in PLACES or _is_error(key) or key != "seed" and unit_of(key) is not None


def _require(scene: Any, name: str, keys: dict) -> None:
    """Raises ValueError for keys that are none of the scene, or have values that it does not take."""
    if "seed" in keys:
        raise ValueError(f"{name}: seed: a measurement has none")
    try:
        scene.replace(keys)
    except SceneError as error:
        raise ValueError(f"{name}: neither a number of results nor a setting: {error}") from None


def _numbers(row: int, name: str, cells: dict, species: list[str]) -> list[Number]:
    """@param cells of results. Raises ValueError."""
    for key, value in cells.items():
        is_count = key.split(".")[0] in PLACES
        number(f"{name}: {key}", value, 0.0 if is_count or _is_error(key) else -math.inf)
        if is_count and key.partition(".")[2] not in species:
            raise ValueError(f"{name}: {key}: there is no such species; there are {', '.join(species)}")
    found = []
    for kind in species:
        left, right, deck = (cells.get(f"{place}.{kind}") for place in PLACES)
        if left is None and right is None and deck is None:
            continue
        if left is None or right is None:
            raise ValueError(f"{name}: left.{kind} and right.{kind} must be given, both")
        parts = [("left", left, left + right)] + ([] if deck is None else [("on_base", deck, left + right + deck)])
        for place, part, whole in parts:
            if whole == 0:
                raise ValueError(f"{name}: no {kind} was counted")
            found.append(Number(row, f"share.{place}.{kind}", *map(float, _share(part, whole)), whole))
    for key, value in cells.items():
        if key.split(".")[0] not in PLACES and not _is_error(key):
            error = cells.get(key + STDERR, cells.get(key.replace(VELOCITY, VELOCITY_STDERR, 1), None)
                              if key.startswith(VELOCITY) else None)
            found.append(Number(row, key, float(value), None if error is None else error ** 2))
    if not found:
        raise ValueError(f"{name}: nothing was measured: give counts, such as left.{species[0]}, right.{species[0]}")
    return found


def _rows(measured: Any, unknown: list[str]) -> list[dict]:
    """Of a bag without what is unknown: its base has what was commanded."""
    if isinstance(measured, (str, os.PathLike)):
        measured = [measured] if os.fspath(measured).endswith(".bag") else _table(os.fspath(measured))
    if isinstance(measured, pandas.DataFrame):
        measured = measured.to_dict("records")
    if not isinstance(measured, (list, tuple)):
        raise ValueError(f"measured = {measured!r}: must be the path of a CSV file or a bag, or rows such as {EXAMPLE}")
    rows = [{key: value for key, value in read_bins(os.fspath(row)).items() if key not in unknown}
            if isinstance(row, (str, os.PathLike)) else row for row in measured]
    for k, row in enumerate(rows):
        if not isinstance(row, dict):
            raise ValueError(f"measured[{k}] = {row!r}: must be a mapping, such as {EXAMPLE[1:-1]}")
    return [{key: value for key, value in row.items() if value is not None and value == value} for row in rows]


def _table(path: str) -> pandas.DataFrame:
    """Raises ValueError, OSError."""
    try:
        texts = read_csv(path)
        return pandas.DataFrame({name: column_of(texts, name, path).map(seed_of) for name in texts}, dtype=object)
    except Refusal as error:
        raise ValueError(str(error)) from None

