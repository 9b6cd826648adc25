"""From the search to the answer: runs of the best setting with fresh seeds, and what they say."""
import time

import numpy as np
import pandas

from ratchet_sieve import stats
from ratchet_sieve.answers.answer import Answer, Interval
from ratchet_sieve.answers.cost import announce, duration, fills, idle_text, lift_off_text, whys
from ratchet_sieve.answers.depends import PART, Dependence, known_text, screening
from ratchet_sieve.answers.intervals import interval_of, products_of
from ratchet_sieve.answers.machine import LEAST_WORKING, flow_of
from ratchet_sieve.answers.search import BATCH, COSTLIEST, Z
from ratchet_sieve.texts import at_most, counted, percent
from ratchet_sieve.values import Values

FRESH = 12          # runs of the best setting; then half as many at a time
MOST_FRESH = 192
LONG_ENOUGH = 12.0  # mean times in the machine that such a run of a fed machine lasts at least
EXPECTED = 2.4      # half the width of the interval that is aimed at, in standard errors
MOST_DOUBLINGS = 4  # of the first runs of a fed machine that have not settled
PER_KEY = 8         # fresh runs for each unknown key, at least
FEWER_FRESH = (FRESH, 8, 6, 4)  # of them, as the budget has it
AFFORDABLE = 0.9    # of what is left of the budget: the runs differ in cost
LEAST_PART = 0.1    # of the shortest run
MOST_FILLING = 0.1  # of the fresh runs, of twice the length: where more fill up the machine is metastable at best
AFTER_INTERRUPT, OF_INTERRUPTED = 2.0, 0.1  # for fresh runs after an interrupt: [s], and of the time so far
INTERRUPTED = "interrupted: the answer so far; the same call with the same results continues"
EDGE = 0.02         # of a range: nearer to its end than this is at its edge
FLOOR = "contact.min_rebound_speed"


def answer_of(search, budget, bar):
    """Searches, measures the best setting with fresh seeds, and puts the answer together.
    @param budget a Budget. @param bar a Progress
    @throws RuntimeError the machine works nowhere. @throws ValueError the budget ends before there is an answer"""
    clocks, notes, fresh, floor, known = (time.monotonic(), time.process_time()), [], Fresh(), None, None
    lines, announced = announce(search, budget.seconds, FRESH, search.within / EXPECTED)
    bar.announced = announced if budget.seconds is None else min(announced, budget.seconds)
    for line in lines:
        bar.say(line)
    notes += idle_text(search)
    try:
        search.deadline = budget.of_search
        _first_runs(search, bar)
        while True:
            _search(search, bar, announced)
            late = search.is_cut_short = search.is_late()
            if late:
                search.assess()
            search.deadline = budget.end
            if search.nowhere() or _fresh_runs(search, bar, fresh, notes):
                break
            search.deadline = budget.of_search
        search.assess(best=search.best)  # with the fresh runs as well
        if len(fresh.rows) and not search.is_late():
            floor = _floor(search, fresh.rows)
            known = _known(search, fresh.rows)
    except KeyboardInterrupt as signalled:
        late = False
        notes.append(INTERRUPTED)
        # It names a signal other than Ctrl-C, whose sender kills what does not end soon.
        so_far = 0.0 if signalled.args else time.monotonic() - clocks[0]
        _interrupted(search, bar, fresh, max(AFTER_INTERRUPT, OF_INTERRUPTED * so_far))
    left = float(search.may.max())
    if left > search.within and not search.nowhere() and INTERRUPTED not in notes:
        notes.append(f"the {'budget' if late else 'limit of runs'} ended the search: another setting "
                     f"may be better by {at_most(left)}")
    answer = _answer(search, fresh.working(search.machine, notes), notes, floor, clocks, announced)
    answer.known = known
    return answer


def _interrupted(search, bar, fresh, seconds):
    """One short round of fresh runs, which a second interrupt ends. Raises KeyboardInterrupt where nothing is known."""
    search.is_cut_short = True
    if not search.assess(best=search.best if len(fresh.rows) else None):
        raise KeyboardInterrupt
    if len(fresh.rows) >= FRESH:
        return
    search.deadline = time.monotonic() + seconds
    bar.show(0.9, "interrupted: the best with fresh seeds; again ends at once")
    try:
        _fresh_runs(search, bar, fresh, [])
    except KeyboardInterrupt:
        pass
    search.assess(best=search.best)


class Fresh:
    """The runs with fresh seeds of the setting that is the best."""

    def __init__(self):
        self.rows = pandas.DataFrame()

    def working(self, machine, notes):
        """@return those in which the machine works; None: there are none"""
        if not len(self.rows):
            return None
        seen = machine.observed(self.rows)
        works = seen["value"].notna()
        if not works.all():
            notes.append(f"of {counted(len(works), 'fresh run')} some are left out: {whys(seen)}")
        if fills(seen):
            notes.append("it may not stay as it is: about once in "
                         f"{duration(self.rows['simulated_time'].sum() / fills(seen))} of work it fills up")
        return self.rows[works] if works.sum() > 1 else None


