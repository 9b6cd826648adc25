"""What arguments may be. An error is one line: the argument, its value and what is allowed."""
from __future__ import annotations

import math
import operator
import os
from typing import Any, Mapping

MOST = 2 ** 64 - 1  # of the engine's integers


def number(name: str, value: Any, least: float = -math.inf, most: float = math.inf, unit: str = "") -> float:
    """A finite number in a range. Raises ValueError."""
    try:
        found = math.nan if isinstance(value, (str, bytes)) else float(value)
    except (TypeError, ValueError, OverflowError):
        found = math.nan
    if not (math.isfinite(found) and least <= found <= most):
        unit = f" {unit}" if unit else ""
        span = f"{least:g} to {most:g}{unit}" if most < math.inf else f"{least:g}{unit} or more" \
            if least > -math.inf else "a finite number" + (unit and f" in{unit}")
        raise ValueError(f"{name} = {value!r}: must be {span}")
    return found


def integer(name: str, value: Any, least: int = 0, most: int = MOST) -> int:
    """Raises ValueError."""
    try:
        found = operator.index(value)
    except TypeError:
        found = None
    if found is None or not least <= found <= most:
        span = f"{least} or more" if most == MOST and (found is None or found < least) else f"{least} to {most}"
        raise ValueError(f"{name} = {value!r}: must be an integer, {span}")
    return found


def path_of(name: str, value: Any) -> str:
    """Of a file. Raises ValueError."""
    try:
        return os.fsdecode(value)
    except TypeError:
        raise ValueError(f"{name} = {value!r}: must be the path of a file") from None


def mapping(name: str, value: Any, example: str) -> Mapping[str, Any]:
    """Raises ValueError."""
    if not isinstance(value, Mapping):
        raise ValueError(f"{name} = {value!r}: must be a mapping, such as {example}")
    return value
