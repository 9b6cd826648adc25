"""What a search will cost, before its first run, and where its machine does nothing."""
import time

import numpy as np
import pandas

from ratchet_sieve.answers.search import SEEDS, SINGLE
from ratchet_sieve.texts import counted, shown

OF_A_RUN = 1.0     # of the short run [s of wall time]
OF_BUDGET = 0.05   # the same, of a budget
SEARCH = 4.0       # simulated time of the search, over that of its first runs, as it is in the problems of separate.md
BISECTIONS = 20    # of the lowest setting that throws disks up


def announce(search, seconds, error):
    """@param seconds the budget or None @param error standard error of the final mean that is aimed at
    @return what is said before the first run, a line each, and the cost [s of wall time]"""
    machine, first = search.machine, len(search.first())
    middle = search.grid[int(np.abs(search.grid - np.median(search.grid, axis=0)).sum(axis=1).argmin())]
    simulated = machine.shortest * first * SEARCH
    if machine.kind == "fed":
        simulated += SINGLE / error ** 2 / machine.rate
    limit = OF_A_RUN if seconds is None else min(OF_A_RUN, OF_BUDGET * seconds)
    line, cost = cost_text(machine, middle, search.seed, simulated, search.threads, limit)
    if seconds is not None and seconds < cost:
        line += f"; the budget ends it after {duration(seconds)}"
    return [*idle_text(search), line], cost


def cost_text(machine, place, seed, simulated, threads, limit=OF_A_RUN):
    """@param place of a short run, which tells what a simulated second costs @param simulated time of all runs [s]
    @return what they will cost, as a line and in seconds of wall time"""
    begin = time.monotonic()
    rows = machine.run(place[None], [machine.shortest], (seed + SEEDS - 1, 1), budget=limit)
    if len(rows):
        second = float(rows["wall_time"].iloc[0] / rows["simulated_time"].iloc[0])
    else:
        second = (time.monotonic() - begin) / machine.shortest  # at least: it was cut while its disks were placed
    cost = second * simulated / threads
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
