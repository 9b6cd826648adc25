"""Many runs, and the results files that sieve_sweep writes."""
from __future__ import annotations

import json
import os
import sqlite3
import tempfile
from typing import TYPE_CHECKING, Any, Iterable, Mapping, Optional, Union

import numpy as np

from . import _engine
from .errors import ResultsError
from .progress import Progress
from .scene import Scene, _plain

if TYPE_CHECKING:
    import pandas

_OWN = "SELECT cases.* FROM plan JOIN cases USING (run_hash) WHERE plan.sweep = " \
       "(SELECT id FROM sweeps WHERE fingerprint = ?) ORDER BY plan.position"
_ALL = "SELECT * FROM cases"


def sweep(scene: Scene, grid: Optional[Mapping[str, Iterable]] = None, *, zip: Optional[Mapping[str, Iterable]] = None,
          cases: Optional[list[Mapping[str, Any]]] = None, seeds: Union[int, tuple[int, int], None] = None,
          results: Union[str, os.PathLike, None] = None, threads: int = 0, progress: bool = True) -> pandas.DataFrame:
    """Runs a scene at many settings, as `sieve_sweep run` does: the product of grid, zip, cases and seeds.

    grid     dotted key -> values: every combination
    zip      dotted key -> values, stepped through together
    cases    one mapping of dotted keys to values for each setting
    seeds    their number, from 1 on, or (first, count); None: the scene's own
    results  file that keeps the results (SQLite); a case that has one there is not run again. None: kept nowhere
    threads  0: one per processor
    Returns a row for each case, in the order of the product, seeds fastest: see read_sweep().
    Raises SceneError before any case is run, ResultsError. After Ctrl-C a call with the same file goes on.
    """
    sweep_of: dict[str, Any] = {"scene": scene.given}
    for name, axes in (("grid", grid), ("zip", zip)):
        if axes:
            sweep_of[name] = {key: np.asarray(list(values)).tolist() if not isinstance(values, list) else values
                              for key, values in axes.items()}
    if cases:
        sweep_of["cases"] = [dict(case) for case in cases]
    if seeds is not None:
        first, count = seeds if isinstance(seeds, tuple) else (1, seeds)
        sweep_of["seed"] = {"first": first, "count": count}
    text = json.dumps(sweep_of, default=_plain, ensure_ascii=False)
    with tempfile.TemporaryDirectory() as directory, Progress(progress, "sweep") as bar:
        path = os.fspath(results) if results is not None else os.path.join(directory, "results.db")
        fingerprint = _engine.sweep(
            text, "sweep", path, threads,
            lambda done, failed, count: bar.show((done + failed) / max(count, 1),
                                                 f"{done} of {count} cases" + (f", {failed} failed" if failed else "")))
        return _read(path, _OWN, (fingerprint,))


def read_sweep(path: Union[str, os.PathLike]) -> pandas.DataFrame:
    """All cases of a results file: columns for the swept keys and for each number of the summary, named as in
    docs/sweeps.md (mean_vx.A, purity.left.number.A). SI units; undefined values are NaN, which is pandas' word for none.
    Raises ResultsError."""
    if not os.path.exists(path):
        raise ResultsError(f"{os.fspath(path)}: no such file")
    return _read(os.fspath(path), _ALL, ())


def _read(path: str, query: str, parameters: tuple) -> pandas.DataFrame:
    import pandas

    try:
        connection = sqlite3.connect(f"file:{path.replace('?', '%3f').replace('#', '%23')}?mode=ro", uri=True)
        try:
            table = pandas.read_sql_query(query, connection, params=parameters).drop(columns=["summary"])
        finally:
            connection.close()
        # pandas takes a column in which no value is defined for one of texts.
        return table.astype({name: float for name in table if table[name].isna().all() and name != "error"})
    except (sqlite3.Error, pandas.errors.DatabaseError) as error:
        raise ResultsError(f"{path}: no results of a sweep: {error}") from error
