"""A line that shows how far a long call has come."""
from __future__ import annotations

import sys
import time

WIDTH = 30  # of the bar, in characters


class Progress:
    """A bar on standard error, if that is a terminal or a notebook; erased at the end."""

    def __init__(self, shown: bool, what: str):
        self._what = what
        self._begin = time.monotonic()
        self._shown = shown and (sys.stderr.isatty() or "ipykernel" in sys.modules)

    def __enter__(self) -> Progress:
        return self

    def __exit__(self, *error: object) -> None:
        if self._shown:
            print("\r\033[K", end="", file=sys.stderr, flush=True)

    def show(self, part: float, text: str) -> None:
        """@param part from 0 to 1"""
        if not self._shown:
            return
        filled = round(WIDTH * min(max(part, 0.0), 1.0))
        elapsed = time.monotonic() - self._begin
        left = f", {elapsed * (1.0 - part) / part:.0f} s left" if part > 0.01 else ""
        print(f"\r{self._what} [{'#' * filled}{' ' * (WIDTH - filled)}] {text}{left}\033[K", end="",
              file=sys.stderr, flush=True)
