"""The front of separation against throughput: settings that no other beats in both.

Many settings are tried by Optuna's tree-structured Parzen estimators of two objectives (Ozaki et al., GECCO 2020, doi
10.1145/3377930.3389817). The most promising ones are run with fresh seeds, which decide what is on the front; what is
reported comes from other seeds, and of that only what no other beats there, too.
"""
from __future__ import annotations

import dataclasses
import datetime
import os
import time
import warnings
from typing import Any, Iterable, Mapping, Optional

import numpy as np
import pandas

from ratchet_sieve import stats
from ratchet_sieve.answers.cost import cost_text, short_runs
from ratchet_sieve.answers.machine import LEAST_WORKING, Machine, flow_of
from ratchet_sieve.answers.search import BATCH, OPEN_COST, SEEDS, seed_of
from ratchet_sieve.arguments import integer
from ratchet_sieve.progress import Progress
from ratchet_sieve.scene import AnyScene
from ratchet_sieve.texts import counted

FIRST = 16   # settings that are spread over the ranges before densities are used
PROMISING = 8  # settings that are run with fresh seeds
RUNS = 6     # of each, to decide, and as many again to report
TRIED, AGAIN = 1.0, 1.5  # durations of a setting's runs, over the shortest one
ATTEMPTS = 5  # to open a storage
PATIENCE, POLL = 5.0, 0.2  # with settings that other processes try: over the longest batch; between looks [s]
TRIED_AS = "found"  # what a trial found, among its attributes in Optuna's storage


@dataclasses.dataclass(repr=False)
class Front:
    """Settings that no other beats in both value and throughput.

    table   DataFrame, by rising throughput: the swept keys, value (|mean separation|, or the mean of the goal),
            throughput [disks/s], processed, each with half the width of its interval at 95 % (value_half_width ...),
            runs; all from seeds that had no part in the choice; and `lower`, the lower end of the value's interval from
            the seeds that chose. Where value's interval contains 0 nothing is separated
    tried   DataFrame: all settings, with the value and the throughput of one run; NaN where the machine does not work,
            and `why`
    """

    machine: Any
    table: pandas.DataFrame
    tried: pandas.DataFrame

    def best(self, throughput: float = 0.0) -> Optional[dict]:
        """The settings with the highest value, by the lower end of its interval, at this throughput at least [disks/s];
        None: there are none, or none that surely separates."""
        row = self.best_row(throughput)
        return None if row is None else {key: row[key] for key in self.machine.keys}

    def best_row(self, throughput: float = 0.0) -> Optional[dict]:
        """The row of best() in the table."""
        surely = np.minimum(self.table.lower, self.table.value - self.table.value_half_width) > 0.0
        enough = self.table[(self.table.throughput >= throughput) & (surely | (not self.machine.is_signed))]
        return None if enough.empty else self.table.astype(object).loc[enough.lower.idxmax()].to_dict()

    def scene(self, throughput: float = 0.0) -> Any:
        """The scene with best(). Raises ValueError where there is none."""
        best = self.best(throughput)
        if best is None:
            raise ValueError(f"throughput = {throughput:g}: no setting of the front has as much"
                             + (" and surely separates" if self.machine.is_signed else ""))
        return self.machine.scene.replace(best)

    def __str__(self) -> str:
        return f"{self.machine.goal} against throughput, {counted(len(self.tried), 'setting')} tried\n" + \
            self.table.drop(columns="lower").to_string(index=False, float_format="{:.4g}".format)

    __repr__ = __str__

    def plot(self, axes: Any = None) -> Any:
        """Draws the front over all settings that were tried. Returns matplotlib's axes."""
        from ratchet_sieve.plots.answer import draw_front

        return draw_front(self, axes)

    def write(self, path: Any) -> None:
        """Writes the table (.csv), or a picture (.png, .svg, .pdf). Raises OSError, ValueError."""
        self.machine.write(path, {".csv": lambda: self.table.to_csv(index=False)}, self.plot)


