"""Draws the tables that sieve_analyze wrote into a directory, and prints the paths of the pictures."""
import matplotlib
import numpy as np
from matplotlib.ticker import LogLocator, MaxNLocator, NullFormatter

from ratchet_sieve.plots.curves import distribution, signed
from ratchet_sieve.plots.observed import PLACES, drawings_of_observed
from ratchet_sieve.plots.program import parser_of, run_of, run_program, write
from ratchet_sieve.plots.style import (COLOURS, GREY, MM, UJ, any_defined, beside, coloured, describe, panels,
                                       say_undefined)
from ratchet_sieve.tables import read_table

FEWEST_DISKS = 5  # of which a distribution is drawn
CONTACTS = {'disk_disk': 'disk-disk', 'left_slope': 'left slope', 'right_slope': 'right slope', 'apex': 'apex',
            'wall': 'wall', 'level': 'level face'}


def plot_bins(axes, bins):
    for colour, (species, part) in coloured(bins.by('species').items()):
        for place, line, width in (*((place, line, None) for place, line in PLACES.items()), ('on_base', ':', 1.0)):
            axes.step(part.numbers('time'), part.numbers(place), where='post', color=colour, linestyle=line,
                      linewidth=width, label=f"{species} {place.replace('on_', 'on the ')}")
    axes.set_ylim(bottom=0)
    axes.yaxis.set_major_locator(MaxNLocator(integer=True))
    describe(axes, 'Bins', 'disks')
    beside(axes)


def plot_segregation(axes, segregation):
    time = segregation.numbers('time')
    quality, processed = segregation.numbers('quality'), segregation.numbers('processed')
    if any_defined(quality) or any_defined(processed):
        axes.step(time, quality, where='post', color='black', label='quality $Q$')
        axes.step(time, processed, where='post', color=COLOURS[2], label='processed $P$')
    beside(axes, 'undefined: no disk was counted')
    axes.set_ylim(-0.02, 1.05)
    describe(axes, 'Segregation', 'ratio')


# Of each quantity of the drive the axis' label, the colour and the factor from SI units.
DRIVE = {'inclination': (r'$\theta$ [rad]', COLOURS[4], 1.0), 'frequency': ('$f$ [Hz]', COLOURS[5], 1.0),
         'amplitude': ('$A$ [mm]', COLOURS[3], MM)}


def plot_drive(axes, drive, quantity):
    label, colour, scale = DRIVE[quantity]
    time, applied = drive.numbers('time'), drive.numbers(quantity, scale)
    axes.step(time, drive.numbers('commanded_' + quantity, scale), where='post', color=GREY, linestyle=':',
              linewidth=1.2, label='commanded')
    axes.plot(time, applied, color=colour, label='applied')
    describe(axes, quantity.capitalize(), label)
    beside(axes)


def plot_drift(axes, drift):
    for colour, (species, part) in coloured(drift.by('species').items()):
        axes.plot(part.numbers('time'), part.numbers('displacement', MM), color=colour, label=species)
    signed(axes)
    describe(axes, 'Drift: mean displacement of the disks since each entered', 'displacement [mm]')
    beside(axes)


def scale_by_decades(axes):
    axes.set_yscale('log')
    axes.yaxis.set_major_locator(LogLocator(subs=(1.0, 3.0)))
    axes.yaxis.set_major_formatter('{x:g}')
    axes.yaxis.set_minor_formatter(NullFormatter())


def positive(values):
    """Values of 0 and below, which a logarithmic scale cannot show, become NaN."""
    return np.where(values > 0.0, values, np.nan)


def plot_contacts(axes, contacts):
    """Each kind's rate, from the end of the first window on."""
    end = contacts.numbers('window_end')
    windows = end > contacts.numbers('window_start')
    for colour, (kind, label) in zip(COLOURS, CONTACTS.items()):
        rates = positive(contacts.numbers(kind + '_rate')[windows])
        if any_defined(rates):
            axes.plot(end[windows], rates, color=colour, linewidth=1.0, label=label)
    if axes.lines:
        scale_by_decades(axes)
    describe(axes, 'Contacts', 'contacts [1/s]')
    beside(axes, 'no contact was recorded')


def draw_result(directory):
    """Bins and segregation above what of the drive changes; if no disk can leave, drift and contacts."""
    drive = read_table(directory / 'drive.csv')
    changing = [quantity for quantity in DRIVE if any(len(set(drive.numbers(column))) > 1
                                                      for column in (quantity, 'commanded_' + quantity))]
    heights = (3, 2, *(1.1 for _ in changing))
    figure, axes = panels(len(heights), 1, (7.5, sum(heights) + 0.4), None, sharex=True,
                          gridspec_kw={'height_ratios': heights})
    if disks_can_leave(directory):
        plot_bins(axes[0], read_table(directory / 'bins.csv'))
        plot_segregation(axes[1], read_table(directory / 'segregation.csv'))
    else:
        plot_drift(axes[0], read_table(directory / 'drift.csv'))
        plot_contacts(axes[1], read_table(directory / 'contacts.csv'))
    for place, quantity in zip(axes[2:], changing):
        plot_drive(place, drive, quantity)
    axes[-1].set_xlabel('time [s]')
    figure.subplots_adjust(hspace=0.45)
    return figure


def disks_can_leave(directory):
    bins = read_table(directory / 'bins.csv')
    return run_of(directory).column('open_ends').iloc[0] == '1' or any(bins.numbers('left') + bins.numbers('right'))


