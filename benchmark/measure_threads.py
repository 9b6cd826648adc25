#!/usr/bin/python3
"""Measures what strips and threads give a layer, and works out what more threads would give. Prints two Markdown
tables.

Model: T(p) = alone + (T - alone) / (events / critical events) + 2 windows meeting p / 2, with p strips on one thread in
T, of which `alone` is between windows; the critical events of a window are those of the strip with the most and of the
cut with the most, and p threads meet twice, in a time that grows as their number. It knows nothing of memory.
"""
import statistics

from ratchet_sieve import origin
from ratchet_sieve.texts import table
from report import arguments_of, benchmarks, publish

LAYERS = ((20, '524'), (153, '4,008'), (382, '10,008'), (3817, '100,004'))
QUEUE, ONE, TWO = range(3)
MODELLED = ((20, '524'), (382, '10,008'), (3817, '100,004'), (38170, '1,000,054'))
THREADS = (2, 4, 16, 64)
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


def waiting(runs):
    """The share of the two threads' time in which they wait for each other or one works alone, %."""
    shares = [100 * one['meeting'] for one in runs if 'meeting' in one]
    return f'{statistics.median(shares):.1f}' if shares else '—'


def tables(layers, rounds, about):
    yield f'{origin.text(about)}; medians of {rounds} rounds, in turns; in brackets those of each half of the rounds.'
    yield ''
    lines = []
    for teeth, disks in LAYERS:
        queue, one, two = (layers[teeth, way] for way in (QUEUE, ONE, TWO))
        lines.append([disks, f'{M * rate(queue):.2f}', ratio(one, queue), ratio(two, one), waiting(two)])
    yield table(['disks', 'single queue, M collisions/s', 'one thread over a single queue', 'two threads over one',
                 'waiting, %'], lines)


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


def speed_up(strips, threads, meeting):
    """Of so many threads with a strip each over the same strips on one thread. @param meeting of two threads [s]"""
    wall = strips['real_time'] * strips['iterations'] / 1e3
    alone = strips['alone'] * wall
    together = alone + (wall - alone) / strips['events_over_critical'] + strips['windows'] * meeting * threads
    return wall / together


def model(strips, layers, meeting):
    """@param strips (teeth, strips) -> runs on one thread @param meeting of two threads [s]"""
    yield f'A meeting of two threads takes {1e6 * meeting:.2f} µs.'
    yield ''
    measured = {teeth: f'{rate(layers[teeth, TWO]) / rate(layers[teeth, ONE]):.1f}' for teeth, _ in LAYERS}
    lines = []
    for teeth, disks in MODELLED:
        most = max((count for other, count in strips if other == teeth), default=1)
        line = [f'{teeth:,}', disks, measured.get(teeth, '—')]
        for threads in THREADS:
            # More threads than strips have nothing to do.
            count = min(threads, most)
            line.append('1' if count == 1 else f'{speed_up(strips[teeth, count][0], count, meeting):.1f}' +
                        (f' ({count} threads)' if count < threads else ''))
        lines.append(line)
    yield table(['teeth', 'disks', '2 threads, measured', *(f'{threads}, by the model' for threads in THREADS)], lines)


def main():
    arguments = arguments_of(__doc__, 'threads', rounds=11)
    about = origin.describe_physics()
    layers = by_arguments(benchmarks(arguments, 'mixtureOnThreads', arguments.rounds))
    meeting = 1.0 / benchmarks(arguments, 'meetingOfTwoThreads')[0]['meetings']
    publish(arguments, 'threads', tables(layers, arguments.rounds, about), figures(layers), about)
    print(*model(by_arguments(benchmarks(arguments, 'mixtureInStrips')), layers, meeting), sep='\n')


if __name__ == '__main__':
    main()
