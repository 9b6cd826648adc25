"""Which machine parts a mixture best, how well, and how surely; see docs/separate.md."""
from __future__ import annotations

import re
import time
from typing import Any, Mapping, Optional, Union

from ..arguments import integer, number
from ..progress import Progress
from ..scene import AnyScene
from .answer import Answer
from .final import answer_of
from .grains import Grains
from .machine import WITHIN, Machine
from .search import Search

SHARE_OF_SEARCH = 0.6  # of the budget: the rest is for the fresh runs
SHARE_OF_END = 0.03    # of it, to put the answer together
_UNITS = {"": 1.0, "s": 1.0, "min": 60.0, "h": 3600.0}


def separate(scene: AnyScene, over: Mapping[str, tuple[float, float]], *, within: Optional[float] = None,
             budget: Union[float, str, None] = None, goal: Optional[str] = None, unknown: Any = None,
             seed: int = 1, results: Any = None, threads: int = 0, progress: bool = True) -> Answer:
    """Which settings of a machine part its kinds best, how well, and how surely.

    scene     a Scene, the path of a scene file, or a mapping
    over      dotted key -> (from, to)
    within    no other setting is better by more than this, and half the width of the result's interval, both at 95 %;
              default 0.02, of a machine without open ends 0.001 m/s
    budget    wall time [s], or a text such as "2 min", by which the call ends: its runs are cut and count for what
              they have. The last 40 % of it are for the best with fresh seeds. None: as long as it takes
    goal      a column of a sweep's results (docs/sweeps.md) that is to be large, such as "purity.left.mass.A", in
              place of the separation; `within` is then required, in its units
    unknown   key -> (low, high), or (value, "±", error at 95 %): of what is not known each run draws its own. The
              search finds what is best on the mean. None: of Grains that calibrate() gave, what they leave unknown
    seed      of the search and of the runs: the same gives the same answer, where no budget ends it
    results   file that keeps the runs (SQLite): the same call continues. None: kept nowhere
    threads   0: one per processor
    progress  whether to say on standard error what it will cost, and to show a bar in a terminal or a notebook
    Raises SceneError, ValueError before anything runs, RuntimeError where the machine works nowhere. Ctrl-C and the end
    of the budget give the answer so far, with a warning; before there is any, KeyboardInterrupt and ValueError. After
    Ctrl-C the best gets fresh seeds for 2 s, or a tenth of the time so far; a second one ends that.
    """
    if unknown is None and isinstance(scene, Grains):
        unknown = scene.unknown
    machine = Machine(scene, over, goal, unknown)
    if within is None and goal is not None:
        raise ValueError(f"within: must be given, in the units of {goal}")
    within = number("within", WITHIN[machine.kind] if within is None else within)
    if within <= 0.0 or machine.kind != "closed" and machine.is_signed and within >= 1.0:
        raise ValueError(f"within = {within!r}: must be above 0" + ("" if within <= 0.0 else " and below 1"))
    seconds = _seconds(budget)
    limit = Budget(seconds, time.monotonic())
    search = Search(machine, within, seed, threads=integer("threads", threads), results=results)
    with Progress(progress, "separate") as bar:
        return answer_of(search, limit, bar)


class Budget:
    """Wall time. @ivar seconds of it; of_search, end of time.monotonic(): when the search and the call end. None: no
    limit"""

    def __init__(self, seconds: Optional[float], begin: float):
        self.seconds = seconds
        self.of_search = None if seconds is None else begin + SHARE_OF_SEARCH * seconds
        self.end = None if seconds is None else begin + (1.0 - SHARE_OF_END) * seconds


def _seconds(budget: Union[float, str, None]) -> Optional[float]:
    """Raises ValueError."""
    if isinstance(budget, str):
        match = re.fullmatch(r"([0-9.]+) *([a-z]*)", budget)
        if match and match[2] in _UNITS and match[1].count(".") < 2 and match[1] != ".":
            budget = float(match[1]) * _UNITS[match[2]]
        else:
            raise ValueError(f'budget = {budget!r}: must be seconds, or a text such as "90 s", "2 min" or "1 h"')
    return None if budget is None else number("budget", budget, 0.0, unit="s")
