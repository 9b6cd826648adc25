"""What a study is: its sweeps, what its rows come to, its pictures, its claims and its figures."""
import dataclasses
from typing import Callable

from ratchet_sieve.texts import span


def axis(means, index):
    """The values of one key of a map's places, in order."""
    return sorted({place[index] for place in means})


def told(mean, scale=1.0):
    """A mean in words."""
    return "—" if mean is None else mean.text(scale)


@dataclasses.dataclass(frozen=True)
class Sweep:
    """A file of config/sweeps, by its name without .yaml."""
    name: str
    needed: dict = dataclasses.field(default_factory=dict)  # values that --quick keeps, of some keys
    is_quick: bool = True  # False: --quick leaves it out, and the study gets no rows of it


@dataclasses.dataclass(frozen=True)
class Picture:
    name: str      # of its files, after the document's
    caption: str   # one line
    draw: Callable  # numbers -> matplotlib figure
    sweeps: tuple = ()  # names of those that it shows; empty: all of the study


@dataclasses.dataclass(frozen=True)
class Study:
    name: str
    title: str
    sweeps: tuple      # of Sweep
    evaluate: Callable  # {sweep's name: Rows} -> numbers, whatever the study's other parts take
    pictures: tuple    # of Picture
    claims: Callable   # numbers -> list of Claim
    text: Callable = lambda numbers: ""  # numbers -> Markdown that follows the pictures: tables
    figures: Callable = lambda numbers: {}  # numbers -> key -> text: what other documents may quote
    tables: Callable = lambda numbers: {}  # numbers -> file's name without .csv -> (header, lines)


@dataclasses.dataclass
class Outcome:
    """A study that was run."""
    study: Study
    numbers: object
    rows: dict  # of each sweep

    def claims(self):
        return self.study.claims(self.numbers)

    def samples(self, picture):
        """How many independent ones each point of a picture has, in words."""
        counts = set()
        for name, rows in self.rows.items():
            if rows and (not picture.sweeps or name in picture.sweeps):
                counts.add(len(rows.values("seed")))
        return f"n = {span(sorted(counts))} {'runs' if counts != {1} else 'run'} a point" if counts else ""
