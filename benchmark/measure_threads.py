#!/usr/bin/python3
"""Measures what strips and threads give a layer: collisions per second of wall time with a single queue, by strips on
one thread, and on two. Prints a Markdown table.
"""
import argparse
import json
import pathlib
import statistics
import subprocess

import physics
from ratchet_sieve import documents, origin

ROOT = pathlib.Path(__file__).resolve().parent.parent
LAYERS = ((20, '524', '≥ 1', '1.3'), (153, '4,008', '', ''), (382, '10,008', '1.7', '1.9'), (3817, '100,004', '1.8', '1.95'))
QUEUE, ONE, TWO = range(3)


def measured(program, rounds):
    """@return (teeth, way) -> collisions per second of wall time in each round; the ways take turns"""
    finished = subprocess.run(
        [program, '--benchmark_filter=^mixtureOnThreads', '--benchmark_format=json',
         f'--benchmark_repetitions={rounds}', '--benchmark_enable_random_interleaving=true'],
        check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    found = {}
    for run in json.loads(finished.stdout)['benchmarks']:
        if run['run_type'] == 'iteration':
            teeth, way = map(int, run['name'].split('/')[1:3])
            found.setdefault((teeth, way), []).append(run['collisions'])
    return found


def ratio(over, under):
    """Of the medians, with the range of what halves of the rounds give."""
    half = len(over) // 2
    halves = sorted(statistics.median(over[part]) / statistics.median(under[part])
                    for part in (slice(None, half), slice(half, None)))
    return f'{statistics.median(over) / statistics.median(under):.2f} ({halves[0]:.2f}, {halves[1]:.2f})'


def table(found, rounds, about):
    yield f'{origin.text(about)}; medians of {rounds} rounds, in turns; in brackets those of each half of the rounds.'
    yield ''
    yield ('| disks | single queue, M collisions/s | one thread over a single queue | two threads over one | wanted | '
           'hoped for |')
    yield '|---|---|---|---|---|---|'
    for teeth, disks, target, stretch in LAYERS:
        queue, one, two = (found[teeth, way] for way in (QUEUE, ONE, TWO))
        yield (f'| {disks} | {statistics.median(queue) / 1e6:.2f} | {ratio(one, queue)} | {ratio(two, one)} | {target} | '
               f'{stretch} |')


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--programs', type=pathlib.Path, default=ROOT / 'devel/lib/ratchet_sieve', metavar='DIR',
                        help='where engine_benchmark is')
    parser.add_argument('--rounds', type=int, default=11, help='repetitions of all benchmarks (default: 11)')
    parser.add_argument('--write', type=pathlib.Path, metavar='FILE',
                        help='put the table between the marks of this document')
    arguments = parser.parse_args()
    if arguments.write:
        documents.require_place(parser, arguments.write, 'threads')
    text = '\n'.join(table(measured(arguments.programs / 'engine_benchmark', arguments.rounds), arguments.rounds,
                           physics.describe()))
    print(text)
    if arguments.write:
        documents.put(arguments.write, 'threads', text)


if __name__ == '__main__':
    main()
