"""Draws the tables that sieve_analyze wrote into a directory, and prints the paths of the pictures."""
import math

import matplotlib
from matplotlib.ticker import LogLocator, MaxNLocator, NullFormatter

from ratchet_sieve.plots.curves import distribution, signed
from ratchet_sieve.plots.observed import drawings_of_observed
from ratchet_sieve.plots.program import parser_of, run_of, run_program, write
from ratchet_sieve.plots.style import COLOURS, GREY, MM, UJ, any_defined, beside, panels, say_undefined
from ratchet_sieve.tables import Table

FEWEST_DISKS = 5  # of which a distribution is drawn


def plot_bins(axes, bins):
    for colour, (species, part) in zip(COLOURS, bins.by('species')):
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


def plot_drive(axes, drive, quantity, label, colour, scale=1.0):
    time, applied = drive.numbers('time'), drive.numbers(quantity, scale)
    axes.step(time, drive.numbers('commanded_' + quantity, scale), where='post', color=GREY, linestyle=':',
              linewidth=1.2, label='commanded')
    axes.plot(time, applied, color=colour, label='applied')
    axes.set_ylabel(label)
    axes.set_title(quantity.capitalize(), loc='left')
    if applied and max(applied) - min(applied) < 1e-9:
        margin = max(0.1 * abs(applied[0]), 0.01)
        axes.set_ylim(applied[0] - margin, applied[0] + margin)
    beside(axes)


def plot_whole_drive(three_axes, drive):
    plot_drive(three_axes[0], drive, 'inclination', r'$\theta$ [rad]', COLOURS[4])
    plot_drive(three_axes[1], drive, 'frequency', '$f$ [Hz]', COLOURS[5])
    plot_drive(three_axes[2], drive, 'amplitude', '$A$ [mm]', COLOURS[3], MM)
    three_axes[2].set_xlabel('time [s]')


def plot_drift(axes, drift):
    for colour, (species, part) in zip(COLOURS, drift.by('species')):
        axes.plot(part.numbers('time'), part.numbers('displacement', MM), color=colour, label=species)
    signed(axes)
    axes.set_ylabel('displacement [mm]')
    axes.set_title('Drift: mean displacement of the disks since each entered', loc='left')
    beside(axes)


CONTACTS = {'disk_disk': 'disk-disk', 'left_slope': 'left slope', 'right_slope': 'right slope', 'apex': 'apex',
            'wall': 'wall', 'level': 'level face'}


def scale_by_decades(axes):
    axes.set_yscale('log')
    axes.yaxis.set_major_locator(LogLocator(subs=(1.0, 3.0)))
    axes.yaxis.set_major_formatter('{x:g}')
    axes.yaxis.set_minor_formatter(NullFormatter())


def positive(values):
    """Values of 0 and below, which a logarithmic scale cannot show, become NaN."""
    return [value if value > 0.0 else math.nan for value in values]


def plot_contacts(axes, contacts):
    """Each kind's rate, from the end of the first window on."""
    windows = zip(contacts.numbers('window_start'), contacts.numbers('window_end'))
    contacts = Table(contacts.path, contacts.frame.iloc[[k for k, (start, end) in enumerate(windows) if end > start]])
    for colour, (kind, label) in zip(COLOURS, CONTACTS.items()):
        rates = positive(contacts.numbers(kind + '_rate'))
        if any_defined(rates):
            axes.plot(contacts.numbers('window_end'), rates, color=colour, linewidth=1.0, label=label)
    if axes.lines:
        scale_by_decades(axes)
    else:
        say_undefined(axes, 'no contact was recorded')
    axes.set_ylabel('contacts [1/s]')
    axes.set_title('Contacts', loc='left')
    beside(axes)


def draw_result(directory):
    """Bins and segregation above the drive; if no disk can leave, drift and contacts."""
    heights = (3, 2, 1.1, 1.1, 1.1)
    figure, axes = panels(5, 1, (7.5, 8.5), None, sharex=True, gridspec_kw={'height_ratios': heights})
    if disks_can_leave(directory):
        plot_bins(axes[0], Table(directory / 'bins.csv'))
        plot_segregation(axes[1], Table(directory / 'segregation.csv'))
    else:
        plot_drift(axes[0], Table(directory / 'drift.csv'))
        plot_contacts(axes[1], Table(directory / 'contacts.csv'))
    plot_whole_drive(axes[2:], Table(directory / 'drive.csv'))
    figure.subplots_adjust(hspace=0.45)
    return figure


def disks_can_leave(directory):
    bins = Table(directory / 'bins.csv')
    return run_of(directory).texts('open_ends').iloc[0] == '1' or any(bins.numbers('left') + bins.numbers('right'))


