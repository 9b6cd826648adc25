"""What a study is: its sweeps, what its rows come to, its pictures, its claims and its figures."""
import dataclasses
from typing import Callable

from ratchet_sieve import plots
from ratchet_sieve.texts import span

# Keys of sweeps.
THETA, F, TEETH, A = "base.inclination", "base.frequency", "base.teeth", "base.asymmetry"
D, E, V_MIN = "density", "species.0.restitution", "contact.min_rebound_speed"


def means(rows, field, *keys):
    """@return map from the values of these keys, in order, to the field's Mean"""
    return {place: cell.mean(field) for place, cell in sorted(rows.by(*keys).items())}


def over(rows, fields, *keys):
    """@return map from the values of these keys, in order, to the Means of several fields"""
    return {place: tuple(cell.mean(field) for field in fields) for place, cell in sorted(rows.by(*keys).items())}


WAYS = ("a_m_per_s", "b_m_per_s")  # columns of what ways() gives, in a CSV file


def ways(rows, *keys):
    """@return map from the values of these keys, in order, to both kinds' mean velocities [m/s]"""
    return over(rows, ("mean_vx.A", "mean_vx.B"), *keys)


def axis(means, index):
    """The values of one key of a map's places, in order."""
    return sorted({place[index] for place in means})


def told(mean):
    """A mean in words."""
    return "—" if mean is None else mean.text()


def csv_lines(keys, fields, cells):
    """A table for a CSV file: the values of the keys, each field's mean and its error, and the number of samples.
    @param cells map from the values of the keys to the fields' Means; None: not defined"""
    lines = []
    for place, found in cells.items():
        found = found if isinstance(found, (tuple, list)) else (found,)
        place = place if isinstance(place, tuple) else (place,)
        lines.append([*(f"{value:g}" if isinstance(value, float) else value for value in place),
                      *(number for mean in found for number in numbers_of(mean)),
                      max((mean.count for mean in found if mean), default=0)])
    return [*keys, *(name for field in fields for name in (field, f"{field}_error")), "n"], lines


def numbers_of(mean):
    return ("", "") if mean is None else (f"{mean.value:.6g}", f"{mean.error or 0.0:.2g}")


def family(axes, curves, scale=1.0, **options):
    """Curves in the colours of a scale, each with its name for a legend. @param curves map from name to points"""
    for (name, points), colour in zip(curves.items(), plots.ramp(len(curves))):
        plots.curve(axes, points, scale, color=colour, label=name, **options)


def named_curves(axes, curves, colours, scale=1.0):
    """Curves whose names will stand at their ends. @param curves map from name to points
    @return what plots.end_labels takes"""
    ends = []
    for (name, points), colour in zip(curves.items(), colours):
        plots.curve(axes, points, scale, color=colour)
        ends.append((scale * points[-1][1].value, name, colour))
    return ends


MARKERS = "os^Dv"


def kind_curves(axes, pairs, kinds, k, **options):
    """The mean velocities of two kinds, each in its colour; their lines and markers are those of the k-th pair.
    @param pairs map from x to both"""
    for index, (kind, colour) in enumerate(zip(kinds, plots.COLOURS)):
        plots.curve(axes, [(x, pair[index]) for x, pair in pairs.items()], plots.MM, color=colour, marker=MARKERS[k],
                    linestyle=("-", "--", ":")[k], markersize=4, label=kind, **options)


@dataclasses.dataclass(frozen=True)
class Picture:
    name: str      # of its files, after the document's
    caption: str   # what it shows; then, after a semicolon, its bars
    draw: Callable  # numbers -> matplotlib figure; of one panel, axes and numbers -> nothing
    sweeps: tuple = ()  # names of those that it shows; empty: all of the study
    size: tuple = None  # of one panel [inches]

    def figure(self, numbers):
        if not self.size:
            return self.draw(numbers)
        figure, axes = plots.panels(1, 1, self.size)
        self.draw(axes, numbers)
        return figure


@dataclasses.dataclass(frozen=True)
class Study:
    name: str
    title: str
    sweeps: tuple      # of names of files of config/sweeps, without .yaml
    evaluate: Callable  # {sweep's name: Rows} -> numbers, whatever the study's other parts take
    pictures: tuple    # of Picture; the first is the one that a document shows
    claims: Callable   # numbers -> list of Claim
    text: Callable = lambda numbers: ""  # numbers -> Markdown that follows the checks
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
