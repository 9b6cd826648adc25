"""What leaves a machine, and the intervals of it over runs with fresh seeds."""
import numpy as np

from ratchet_sieve import stats
from ratchet_sieve.answers.answer import Interval
from ratchet_sieve.answers.machine import SIDES
from ratchet_sieve.goals import LEFT, LEFT_MASS, RIGHT, RIGHT_MASS
from ratchet_sieve.values import Values

SURE = 10  # disks of either kind: the spread of the runs says nothing of a share with fewer
_SIDE = {"left": LEFT, "right": RIGHT}


def interval_of(machine, rows):
    """The goal's mean over runs that work, with its interval. Its half width is None where the runs do not tell it.
    @return None: there is no run"""
    found = _mean(machine.observed(rows)["value"]) if len(rows) else None
    if found is None:
        return None
    bins = machine.bins(rows).sum(axis=0) if machine.kind != "closed" else None
    if machine.share_goal:
        what, side, by, name = machine.goal.split(".", 3)
        return _of_share(found, bins, what, side, by, machine.scene.species.index(name))
    if machine.is_signed and machine.kind != "closed":
        each = [_of_share(Interval(_ratio(*bins[k, [LEFT, RIGHT]]), 0.0, found.count), bins, "recovery", "left",
                          "number", k) for k in range(len(bins))]
        if found.half_width == 0.0 or bins[:, [LEFT, RIGHT]].min() < SURE:  # Newcombe, Statist. Med. 17, 873 (1998)
            return Interval(found.value, float(np.hypot(*(of.half_width for of in each))), found.count)
    return Interval(found.value, found.half_width or None, found.count)


def products_of(machine, fresh):
    """Throughput, purity, recovery and the disks inside, of fresh runs: means over them with intervals."""
    if fresh is None or machine.kind == "closed":
        return {"throughput": None, "purity": None, "recovery": None, "inside": None}
    names, steady = machine.scene.species, machine.kind == "fed"
    bins = machine.bins(fresh)
    pooled = bins.sum(axis=0)

    def share(what, side, by, k):
        name = f"steady.{what}.{side}.{by}.value.{names[k]}" if steady else f"{what}.{side}.{by}.{names[k]}"
        found = _mean(fresh[name]) if name in fresh else None
        return found and _of_share(found, pooled, what, side, by, k)

    shares = {what: Values((side, Values((by, Values((name, share(what, side, by, k)) for k, name in enumerate(names)))
                                         for by in ("number", "mass")))
                           for side in SIDES) for what in ("purity", "recovery")}
    if steady:
        number, flow = (fresh[f"steady.throughput.{by}.value"] for by in ("number", "mass"))
    else:
        number = bins[:, :, [LEFT, RIGHT]].sum(axis=(1, 2)) / fresh["simulated_time"]
        flow = fresh[[f"mass_flow.{side}.mean.{name}" for side in SIDES for name in names]].sum(axis=1)
    counts = pooled[:, [LEFT, RIGHT]].sum(axis=1)
    radii = np.array([machine.scene[f"species.{k}.radius"] for k in range(len(names))])
    diameter = float(2.0 * (radii * counts).sum() / max(counts.sum(), 1.0))
    throughput = Values(disks=_mean(number), mass=_mean(flow), mass_per_depth=_mean(flow / diameter), depth=diameter)
    return {"throughput": throughput, "inside": _mean(fresh["steady.inside.value"]) if steady else None, **shares}


def _mean(values):
    values = np.asarray(values, dtype=float)
    found = stats.mean_of(values[np.isfinite(values)])
    return found and Interval.of(found)


def _ratio(part, rest):
    return part / (part + rest) if part + rest else 0.0


def _of_share(found, bins, what, side, by, k):
    """A share's interval, wider where its disks are few. @param found over runs @param bins of all, (species, 5)"""
    own, other = _SIDE[side], _SIDE[SIDES[1 - SIDES.index(side)]]
    part = bins[k, own]
    rest = bins[:, own].sum() - part if what == "purity" else bins[k, other]
    if found.half_width and min(part, rest) >= SURE or part + rest == 0.0:
        return found
    by_mass = by == "mass" and what == "purity"
    heavier = _mean_mass(bins[[k]]) / _mean_mass(np.delete(bins, k, axis=0)) if by_mass else 1.0
    low, high = (heavier * p / (heavier * p + 1.0 - p) for p in stats.wilson(part, part + rest))
    width = max(found.half_width or 0.0, found.value - low, high - found.value)
    return Interval(found.value, float(width), found.count)


def _mean_mass(bins):
    """Of some species, by what left at either end; 1 where nothing did."""
    count = bins[:, [LEFT, RIGHT]].sum()
    return bins[:, [LEFT_MASS, RIGHT_MASS]].sum() / count if count else 1.0