def draw_displacements(directory):
    table = Table(directory / 'displacements.csv')
    names = table.values('species')
    figure, axes = panels(max(len(names), 1), 1, (6.5, 1.2 + 2.3 * max(len(names), 1)), None, sharex=True,
                          squeeze=False)
    times = table.values('time')
    shades = matplotlib.colormaps['viridis_r']
    for row, species in zip(axes[:, 0], names):
        part = table.where('species', species)
        for index, time in enumerate(times):
            histogram = part.where('time', time)
            disks = int(sum(histogram.numbers('count')))
            if disks < FEWEST_DISKS:
                continue
            edges = histogram.numbers('from', MM) + histogram.numbers('to', MM)[-1:]
            distribution(row, edges, histogram.numbers('density', 1.0 / MM), label=f'{float(time):g} s ({disks})',
                         color=shades(0.15 + 0.8 * index / max(len(times) - 1, 1)))
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
    figure, (axes, bars) = panels(1, 2, (7.5, 3.2), None, sharey=True, gridspec_kw={'width_ratios': (3, 1.2)})
    names = finals.values('species')
    for colour, name in zip(COLOURS, names):
        part = statistics.where('species', name)
        time, mean = part.numbers('time'), part.numbers('mean_vx', MM)
        error = [0.0 if math.isnan(e) else e for e in part.numbers('mean_vx_stderr', MM)]
        axes.plot(time, mean, color=colour, label=name)
        axes.fill_between(time, [m - e for m, e in zip(mean, error)], [m + e for m, e in zip(mean, error)],
                          color=colour, alpha=0.25, linewidth=0)
        final, final_error = whole_run(finals, name)
        if not math.isnan(final):
            bars.errorbar([name], [final], yerr=[0.0 if math.isnan(final_error) else final_error],
                          color=colour, marker='o', markersize=5, capsize=4)
    settled = [m for name in names for m in
               steady(statistics.where('species', name).numbers('mean_vx', MM)) + reach(*whole_run(finals, name))]
    if settled:
        margin = 0.15 * (max(settled) - min(settled)) + 1.0
        axes.set_ylim(min(settled + [0.0]) - margin, max(settled + [0.0]) + margin)
    for part in (axes, bars):
        signed(part)
    axes.set_ylabel(r'$\langle V_x \rangle$ [mm/s]')
    axes.set_xlabel('time [s]')
    axes.set_title('Mean velocity up to a time', loc='left')
    axes.legend(loc='lower right', bbox_to_anchor=(1.0, 1.01), borderaxespad=0.0, ncol=max(len(names), 1))
    bars.set_xlabel('species')
    bars.set_title('Whole run', loc='left')
    bars.margins(x=0.5)
    return figure


def steady(values):
    """Without the first twentieth, in which a mean over a short time fluctuates."""
    defined = [value for value in values if not math.isnan(value)]
    return defined[len(defined) // 20:]


def whole_run(finals, species):
    """Mean velocity of a species and its error [mm/s]."""
    part = finals.where('species', species)
    return part.numbers('mean_vx', MM)[0], part.numbers('mean_vx_stderr', MM)[0]


def reach(mean, error):
    """The ends of an error bar, if there is one."""
    return [value for value in (mean - error, mean + error) if not math.isnan(value)]


def draw_temperature(directory):
    statistics = Table(directory / 'statistics.csv')
    figure, axes = panels(1, 1, (6.5, 3.0), None)
    for colour, (species, part) in zip(COLOURS, statistics.by('species')):
        axes.plot(part.numbers('window_end'), positive(part.numbers('granular_temperature', UJ)), color=colour,
                  linewidth=1.0, label=species)
    scale_by_decades(axes)
    axes.set_ylabel(r'$\frac{1}{2} m \langle |v - \langle v \rangle|^2 \rangle$ [µJ]')
    axes.set_xlabel('time [s]')
    axes.set_title('Granular temperature, over whole periods of the drive', loc='left')
    beside(axes)
    return figure


def draw_contacts(directory):
    contacts = Table(directory / 'contacts.csv')
    time, ratio = contacts.numbers('time'), contacts.numbers('short_to_long')
    figure, (rates, ratios) = panels(2, 1, (6.5, 4.8), None, sharex=True, gridspec_kw={'height_ratios': (2, 1)})
    plot_contacts(rates, contacts)
    rates.set_title('Contacts, over whole periods of the drive', loc='left')
    if any_defined(ratio):
        ratios.plot(time, ratio, color='black')
        settled = steady(ratio)
        margin = 0.5 * (max(settled) - min(settled)) + 0.05
        ratios.set_ylim(max(0.0, min(settled) - margin), max(settled) + margin)
    else:
        say_undefined(ratios, 'undefined: no contact with the longer slope')
    ratios.set_ylabel('short / long')
    ratios.set_xlabel('time [s]')
    ratios.set_title('Contacts with the shorter over those with the longer slope, up to a time', loc='left')
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
