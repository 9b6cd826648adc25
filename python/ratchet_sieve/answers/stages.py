"""Stages: a machine that takes what leaves the one before it at one end, grain by grain, and what all give together."""
from __future__ import annotations

from typing import Any

import numpy as np

from ratchet_sieve import stats
from ratchet_sieve.answers.answer import Interval
from ratchet_sieve.answers.machine import SIDES
from ratchet_sieve.answers.search import SEEDS, seed_of
from ratchet_sieve.runs import run
from ratchet_sieve.values import Values

RUNS = 8      # of the whole chain, with seeds of their own
CLASSES = 12  # of a size distribution, of equal numbers of grains


class Chain:
    """Machines at their best settings, each of which is fed with what leaves the one before it at a side.

    scenes, sides  of each stage: the side is that of the next one's feed, of the last None
    """

    def __init__(self, scenes: list, sides: list, begin: float, end: float):
        """@param begin time from which products count, end of all runs [s]"""
        self.scenes, self.sides, self.begin, self.end = scenes, sides, begin, end

    def run(self, seed: int) -> list:
        """@return the run of each stage"""
        runs: list = []
        for scene, fed_by in zip(self.scenes, [None, *self.sides]):
            scene = scene.replace({"duration": self.end, "seed": seed})
            runs.append(run(scene, progress=False, feed=getattr(runs[-1].exits, fed_by) if fed_by else None))
        return runs

    def products(self, runs: list) -> list:
        """@return (stage, side, exits) of what no further stage takes, while all of them worked"""
        return [(stage + 1, side, exits[exits["time"] > self.begin])
                for stage, (one, taken) in enumerate(zip(runs, self.sides)) for side in SIDES if side != taken
                for exits in [getattr(one.exits, side)]]


def balance(runs: list, sides: list) -> Values:
    """Of each species, in grains: what was fed to the first stage, where it left, and what is still inside of each;
    a grain may also be on its way between two of them."""
    found = Values()
    for k, name in enumerate(runs[0].scene.species):
        rows: dict[str, int] = {}
        for stage, (one, taken) in enumerate(zip(runs, sides), 1):
            bins = one.simulation.bins[name]
            rows[f"inside {stage}"] = int(bins["on_base"])
            rows.update({f"{side} {stage}": int(bins[side]) for side in SIDES if side != taken})
            if stage == 1:
                rows["fed"] = int(bins["on_base"] + bins["left"] + bins["right"])
        found[name] = Values(rows)
    return found


def next_feed(scene: Any, exits: Any, seconds: float) -> dict:
    """@param exits of several runs, `seconds` of them altogether @return keys of a scene that is fed as they left: at
    their rate, in their numbers, and with their sizes where the scene's species have any"""
    keys = {"feed.rate": float(f"{len(exits) / seconds:.6g}")}
    for k, name in enumerate(scene.species):
        own = exits[exits["species"] == name]
        given = scene.given["species"][k]
        keys[f"species.{k}.share"] = len(own) / len(exits)
        if "share_by" in given:
            keys[f"species.{k}.share_by"] = "number"
        if "size" in given and len(own) > CLASSES:
            radii = np.unique(np.quantile(own["radius"], np.linspace(0.0, 1.0, CLASSES + 1)))
            if len(radii) > 1:
                counts = np.histogram(own["radius"], radii)[0]
                keys[f"species.{k}.size"] = {
                    "distribution": "table", "radii": radii.tolist(), "weights": [0.0, *map(float, counts)],
                    "by": "number", "mass_exponent": scene[f"species.{k}.size.mass_exponent"]}
    return keys


def totals(chain: Chain, seed: int) -> Values:
    """Runs the chain with seeds of its own. @return products: a list of Values with stage, side, throughput [kg/s], and
    purity and recovery by mass and by number, over all stages, with intervals over the runs; balance of the last run"""
    names, found = chain.scenes[0].species, []
    for k in range(RUNS):
        runs = chain.run(seed + k)
        products = chain.products(runs)
        found.append([[(own["mass"].sum(), len(own)) for own in (exits[exits["species"] == name] for name in names)]
                      for _, _, exits in products])
    amounts = np.array(found, dtype=float)  # of run, product, species and (mass, number)
    with np.errstate(divide="ignore", invalid="ignore"):
        purity = amounts / amounts.sum(axis=2, keepdims=True)
        recovery = amounts / amounts.sum(axis=1, keepdims=True)

    def shares(values: Any) -> Values:
        return Values((by, Values((name, _interval(values[:, k, j])) for k, name in enumerate(names)))
                      for j, by in enumerate(("mass", "number")))

    seconds = chain.end - chain.begin
    return Values(balance=balance(runs, chain.sides), products=[
        Values(stage=stage, side=side, throughput=_interval(amounts[:, p, :, 0].sum(axis=1) / seconds),
               purity=shares(purity[:, p]), recovery=shares(recovery[:, p]))
        for p, (stage, side, _) in enumerate(products)])


def _interval(values: Any) -> Any:
    values = values[np.isfinite(values)]
    found = stats.mean_of(values) if len(values) else None
    return found and Interval.of(found)


def next_stage(answer: Any, side: str, over: Any, separate: Any, **options: Any) -> Any:
    """See Answer.next_stage()."""
    if side not in SIDES:
        raise ValueError(f"side = {side!r}: must be left or right")
    machine = answer.machine
    if machine.kind != "fed":
        raise ValueError("feed.rate: must be above 0: only what leaves a fed machine feeds another one")
    before = answer.chain
    scenes = [*(before.scenes if before else []), answer.scene]
    sides = [*(before.sides[:-1] if before else []), side]
    begin, length = _times(answer)
    begin += before.begin if before else 0.0
    seed = seed_of(options.get("seed", 1)) + SEEDS // 4  # of which no search knows
    chain = Chain(scenes, [*sides[:-1], side], begin, begin + length)
    exits = [getattr(chain.run(seed + k)[-1].exits, side) for k in range(RUNS // 2)]
    exits = np.concatenate([rows[rows["time"] > begin] for rows in exits])
    if not len(exits):
        raise ValueError(f"side = {side!r}: nothing leaves the machine there")
    found = separate(answer.scene.replace(next_feed(answer.scene, exits, RUNS // 2 * length)), over, **options)
    if found.best:
        more, longer = _times(found)
        chain = Chain([*scenes, found.scene], [*sides, None], begin + more, begin + more + max(length, longer))
        found.chain, found.stages = chain, totals(chain, seed + RUNS)
    if found.separated and answer.separated and machine.is_signed and found.machine.is_signed and \
            found.separation.value * answer.separation.value < 0.0:
        found.warnings.append(
            f"this stage undoes the one before: it separates the other way round ({answer.separation}, then "
            f"{found.separation}); its {side} end has more of the kind that left the first one to the "
            f"{SIDES[1 - SIDES.index(side)]}")
    return found


def _times(answer: Any) -> tuple[float, float]:
    """@return from when a machine works steadily, and how long the runs that judged it were then [s]"""
    last = answer.runs[answer.runs["steady.from"].notna()].tail(1).iloc[0]
    longest = answer.runs["steady.from"].tail(4).max()
    return float(longest), float(last["simulated_time"] - last["steady.from"])
