"""The classes of Gymnasium, or where it is not installed stand-ins with the same contract."""
from __future__ import annotations

import enum

try:
    from gymnasium import Env
    from gymnasium.spaces import Box
    from gymnasium.utils.seeding import np_random
    from gymnasium.vector import VectorEnv
except ImportError:
    from .stand_ins import Box, Env, VectorEnv, np_random

try:
    from gymnasium.vector import AutoresetMode
except ImportError:
    class AutoresetMode(enum.Enum):
        """When a sieve whose episode has ended begins the next one."""

        NEXT_STEP = "NextStep"
        SAME_STEP = "SameStep"
        DISABLED = "Disabled"

__all__ = ["AutoresetMode", "Box", "Env", "VectorEnv", "np_random"]