def _search(search, bar, announced):
    while True:
        if not search.assess():
            reasons = whys(search.machine.observed(search.runs)) if len(search.runs) else "none has ended"
            errors = search.runs["error"].dropna()[:1] if "error" in search.runs else ()
            runs = f"in {counted(len(search.runs), 'run')}: " + "; ".join((reasons, *errors))
            if search.is_late():
                raise ValueError(f"budget: too small for any answer, of about {duration(announced)}: {runs}")
            works = len(search.runs) and search.machine.observed(search.runs)["value"].notna().any()
            raise RuntimeError("the machine works " + ("at one setting alone, too few for a search: widen the ranges "
                               "around it, " if works else "nowhere in these ranges: ") + runs)
        part, text = 0.3 + 0.5 * min(search.within / max(float(search.may.max()), 1e-9), 1.0), _so_far(search)
        search.show = lambda done: bar.show(part, f"{text}; {done}")
        bar.show(part, text)
        chosen, durations = search.chosen()
        if not len(chosen):
            break
        search.measure(chosen, durations)


def _first_runs(search, bar):
    """And longer ones, as long as most of them have not settled."""
    first = search.first()
    units, doublings = [1.0] * len(first), 0
    while len(first) and not search.is_late() and doublings <= MOST_DOUBLINGS:
        for k in range(0, len(first), BATCH):
            search.show = lambda done: bar.show(0.3 * k / len(first), f"{counted(len(search.runs), 'run')}; {done}")
            search.measure(first[k:k + BATCH], units[k:k + BATCH])
            if search.is_late():
                break
        doublings += 1
        first, units = search.unsettled() if len(search.runs) else (first, units)


def _so_far(search):
    machine, k = search.machine, search.best
    at = ", ".join(f"{key.rsplit('.')[-1]} {value:g}" for key, value in machine.settings(search.grid[k]).items())
    return f"{counted(len(search.runs), 'run')}, best {search.value[k]:.3g} ± {Z * search.error[k]:.1g} at {at}"


