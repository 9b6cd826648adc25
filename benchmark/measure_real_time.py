#!/usr/bin/python3
"""Measures whether a live node keeps up with real time, by events and by steps of time, and the messages lost if it
does not: the mixture of Fig. 8, with a listener to each of its topics for programs, while it records. Prints a table.
Exit status 1 if a message was lost. Needs ROS on the path, but no master: it starts its own.
"""
import pathlib
import sys
import tempfile

import ros_processes
from measure_node import FOR_PROGRAMS, Bench, description
from ratchet_sieve import documents, origin
from report import parsed, parser_of, publish

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


class Row:
    """A method at both spans. Wall times are of the best rounds, which other load disturbed least."""

    def __init__(self, benches, parameters):
        self.benches = benches
        self.parameters = parameters
        self.walls = [float('inf')] * len(benches)
        self.lost = 0

    def round(self):
        for k, bench in enumerate(self.benches):
            finished, lost = bench.node(FOR_PROGRAMS, records=True, **self.parameters)
            self.walls[k] = min(self.walls[k], finished.wall)
            self.lost += lost

    def factors(self):
        """Simulated over wall time, in the first span and after it."""
        first, whole = self.benches
        return (f'{first.duration / self.walls[0]:.2f}',
                f'{(whole.duration - first.duration) / (self.walls[1] - self.walls[0]):.2f}')

    def text(self, name):
        return f'| {name} | {" | ".join(self.factors())} | {self.lost} |'


def table(rows):
    first, whole = next(iter(rows.values())).benches
    yield f'{first.disks()} disks:'
    yield ''
    yield (f'| | simulated over wall time, first {first.duration:g} s | from there to {whole.duration:g} s '
           '| messages lost, bag included |')
    yield '|---|---|---|---|'
    yield from (row.text(name) for name, row in rows.items())


def main():
    parser = parser_of(__doc__, rounds=3)
    parser.add_argument('--short', action='store_true', help='few disks, one round: test only that nothing is lost')
    arguments = parsed(parser, 'real-time')
    about = description()
    teeth, spans, rounds = SHORT if arguments.short else (TEETH, SPANS, arguments.rounds)
    with tempfile.TemporaryDirectory() as directory:
        scratch = pathlib.Path(directory)
        with ros_processes.master(scratch) as client:
            rows = {name: Row([Bench(arguments.programs, scratch, client, teeth, span, **keys) for span in spans],
                              parameters)
                    for name, (keys, parameters) in METHODS.items()}
            for _ in range(rounds):
                for row in rows.values():
                    row.round()
    publish(arguments, 'real-time', [f'{about}. The best of {rounds} rounds.', '', *table(rows)])
    if arguments.write:
        known = {f'{key}.{span}': factor for key, name in QUOTED.items()
                 for span, factor in zip(('first', 'after'), rows[name].factors())}
        documents.quote(arguments.write.with_name('performance.md'), 'real_time', known, origin.describe_physics())
    return 1 if any(row.lost for row in rows.values()) else 0


if __name__ == '__main__':
    sys.exit(main())
