"""Draws a search of seek.py, from the tables that sieve_analyze wrote from its bag: inclination, frequency, and Q of
the disks that left within the last seconds, over time. Prints the path of the picture."""
import numpy as np
from matplotlib.ticker import MaxNLocator

from ratchet_sieve.plots.analysis import plot_drive
from ratchet_sieve.plots.program import parser_of, run_of, run_program, write
from ratchet_sieve.plots.style import GREY, any_defined, beside, panels
from ratchet_sieve.tables import read_table


def windowed_quality(bins, window):
    """Q, eq. (2) of the paper, of the first two species' disks that left within the last `window` seconds; nan where
    none of one did. @return times and Q"""
    species = list(bins.by('species').values())[:2]
    if len(species) < 2:
        return [], []
    times = species[0].numbers('time')
    ends = np.flatnonzero(times >= times[0] + window)
    begins = np.searchsorted(times, times[ends] - window, side='right') - 1
    shares = []
    for part in species:
        counts = np.array([part.numbers('left'), part.numbers('right')])
        fallen = counts[:, ends] - counts[:, begins]
        shares.append(fallen[1] / np.where(fallen.sum(axis=0) > 0.0, fallen.sum(axis=0), np.nan))
    return times[ends], np.abs(shares[0] - shares[1])


def draw_best(axes, best, column):
    """The known best, with its values in the legend."""
    values = ', '.join(f'{line[column]:g}' for line in best)
    for k, line in enumerate(best):
        axes.plot(line[:2], [line[column]] * 2, color=GREY, linestyle='--', linewidth=1.2, zorder=3,
                  label=f'best by a sweep:\n{values}' if k == 0 else None)


def draw(directory, window, best):
    drive = read_table(directory / 'drive.csv')
    figure, axes = panels(3, 1, (7.5, 5.6), None, sharex=True, gridspec_kw={'height_ratios': (2.2, 2, 1)})
    draw_best(axes[0], best, 2)
    plot_drive(axes[0], drive, 'inclination')
    times, quality = windowed_quality(read_table(directory / 'bins.csv'), window)
    if any_defined(quality):
        draw_best(axes[1], best, 3)
        axes[1].plot(times, quality, color='black', linewidth=1.0, label='$Q$')
    beside(axes[1], 'undefined: too few disks left')
    axes[1].set_ylim(-0.02, None)
    axes[1].set_ylabel('$Q$')
    axes[1].set_title(f'Quality of what left within the last {window:g} s', loc='left')
    plot_drive(axes[2], drive, 'frequency')
    axes[2].yaxis.set_major_locator(MaxNLocator(nbins=4, integer=True))
    axes[2].set_xlabel('time [s]')
    figure.subplots_adjust(hspace=0.4)
    return figure


def main():
    parser = parser_of('seek', __doc__, 'with the CSV files of sieve_analyze --out')
    parser.add_argument('--window', type=float, default=10.0, help='seconds over which Q is taken (10)')
    parser.add_argument('--best', type=float, nargs=4, action='append', default=[],
                        metavar=('FROM', 'TO', 'THETA', 'Q'),
                        help='the known best inclination and Q between two times, drawn dashed')
    options = parser.parse_args()
    run_program(parser.prog, lambda: write(draw(options.directory, options.window, options.best),
                                           options.directory / 'seek.png', run_of(options.directory)))


if __name__ == '__main__':
    main()
