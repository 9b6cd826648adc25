#!/usr/bin/python3
"""Measures what the live node, the recording and the start of the programs cost beside the engine, and prints a table.
Each is a ratio to sieve_run without a bag in the same round, so that other load on the machine counts for both. Exit
status 1 if a message was lost. Needs ROS on the path, but no master: it starts its own.
"""
import dataclasses
import json
import os
import pathlib
import statistics
import sys
import tempfile

import rosbag
import yaml

import ros_processes
from ratchet_sieve import origin
from ratchet_sieve.texts import table
from report import ROOT, parsed, parser_of, quote

RATE = 60  # frames of each kind per simulated second, the node's default
STATISTICS_RATE = 10

BAG = '`sieve_run --bag`'
IDLE = '`sieve_node`, nobody subscribed'
SUBSCRIBED = '`sieve_node`, one subscriber to `~particles`'
EVERYTHING = '`sieve_node`, one to each of its topics, those for RViz too'
RECORD = '`sieve_node` with `~record`'

FOR_PROGRAMS = ['particles', 'bins', 'base', 'statistics']
FOR_EYES = ['markers', 'cloud']
LISTENED = {IDLE: [], SUBSCRIBED: ['particles'], EVERYTHING: FOR_PROGRAMS + FOR_EYES, RECORD: []}
KEYS = ('bag', 'nobody', 'particles', 'all', 'record')  # of those cases in performance.json ...
SIZES = ('large', 'fig8')  # ... and of the sizes


def mixture(teeth, duration, **keys):
    """The scene of Fig. 8 on so many teeth, with other keys changed."""
    scene = yaml.safe_load((ROOT / 'config/paper_fig8.yaml').read_text())
    scene['base']['teeth'] = teeth
    scene.update(duration=duration, settle=0.0, **keys)
    return scene


class Bench:
    """The mixture of Fig. 8 on so many teeth, run for so long by one program after the other."""

    def __init__(self, programs, scratch, client, teeth, duration, **keys):
        self.programs, self.client, self.duration = programs, client, duration
        self.scene = mixture(teeth, duration, **keys)
        self.scene_file = scratch / f'{teeth}.yaml'
        self.scene_file.write_text(yaml.safe_dump(self.scene))
        self.bag = scratch / 'run.bag'

    def disks(self):
        base = self.scene['base']
        diameters = sum(2 * species['radius'] for species in self.scene['species'])
        each = round(self.scene['density'] * base['teeth'] * base['tooth_width'] / diameters)
        return each * len(self.scene['species'])

    def expected(self, rate):
        return [k / rate for k in range(int(self.duration * rate + 1e-9) + 1)]

    def lost_on(self, topic, heard):
        """How many of the messages that are due on a topic a listener did not get. Those for RViz come when there
        is time: one is due."""
        if topic in FOR_EYES:
            return 0 if heard['bytes'] else 1
        return len(set(self.expected(STATISTICS_RATE if topic == 'statistics' else RATE)) - set(heard['times']))

    def lost_in_bag(self):
        """How many of the messages that are due the bag does not hold."""
        with rosbag.Bag(str(self.bag)) as bag:
            counts = {topic: info.message_count for topic, info in bag.get_type_and_topic_info().topics.items()}
        wanted = {f'/sieve/{topic}': len(self.expected(RATE)) for topic in ('particles', 'bins', 'base')}
        wanted.update({'/sieve/statistics': len(self.expected(STATISTICS_RATE)), '/sieve/scene': 1})
        self.bag.unlink()
        return sum(abs(counts.get(topic, 0) - count) for topic, count in wanted.items())

    def node(self, topics, records, **parameters):
        """Runs a node with a listener to each topic. @return what it took, how many messages were lost"""
        # Every frame that sieve_run records, too, for the two to be compared.
        parameters.update(scene=self.scene, record=str(self.bag) if records else '', recording={'particles': RATE})
        finished, received = ros_processes.run_node(self.client, self.programs / 'sieve_node', parameters,
                                                    [f'/sieve/{topic}' for topic in topics])
        lost = sum(self.lost_on(topic.rpartition('/')[2], heard) for topic, heard in received.items())
        return finished, lost + (self.lost_in_bag() if records else 0)

    def round(self):
        """@return the wall time of sieve_run, and each case beside it"""
        command = [self.programs / 'sieve_run', self.scene_file]
        with_start = ros_processes.run(command)
        alone = dataclasses.replace(with_start, wall=json.loads(with_start.output)['wall_time'])
        compared = {BAG: Compared(with_start, ros_processes.run([*command, '--bag', self.bag]), self.lost_in_bag())}
        for case, topics in LISTENED.items():
            compared[case] = Compared(alone, *self.node(topics, case == RECORD))
        return alone.wall, compared


@dataclasses.dataclass
class Compared:
    """A case beside sieve_run of the same round."""
    headless: ros_processes.Finished
    other: ros_processes.Finished
    lost: int  # messages


def rates(cases):
    """Simulated over wall time, relative to sieve_run: of the best rounds of both, which other load disturbed least,
    and the median and range of all rounds."""
    best = min(one.headless.wall for one in cases) / min(one.other.wall for one in cases)
    return f'{100 * best:.1f}', percent([one.headless.wall / one.other.wall for one in cases])


