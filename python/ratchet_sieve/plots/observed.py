"""Draws what a scene asks to be observed, from tables that sieve_analyze wrote."""
import math

import matplotlib
import numpy as np
from matplotlib.ticker import MaxNLocator

from ratchet_sieve.plots.curves import signed
from ratchet_sieve.plots.style import MM, UJ, any_defined, beside, coloured, describe, panels, say_undefined
from ratchet_sieve.tables import read_table

G = 1e3  # per kg
PLACES = {'left': '--', 'right': '-'}  # their lines
FEWEST_TIMES = 20  # of which a distribution is drawn
FLOW_POINTS = 40   # of a curve of the mass flow


def parts(table):
    """Of each bin and species: colour, line, label, and its lines of the table."""
    for colour, (species, own) in coloured(table.by('species').items()):
        for place, line in PLACES.items():
            part = own.where({'place': place})
            if len(part):
                yield colour, line, f'{species} {place}', part


def draw_residence_times(directory):
    """Densities over the logarithm of time, in which the histogram's bins are nearly equal."""
    figure, axes = panels(1, 1, (6.5, 3.4), None)
    for colour, line, label, part in parts(read_table(directory / 'residence_times.csv')):
        edges, counts = [*part.numbers('from'), *part.numbers('to')[-1:]], part.numbers('count')
        if sum(counts) >= FEWEST_TIMES:
            edges, counts = coarser(edges, counts)
            density = counts / sum(counts) / np.diff(np.log(edges))
            axes.step([edges[0], *edges], [0.0, *density, 0.0], where='post', color=colour, linestyle=line,
                      label=f'{label} ({sum(counts):.0f})')
    if axes.lines:
        axes.set_xscale('log')
        axes.xaxis.set_major_formatter('{x:g}')
    beside(axes, 'too few disks left', title='species, bin (disks)')
    axes.set_ylim(bottom=0.0)
    describe(axes, 'Residence times of the disks that left', r'density over $\ln t$', 'time in the machine [s]')
    return figure


def coarser(edges, counts):
    """Neighbouring bins together, until there are about sqrt(n) / 2 of them; the last is the widest."""
    together = max(1, math.ceil(2.0 * len(counts) / math.sqrt(sum(counts))))
    starts = [*range(0, max(len(counts) - together, 0) + 1, together)]
    return [*(edges[k] for k in starts), edges[-1]], np.add.reduceat(counts, starts)


def draw_mass_flow(directory):
    """Means of consecutive blocks of equal length, at their ends."""
    figure, axes = panels(1, 1, (6.5, 3.4), None)
    for colour, line, label, part in parts(read_table(directory / 'mass_flow.csv')):
        together = math.ceil(len(part) / FLOW_POINTS)
        blocks = len(part) // together
        flow = np.reshape(part.numbers('flow', G)[:blocks * together], (blocks, together)).mean(axis=1)
        axes.plot(part.numbers('time')[together - 1::together], flow, color=colour, linestyle=line, label=label)
    beside(axes, 'no disk can have left')
    axes.set_ylim(bottom=0.0)
    describe(axes, 'Mass flow into the bins', 'mass per time [g/s]', 'time [s]')
    return figure


PROFILES = {'number_density': ('disks [1/cm²]', 1e-4), 'velocity_along': ('velocity along [mm/s]', MM),
            'velocity_up': ('velocity up [mm/s]', MM), 'temperature': ('temperature [µJ]', UJ)}
DENSE = 0.02  # slices of a smaller share of the largest density have too few disks for their means to be drawn
PHASE_LINES = ['-', '--', ':', '-.']
MOST_PHASES_DRAWN = len(PHASE_LINES)


def draw_height_profile(directory):
    table = read_table(directory / 'height_profile.csv')
    figure, axes = panels(1, len(PROFILES), (9.5, 3.8), None, sharey=True)
    phases = list(table.by('phase_from'))
    drawn = phases[::math.ceil(len(phases) / MOST_PHASES_DRAWN)] if phases else []
    for colour, (species, own) in coloured(table.by('species').items()):
        for line, phase in zip(PHASE_LINES, drawn):
            part = own.where({'phase_from': phase})
            label = species if len(phases) == 1 else f'{species}, phase {float(phase) / math.pi:.2g} π'
            plot_profile(axes, part, colour, line, label)
    for each, (label, _) in zip(axes, PROFILES.values()):
        each.set_xlabel(label)
        each.xaxis.set_major_locator(MaxNLocator(3))
    axes[0].set_ylim(bottom=0.0)
    axes[0].set_title('Means over time, by height', loc='left')
    axes[0].set_ylabel('height above the base [mm]')
    if axes[0].lines:
        beside(axes[-1], title=None if len(phases) < 2 else f'parts of {2.0 / len(phases):.2g} π from')
    else:
        say_undefined(axes[0], 'no disk was seen')
    figure.subplots_adjust(wspace=0.15)
    return figure


def plot_profile(axes, part, colour, line, label):
    heights = np.mean([part.numbers('from', MM), part.numbers('to', MM)], axis=0)
    density = part.numbers('number_density')
    if not any_defined(density):
        return
    for each, (column, (_, scale)) in zip(axes, PROFILES.items()):
        values = part.numbers(column, scale)
        if column != 'number_density':
            values = np.where(density >= DENSE * max(density), values, np.nan)
        each.plot(values, heights, color=colour, linestyle=line, label=label)


def draw_size_classes(directory):
    """What left of each size class, by the bin, and its mean velocity."""
    table = read_table(directory / 'size_classes.csv')
    names = list(table.by('species'))
    figure, axes = panels(2, max(len(names), 1), (2.5 + 3.0 * len(names), 4.4), None, squeeze=False, sharex='col')
    for column, (colour, (species, part)) in enumerate(coloured(table.by('species').items())):
        edges = np.append(part.numbers('radius_from', MM), part.numbers('radius_to', MM)[-1:])
        shares, velocities = axes[0, column], axes[1, column]
        below, full = np.zeros(len(part)), np.array(matplotlib.colors.to_rgb(colour))
        for key, paler, label in (('left', 0.0, 'left'), ('right', 0.45, 'right'), ('on_base', 0.8, 'on the base')):
            shares.bar(edges[:-1], part.numbers(key), np.diff(edges), bottom=below, align='edge',
                       color=1.0 - (1.0 - full) * (1.0 - paler), edgecolor='white', linewidth=0.8, label=label)
            below = below + part.numbers(key)
        shares.set_title(f'Species {species}', loc='left')
        velocities.errorbar((edges[:-1] + edges[1:]) / 2.0, part.numbers('mean_vx', MM), color=colour, marker='o',
                            yerr=np.nan_to_num(part.numbers('mean_vx_stderr', MM)), markersize=4, capsize=3)
        signed(velocities)
        velocities.set_xlabel('radius [mm]')
        shares.legend(loc='lower right', bbox_to_anchor=(1.0, 1.08), ncol=3, borderaxespad=0.0, columnspacing=0.8,
                      handlelength=1.0)
    axes[0, 0].set_ylabel('disks')
    axes[1, 0].set_ylabel(r'$\langle V_x \rangle$ [mm/s]')
    return figure


DRAWN = {'residence_times': draw_residence_times, 'height_profile': draw_height_profile, 'mass_flow': draw_mass_flow,
         'size_classes': draw_size_classes}


def drawings_of_observed(directory):
    """@return by the name of its picture, what draws each observable that the run has"""
    table = directory / 'observed.csv'
    names = read_table(table).by('observable') if table.exists() else []
    return {f'{name}.png': DRAWN[name] for name in names if name in DRAWN}
