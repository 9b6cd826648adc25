#!/usr/bin/python3
"""Draws the tables that sieve_analyze wrote into a directory, and prints the paths of the pictures."""
import argparse
import csv
import math
import pathlib
import sys

import matplotlib

matplotlib.use('Agg')
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.ticker import MaxNLocator  # noqa: E402

MM = 1e3  # per m
UJ = 1e6  # per J

FEWEST_DISKS = 5  # of which a distribution is drawn

# Okabe and Ito's colours, which colour-blind readers tell apart.
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


def number(text):
    """A field as a number; an empty one is not defined and breaks a line."""
    return float(text) if text else math.nan


class Table:
    """A CSV file by its columns."""

    def __init__(self, path):
        with open(path, newline='', encoding='utf-8') as file:
            self.rows = list(csv.DictReader(file))

    def numbers(self, column, scale=1.0):
        return [scale * number(row[column]) for row in self.rows]

    def values(self, column):
        """The different values of a column, in the order in which they come."""
        return list(dict.fromkeys(row[column] for row in self.rows))

    def where(self, column, value):
        part = Table.__new__(Table)
        part.rows = [row for row in self.rows if row[column] == value]
        return part


def any_defined(values):
    return any(not math.isnan(value) for value in values)


def say_undefined(axes, text):
    axes.text(0.5, 0.5, text, transform=axes.transAxes, ha='center', va='center', color=GREY)


def beside(axes, **options):
    """A legend to the right of the axes, where it covers nothing; none where nothing was recorded."""
    if not axes.get_legend_handles_labels()[0]:
        return
    axes.legend(loc='upper left', bbox_to_anchor=(1.01, 1.02), borderaxespad=0.0, **options)


def plot_bins(axes, bins):
    for colour, species in zip(COLOURS, bins.values('species')):
        part = bins.where('species', species)
        time = part.numbers('time')
        axes.step(time, part.numbers('left'), where='post', color=colour, linestyle='--', label=f'{species} left')
        axes.step(time, part.numbers('right'), where='post', color=colour, label=f'{species} right')
        axes.step(time, part.numbers('on_base'), where='post', color=colour, linestyle=':', linewidth=1.0,
                  label=f'{species} on the base')
    axes.set_ylabel('disks')
    axes.set_ylim(bottom=0)
    axes.yaxis.set_major_locator(MaxNLocator(integer=True))
    axes.set_title('Bins', loc='left')
    beside(axes)


def plot_segregation(axes, segregation):
    time = segregation.numbers('time')
    quality, processed = segregation.numbers('quality'), segregation.numbers('processed')
    if any_defined(quality + processed):
        axes.step(time, quality, where='post', color='black', label='quality $Q$')
        axes.step(time, processed, where='post', color=COLOURS[2], label='processed $P$')
        beside(axes)
    else:
        say_undefined(axes, 'undefined: no disk was counted')
    axes.set_ylim(-0.02, 1.05)
    axes.set_ylabel('ratio')
    axes.set_title('Segregation', loc='left')


def plot_drive(axes, drive, quantity, label, colour):
    time, applied = drive.numbers('time'), drive.numbers(quantity)
    axes.step(time, drive.numbers('commanded_' + quantity), where='post', color=GREY, linestyle=':', linewidth=1.2,
              label='commanded')
    axes.plot(time, applied, color=colour, label='applied')
    axes.set_ylabel(label)
    if applied and max(applied) - min(applied) < 1e-9:
        margin = max(0.1 * abs(applied[0]), 0.01)
        axes.set_ylim(applied[0] - margin, applied[0] + margin)
    beside(axes)


def draw_segregation(directory):
    drive = Table(directory / 'drive.csv')
    figure, axes = plt.subplots(4, 1, sharex=True, figsize=(7.5, 7.5),
                                gridspec_kw={'height_ratios': (3, 2, 1.2, 1.2)})
    plot_bins(axes[0], Table(directory / 'bins.csv'))
    plot_segregation(axes[1], Table(directory / 'segregation.csv'))
    plot_drive(axes[2], drive, 'inclination', r'$\theta$ [rad]', COLOURS[4])
    axes[2].set_title('Inclination', loc='left')
    plot_drive(axes[3], drive, 'frequency', '$f$ [Hz]', COLOURS[5])
    axes[3].set_title('Frequency', loc='left')
    axes[3].set_xlabel('time [s]')
    figure.subplots_adjust(hspace=0.35)
    return figure


