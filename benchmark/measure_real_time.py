#!/usr/bin/python3
"""Measures whether a live node keeps up with real time, by events and by steps of time, and the messages lost if it
does not: the mixture of Fig. 8, with a listener to each of its topics for programs, while it records. Prints a table.
Exit status 1 if a message was lost. Needs ROS on the path, but no master: it starts its own.
"""
import os
import pathlib
import sys
import tempfile

from measure_node import FOR_PROGRAMS, Bench
from ratchet_sieve import origin, processes
from ratchet_sieve.texts import table
from report import arguments_of, publish

# What is asked for: keys of the scene, and parameters of the node.
METHODS = {'events': ({}, {'real_time_factor': 1.0}),
           'events, one thread': ({}, {'real_time_factor': 1.0, 'threads': 1}),
           'events, as fast as it goes': ({}, {'real_time_factor': 0.0}),
           **{f'steps of {1e3 * step:g} ms': ({'accuracy': {'method': 'steps', 'step': step}},
                                              {'real_time_factor': 1.0})
              for step in (0.001, 0.002, 0.004)}}
QUOTED = {'events': 'events', 'one_thread': 'events, one thread', 'free': 'events, as fast as it goes'}
TEETH = 382
SPANS = (1.0, 4.0)  # in the first second all disks land within a few steps [s]
SHORT = (4, (0.2, 0.4), 1)
SHORT_METHODS = ['events', 'events, as fast as it goes', 'steps of 4 ms']


def measure(benches, rounds, methods):
    """@return of each method its wall time at each span, of the best rounds, which other load disturbed least, and how
    many messages were lost"""
    walls = {name: [float('inf')] * len(SPANS) for name in methods}
    lost = dict.fromkeys(methods, 0)
    for _ in range(rounds):
        for name in methods:
            parameters = METHODS[name][1]
            for k, bench in enumerate(benches[name]):
                finished, missed = bench.node(FOR_PROGRAMS, records=True, **parameters)
                walls[name][k] = min(walls[name][k], finished.wall)
                lost[name] += missed
    return walls, lost


def main():
    arguments = arguments_of(__doc__, 'real-time', rounds=3,
                             short='few disks, methods and rounds: test only that nothing is lost')
    about = origin.describe_physics()
    where = f'{origin.text(about)}, load {os.getloadavg()[1]:.1f} before the first round'
    teeth, spans, rounds = SHORT if arguments.short else (TEETH, SPANS, arguments.rounds)
    methods = SHORT_METHODS if arguments.short else [*METHODS]
    with tempfile.TemporaryDirectory() as directory:
        scratch = pathlib.Path(directory)
        with processes.master(scratch) as client:
            benches = {name: [Bench(arguments.programs, scratch, client, teeth, span, **keys) for span in spans]
                       for name, (keys, _) in METHODS.items() if name in methods}
            walls, lost = measure(benches, rounds, methods)
    first, whole = spans
    factors = {name: (f'{first / one:.2f}', f'{(whole - first) / (both - one):.2f}')
               for name, (one, both) in walls.items()}
    publish(arguments, 'real-time', [
        f'{where}. The best of {rounds} rounds.', '', f"{benches['events'][0].disks()} disks:", '',
        table(['', f'simulated over wall time, first {first:g} s', f'from there to {whole:g} s',
               'messages lost, bag included'], [[name, *of, lost[name]] for name, of in factors.items()])],
        {f'{key}.{span}': factor for key, name in QUOTED.items() if name in factors
         for span, factor in zip(('first', 'after'), factors[name])}, about)
    return 1 if any(lost.values()) else 0


if __name__ == '__main__':
    sys.exit(main())
