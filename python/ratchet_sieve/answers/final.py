"""From the search to the answer: runs of the best setting with fresh seeds, and what they say."""
import time

import numpy as np
import pandas

from ratchet_sieve import stats
from ratchet_sieve.answers.answer import Answer, Interval
from ratchet_sieve.answers.search import BATCH, COSTLIEST, Z
from ratchet_sieve.texts import at_most, counted
from ratchet_sieve.values import Values

FRESH = 12          # runs of the best setting at a time
MOST_FRESH = 192
LONG_ENOUGH = 20.0  # mean times in the machine that such a run of a fed machine lasts at least
EXPECTED = 2.4      # half the width of the interval that is aimed at, in standard errors
MOST_DOUBLINGS = 5  # of the first runs of a fed machine that most disks have not left
INTERRUPTED = "interrupted: the answer so far; the same call with the same results continues"
EDGE = 0.02         # of a range: nearer to its end than this is at its edge
FLOOR = "contact.min_rebound_speed"
SIDES = ("left", "right")


def answer_of(search, deadline, bar):
    """Searches, measures the best setting with fresh seeds, and puts the answer together.
    @param deadline of time.monotonic(), or None. @param bar a Progress
    @throws RuntimeError the machine works nowhere. @throws ValueError the budget ends before there is an answer"""
    begin, notes, fresh, floor = (time.monotonic(), time.process_time()), [], Fresh(), None
    try:
        _first_runs(search, deadline, bar)
        while True:
            _search(search, bar)
            if search.nowhere() or _fresh_runs(search, deadline, bar, fresh, notes):
                break
        search.assess(best=search.best)  # with the fresh runs as well
        if len(fresh.rows) and not _is_over(deadline):
            floor = _floor(search, fresh.rows)
    except KeyboardInterrupt:
        if len(search.runs) < len(search.first()) or not search.assess():
            raise
        notes.append(INTERRUPTED)
    left = float(search.may.max())
    if left > search.within and not search.nowhere() and INTERRUPTED not in notes:
        notes.append(f"the {'budget' if search.is_late() else 'limit of runs'} ended the search: another setting "
                     f"may be better by {at_most(left)}")
    return _answer(search, fresh.working(search.machine, notes), notes, floor, begin)


class Fresh:
    """The runs with fresh seeds of the setting that is the best."""

    def __init__(self):
        self.rows = pandas.DataFrame()

    def working(self, machine, notes):
        """@return those in which the machine works; None: there are none"""
        if not len(self.rows):
            return None
        works = machine.observed(self.rows)["value"].notna()
        if not works.all():
            notes.append(f"{(~works).sum()} of the {counted(len(works), 'fresh run')} are left out: there the machine "
                         "was " + _WHY[machine.kind])
        return self.rows[works] if works.sum() > 1 else None


def _is_over(deadline):
    return deadline is not None and time.monotonic() > deadline


def _search(search, bar):
    while True:
        if not search.assess():
            raise RuntimeError(f"the machine works nowhere in these ranges: in {counted(len(search.runs), 'run')} "
                               f"it was {_WHY[search.machine.kind]}")
        bar.show(0.3 + 0.5 * min(search.within / max(float(search.may.max()), 1e-9), 1.0), _so_far(search))
        chosen, durations = search.chosen()
        if not len(chosen):
            break
        search.measure(chosen, durations)


def _first_runs(search, deadline, bar, doublings=0):
    """Longer ones in place of those that were too short."""
    first = search.first()
    for k in range(0, len(first), BATCH):
        search.measure(first[k:k + BATCH], np.ones(len(first[k:k + BATCH])))
        bar.show(0.3 * (k + BATCH) / len(first), counted(len(search.runs), "run"))
        if _is_over(deadline) and k + BATCH < len(first):
            raise ValueError(f"budget: too small for any answer: it ended after {len(search.runs)} of the first "
                             f"{len(first)} runs")
    if search.is_too_short() and doublings < MOST_DOUBLINGS:
        search.machine.shortest *= 2.0
        _first_runs(search, deadline, bar, doublings + 1)


_WHY = {"fed": "choked, or too few of its disks left", "poured": "not emptied by half, or too few of its disks left",
        "closed": "too short to tell a mean velocity"}


def _so_far(search):
    machine, k = search.machine, search.best
    at = ", ".join(f"{key.rsplit('.')[-1]} {value:g}" for key, value in machine.settings(search.grid[k]).items())
    return f"{counted(len(search.runs), 'run')}, best {search.value[k]:.3g} ± {Z * search.error[k]:.1g} at {at}"


def _fresh_runs(search, deadline, bar, fresh, notes):
    """Runs of the best setting until the interval of their mean is as narrow as `within`.
    @param fresh gets the runs. @return False where the machine does not work there, as a rule"""
    machine = search.machine
    duration = search.final_duration(FRESH, search.within / EXPECTED, LONG_ENOUGH)
    if deadline is not None:
        duration = max(min(duration, search.affordable(FRESH, deadline)), machine.shortest)
    fresh.rows = pandas.DataFrame()
    while True:
        rows = fresh.rows = pandas.concat([fresh.rows, search.fresh(FRESH, duration)], ignore_index=True)
        mean = stats.mean_of(machine.observed(rows)["value"].dropna())
        if (not mean or mean.count < 0.8 * len(rows)) and not _is_over(deadline):
            fresh.rows = pandas.DataFrame()
            return False
        if mean and mean.count > 1:
            width = mean.half_width()
            bar.show(0.8 + 0.2 * min((search.within / max(width, 1e-9)) ** 2, 1.0),
                     f"{mean.value:.3g} ± {width:.2g} from {counted(mean.count, 'fresh run')}")
            if width <= search.within:
                return True
        if len(rows) >= MOST_FRESH or _is_over(deadline):
            notes.append("the fresh runs ended before their interval was as narrow as wanted")
            return True


