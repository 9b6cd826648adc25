"""A line that shows how far a long call has come."""
from __future__ import annotations

import os
import sys
import time
from typing import Optional

WIDTH = 30    # of the bar, in characters
COLUMNS = 80  # of a terminal that does not say how many it has


class Progress:
    """A bar on standard error, if that is a terminal or a notebook; erased at the end."""

    def __init__(self, shown: bool, what: str):
        self._what, self._said = what, shown
        self._begin = time.monotonic()
        self.announced: Optional[float] = None  # how long the call is expected to take [s]
        self._shown = shown and (sys.stderr.isatty() or "ipykernel" in sys.modules)

    def __enter__(self) -> Progress:
        return self

    def __exit__(self, *error: object) -> None:
        if self._shown:
            print("\r\033[K", end="", file=sys.stderr, flush=True)

    def say(self, line: str) -> None:
        """A line of its own on standard error, also where that is no terminal."""
        if self._said:
            erase = "\r\033[K" if self._shown else ""
            print(f"{erase}{self._what}: {line}", file=sys.stderr, flush=True)

    def show(self, part: float, text: str) -> None:
        """@param part from 0 to 1"""
        if not self._shown:
            return
        elapsed = time.monotonic() - self._begin
        if self.announced is not None:
            text += f", {elapsed:.0f} s of about {self.announced:.0f}"
        elif part > 0.01:
            text += f", {elapsed * (1.0 - part) / part:.0f} s left"
        room = _columns() - 1  # a longer line would break, and stay when it is drawn anew
        bar = min(WIDTH, max(0, room - len(f"{self._what} [] {text}")))
        filled = round(bar * min(max(part, 0.0), 1.0))
        line = f"{self._what} [{'#' * filled}{' ' * (bar - filled)}] {text}"[:room]
        print(f"\r{line}\033[K", end="", file=sys.stderr, flush=True)


def _columns() -> int:
    try:
        return os.get_terminal_size(sys.stderr.fileno()).columns or COLUMNS
    except (OSError, ValueError):  # of a notebook
        return COLUMNS
