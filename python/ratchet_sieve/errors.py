"""The errors of the engine."""
from __future__ import annotations

import sys
import warnings
from types import FrameType
from typing import Any, Optional


class SceneError(ValueError):
    """An illegal scene or sweep; its text is the line that the programs print.

    key      dotted path of the key, such as "base.inclination"; "" if the error is about no key
    value    as it was given, as text; "" if the error is about no value
    allowed  what is allowed, or what is wrong
    """

    def __init__(self, line: str, key: str = "", value: str = "", allowed: str = ""):
        super().__init__(line)
        self.key = key
        self.value = value
        self.allowed = allowed

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (str(self), self.key, self.value, self.allowed)


class StallError(RuntimeError):
    """An inelastic collapse ended the run (contact.on_collapse: stop)."""


class StateError(ValueError):
    """Bytes that are no saved state of such a scene."""


class ResultsError(RuntimeError):
    """A results file of sweeps that cannot be used."""


class BagError(ValueError):
    """A bag that cannot be read, or no rosbag to read it by."""


class SieveWarning(UserWarning):
    """A legal but implausible scene, or a run to be looked at."""


def warn(text: str) -> None:
    """Warns of the line outside the package that has led here."""
    level = 1
    frame: Optional[FrameType] = sys._getframe()
    while frame and f"{frame.f_globals.get('__name__')}.".startswith(f"{__package__}."):
        level += 1
        frame = frame.f_back
    warnings.warn(text, SieveWarning, stacklevel=level)
