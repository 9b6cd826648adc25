"""Many runs, and the results files that sieve_sweep writes."""
from __future__ import annotations

import contextlib
import json
import os
import pathlib
import sqlite3
import tempfile
from typing import TYPE_CHECKING, Any, Callable, Iterable, Mapping, Optional, Union

from . import _engine
from .arguments import integer, mapping, number, path_of
from .errors import ResultsError
from .progress import Progress
from .scene import AnyScene, Scene, _plain, scene_of

if TYPE_CHECKING:
    import pandas

# Of the physics that has just been run: the file may keep results of earlier ones.
_PLAN = "SELECT {} FROM plan {} WHERE plan.sweep = (SELECT id FROM sweeps WHERE fingerprint = ?) {} " \
        "ORDER BY plan.position"
_OWN = _PLAN.format("cases.*", "JOIN cases USING (run_hash)", "AND physics = (SELECT MAX(physics) FROM cases)")
_PLANNED = _PLAN.format("run_hash", "", "")
_ALL = "SELECT * FROM cases"


def sweep(scene: AnyScene, grid: Optional[Mapping[str, Iterable]] = None, *,
          zip: Optional[Mapping[str, Iterable]] = None, cases: Optional[list[Mapping[str, Any]]] = None,
          seeds: Union[int, tuple[int, int], Iterable[int], None] = None,
          unknown: Any = None, results: Union[str, os.PathLike, None] = None, threads: int = 0,
          budget: Optional[float] = None, progress: Union[bool, Callable[[int, int, int], Any]] = True) -> pandas.DataFrame:
    """Runs a scene at many settings, as `sieve_sweep run` does: the product of grid, zip, cases and seeds.

    scene    a Scene, the path of a scene file, or a mapping
    grid     dotted key -> values, or {"from": .., "to": .., "count": ..}: every combination
    zip      dotted key -> values, stepped through together
    cases    one mapping of dotted keys to values for each setting
    seeds    their number, from 1 on, a pair (first, count), or a list of them; None: the scene's own
    unknown  key -> (low, high), or (value, "±", error at 95 %): each seed draws its own, the same at all settings
    results  file that keeps the results (SQLite); a case that has one there is not run again. None: kept nowhere
    threads  0: one per processor
    budget   wall time [s] after which the runs under way are cut: their rows have the status "cut", and what they
             measured until then; a later call with the same file continues them. Cases that were not begun have no row
    progress whether to show a bar; or a function of the numbers of cases: done, failed, all
    Returns a row for each case, in the order of the product, seeds fastest, in which the index counts them: see
    read_sweep().
    Raises SceneError, ValueError before any case is run, ResultsError. After Ctrl-C a call with the same file goes on.
    """
    scene = scene_of(scene)
    sweep_of: dict[str, Any] = {"scene": _without_folder(scene)}
    for name, axes in (("grid", grid), ("zip", zip)):
        if axes is not None and mapping(name, axes, '{"base.inclination": [0.0, 0.1]}'):
            sweep_of[name] = {key: _values(key, values) for key, values in axes.items()}
    if cases is not None and not hasattr(cases, "__iter__"):
        raise ValueError(f'cases = {cases!r}: must be a list of mappings, such as [{{"base.inclination": 0.1}}]')
    if cases:
        sweep_of["cases"] = [dict(mapping(f"cases[{k}]", case, '{"base.inclination": 0.1}'))
                             for k, case in enumerate(cases)]
    if unknown is not None:
        from .answers.unknown import prior_of

        drawn = prior_of(scene, unknown)
        for k, case in enumerate(sweep_of.get("cases", ())):
            for key in case.keys() & {*drawn.keys, "seed"}:
                raise ValueError(f"cases[{k}]: {key}: must not be set, with `unknown`" +
                                 (": give `seeds`" if key == "seed" else ", which has it as well"))
        own = list(_listed(seeds, scene["seed"]))
        sweep_of["cases"] = [case for each in sweep_of.get("cases", [{}])
                             for case in drawn.cases_of(each, own)]
    elif seeds is not None:
        sweep_of["seed"] = _seeds(seeds)
    threads, kept = integer("threads", threads), None if results is None else path_of("results", results)
    seconds = None if budget is None else number("budget", budget, 0.0, unit="s")
    text = json.dumps(sweep_of, default=_plain, ensure_ascii=False)
    with tempfile.TemporaryDirectory() as directory, Progress(progress is True, "sweep") as bar:
        path = kept or os.path.join(directory, "results.db")
        show = progress if callable(progress) else lambda done, failed, count: bar.show(
            (done + failed) / max(count, 1), f"{done} of {count} cases" + (f", {failed} failed" if failed else ""))
        fingerprint, cut = _engine.sweep(text, "sweep", os.fsencode(path), threads, show, seconds)
        table = _read(path, _OWN, (fingerprint,))
        if seconds is None:
            return table
        return _with_cut(table, cut, _read(path, _PLANNED, (fingerprint,))["run_hash"])


