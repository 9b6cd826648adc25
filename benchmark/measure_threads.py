#!/usr/bin/python3
"""Measures what strips and threads give a layer. Prints a Markdown table."""
import statistics

from ratchet_sieve import origin
from ratchet_sieve.texts import table
from report import arguments_of, benchmarks, publish

LAYERS = ((20, '524'), (153, '4,008'), (382, '10,008'), (3817, '100,004'))
QUEUE, ONE, TWO = range(3)
M = 1e-6


def by_arguments(runs):
    """@return the numbers in a benchmark's name, teeth first -> its runs"""
    found = {}
    for one in runs:
        found.setdefault(tuple(map(int, one['name'].split('/')[1:3])), []).append(one)
    return found


def rate(runs):
    """Collisions per second of wall time."""
    return statistics.median(one['collisions'] for one in runs)


def ratio(over, under):
    """Of the medians, with the range of what halves of the rounds give."""
    half = len(over) // 2
    halves = sorted(rate(over[part]) / rate(under[part]) for part in (slice(None, half), slice(half, None)))
    return f'{rate(over) / rate(under):.2f} ({halves[0]:.2f}, {halves[1]:.2f})'


def tables(layers, rounds, about):
    yield (f'{origin.text(about)}; medians of {rounds} rounds, in turns; in brackets those of each half of the rounds, '
           'between which a ratio of medians need not lie.')
    yield ''
    lines = []
    for teeth, disks in LAYERS:
        queue, one, two = (layers[teeth, way] for way in (QUEUE, ONE, TWO))
        lines.append([disks, f'{M * rate(queue):.2f}', ratio(one, queue), ratio(two, one)])
    yield table(['disks', 'single queue, M collisions/s', 'one thread over a single queue', 'two threads over one'],
                lines)


def figures(layers):
    """Those of performance.json."""
    known = {}
    for teeth, disks in LAYERS:
        key = 'disks_' + disks.replace(',', '')
        one, two = (layers[teeth, way] for way in (ONE, TWO))
        known[f'{key}.one'] = f'{M * rate(one):.2f} M'
        known[f'{key}.two'] = f'{M * rate(two):.2f} M'
        known[f'{key}.times'] = f'{rate(two) / rate(one):.2f}'
    return known


def main():
    arguments = arguments_of(__doc__, 'threads', rounds=11)
    about = origin.describe_physics()
    layers = by_arguments(benchmarks(arguments, 'mixtureOnThreads', arguments.rounds))
    publish(arguments, 'threads', tables(layers, arguments.rounds, about), figures(layers), about)


if __name__ == '__main__':
    main()
