"""Goals: numbers that tell how well a sieve works, from what left it, each with its standard error."""
from __future__ import annotations

import itertools
import re
from typing import NamedTuple, Sequence

import numpy as np

FORMS = ("quality, purity:SPECIES:BIN, recovery:SPECIES:BIN, flow:SPECIES:BIN or throughput, BIN left or right; all but "
         "quality may end in :mass")
_FORM = re.compile(r"quality|(?:(?P<measure>purity|recovery|flow):(?P<species>.+):(?P<bin>left|right)|throughput)"
                   r"(?P<mass>:mass)?", re.DOTALL)

# Columns of bins, as in ratchet_sieve.env.readings.BIN_FIELDS.
LEFT, RIGHT, ON_BASE, LEFT_MASS, RIGHT_MASS = range(5)
_LEFT, _RIGHT = (LEFT, LEFT_MASS), (RIGHT, RIGHT_MASS)
_OTHER_SIDE = {_LEFT: _RIGHT, _RIGHT: _LEFT}


class Measured(NamedTuple):
    """Values with their standard errors, each an array (n,), and whether they are defined; both are 0 where not."""

    value: np.ndarray
    error: np.ndarray
    defined: np.ndarray


class Goal:
    """What is to be large: quality, purity:A:left and so on; see FORMS."""

    def __init__(self, text: str, species: Sequence[str]):
        """Raises ValueError for a text that is no goal, or names another species."""
        form = _FORM.fullmatch(text)
        if not form:
            raise ValueError(f"{text}: must be {FORMS}")
        self.text = text
        self.measure = form["measure"] or text.partition(":")[0]
        self.by_mass = bool(form["mass"])
        self.right = form["bin"] == "right"
        if form["species"] and form["species"] not in species:
            raise ValueError(f"{text}: there is no species {form['species']}; there are {', '.join(species)}")
        self.own = np.array([name == form["species"] for name in species])

    @property
    def is_share(self) -> bool:
        """Whether it is a number of 0 to 1, rather than a flow."""
        return self.measure not in ("flow", "throughput")

    def measured(self, bins: np.ndarray, durations: np.ndarray) -> Measured:
        """Of what left in n windows of time: bins (n, species, 5), durations (n,) [s]."""
        with np.errstate(divide="ignore", invalid="ignore"):
            if self.measure == "quality":
                return _quality(bins)
            side = _RIGHT if self.right else _LEFT
            wanted = self._amount(bins[:, self.own], side)
            if self.measure == "purity":
                return _share(wanted, self._amount(bins[:, ~self.own], side))
            if self.measure == "recovery":
                return _share(wanted, self._amount(bins[:, self.own], _OTHER_SIDE[side]))
            everything = self._amount(bins, *_OTHER_SIDE)
            part = everything if self.measure == "throughput" else wanted
            error = np.sqrt(part.with_one_more(everything).variance) / durations
            return _defined(part.sum / durations, error, (durations > 0.0) & (everything.disks > 0.0))

    def _amount(self, bins: np.ndarray, *sides: tuple[int, int]) -> _Amount:
        numbers, masses = zip(*sides)
        count = bins[..., numbers].reshape(len(bins), -1)
        amount = bins[..., masses].reshape(len(bins), -1) if self.by_mass else count
        variance = np.where(count > 0.0, amount ** 2 / count, 0.0)
        return _Amount(count.sum(axis=1), amount.sum(axis=1), variance.sum(axis=1))


class _Amount(NamedTuple):
    """Disks, counted by one or by their mass, with the variance of the sum if their number is a Poisson number."""

    disks: np.ndarray
    sum: np.ndarray
    variance: np.ndarray

    def with_one_more(self, other: _Amount) -> _Amount:
        """With one more average disk (Laplace's rule): ten of ten do not prove that all are. `other` has the average
        where this has no disk."""
        each = np.where(self.disks > 0.0, self.sum / self.disks, other.sum / other.disks)
        return _Amount(self.disks + 1.0, self.sum + each, self.variance + each ** 2)


def _defined(value: np.ndarray, error: np.ndarray, defined: np.ndarray) -> Measured:
    return Measured(np.where(defined, value, 0.0), np.where(defined, error, 0.0), defined)


def _share(part: _Amount, rest: _Amount) -> Measured:
    more, more_rest = part.with_one_more(rest), rest.with_one_more(part)
    whole = more.sum + more_rest.sum
    share = more.sum / whole
    error = np.sqrt((1.0 - share) ** 2 * more.variance + share ** 2 * more_rest.variance) / whole
    return _defined(part.sum / (part.sum + rest.sum), error, part.disks + rest.disks > 0.0)


def _quality(bins: np.ndarray) -> Measured:
    """Q, eq. (2) of the paper, of the pair of species of which it is the largest."""
    counted = bins[..., LEFT] + bins[..., RIGHT]
    left = bins[..., LEFT] / counted  # not a number where none of a species left
    right = (bins[..., RIGHT] + 1.0) / (counted + 2.0)  # by Laplace's rule
    variance = right * (1.0 - right) / counted
    pairs = np.array(list(itertools.combinations(range(bins.shape[1]), 2)), dtype=int).reshape(-1, 2)
    if not len(pairs):
        none = np.zeros(len(bins))
        return Measured(none, none, none > 0.0)
    values = np.nan_to_num(np.abs(left[:, pairs[:, 0]] - left[:, pairs[:, 1]]), nan=-1.0)
    best = values.argmax(axis=1)
    rows = np.arange(len(bins))
    error = np.sqrt(variance[rows, pairs[best, 0]] + variance[rows, pairs[best, 1]])
    return _defined(values[rows, best], error, values[rows, best] >= 0.0)
