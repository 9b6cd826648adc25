"""What a batch becomes in a machine."""
from __future__ import annotations

import dataclasses
from typing import Any

from ratchet_sieve.arguments import number
from ratchet_sieve.values import Values

SECONDS = 3600.0  # of an hour


@dataclasses.dataclass(repr=False)
class Batch:
    """Of so many `kilograms` of feed per metre of depth: `hours`, and `products`, .left.A and so on [kg], with
    intervals at 95 %, for a machine of the same depth."""

    kilograms: float
    hours: Any
    products: Values

    def __str__(self) -> str:
        return "\n".join([f"{self.kilograms:g} kg per metre of depth: {self.hours} h",
                          *(f"{side}: " + ", ".join(f"{name} {mass} kg" for name, mass in masses.items())
                            for side, masses in self.products.items())])

    __repr__ = __str__


def batch_of(answer: Any, kilograms: float) -> Batch:
    """Raises ValueError."""
    kilograms = number("kilograms", kilograms)
    if kilograms <= 0.0:
        raise ValueError(f"kilograms = {kilograms:g}: must be above 0")
    if not answer.throughput or not answer.throughput.mass_per_depth:
        raise ValueError("batch: there are no runs of an open machine that say what leaves")
    flow, feed = answer.throughput.mass_per_depth, answer.feed.mass

    def mass(side: str, name: str) -> Any:
        """The feed's share of it is known, so that its error is that of the recovery."""
        recovery = answer.recovery[side].mass[name]
        if recovery is None:
            raise ValueError(f"batch: no {name} has left in the runs")
        return _times(recovery, kilograms * feed[name])

    return Batch(kilograms, _times(flow, kilograms / flow.value ** 2 / SECONDS),
                 Values((side, Values((name, mass(side, name)) for name in feed)) for side in ("left", "right")))


def _times(interval: Any, factor: float) -> Any:
    """With the same relative error."""
    return dataclasses.replace(interval, value=factor * interval.value,
                               half_width=interval.half_width and factor * interval.half_width)
