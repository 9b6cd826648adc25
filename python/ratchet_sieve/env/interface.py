"""The classes of Gymnasium that the environments are derived from; where it is not installed, none."""
from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

try:
    from gymnasium import Env
    from gymnasium.spaces import Box
    from gymnasium.vector import VectorEnv
except ImportError:
    Env = VectorEnv = object

    class Box(NamedTuple):
        """The bounds of the elements of an array."""

        low: np.ndarray
        high: np.ndarray
        dtype: Any

        @property
        def shape(self) -> tuple[int, ...]:
            return self.low.shape

try:
    from gymnasium.vector import AutoresetMode
except ImportError:
    AutoresetMode = None

__all__ = ["AutoresetMode", "Box", "Env", "VectorEnv"]