def front(scene: AnyScene, over: Mapping[str, tuple[float, float]], *, trials: int = 160, goal: Optional[str] = None,
          start: Iterable[Mapping[str, float]] = (), seed: int = 1, results: Any = None, storage: Any = None,
          threads: int = 0, progress: bool = True) -> Front:
    """Settings of a fed machine that part its kinds well at much throughput. Needs Optuna.

    scene, over, goal, seed, results, threads  as of separate()
    trials  settings that are tried
    start   settings that are tried first; of keys that one does not name, the scene's own values
    storage Optuna's, or its URL, such as sqlite:///front.db: all processes that give the same one try settings
            together, until there are `trials`; each measures the front by itself
    Raises SceneError, ValueError before anything runs, ImportError without Optuna, RuntimeError where the machine works
    nowhere. After Ctrl-C the same call with the same results continues.
    """
    machine = Machine(scene, over, goal)
    if machine.kind != "fed":
        raise ValueError("feed.rate: must be above 0: a machine that is not fed has no lasting throughput")
    trials = integer("trials", trials, 1)
    options = {"threads": integer("threads", threads), "results": results}
    seed, begin = seed_of(seed), [machine.place(settings) for settings in start]
    with Progress(progress, "front") as bar:
        study = _study(machine, storage, seed)
        places, threads = np.array([[0.25], [0.75]]) * np.ones(len(machine.keys)), threads or os.cpu_count()
        length, second = short_runs(machine, places, seed, threads)
        simulated = length * (TRIED * trials + 2 * AGAIN * RUNS * PROMISING)
        line, bar.announced = cost_text(machine, length, second * simulated, threads)
        bar.say(line)
        tried = _tried(machine, study, trials, begin, seed, TRIED * BATCH * length * second, options, bar)
        promising = _promising(machine, tried)
        if promising.empty:
            raise RuntimeError(f"the machine works nowhere in these ranges: {counted(trials, 'setting')} tried")
        places = np.array([machine.place(row) for row in promising[machine.keys].to_dict("records")])
        chosen = _measured(machine, places, seed + SEEDS // 2, options,
                           lambda done: bar.show(0.8, f"again: {done} runs")).dropna(subset=["value"])
        if chosen.empty:
            raise RuntimeError("the machine works with no fresh seeds at any of the settings that seemed to be good")
        kept = _unbeaten(chosen.value.to_numpy(), chosen.throughput.to_numpy())
        chosen = chosen.iloc[kept]
        table = _measured(machine, places[chosen.index], seed + SEEDS // 2 + RUNS, options,
                          lambda done: bar.show(0.9, f"the front again: {done} runs"))
    lower = (chosen.value - chosen.value_half_width).to_numpy()
    table = table.assign(lower=lower).dropna(subset=["value"])
    table = table.iloc[_unbeaten(table.value.to_numpy(), table.throughput.to_numpy())]
    return Front(machine, table.sort_values("throughput", ignore_index=True), tried)


def _study(machine, storage, seed):
    """Optuna's, which processes with the same storage, machine, ranges and goal share."""
    try:
        import optuna
    except ImportError as error:
        raise ImportError("a front needs Optuna: scripts/setup --optimise, or python3-optuna of Debian") from error
    optuna.logging.set_verbosity(optuna.logging.WARNING)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", optuna.exceptions.ExperimentalWarning)
        # Processes that share a study must not ask for the same settings.
        sampler = optuna.samplers.TPESampler(seed=seed % 2 ** 32 if storage is None else None, multivariate=True,
                                             constant_liar=True, n_startup_trials=FIRST)
    name = f"{machine.scene.hash} {dict(zip(machine.keys, zip(machine.low, machine.high)))} {machine.goal}"
    for left in reversed(range(ATTEMPTS)):
        try:
            return optuna.create_study(directions=["maximize", "maximize"], sampler=sampler, storage=storage,
                                       study_name=name, load_if_exists=True)
        except Exception:  # of two processes that make a new storage at once one fails, in ways of the database
            if storage is None or not left:
                raise
            time.sleep(POLL)


def _names(machine):
    return [f"{k}" for k in range(len(machine.keys))]


def _tried(machine, study, trials, start, seed, batch, options, bar):
    """Optuna's settings, one run each, until there are enough in the study.
    @param start places that are tried first. @param batch what BATCH settings take on one core, as a rule [s]
    @return a row for each setting"""
    from optuna.trial import TrialState

    start = [dict(zip(_names(machine), map(float, place))) for place in start]
    while True:
        known = study.get_trials(deepcopy=False)
        found = [trial for trial in known if TRIED_AS in trial.user_attrs]
        under_way = _under_way(known, batch)
        room = min(BATCH, trials - len(found) - len(under_way))
        part, text = 0.8 * (len(found) + 0.5) / trials, f"{counted(len(found), 'setting')} of {trials}"
        if room <= 0 and under_way:
            bar.show(part, f"{text}; other processes try {len(under_way)}")
            time.sleep(POLL)
            continue
        if room <= 0:
            found = found[:trials]  # two processes that asked at once have tried more
            return pandas.DataFrame([trial.user_attrs[TRIED_AS] for trial in found]).astype(
                {name: float for name in ("value", "throughput", "processed")})
        waiting = [trial for trial in known if trial.state == TrialState.WAITING]
        held = [trial.system_attrs.get("fixed_params") for trial in found + under_way + waiting]
        for settings in start:
            if settings not in held:  # also where the process that was to try it has ended
                study.enqueue_trial(settings)
        values = [trial.values[0] for trial in found if trial.values]
        text += f", best {max(values):.3g}" if values else ""
        asked = []
        try:
            while len(asked) < room:
                asked.append(study.ask())
            places = np.array([[trial.suggest_float(name, 0.0, 1.0) for name in _names(machine)] for trial in asked])
            rows = _seen(machine, places, TRIED, (seed, 1), options, lambda done: bar.show(part, f"{text}; {done}"))
            for trial, row in zip(asked, rows.astype(object).where(rows.notna(), None).to_dict("records")):
                row["value"] = None if row["value"] is None else _height(machine, row["value"])
                trial.set_user_attr(TRIED_AS, row)
                if row["value"] is not None:
                    study.tell(trial, (row["value"], row["throughput"]))
        finally:  # the machine does not work there, or the call was interrupted
            for trial in asked:
                study.tell(trial, state=TrialState.FAIL, skip_if_finished=True)