def draw_displacements(directory):
    table = Table(directory / 'displacements.csv')
    names = table.values('species')
    figure, axes = plt.subplots(max(len(names), 1), 1, sharex=True, squeeze=False,
                                figsize=(6.5, 1.2 + 2.3 * max(len(names), 1)))
    times = table.values('time')
    shades = plt.get_cmap('viridis_r')
    for row, species in zip(axes[:, 0], names):
        part = table.where('species', species)
        for index, time in enumerate(times):
            histogram = part.where('time', time)
            disks = int(sum(histogram.numbers('count')))
            if disks < FEWEST_DISKS:
                continue
            edges = histogram.numbers('from', MM) + histogram.numbers('to', MM)[-1:]
            row.step(edges, histogram.numbers('density', 1.0 / MM) + [0.0], where='post',
                     color=shades(0.15 + 0.8 * index / max(len(times) - 1, 1)), label=f'{float(time):g} s ({disks})')
        row.axvline(0.0, color=GREY, linewidth=0.8)
        row.set_ylabel('density [1/mm]')
        row.set_ylim(bottom=0.0)
        row.set_title(f'Species {species}', loc='left')
        if row.get_legend_handles_labels()[0]:
            beside(row, title='after (disks)')
        else:
            say_undefined(row, 'too few disks in the machine')
    if not names:
        say_undefined(axes[0, 0], 'no disk was recorded in the machine')
    axes[-1, 0].set_xlabel('displacement of the disks in the machine, since each entered [mm]')
    return figure


def draw_velocities(directory):
    statistics, finals = Table(directory / 'statistics.csv'), Table(directory / 'velocities.csv')
    figure, (axes, bars) = plt.subplots(1, 2, sharey=True, figsize=(7.5, 3.2), gridspec_kw={'width_ratios': (3, 1.2)})
    for colour, row in zip(COLOURS, finals.rows):
        part = statistics.where('species', row['species'])
        time, mean = part.numbers('time'), part.numbers('mean_vx', MM)
        error = [0.0 if math.isnan(e) else e for e in part.numbers('mean_vx_stderr', MM)]
        axes.plot(time, mean, color=colour, label=row['species'])
        axes.fill_between(time, [m - e for m, e in zip(mean, error)], [m + e for m, e in zip(mean, error)],
                          color=colour, alpha=0.25, linewidth=0)
        final, final_error = MM * number(row['mean_vx']), MM * number(row['mean_vx_stderr'])
        if not math.isnan(final):
            bars.errorbar([row['species']], [final], yerr=[0.0 if math.isnan(final_error) else final_error],
                          color=colour, marker='o', markersize=5, capsize=4)
    settled = [m for row in finals.rows for m in
               steady(statistics.where('species', row['species']).numbers('mean_vx', MM)) + reach(row)]
    if settled:
        margin = 0.15 * (max(settled) - min(settled)) + 1.0
        axes.set_ylim(min(settled + [0.0]) - margin, max(settled + [0.0]) + margin)
    for part in (axes, bars):
        part.axhline(0.0, color=GREY, linewidth=0.8)
    axes.set_ylabel(r'$\langle V_x \rangle$ [mm/s]')
    axes.set_xlabel('time [s]')
    axes.set_title('Mean velocity up to a time', loc='left')
    axes.legend(loc='lower right', bbox_to_anchor=(1.0, 1.01), borderaxespad=0.0, ncol=max(len(finals.rows), 1))
    bars.set_xlabel('species')
    bars.set_title('Whole run', loc='left')
    bars.margins(x=0.5)
    return figure


def steady(values):
    """Without the first twentieth, in which a mean over hardly any time leaps about."""
    defined = [value for value in values if not math.isnan(value)]
    return defined[len(defined) // 20:]


def reach(row):
    """The ends of a species' error bar, where it has one."""
    mean, error = MM * number(row['mean_vx']), MM * number(row['mean_vx_stderr'])
    return [value for value in (mean - error, mean + error) if not math.isnan(value)]


def draw_temperature(directory):
    statistics, contacts = Table(directory / 'statistics.csv'), Table(directory / 'contacts.csv')
    figure, (axes, rates) = plt.subplots(2, 1, sharex=True, figsize=(6.5, 4.8))
    for colour, species in zip(COLOURS, statistics.values('species')):
        part = statistics.where('species', species)
        values = [v if v > 0.0 else math.nan for v in part.numbers('granular_temperature', UJ)]
        axes.plot(part.numbers('time'), values, color=colour, linewidth=1.0, label=species)
    axes.set_yscale('log')
    axes.set_ylabel(r'$\frac{1}{2} m \langle |v - \langle v \rangle|^2 \rangle$ [µJ]')
    axes.set_title('Granular temperature', loc='left')
    beside(axes)
    time = contacts.numbers('time')
    rates.plot(time[1:], contacts.numbers('collision_rate')[1:], color=GREY, linewidth=1.0, label='collisions')
    rates.set_ylim(bottom=0.0)
    rates.set_ylabel('collisions [1/s]')
    rates.set_xlabel('time [s]')
    rates.set_title('Collision rate', loc='left')
    return figure


DRAWINGS = {
    'segregation.png': draw_segregation,
    'displacements.png': draw_displacements,
    'velocities.png': draw_velocities,
    'temperature.png': draw_temperature,
}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('directory', metavar='DIR', type=pathlib.Path, help='with the CSV files of sieve_analyze --out')
    directory = parser.parse_args().directory
    try:
        with matplotlib.rc_context(STYLE):
            for name, draw in DRAWINGS.items():
                figure = draw(directory)
                figure.align_ylabels()
                figure.savefig(directory / name, bbox_inches='tight')
                plt.close(figure)
                print(directory / name)
    except OSError as error:
        where = f'{error.filename}: ' if error.filename else ''
        sys.exit(f'plot_analysis.py: {where}{error.strerror}')


if __name__ == '__main__':
    main()
