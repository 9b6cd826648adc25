"""What a search will cost, before its first run, and where its machine does nothing."""
import time

import numpy as np
import pandas

from ratchet_sieve.answers.machine import CHOKED, FILLING
from ratchet_sieve.answers.search import LIFT_OFF, SEEDS, SINGLE, usual_length
from ratchet_sieve.texts import counted, two_digits

OF_A_RUN = 1.0     # of the short runs [s of wall time]
OF_BUDGET = 0.05   # the same, of a budget
SHORT = 8          # such runs: the cost differs over the ranges
FLOOR = 1.5        # runs of the best, over those with fresh seeds: some are of another rebound floor
SHARE = 0.5        # variance of a share times the disks that have left, half of them at its side
UNKNOWN = 6.0      # variance of a run of another goal, over within squared
DEAREST = 10.0     # a run that is taken into account, over the median
SLOW = 1.3         # the cost of all runs over that of the short ones: the best is often where the machine is slow
BISECTIONS = 20    # of the lowest setting that throws disks up


def announce(search, seconds, fresh, error):
    """By what the problems of separate.md took, within a factor of two: of the search as many runs more as the variance
    of one is over `within` squared.
    @param seconds the budget or None @param fresh runs of the best @param error that their mean is to have
    @return what is said before the first run, a line each, and the cost [s of wall time]"""
    machine, first = search.machine, search.first()
    limit = OF_A_RUN if seconds is None else min(OF_A_RUN, OF_BUDGET * seconds)
    length, second = short_runs(machine, search.grid[first[:SHORT]], search.seed, search.threads, limit)
    last, more = fresh * length, UNKNOWN
    if machine.kind == "fed" and search.has_errors:
        single = SHARE if machine.share_goal else SINGLE
        more = single / (machine.rate * length) / search.within ** 2
        last = max(last, single / error ** 2 / machine.rate)
    line, cost = cost_text(machine, length, second * (length * len(first) * (1.0 + more) + FLOOR * last),
                           search.threads)
    if seconds is not None and seconds < cost:
        line += f"; the budget ends it after {duration(seconds)}"
    return [*idle_text(search), line], cost


def short_runs(machine, places, seed, threads, limit=OF_A_RUN):
    """@param limit of them [s of wall time]
    @return how long a run must be, as a rule, and what a simulated second of it costs [s of wall time]"""
    begin = time.monotonic()
    rows = machine.run(places, np.full(len(places), machine.plain), (seed + SEEDS - 1, 1), budget=limit,
                       threads=threads)
    if not len(rows):  # all were cut while their disks were placed
        return machine.shortest, (time.monotonic() - begin) / machine.plain
    length = machine.shortest * usual_length(machine, rows)
    # One that fills up is taken to go on so: its cost per second grows as its disks. The dearest ones are given up.
    fills_up = (rows["processed"].fillna(0.0) < 0.5) & (rows["status"] == "done")
    grows = np.where(fills_up, np.maximum(0.5 * (1.0 + machine.shortest / rows["simulated_time"]), 1.0), 1.0)
    seconds = rows["wall_time"] / rows["simulated_time"] * grows
    return length, float(np.minimum(seconds, DEAREST * seconds.median()).mean())


def cost_text(machine, length, seconds, threads):
    """@param length of a run [s] @param seconds of all runs, on one core @return what they will cost, as a line and in
    seconds of wall time"""
    cost = SLOW * seconds / threads
    why = f", because {machine.rarest[0]} is {100.0 * machine.rarest[1]:.2g} %" if machine.rarest else ""
    return (f"each run is {two_digits(length)} s long{why}: about {duration(cost)} on "
            f"{counted(threads, 'core')}"), cost


def idle_text(search):
    """Where nothing is thrown up, if it is so anywhere."""
    machine, idle = search.machine, search.idle
    if not len(idle):
        return []
    for k, key in enumerate(machine.keys):
        low, high = idle[:, k].max(), search.grid[:, k].min()
        if low < high:
            return [f"below {key} = {_edge(machine, search.grid[0], k, low, high):.3g} nothing is thrown: left out"]
    part = 100.0 * len(idle) / (len(idle) + len(search.grid))
    return [f"{part:.2g} % of the ranges are left out: nothing is thrown there, for the base accelerates by less than "
            "gravity"]


def lift_off_text(machine, place):
    """How near to lift-off a setting is, where it is near."""
    lift = machine.lift(place)
    if machine.kind != "fed" or not 1.0 <= lift < LIFT_OFF:
        return []
    return [f"the base's peak acceleration is {lift:.3g} g there: near 1 a machine that works may fill up after "
            "minutes"]


def _edge(machine, place, k, low, high):
    """The lowest value of a key that throws disks up."""
    for _ in range(BISECTIONS):
        middle = 0.5 * (low + high)
        at = np.array(place)
        at[k] = middle
        low, high = (low, middle) if machine.lift(at) >= 1.0 else (middle, high)
    return machine.low[k] + high * (machine.high[k] - machine.low[k])


def duration(seconds):
    """In words: 40 s, 20 min, 3 h."""
    for unit, name in ((3600.0, "h"), (60.0, "min")):
        if seconds >= 2.0 * unit:
            return f"{two_digits(seconds / unit)} {name}"
    return f"{two_digits(max(seconds, 0.1))} s"


def fills(seen):
    """How many runs filled up."""
    return int(seen["why"].isin((FILLING, CHOKED)).sum())


def whys(seen):
    """Why runs say nothing, with their numbers."""
    counts = pandas.Series(seen["why"][seen["why"] != ""]).value_counts()
    return ", ".join(f"{count} {why}" for why, count in counts.items())