def measure_start(programs, scratch, repetitions):
    """Wall time from exec to exit [ms], medians over interleaved starts: sieve_run on ten disks, /bin/true."""
    scene = scratch / 'ten.yaml'
    ten = mixture(2, 0.001)
    del ten['density']
    for species in ten['species']:
        species['count'] = 5
    scene.write_text(yaml.safe_dump(ten))
    commands = {'sieve_run': [programs / 'sieve_run', scene], 'true': ['/bin/true']}
    taken = {name: [] for name in commands}
    for _ in range(repetitions):
        for name, command in commands.items():
            taken[name].append(1e3 * ros_processes.run(command).wall)
    return {name: statistics.median(times) for name, times in taken.items()}


def measure_single(programs, scratch, seconds, rounds):
    """Wall time of 4000 single disks (Fig. 3) recorded over that without a bag, whole processes.
    @return the ratio of each round, with one thread and with as many as there are processors"""
    scene, bag = ROOT / 'config/paper_fig3.yaml', scratch / 'single.bag'
    ratios = ([], [])
    for _ in range(rounds):
        for options, found in zip((['--threads', '1'], []), ratios):
            command = [programs / 'sieve_run', scene, '--set', f'duration={seconds:g}', *options]
            alone = ros_processes.run(command).wall
            found.append(ros_processes.run([*command, '--bag', bag]).wall / alone)
            bag.unlink()
    return ratios


def single_line(ratios, seconds):
    one, many = (f'{statistics.median(found):.1f} ({min(found):.1f} to {max(found):.1f}) times' for found in ratios)
    return (f'4000 single disks (Fig. 3), {seconds:g} simulated seconds: `sieve_run --bag` takes {one} the wall time '
            f'of `sieve_run`, both with `--threads 1`, and {many} with a thread for each processor.')


def percent(values):
    """The median and, in brackets, the range."""
    values = [100 * value for value in values]
    return f'{statistics.median(values):.1f} ({min(values):.1f} to {max(values):.1f})'


def tables(benches, rounds, start):
    yield (f'`sieve_run` on ten disks takes {start["sieve_run"]:.1f} ms from start to end, `/bin/true` '
           f'{start["true"]:.1f} ms.')
    for bench, measured in zip(benches, rounds):
        walls = [wall for wall, _ in measured]
        yield ''
        yield (f'{bench.disks()} disks, {bench.duration:g} simulated seconds, which `sieve_run` takes '
               f'{statistics.median(walls):.2f} s for ({min(walls):.2f} to {max(walls):.2f}), {len(walls)} rounds:')
        yield ''
        lines = []
        for case in (BAG, *LISTENED):
            cases = [compared[case] for _, compared in measured]
            best, every = rates(cases)
            lines.append([case, best, every, percent([one.other.cpu / one.headless.cpu for one in cases]),
                          sum(one.lost for one in cases)])
        yield table(['', "rate, best rounds, % of `sieve_run`'s", 'every round', 'CPU time, %', 'messages lost'], lines)


def figures(rounds, start, single):
    """Those of performance.json."""
    known = {'start_ms': f'{start["sieve_run"]:.1f}'}
    for key, found in zip(('one_thread', 'threads'), single):
        known[f'single.bag_{key}'] = f'{statistics.median(found):.1f}'
    for name, measured in zip(SIZES, rounds):
        for key, case in zip(KEYS, (BAG, *LISTENED)):
            known[f'{name}.{key}'] = rates([compared[case] for _, compared in measured])[0]
    return known


def description(about=None):
    return f'{origin.text(about)}, load {os.getloadavg()[1]:.1f} before the first round'


def main():
    parser = parser_of(__doc__, rounds=7)
    parser.add_argument('--short', action='store_true', help='few disks, one round: test only that nothing is lost')
    arguments = parsed(parser)
    about = origin.describe_physics()
    where = description(about)
    sizes, rounds, starts, single_seconds = [(382, 1.0), (20, 15.0)], arguments.rounds, 50, 20.0
    if arguments.short:
        # No more messages than a publisher's queue holds: a slow machine loses none.
        sizes, rounds, starts, single_seconds = [(4, 0.4)], 1, 2, 1.0
    with tempfile.TemporaryDirectory() as directory:
        scratch = pathlib.Path(directory)
        start = measure_start(arguments.programs, scratch, starts)
        single = measure_single(arguments.programs, scratch, single_seconds, rounds)
        with ros_processes.master(scratch) as client:
            benches = [Bench(arguments.programs, scratch, client, *size) for size in sizes]
            measured = [[bench.round() for _ in range(rounds)] for bench in benches]
    print(f'{where}. Medians, in brackets the range.', '', *tables(benches, measured, start), '',
          single_line(single, single_seconds), sep='\n')
    quote(arguments, 'node', figures(measured, start, single), about)
    return 1 if any(one.lost for rounds in measured for _, compared in rounds for one in compared.values()) else 0


if __name__ == '__main__':
    sys.exit(main())
