"""What the programs that draw tables have in common."""
import argparse
import pathlib
import sys

from ratchet_sieve.plots.style import GREY, save, styled
from ratchet_sieve.tables import Refusal, read_table, write_each


def parser_of(module, description, help_of_directory):
    """For `python3 -m ratchet_sieve.plots.MODULE`."""
    parser = argparse.ArgumentParser(prog=f"ratchet_sieve.plots.{module}", description=description)
    parser.add_argument("directory", metavar="DIR", type=pathlib.Path, help=help_of_directory)
    return parser


def run_program(name, draw):
    """Draws. An error is one line: exit status 2 if something cannot be read or drawn, 1 if it cannot be written."""
    try:
        with styled():
            write_each(name, [draw])
    except Refusal as refusal:
        print(f"{name}: {refusal}", file=sys.stderr)
        sys.exit(2)


def run_of(directory):
    """The run that the tables were made from, as Rows of one line."""
    table = read_table(directory / "run.csv")
    if not len(table):
        raise Refusal(f"{table.path}: has no line below its head")
    return table


def write(figure, path, run):
    """Writes a picture with the run's hash, seed and version, and prints its path."""
    figure.align_ylabels()
    lowest_left = min(figure.axes, key=lambda axes: (axes.get_position().y0, axes.get_position().x0))
    scene_hash, seed, version = (run.column(name).iloc[0] for name in ("scene_hash", "seed", "version"))
    lowest_left.annotate(f"scene {scene_hash}, seed {seed}, ratchet_sieve {version}",
                         (0.0, 0.0), (0.0, -36.0), xycoords="axes fraction", textcoords="offset points", va="top",
                         fontsize=7, color=GREY)
    save(figure, path, svg=False, bbox_inches="tight")
    print(path)
