"""What a search for the best setting found."""
from __future__ import annotations

import dataclasses
import json
from typing import Any, Optional

import pandas

from ratchet_sieve.answers.products import Batch, batch_of
from ratchet_sieve.texts import at_most, counted, percent, plus_minus, shown, which_way
from ratchet_sieve.values import Values


@dataclasses.dataclass(frozen=True)
class Interval:
    """A mean and half the width of its interval at 95 % (None: not known); `count` runs, 0: of a surface."""

    value: float
    half_width: Optional[float]
    count: int

    @classmethod
    def of(cls, mean: Any) -> Interval:
        """Of a Mean of ratchet_sieve.stats."""
        return cls(mean.value, mean.half_width() if mean.count > 1 else None, mean.count)

    def __str__(self) -> str:
        if not self.half_width or self.half_width < 1e-9 * abs(self.value):
            return shown(float(f"{self.value:.3g}"))
        return plus_minus(self.value, self.half_width)

    __repr__ = __str__


@dataclasses.dataclass(repr=False)
class Answer:
    """Which settings part the kinds best.

    best        key -> value; None where nothing is separated. Without an interval the best so far
    separation  Interval of the goal at the best, from runs with fresh seeds; signed: above 0 the first species of the
                scene leaves more to the left. In a closed machine the difference of mean velocities, first less
                second [m/s]; with a goal of the user's, that number
    separated   whether the interval is known and does not contain 0
    bound       |value| is not above this at any setting, at 95 % of all together, by the surface
    as_good     DataFrame: settings that cannot be told from the best: the surface's value and half_width, by how much
                each `may_lose` against the best (95 %), and of the nearest run `processed` (P), `throughput` [1/s],
                disks `inside` while steady, and `warnings`
    inside      disks in a fed machine while it is steady
    stages      of next_stage(): products over all stages and their balance, see there
    feed        what is fed: .number.A, .mass.A
    throughput  disks [1/s], mass [kg/s] of the one plane of disks, mass_per_depth [kg/(s m)]: planes side by side, each
                as thick as the mean diameter `depth` [m]. None in a closed machine
    purity, recovery  .left.number.A and so on; None in a closed machine
    floor       what changes with half of contact.min_rebound_speed: .from, .to [m/s], .change, .depends; None: not
                checked
    spread      (low, high) of the value for 95 % of what `unknown` leaves open, with the error of what the runs say;
                None: too few runs, or nothing is unknown
    depends_on  DataFrame: of each unknown `key` its `share` of that variance, with the standard `error`; None: no
                dependence is seen
    known       without `unknown`: a line on what is taken as known, and on which two keys it depends most
    warnings    texts: what was cut short, a setting at the end of its range, warnings of the runs
    cost        runs, simulated [s], processor [s] and seconds [s of wall time], both of this call; `announced` before
                the first run [s of wall time]
    idle        settings beside those of `map`, at which the base throws nothing up
    map         DataFrame: the surface over the ranges, with its half_width; `why` the machine is no answer there, as
                choked, still filling: "" where it is one
    runs        DataFrame: a row for each run, as of a sweep
    seen        DataFrame: the value of each run and its variance
    """

    machine: Any
    best: Optional[dict]
    separation: Interval
    separated: bool
    bound: float
    within: float
    as_good: pandas.DataFrame
    throughput: Optional[Values]
    purity: Optional[Values]
    recovery: Optional[Values]
    cost: Values
    warnings: list
    map: pandas.DataFrame
    runs: pandas.DataFrame
    seen: pandas.DataFrame
    floor: Any = None
    inside: Optional[Interval] = None
    stages: Optional[Values] = None
    chain: Any = None
    idle: int = 0
    spread: Optional[tuple] = None
    depends_on: Optional[pandas.DataFrame] = None
    grains: Any = None
    known: Optional[str] = None

    @property
    def scene(self) -> Any:
        """The scene with the best settings. Raises ValueError where nothing is separated."""
        if self.best is None:
            raise ValueError("nothing is separated: there is no best setting")
        return self.machine.scene.replace(self.best)

    @property
    def feed(self) -> Any:
        """What is fed or poured: Scene.composition at the best settings, or of the scene where there are none."""
        return self.machine._changed(self.best or {}).composition

    def batch(self, kilograms: float) -> Batch:
        """How long a batch takes [h], and its products [kg]. @param kilograms of the feed per metre of depth. Raises
        ValueError where nothing is known of what leaves."""
        return batch_of(self, kilograms)

    def __str__(self) -> str:
        return "\n".join(self._lines())

    __repr__ = __str__

    def _lines(self) -> list[str]:
        unit = " m/s" if self.machine.kind == "closed" and self.machine.is_signed else ""
        goal = self.machine.goal
        if self.best is None:
            what = "not separated" if self.machine.is_signed else "no best setting, for 0 is not excluded"
            lines = [f"{what}: |{goal}| < {at_most(self.bound)}{unit} at 95 % everywhere"
                     if self.bound < self.within else
                     f"{what}: {goal} {self.separation}{unit} at the best setting, "
                     f"below {at_most(self.bound)}{unit} at 95 % everywhere"]
        else:
            at = ", ".join(f"{key} = {_with_unit(key, value)}" for key, value in (self.best or {}).items())
            source = f"95 %, {counted(self.separation.count, 'run')} with fresh seeds" if self.separation.count else \
                "no interval: of the search's own runs"
            lines = [f"{goal} {self.separation}{unit} ({source})" + self._way(), f"at {at}",
                     f"as good: {self._region()}; {self._worst(unit)}"]
            lines += self.grains.lines(unit) if self.grains else []
            lines += self._products() if self.purity else []
        if self.best and self.throughput:
            per = self.throughput
            lines.append(f"throughput {per.disks} disks/s; {_grams(per.mass)} g/s in one plane of disks; "
                         f"{_grams(per.mass_per_depth)} g/s per metre of depth, as of planes {1e3 * per.depth:.3g} mm "
                         "thick")
        if self.best and self.floor:
            lines.append(f"with half of contact.min_rebound_speed: changes by {self.floor.change}, "
                         + ("it depends on it" if self.floor.depends else "no dependence seen"))
        for product in self.stages.products if self.stages else ():
            lines.append(f"product {product.stage} {product.side}: " + "; ".join(
                f"{name} purity {product.purity.mass[name]} by mass, recovery {product.recovery.mass[name]}"
                for name in self.machine.scene.species) + f"; {_grams(product.throughput)} g/s in one plane of disks")
        if self.best and self.known:
            lines.append(self.known)
        lines.append(f"cost: {counted(self.cost.runs, 'run')}, {self.cost.simulated:.4g} s simulated, "
                     f"{self.cost.processor:.3g} s of processor time")
        return lines + [f"warning: {text}" for text in self.warnings]

    def _way(self) -> str:
        """Which way the sign is."""
        if not self.machine.is_signed:
            return ""
        names, value = self.machine.scene.species, self.separation.value
        if self.machine.kind == "closed":  # of velocities: above 0 the first is the faster one to the right
            return f": {names[value < 0.0]} drifts to the right of {names[value > 0.0]}"
        left = [self.recovery.left.number[name] for name in names] if self.recovery else [None]
        return ": " + which_way(value, names, [share.value for share in left] if all(left) else None)

    def _products(self) -> list[str]:
        """By mass first, with the feed's own beside: a purity of 0.78 of a feed of 0.76 is none."""
        feed, lines = self.feed, []
        for side in ("left", "right"):
            for name in self.machine.scene.species:
                purity, recovery = ([_text(of[side][by][name]) for by in ("mass", "number")]
                                    for of in (self.purity, self.recovery))
                lines.append(f"{side}: {name} purity {purity[0]} by mass (feed {feed.mass[name]:.2g}), {purity[1]} by "
                             f"number (feed {feed.number[name]:.2g}); recovery {recovery[0]}"
                             + (f" by mass, {recovery[1]} by number" if recovery[1] != recovery[0] else ""))
        return lines

    def _worst(self, unit: str) -> str:
        """What the worst of those that are as good may lose."""
        most, value = self.as_good.may_lose.max(), abs(self.separation.value)
        if not most > 0.0:
            return "no other setting is as good"
        bounded = self.machine.is_signed or self.machine.share_goal
        loss = f"all of the {value:.2g}" if bounded and most >= value else at_most(most)
        return f"the worst of them may lose {loss}{unit}"

    def _region(self) -> str:
        part = len(self.as_good) / (len(self.map) + self.idle)
        spans = ", ".join(f"{key} {self.as_good[key].min():g} to {_with_unit(key, self.as_good[key].max())}"
                          for key in self.machine.keys)
        return f"{spans} ({percent(part)} of the ranges)"

    def next_stage(self, side: str, over: Any, **options: Any) -> Answer:
        """The machine that takes what leaves this one, at its best settings, at a side: a search of its own, whose
        scene is fed at the rate, in the numbers and with the sizes that leave. Of the best of it `stages` has, from
        runs of all stages, each fed with the very grains that leave the one before: `products` that no further stage
        takes, with their stage, side, throughput [kg/s], purity and recovery of all that is fed, by mass and by number,
        with intervals; and of one such run the `balance` of grains: fed, at each end, and inside of each stage.

        side     "left" or "right"
        over     ranges of the next machine's keys; else it is as this one
        options  of separate()
        Raises ValueError, also for a machine that is not fed, or where nothing leaves there. Warns where the stage
        undoes this one.
        """
        from . import separate
        from .stages import next_stage

        return next_stage(self, side, over, separate, **options)

    def plot(self, axes: Any = None) -> Any:
        """Draws the surface with the settings that are as good. Returns matplotlib's axes."""
        from ratchet_sieve.plots.answer import draw

        return draw(self, axes)

    def as_json(self) -> dict:
        """As `sieve_separate --json` writes it; what is undefined is None."""
        names = ("best", "separation", "separated", "bound", "throughput", "feed", "purity", "recovery", "inside",
                 "floor", "stages", "spread", "known", "warnings", "cost")
        return {"goal": self.machine.goal, "within": self.within,
                **{name: _plain(getattr(self, name)) for name in names},
                "depends_on": None if self.depends_on is None else self.depends_on.to_dict("records"),
                "as_good": json.loads(self.as_good.to_json(orient="records", double_precision=6))}

    def write(self, path: Any) -> None:
        """Writes the answer; the ending selects the form: .html, .json, .csv (its map), or a picture's (.png, .svg,
        .pdf). Raises OSError, ValueError."""
        self.machine.write(path, {
            ".html": self._page,
            ".csv": lambda: self.map.to_csv(index=False),
            ".json": lambda: json.dumps(self.as_json(), ensure_ascii=False, allow_nan=False, indent=1) + "\n"},
            self.plot)

    def _page(self) -> str:
        from .page import page_of

        return page_of(self)


def _with_unit(key: str, value: float) -> str:
    from ratchet_sieve.plots.means import plain_label

    unit = plain_label(key)[1]
    return f"{value:g} {unit}".rstrip()


def _text(interval: Optional[Interval]) -> str:
    return "undefined" if interval is None else str(interval)


def _grams(interval: Interval) -> Interval:
    return Interval(1e3 * interval.value, interval.half_width and 1e3 * interval.half_width, interval.count)


def _plain(value: Any) -> Any:
    if isinstance(value, Interval):
        return {"value": value.value, "half_width": value.half_width, "count": value.count}
    if isinstance(value, dict):
        return {key: _plain(item) for key, item in value.items()}
    if isinstance(value, list):
        return [_plain(item) for item in value]
    return value
