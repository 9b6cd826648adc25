"""Stand-ins for the classes of Gymnasium 1.x that the environments are derived from, with the same contract."""
from __future__ import annotations

from typing import Any, Optional

import numpy as np


def np_random(seed: Optional[int] = None) -> tuple[np.random.Generator, int]:
    """A generator and its seed, the same as Gymnasium's; of seed None, a random one. Raises ValueError."""
    if seed is not None and not (isinstance(seed, int) and seed >= 0):
        raise ValueError(f"seed = {seed!r}: must be an int of 0 or more")
    sequence = np.random.SeedSequence(seed)
    return np.random.Generator(np.random.PCG64(sequence)), sequence.entropy


class _Seeded:
    """What has a generator of random numbers, made when it is first used."""

    _np_random: Optional[np.random.Generator] = None
    _np_random_seed: Optional[int] = None

    @property
    def np_random(self) -> np.random.Generator:
        if self._np_random is None:
            self._np_random, self._np_random_seed = np_random()
        return self._np_random

    @property
    def np_random_seed(self) -> int:
        self.np_random
        return self._np_random_seed


class Box(_Seeded):
    """The arrays of a shape and dtype with low <= x <= high, element by element."""

    def __init__(self, low: Any, high: Any, shape: Optional[tuple] = None, dtype: Any = np.float32,
                 seed: Optional[int] = None):
        self.dtype = np.dtype(dtype)
        if shape is None:
            shape = np.broadcast_shapes(np.shape(low), np.shape(high)) or (1,)
        self.shape = tuple(int(size) for size in shape)
        self.low = np.broadcast_to(np.asarray(low, dtype=self.dtype), self.shape).copy()
        self.high = np.broadcast_to(np.asarray(high, dtype=self.dtype), self.shape).copy()
        if not np.all(self.low <= self.high):
            raise ValueError(f"low = {self.low}, high = {self.high}: no low may be above its high, none may be NaN")
        self.bounded_below = self.low > -np.inf
        self.bounded_above = self.high < np.inf
        if seed is not None:
            self.seed(seed)

    def seed(self, seed: Optional[int] = None) -> int:
        self._np_random, self._np_random_seed = np_random(seed)
        return self._np_random_seed

    def is_bounded(self, manner: str = "both") -> bool:
        below, above = bool(self.bounded_below.all()), bool(self.bounded_above.all())
        try:
            return {"both": below and above, "below": below, "above": above}[manner]
        except KeyError:
            raise ValueError(f"manner = {manner!r}: must be both, below or above") from None

    def sample(self) -> np.ndarray:
        """Uniform between two bounds, exponential from one, normal without any."""
        random = self.np_random
        both = self.bounded_below & self.bounded_above
        low, high = np.where(self.bounded_below, self.low, 0.0), np.where(self.bounded_above, self.high, 0.0)
        uniform = random.uniform(np.where(both, low, 0.0), np.where(both, high, 1.0))
        from_one = random.exponential(size=self.shape)
        one = np.where(self.bounded_below, low + from_one, high - from_one)
        none = random.normal(size=self.shape)
        values = np.where(both, uniform, np.where(self.bounded_below | self.bounded_above, one, none))
        return values.astype(self.dtype)

    def contains(self, x: Any) -> bool:
        """A dtype that would lose digits is not contained; a sequence is taken as an array."""
        try:
            array = x if isinstance(x, np.ndarray) else np.asarray(x, dtype=self.dtype)
        except (TypeError, ValueError):
            return False
        return bool(np.can_cast(array.dtype, self.dtype) and array.shape == self.shape and
                    np.all(array >= self.low) and np.all(array <= self.high))

    __contains__ = contains

    def __eq__(self, other: object) -> bool:
        return (isinstance(other, Box) and self.shape == other.shape and self.dtype == other.dtype and
                np.array_equal(self.low, other.low) and np.array_equal(self.high, other.high))

    def __repr__(self) -> str:
        return f"Box({self.low.tolist()}, {self.high.tolist()}, {self.shape}, {self.dtype})"


class Env(_Seeded):
    """One environment."""

    metadata: dict[str, Any] = {"render_modes": []}
    render_mode: Optional[str] = None
    spec = None

    def reset(self, *, seed: Optional[int] = None, options: Optional[dict] = None) -> Any:
        if seed is not None:
            self._np_random, self._np_random_seed = np_random(seed)

    def close(self) -> None:
        pass

    @property
    def unwrapped(self) -> Env:
        return self

    def __enter__(self) -> Env:
        return self

    def __exit__(self, *error: Any) -> bool:
        self.close()
        return False


class VectorEnv(_Seeded):
    """Several environments of a kind, stepped together."""

    metadata: dict[str, Any] = {}
    render_mode: Optional[str] = None
    spec = None
    closed = False

    def close(self, **keywords: Any) -> None:
        if not self.closed:
            self.close_extras(**keywords)
            self.closed = True

    def close_extras(self, **keywords: Any) -> None:
        pass

    @property
    def unwrapped(self) -> VectorEnv:
        return self
