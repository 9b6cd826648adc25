"""What a study is: its sweeps, what its rows come to, its pictures, its claims and its figures."""
import dataclasses
from typing import Callable

from ratchet_sieve import plots
from ratchet_sieve.texts import span, table


def means(rows, field, *keys):
    """@return map from the values of these keys, in order, to the field's Mean"""
    return {place: cell.mean(field) for place, cell in sorted(rows.by(*keys).items())}


def ways(rows, *keys):
    """@return map from the values of these keys, in order, to both kinds' mean velocities [m/s]"""
    return {place: (cell.mean("mean_vx.A"), cell.mean("mean_vx.B")) for place, cell in sorted(rows.by(*keys).items())}


def axis(means, index):
    """The values of one key of a map's places, in order."""
    return sorted({place[index] for place in means})


def told(mean, scale=1.0):
    """A mean in words."""
    return "—" if mean is None else mean.text(scale)


def velocity_table(means, corner, row, column):
    """@param means map from the values of row and column to a mean velocity. @param row, column how a value is written
    """
    xs, ys = axis(means, 0), axis(means, 1)
    return ("⟨V_x⟩ in mm/s:\n\n"
            + table([corner, *map(column, ys)], [[row(x), *(means[x, y].text(plots.MM) for y in ys)] for x in xs]))


def named_curves(axes, curves, colours, scale=1.0):
    """Curves whose names will stand at their ends. @param curves map from name to points
    @return what plots.end_labels takes"""
    ends = []
    for (name, points), colour in zip(curves.items(), colours):
        plots.curve(axes, points, scale, color=colour)
        ends.append((scale * points[-1][1].value, name, colour))
    return ends


def kind_curves(axes, pairs, kinds, colour, **options):
    """The mean velocities of two kinds in one colour, the second dashed. @param pairs map from x to both"""
    for index, (kind, style) in enumerate(zip(kinds, ("-", "--"))):
        plots.curve(axes, [(x, pair[index]) for x, pair in pairs.items()], plots.MM, color=colour, linestyle=style,
                    label=kind, **options)


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
