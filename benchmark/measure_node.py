#!/usr/bin/python3
"""Measures what the live node, the recording and the start of the programs cost beside the engine. Prints figures: the
rate of each case, in per cent of that of sieve_run without a bag, by the best rounds of both, which other load
disturbed least; how many times as long a recorded run of single disks takes; the time of a start [ms]. Exit status 1 if
a message was lost. Needs ROS on the path, but no master: it starts its own.
"""
import json
import pathlib
import statistics
import sys
import tempfile

import rosbag
import yaml

import ros_processes
from ratchet_sieve import origin, processes
from report import ROOT, arguments_of, quote

RATE = 60  # frames of each kind per simulated second, the node's default
STATISTICS_RATE = 10

FOR_PROGRAMS = ['particles', 'bins', 'base', 'statistics']
FOR_EYES = ['markers', 'cloud']
# Of each case of the node in performance.json, its listeners.
LISTENED = {'nobody': [], 'particles': ['particles'], 'all': FOR_PROGRAMS + FOR_EYES, 'record': []}


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
        """@return of each case the wall times of sieve_run and of the case [s], and how many messages were lost"""
        command = [self.programs / 'sieve_run', self.scene_file]
        with_start = ros_processes.run(command)
        alone = json.loads(with_start.output)['wall_time']
        cases = {'bag': (with_start.wall, ros_processes.run([*command, '--bag', self.bag]).wall, self.lost_in_bag())}
        for case, topics in LISTENED.items():
            finished, lost = self.node(topics, case == 'record')
            cases[case] = alone, finished.wall, lost
        return cases


def measure_start(programs, scratch, repetitions):
    """Wall time of sieve_run on ten disks from exec to exit [ms], the median."""
    scene = scratch / 'ten.yaml'
    ten = mixture(2, 0.001)
    del ten['density']
    for species in ten['species']:
        species['count'] = 5
    scene.write_text(yaml.safe_dump(ten))
    return statistics.median(1e3 * ros_processes.run([programs / 'sieve_run', scene]).wall for _ in range(repetitions))


def measure_single(programs, scratch, seconds, rounds):
    """Wall time of 4000 single disks (Fig. 3) recorded over that without a bag, whole processes.
    @return the ratio of each round, with one thread and with as many as there are processors"""
    scene, bag = ROOT / 'config/paper_fig3.yaml', scratch / 'single.bag'
    ratios = {'one_thread': [], 'threads': []}
    for _ in range(rounds):
        for options, found in zip((['--threads', '1'], []), ratios.values()):
            command = [programs / 'sieve_run', scene, '--set', f'duration={seconds:g}', *options]
            alone = ros_processes.run(command).wall
            found.append(ros_processes.run([*command, '--bag', bag]).wall / alone)
            bag.unlink()
    return ratios


def figures(measured, start, single):
    """Those of performance.json. @param measured of each size the rounds"""
    known = {'start_ms': f'{start:.1f}'}
    known.update({f'single.bag_{key}': f'{statistics.median(found):.1f}' for key, found in single.items()})
    for name, rounds in measured.items():
        for case in rounds[0]:
            alone, wall = (min(of_round[case][k] for of_round in rounds) for k in (0, 1))
            known[f'{name}.{case}'] = f'{100 * alone / wall:.1f}'
    return known


def main():
    arguments = arguments_of(__doc__, rounds=7, short='few disks, one round: test only that nothing is lost')
    about = origin.describe_physics()
    sizes, rounds, starts, single_seconds = {'large': (382, 1.0), 'fig8': (20, 15.0)}, arguments.rounds, 50, 20.0
    if arguments.short:
        # No more messages than a publisher's queue holds: a slow machine loses none.
        sizes, rounds, starts, single_seconds = {'short': (4, 0.4)}, 1, 2, 1.0
    with tempfile.TemporaryDirectory() as directory:
        scratch = pathlib.Path(directory)
        start = measure_start(arguments.programs, scratch, starts)
        single = measure_single(arguments.programs, scratch, single_seconds, rounds)
        with processes.master(scratch) as client:
            benches = {name: Bench(arguments.programs, scratch, client, *size) for name, size in sizes.items()}
            measured = {name: [bench.round() for _ in range(rounds)] for name, bench in benches.items()}
    quote(arguments, 'node', figures(measured, start, single), about)
    return 1 if any(case[2] for found in measured.values() for cases in found for case in cases.values()) else 0


if __name__ == '__main__':
    sys.exit(main())