def _under_way(trials, batch):
    """Those that other processes try. One that takes much longer than any has taken, or is to, is taken for dead."""
    longest = max([datetime.timedelta(seconds=batch), *(trial.duration for trial in trials if trial.duration)])
    running = [trial for trial in trials if trial.state.name == "RUNNING" and TRIED_AS not in trial.user_attrs]
    return [trial for trial in running if datetime.datetime.now() - trial.datetime_start < PATIENCE * longest]


def _seen(machine, places, duration, seeds, options, show=lambda done: None):
    """Runs that last longer where they have not settled, unless that is too costly: such a machine fills up.
    @return a row for each place and seed: settings, value, throughput [disks/s], processed, why there is no value"""
    wanted = pandas.DataFrame([machine.settings(place) for place in places])
    once = wanted.drop_duplicates()  # as of whole numbers
    at, lengths = places[once.index], np.full(len(once), duration)
    parts, left, most = [None] * len(once), np.arange(len(once)), None
    while len(left):
        rows = machine.run(at[left], machine.shortest * lengths[left], seeds, **options,
                           progress=lambda done, failed, count: show(f"{done + failed} of {count}"))
        for k, part in zip(left, np.split(rows, len(left))):
            parts[k] = part
        most = OPEN_COST * machine.usual_events(machine.observed(rows)) if most is None else most
        longer = [machine.longer(parts[k], machine.observed(parts[k]), most) for k in left]
        lengths[left] = [max(units[np.isfinite(units)], default=np.inf) for units in longer]
        left = left[np.isfinite(lengths[left])]
    rows = pandas.concat(parts, ignore_index=True)
    seen = machine.observed(rows)
    found = once.loc[once.index.repeat(seeds[1])].reset_index(drop=True).assign(
        value=seen["value"], throughput=flow_of(rows), processed=rows["processed"], why=seen["why"])
    return wanted.merge(found, on=machine.keys, how="left")


def _promising(machine, tried):
    """Of the settings that work the front, and the front without it, as long as there are too few."""
    left, found = tried.dropna(subset=["value"]).drop_duplicates(machine.keys), []
    while len(left) and sum(map(len, found)) < PROMISING:
        kept = _unbeaten(left.value.to_numpy(), left.throughput.to_numpy())
        found.append(left.iloc[kept])
        left = left.drop(left.index[kept])
    return pandas.concat(found).head(max(PROMISING, len(found[0]))) if found else left


def _unbeaten(values, throughputs):
    """@return the numbers of the points which no other is as good as in both and better in one"""
    pairs = np.stack([values, throughputs], axis=-1)
    as_good = (pairs[:, None] >= pairs[None]).all(axis=-1)
    better = (pairs[:, None] > pairs[None]).any(axis=-1)
    return np.flatnonzero(~(as_good & better).any(axis=0))


def _measured(machine, places, first, options, show=lambda done: None):
    """@return a row for each place: means over runs with seeds from `first` on; NaN unless the machine works in most"""
    rows = _seen(machine, places, AGAIN, (first, RUNS), options, show)
    lines = []
    for k in range(len(places)):
        part = rows.iloc[RUNS * k:RUNS * (k + 1)]
        works = part.value.notna()
        line = {**machine.settings(places[k]), "runs": int(works.sum())}
        for name in ("value", "throughput", "processed"):
            mean = stats.mean_of(part[name][works]) if works.sum() >= max(LEAST_WORKING * RUNS, 2) else None
            line.update({name: mean.value if mean else np.nan,
                         f"{name}_half_width": mean.half_width() if mean else np.nan})
        lines.append({**line, "value": _height(machine, line["value"])})
    return pandas.DataFrame(lines)


def _height(machine, value):
    """What is to be large. Of a separation it is |s| of one run, and |mean s| of several: their mean |s| is never 0."""
    return abs(value) if machine.is_signed else value