def _with_cut(table: pandas.DataFrame, cut: list, planned: pandas.Series) -> pandas.DataFrame:
    """With the rows that were cut, each row numbered by its place in the plan."""
    import pandas

    parts = [part for part in (table, pandas.DataFrame(cut)) if len(part)]
    if not parts:
        return table
    rows = pandas.concat(parts)
    rows.index = pandas.Index(planned).get_indexer(rows["run_hash"])
    return rows.sort_index()


def _without_folder(scene: Scene) -> dict:
    """What a scene was given, with the path of its file of fed disks as seen from anywhere."""
    given = scene.given
    if scene.feed_file:
        given["feed"]["file"] = scene.feed_file
    return given


def _values(key: str, values: Any) -> Any:
    """Of a key: their list, or the range as a sweep file has it. Raises ValueError."""
    if isinstance(values, Mapping):
        return dict(values)
    if isinstance(values, (str, bytes)) or not hasattr(values, "__iter__"):
        raise ValueError(f'{key} = {values!r}: must be a list of values, or {{"from": .., "to": .., "count": ..}}')
    return list(values)


def _seeds(seeds: Any) -> Any:
    """As a sweep file has them. Raises ValueError."""
    if isinstance(seeds, tuple) and len(seeds) == 2:
        return {"first": integer("seeds[0]", seeds[0]), "count": integer("seeds[1]", seeds[1], 1)}
    if not isinstance(seeds, (str, bytes)) and hasattr(seeds, "__iter__"):
        return [integer(f"seeds[{k}]", seed) for k, seed in enumerate(seeds)]
    return {"first": 1, "count": integer("seeds", seeds, 1)}


def _listed(seeds: Any, own: int) -> Iterable[int]:
    """@param own the scene's. Raises ValueError."""
    found = [own] if seeds is None else _seeds(seeds)
    return range(found["first"], found["first"] + found["count"]) if isinstance(found, dict) else found


def read_sweep(path: Union[str, os.PathLike]) -> pandas.DataFrame:
    """All cases of a results file: columns for the swept keys and for each number of the summary, named as in
    docs/sweeps.md (mean_vx.A, purity.left.number.A). SI units; undefined values are NaN, pandas' word for none.
    Raises ResultsError."""
    file = path_of("path", path)
    if not os.path.exists(file):
        raise ResultsError(f"{file}: no such file")
    return _read(file, _ALL, ())


def _read(path: str, query: str, parameters: tuple) -> pandas.DataFrame:
    import pandas

    file = pathlib.Path(path).resolve()
    mode = "mode=rw"  # a connection for reading alone would leave an empty log beside the file
    # Where no log can be made, or where it would keep the file's owner from writing, the log that is there is read.
    if not (os.access(file.parent, os.W_OK) and os.access(file, os.W_OK)):
        mode = "mode=ro&readonly_shm=1" if os.path.exists(f"{file}-wal") else "immutable=1"
    try:
        with contextlib.closing(sqlite3.connect(f"{file.as_uri()}?{mode}", uri=True)) as connection:
            cursor = connection.execute(query, parameters)
            table = pandas.DataFrame.from_records(
                cursor.fetchall(), columns=[column[0] for column in cursor.description], coerce_float=True)
        # SQLite has a seed of 2**63 or more as a text; version 1.0 rounded it, but for the summary's.
        if "seed" in table and len(table) and table["seed"].dtype.kind != "i":
            table["seed"] = [json.loads(summary)["seed"] if summary else int(seed)
                             for summary, seed in zip(table["summary"], table["seed"])]
        table = table.drop(columns=["summary"], errors="ignore")
        # pandas takes a column in which no value is defined for one of texts. The copy is in one piece: to a table of
        # many pieces pandas adds a column with a warning.
        undefined = table.columns[table.isna().all()].drop("error", errors="ignore")
        parts = table.drop(columns=undefined), table[undefined].astype(float)  # column by column takes ten times as long
        return pandas.concat(parts, axis=1)[list(table)].copy()
    except sqlite3.Error as error:
        raise ResultsError(f"{path}: no results of a sweep: {error}") from error
