"""What a search will cost, before its first run, and where its machine does nothing."""
import time

import numpy as np
import pandas

from ratchet_sieve.answers.search import SEEDS, SINGLE
from ratchet_sieve.texts import counted, shown

OF_A_RUN = 1.0     # of the short runs [s of wall time]
OF_BUDGET = 0.05   # the same, of a budget
SHORT = 8          # such runs: the cost differs over the ranges
FLOOR = 1.5        # runs of the best, over those with fresh seeds: some are of another rebound floor
SHARE = 0.5        # variance of a share times the disks that have left, half of them at its side
UNKNOWN = 6.0      # variance of a run of another goal, over within squared
SLOW = 1.3         # the cost of all runs over that of the short ones: the best is often where the machine is slow
BISECTIONS = 20    # of the lowest setting that throws disks up


def announce(search, seconds, fresh, error):
    """By what the problems of separate.md took, within a factor of two: of the search as many runs more as the variance
    of one is over `within` squared.
    @param seconds the budget or None @param fresh runs of the best @param error that their mean is to have
    @return what is said before the first run, a line each, and the cost [s of wall time]"""
    machine, first = search.machine, len(search.first())
    last, more = fresh * machine.shortest, UNKNOWN
    if machine.kind == "fed" and search.has_errors:
        single = SHARE if machine.share_goal else SINGLE
        more = single / (machine.rate * machine.shortest) / search.within ** 2
        last = max(last, single / error ** 2 / machine.rate)
    simulated = machine.shortest * first * (1.0 + more) + FLOOR * last
    limit = OF_A_RUN if seconds is None else min(OF_A_RUN, OF_BUDGET * seconds)
    line, cost = cost_text(machine, search.grid[search.first()[:SHORT]], search.seed, simulated, search.threads, limit)
    if seconds is not None and seconds < cost:
        line += f"; the budget ends it after {duration(seconds)}"
    return [*idle_text(search), line], cost


def cost_text(machine, places, seed, simulated, threads, limit=OF_A_RUN):
    """@param places of short runs, which tell what a simulated second costs @param simulated time of all runs [s]
    @return what they will cost, as a line and in seconds of wall time"""
    begin = time.monotonic()
    rows = machine.run(places, np.full(len(places), machine.plain), (seed + SEEDS - 1, 1), budget=limit,
                       threads=threads)
    if len(rows):
        # One that fills up is taken to go on so: its cost per second grows as its disks.
        fills = rows["processed"].fillna(0.0) < 0.5
        grows = np.where(fills, 0.5 * (1.0 + machine.shortest / rows["simulated_time"]), 1.0)
        second = float((rows["wall_time"] / rows["simulated_time"] * np.maximum(grows, 1.0)).mean())
    else:
        second = (time.monotonic() - begin) / machine.plain  # at least: all were cut while their disks were placed
    cost = SLOW * second * simulated / threads
    why = f", because {machine.rarest[0]} is {100.0 * machine.rarest[1]:.2g} %" if machine.rarest else ""
    return (f"each run is {shown(float(f'{machine.shortest:.2g}'))} s long{why}: about {duration(cost)} on "
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


def _edge(machine, place, k, low, high):
    """The lowest value of a key that throws disks up."""
    for _ in range(BISECTIONS):
        middle = 0.5 * (low + high)
        at = np.array(place)
        at[k] = middle
        low, high = (low, middle) if machine.throws(at) else (middle, high)
    return machine.low[k] + high * (machine.high[k] - machine.low[k])


def duration(seconds):
    """In words: 40 s, 20 min, 3 h."""
    for unit, name in ((3600.0, "h"), (60.0, "min")):
        if seconds >= 2.0 * unit:
            return f"{seconds / unit:.2g} {name}"
    return f"{max(seconds, 0.1):.2g} s"


def whys(seen):
    """Why runs say nothing, with their numbers."""
    counts = pandas.Series(seen["why"][seen["why"] != ""]).value_counts()
    return ", ".join(f"{count} {why}" for why, count in counts.items())
