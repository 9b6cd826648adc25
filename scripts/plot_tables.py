"""Reads tables of runs, and what all pictures have in common."""
import contextlib
import csv
import io
import math
import pathlib
import sys

import matplotlib

matplotlib.use('Agg')
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.ticker import LogLocator, MaxNLocator, NullFormatter  # noqa: E402

MM = 1e3  # per m
UJ = 1e6  # per J

# Okabe and Ito's colours, which colour-blind readers can distinguish.
COLOURS = ['#0072B2', '#D55E00', '#009E73', '#CC79A7', '#E69F00', '#56B4E9']
GREY = '#555555'

STYLE = {
    'figure.dpi': 150,
    'font.size': 9,
    'axes.spines.top': False,
    'axes.spines.right': False,
    'axes.grid': True,
    'grid.color': '#E6E6E6',
    'axes.axisbelow': True,
    'axes.titlesize': 9,
    'axes.titleweight': 'bold',
    'legend.frameon': False,
    'legend.fontsize': 8,
    'lines.linewidth': 1.4,
}


class Refusal(Exception):
    """An error of reading or drawing, in one line."""


class Row(dict):
    """A line of a table, from column to text."""

    def __init__(self, path, columns, line):
        super().__init__(zip(columns, line))
        self.path = path

    def __missing__(self, column):
        raise Refusal(f'{self.path}: has no column {column}')

    def number(self, column):
        """An empty field is undefined: NaN, which interrupts a drawn line."""
        try:
            return float(self[column]) if self[column] else math.nan
        except ValueError as error:
            raise Refusal(f'{self.path}: {column}: {self[column]}: must be a number') from error


def read_csv(path):
    """@return the names of the columns, and lines of as many fields. @throws Refusal a damaged or cut file"""
    try:
        text = pathlib.Path(path).read_bytes().decode('utf-8')
        lines = list(csv.reader(io.StringIO(text, newline=''), strict=True))
    except (UnicodeDecodeError, csv.Error) as error:
        raise Refusal(f'{path}: no table: {error}') from error
    if not text.endswith('\n'):
        raise Refusal(f'{path}: cut off, its last line has no end')
    for count, line in enumerate(lines, 1):
        if len(line) != len(lines[0]):
            raise Refusal(f'{path}: line {count}: {len(line)} fields, must be {len(lines[0])}')
    return lines[0], lines[1:]


class Table:
    """A CSV file by its columns, which are named without their units."""

    def __init__(self, path):
        columns, lines = read_csv(path)
        names = [column.split(' [')[0] for column in columns]
        self.rows = [Row(path, names, line) for line in lines]

    def numbers(self, column, scale=1.0):
        return [scale * row.number(column) for row in self.rows]

    def values(self, column):
        """The distinct values of a column, in the order of the file."""
        return list(dict.fromkeys(row[column] for row in self.rows))

    def where(self, column, value):
        part = Table.__new__(Table)
        part.rows = [row for row in self.rows if row[column] == value]
        return part


def of_run(directory):
    """The run that the tables were made from."""
    path = directory / 'run.csv'
    for row in Table(path).rows:
        return row
    raise Refusal(f'{path}: has no line below its head')


@contextlib.contextmanager
def writing(path):
    """Adds the file's name to an error of writing, such as a full disk."""
    try:
        yield
    except OSError as error:
        raise OSError(error.errno, error.strerror, str(path)) from error


def run_program(name, draw):
    """Draws. An error is one line: exit status 2 if something cannot be read or drawn, 1 if it cannot be written."""
    try:
        with matplotlib.rc_context(STYLE):
            draw()
    except OSError as error:
        sys.exit(f'{name}: {error.filename}: {error.strerror}')
    except Refusal as refusal:
        print(f'{name}: {refusal}', file=sys.stderr)
        sys.exit(2)


def write(figure, path, run):
    """Writes a picture with the run's hash, seed and version, and prints its path."""
    figure.align_ylabels()
    lowest_left = min(figure.axes, key=lambda axes: (axes.get_position().y0, axes.get_position().x0))
    lowest_left.annotate(f"scene {run['scene_hash']}, seed {run['seed']}, ratchet_sieve {run['version']}",
                         (0.0, 0.0), (0.0, -36.0), xycoords='axes fraction', textcoords='offset points', va='top',
                         fontsize=7, color=GREY)
    with writing(path):
        figure.savefig(path, bbox_inches='tight')
    plt.close(figure)
    print(path)


def any_defined(values):
    return any(not math.isnan(value) for value in values)


def say_undefined(axes, text):
    axes.text(0.5, 0.5, text, transform=axes.transAxes, ha='center', va='center', color=GREY)


def beside(axes, **options):
    """A legend to the right of the axes; none if nothing was recorded."""
    if not axes.get_legend_handles_labels()[0]:
        return
    axes.legend(loc='upper left', bbox_to_anchor=(1.01, 1.02), borderaxespad=0.0, **options)