def _answer(search, fresh, notes, floor, begin):
    if search.machine.kind == "closed" and search.machine.is_signed:
        notes.insert(0, "nothing leaves a machine without open ends: the goal is how fast the kinds drift apart")
    machine, settings = search.machine, search.machine.settings(search.grid[search.best])
    mean = None if fresh is None else stats.mean_of(machine.observed(fresh)["value"].dropna())
    if mean and mean.count > 1:
        found = Interval.of(mean)
    else:
        found = Interval(float(search.value[search.best]), float(Z * search.error[search.best]), 0)
        if not search.nowhere():
            notes.append("the separation is of the search's own runs: they chose the setting, so that it is too large")
    if search.too_costly.any():
        notes.append(f"{100.0 * search.too_costly.mean():.2g} % of the ranges are left out: there a simulated second "
                     f"costs more than {COSTLIEST:g} times the usual, as on a nearly choked base")
    separated = not machine.is_signed or not search.nowhere() and abs(found.value) > found.half_width
    if separated:
        notes += _edges(machine, settings)
    rows, surface = search.runs, _map(search)
    if fresh is not None:  # each of its warnings once
        notes += dict.fromkeys(filter(None, "\n".join(map(str, fresh["warning_text"].dropna())).splitlines()))
    cost = Values(runs=len(rows), simulated=float(rows["simulated_time"].sum()),
                  processor=time.process_time() - begin[1], seconds=time.monotonic() - begin[0])
    return Answer(machine=machine, best=settings if separated else None, separation=found, separated=separated,
                  bound=search.bound, within=search.within, as_good=_as_good(search, surface, separated), map=surface,
                  runs=rows, seen=machine.observed(rows), cost=cost, floor=floor, warnings=notes,
                  **_of_products(machine, fresh))


def _floor(search, fresh):
    """What changes at the best with half of contact.min_rebound_speed: a Values of `from`, `to` [m/s], the `change` and
    whether it `depends`, that is, whether the change is surely none."""
    machine = search.machine
    speed = machine.scene["contact.min_rebound_speed"]
    if speed == 0.0:
        return None
    lower = search.lowered({FLOOR: 0.5 * speed}, len(fresh) // 2, fresh)
    means = [stats.mean_of(machine.observed(rows)["value"].dropna()) for rows in (lower, fresh)]
    if not all(mean and mean.count > 1 for mean in means):
        return None
    change = means[0].minus(means[1])
    return Values({"from": speed, "to": 0.5 * speed, "change": Interval.of(change),
                   "depends": abs(change.value) > change.half_width()})


def _edges(machine, settings):
    for key, low, high in zip(machine.keys, machine.low, machine.high):
        for end, name in ((low, "lower"), (high, "upper")):
            if abs(settings[key] - end) < EDGE * (high - low):
                yield f"{key} = {settings[key]:g} is at the {name} end of its range: a better one may lie beyond"


def _map(search):
    """The surface: a row for each place of the grid."""
    places = pandas.DataFrame([search.machine.settings(place) for place in search.grid])
    return places.assign(value=np.where(search.works, search.value, np.nan),
                         half_width=np.where(search.works, Z * search.error, np.nan),
                         as_good=search.works & (search.may >= 0.0))


def _as_good(search, table, separated):
    """Of the map the rows that cannot be told from the best, the highest first."""
    good = table[table.as_good if separated else search.works].drop(columns="as_good")
    return good.sort_values("value", key=abs if search.machine.is_signed else None, ascending=False,
                            ignore_index=True)


def _of_products(machine, fresh):
    """What leaves, of the fresh runs: means over them with intervals."""
    if fresh is None or machine.kind == "closed":
        return {"throughput": None, "purity": None, "recovery": None}
    names = machine.scene.species

    def mean(values):
        found = stats.mean_of(np.asarray(values, dtype=float)[np.isfinite(np.asarray(values, dtype=float))])
        return found and Interval.of(found)

    shares = {what: Values((side, Values((by, Values((name, mean(fresh[f"{what}.{side}.{by}.{name}"]))
                                                     for name in names)) for by in ("number", "mass")))
                           for side in SIDES) for what in ("purity", "recovery")}
    seconds = fresh["simulated_time"]
    flow = fresh[[f"mass_flow.{side}.mean.{name}" for side in SIDES for name in names]].sum(axis=1)
    left = fresh[[f"{side}.{name}" for side in SIDES for name in names]].sum(axis=1)
    radii = np.array([machine.scene[f"species.{k}.radius"] for k in range(len(names))])
    counts = np.array([fresh[[f"{side}.{name}" for side in SIDES]].sum().sum() for name in names])
    diameter = float(2.0 * (radii * counts).sum() / max(counts.sum(), 1))
    throughput = Values(disks=mean(left / seconds), mass=mean(flow), mass_per_depth=mean(flow / diameter),
                        depth=diameter)
    return {"throughput": throughput, **shares}