def draw_displacements(directory):
    table = read_table(directory / 'displacements.csv')
    names, times = list(table.by('species')), list(table.by('time'))
    figure, axes = panels(max(len(names), 1), 1, (6.5, 1.2 + 2.3 * max(len(names), 1)), None, sharex=True,
                          squeeze=False)
    shades = matplotlib.colormaps['viridis_r']
    for row, species in zip(axes[:, 0], names):
        part = table.where({'species': species})
        for index, time in enumerate(times):
            histogram = part.where({'time': time})
            disks = int(sum(histogram.numbers('count')))
            if disks < FEWEST_DISKS:
                continue
            edges = [*histogram.numbers('from', MM), *histogram.numbers('to', MM)[-1:]]
            distribution(row, edges, histogram.numbers('density', 1.0 / MM), label=f'{float(time):g} s ({disks})',
                         color=shades(0.15 + 0.8 * index / max(len(times) - 1, 1)))
        row.axvline(0.0, color=GREY, linewidth=0.8)
        row.set_ylim(bottom=0.0)
        describe(row, f'Species {species}', 'density [1/mm]')
        beside(row, 'too few disks in the machine', title='after (disks)')
    if not names:
        say_undefined(axes[0, 0], 'no disk was recorded in the machine')
    axes[-1, 0].set_xlabel('displacement of the disks in the machine, since each entered [mm]')
    return figure


def draw_velocities(directory):
    statistics, finals = read_table(directory / 'statistics.csv'), read_table(directory / 'velocities.csv')
    figure, (axes, bars) = panels(1, 2, (7.5, 3.2), None, sharey=True, gridspec_kw={'width_ratios': (3, 1.2)})
    names = list(finals.by('species'))
    settled = []
    for colour, (name, final, final_error) in coloured(zip(names, finals.numbers('mean_vx', MM),
                                                           finals.numbers('mean_vx_stderr', MM))):
        part = statistics.where({'species': name})
        mean, error = part.numbers('mean_vx', MM), np.nan_to_num(part.numbers('mean_vx_stderr', MM))
        if len(mean) and not np.isnan(mean[-1]):
            final, final_error = mean[-1], error[-1]  # of frames only where there is nothing better
        axes.plot(part.numbers('time'), mean, color=colour, label=name)
        axes.fill_between(part.numbers('time'), mean - error, mean + error, color=colour, alpha=0.25, linewidth=0)
        if not np.isnan(final):
            bars.errorbar([name], [final], yerr=[np.nan_to_num(final_error)], color=colour, marker='o', markersize=5,
                          capsize=4)
        settled += [*steady(mean), *defined(np.array([final - final_error, final + final_error]))]
    if settled:
        margin = 0.15 * (max(settled) - min(settled)) + 1.0
        axes.set_ylim(min(settled + [0.0]) - margin, max(settled + [0.0]) + margin)
    for part in (axes, bars):
        signed(part)
    describe(axes, 'Mean velocity up to a time', r'$\langle V_x \rangle$ [mm/s]', 'time [s]')
    if names:
        axes.legend(loc='lower right', bbox_to_anchor=(1.0, 1.01), borderaxespad=0.0, ncol=len(names))
    bars.set_xlabel('species')
    bars.set_title('Whole run', loc='left')
    bars.margins(x=0.5)
    return figure


def defined(values):
    return values[~np.isnan(values)]


def steady(values):
    """Without the first twentieth, in which a mean over a short time fluctuates."""
    return defined(values)[len(defined(values)) // 20:]


def draw_temperature(directory):
    statistics = read_table(directory / 'statistics.csv')
    figure, axes = panels(1, 1, (6.5, 3.0), None)
    for colour, (species, part) in coloured(statistics.by('species').items()):
        axes.plot(part.numbers('window_end'), positive(part.numbers('granular_temperature', UJ)), color=colour,
                  linewidth=1.0, label=species)
    scale_by_decades(axes)
    describe(axes, 'Granular temperature, over whole periods of the drive',
             r'$\frac{1}{2} m \langle |v - \langle v \rangle|^2 \rangle$ [µJ]', 'time [s]')
    beside(axes)
    return figure


def draw_contacts(directory):
    contacts = read_table(directory / 'contacts.csv')
    ratio = contacts.numbers('short_to_long')
    figure, (rates, ratios) = panels(2, 1, (6.5, 4.8), None, sharex=True, gridspec_kw={'height_ratios': (2, 1)})
    plot_contacts(rates, contacts)
    rates.set_title('Contacts, over whole periods of the drive', loc='left')
    if any_defined(ratio):
        ratios.plot(contacts.numbers('time'), ratio, color='black')
        settled = steady(ratio)
        margin = 0.5 * (max(settled) - min(settled)) + 0.05
        ratios.set_ylim(max(0.0, min(settled) - margin), max(settled) + margin)
    else:
        say_undefined(ratios, 'undefined: no contact with the longer slope')
    describe(ratios, 'Contacts with the shorter over those with the longer slope, up to a time', 'short / long',
             'time [s]')
    return figure


def drawings(directory):
    return {
        'segregation.png' if disks_can_leave(directory) else 'drift.png': draw_result,
        'displacements.png': draw_displacements,
        'velocities.png': draw_velocities,
        'temperature.png': draw_temperature,
        'contacts.png': draw_contacts,
        **drawings_of_observed(directory),
    }


def main():
    parser = parser_of('analysis', __doc__, 'with the CSV files of sieve_analyze --out')
    directory = parser.parse_args().directory

    def draw_all():
        for name, draw in drawings(directory).items():
            write(draw(directory), directory / name, run_of(directory))

    run_program(parser.prog, draw_all)


if __name__ == '__main__':
    main()