def _fresh_runs(search, bar, fresh, notes):
    """Runs of the best setting until the interval of their mean is as narrow as `within`.
    @param fresh gets the runs. @return False where the machine does not work there, as a rule"""
    machine = search.machine
    runs = max(FRESH, PER_KEY * len(machine.unknown.keys)) if machine.unknown else FRESH
    length = search.final_duration(runs, search.within / EXPECTED, LONG_ENOUGH)
    if search.deadline is not None:
        runs, length = _affordable(search, length)
    fresh.rows, least, longer = pandas.DataFrame(), runs, False
    while True:
        search.show = lambda done: bar.show(0.8, f"{done} fresh runs")
        rows = fresh.rows = pandas.concat([fresh.rows, search.fresh(runs, length)], ignore_index=True)
        seen = machine.observed(rows) if len(rows) else None
        works = 0 if seen is None else seen["value"].notna().sum()
        # A fluctuation looks like a machine that fills up: longer runs tell.
        count = max(len(rows), least)
        filling = max(MOST_FILLING * count, 1) if longer else 0
        if seen is not None and not search.is_late() and (
                works < max(len(rows) - (1.0 - LEAST_WORKING) * count, 2) or fills(seen) > filling):
            fresh.rows = pandas.DataFrame()
            if seen["open"].any() and not longer:
                length, longer, runs = 2.0 * length, True, -(-runs // 2)
                continue
            search.close(next(iter(seen["why"][seen["why"] != ""].mode()), ""))
            at = ", ".join(f"{key} = {value:g}" for key, value in machine.settings(search.grid[search.best]).items())
            notes.append(f"{at} is left out: of {counted(len(rows), 'fresh run')} {whys(seen)}")
            return False
        mean = None if seen is None else interval_of(machine, rows[seen["value"].notna()])
        if mean and mean.half_width is not None:
            bar.show(0.8 + 0.2 * min((search.within / max(mean.half_width, 1e-9)) ** 2, 1.0),
                     f"{mean.value:.3g} ± {mean.half_width:.2g} from {counted(mean.count, 'fresh run')}")
            if mean.half_width <= search.within and len(rows) >= least:
                return True
        runs = FRESH // 2
        if len(rows) >= MOST_FRESH or search.is_late():
            notes.append("the fresh runs ended before their interval was as narrow as wanted")
            return True


def _affordable(search, length):
    """@return how many runs, and how long, that end by the deadline: few, where many would be too short"""
    for runs in FEWER_FRESH:
        longest = AFFORDABLE * search.affordable(runs, search.deadline)
        if longest >= search.machine.shortest:
            break
    return runs, max(min(length, longest), LEAST_PART * search.machine.shortest)


def _answer(search, fresh, notes, floor, clocks, announced):
    if search.machine.kind == "closed" and search.machine.is_signed:
        notes.insert(0, "nothing leaves a machine without open ends: the goal is how fast the kinds drift apart")
    machine, settings = search.machine, search.machine.settings(search.grid[search.best])
    found = None if fresh is None else interval_of(machine, fresh)
    if found is None or found.half_width is None:
        found = Interval(float(search.value[search.best]), None, 0)
        if not search.nowhere():
            notes.append(f"the {machine.goal} has no interval: it is of the search's own runs, which chose the "
                         "setting, so that it is too large")
    if search.too_costly.any():
        notes.append(f"{percent(search.part(search.too_costly))} of the ranges are left out: there a simulated second "
                     f"costs more than {COSTLIEST:g} times the usual, as on a nearly choked base")
    silent = pandas.Series(np.where(search.works, "", search.why)).replace("", np.nan).value_counts(normalize=True)
    share = search.part(~search.works & (search.why != ""))
    if share > 0.0:
        notes.append(f"no answer in {percent(share)} of the ranges: "
                     + ", ".join(f"{why} in {percent(share * part)}" for why, part in silent.items()))
    known = found.half_width is not None
    separated = known and not search.nowhere() and abs(found.value) > found.half_width
    best = separated or not known and not search.nowhere()
    if best:
        notes += _edges(machine, settings)
        notes += lift_off_text(machine, search.grid[search.best])
    rows, surface = search.runs, _map(search)
    if fresh is not None:  # each of its warnings once
        notes += dict.fromkeys(filter(None, "\n".join(map(str, fresh["warning_text"].dropna())).splitlines()))
    cost = Values(runs=len(rows), simulated=float(rows["simulated_time"].sum()), announced=announced,
                  processor=time.process_time() - clocks[1], seconds=time.monotonic() - clocks[0])
    return Answer(machine=machine, best=settings if best else None, separation=found, separated=separated,
                  bound=search.bound, within=search.within, as_good=_as_good(search, surface, best), map=surface,
                  idle=len(search.idle), runs=rows, seen=machine.observed(rows), cost=cost, floor=floor, warnings=notes,
                  **products_of(machine, fresh), **_depends_on(machine, fresh))


def _depends_on(machine, fresh):
    """How much of what is unknown the fresh runs tell."""
    if machine.unknown is None or fresh is None:
        return {}
    found = Dependence(machine.unknown, fresh[machine.unknown.keys].to_numpy(float),
                       machine.observed(fresh)["value"].to_numpy())
    return {"depends_on": found.table, "spread": found.spread, "grains": found}


def _known(search, fresh):
    """The line that says which coefficients are taken as known, and on which two it depends most. None: it is not so,
    or its runs would cost more than they may."""
    machine = search.machine
    unknown = screening(machine.scene) if machine.unknown is None and not search.nowhere() else None
    if unknown is None:
        return None
    mean = fresh["simulated_time"].mean()
    length = PART * search.runs["events"].sum() * fresh["simulated_time"].sum() / fresh["events"].sum() \
        / len(unknown.table)
    if machine.kind == "fed":
        length = min(length, mean)
    if length < (machine.shortest if machine.kind == "fed" else mean):
        return None
    rows = search.screened(unknown, length)
    # Over a whole run, which short ones have as well.
    values, known = (machine.observed(of)["value"] if machine.goal != "separation" else of["separation"]
                     for of in (rows, fresh))
    return known_text(unknown, values.to_numpy(), float(known.var()) * mean / length) \
        if len(rows) == len(unknown.table) else None


def _floor(search, fresh):
    """What changes at the best with half of contact.min_rebound_speed: a Values of `from`, `to` [m/s], the `change` and
    whether it `depends`, that is, whether the change is surely none."""
    machine = search.machine
    speed = machine.scene["contact.min_rebound_speed"]
    if speed == 0.0:
        return None
    lower = search.lowered({FLOOR: 0.5 * speed}, FRESH // 2, fresh)
    if not len(lower):
        return None
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
    """The surface: a row for each place of the grid, with what the nearest run says of the machine there."""
    places = pandas.DataFrame([search.machine.settings(place) for place in search.grid])
    works = search.works & (search.why == "")
    rows = search.runs.iloc[search.last].reset_index(drop=True)
    fields = {"processed": rows["processed"], "throughput": flow_of(rows),
              "inside": rows.get("steady.inside.value"), "warnings": rows["warning_text"].fillna("")}
    return places.assign(value=np.where(works, search.value, np.nan),
                         half_width=np.where(works, Z * search.error, np.nan),
                         as_good=works & (search.may >= 0.0), may_lose=np.where(works, search.loss, np.nan),
                         **({} if search.machine.kind == "closed" else fields), why=search.why)


def _as_good(search, table, best):
    """Of the map the rows that cannot be told from the best, the highest first."""
    good = table[table.as_good if best else search.works].drop(columns=["as_good", "why"])
    return good.sort_values("value", key=abs if search.machine.is_signed else None, ascending=False,
                            ignore_index=True)
