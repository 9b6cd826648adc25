#!/usr/bin/python3
"""Runs searches of examples/seek.py on simulated sieves, without ROS, and tells what they found: the table of
docs/seeking.md.

Usage: searches.py [--count N] [--start THETA] [--frequency F] [--least-disks N]
"""
import argparse
import collections
import concurrent.futures
import functools
import importlib.util
import types

import ratchet_sieve as rs
from ratchet_sieve import places

STEP = 0.1  # between two messages [s]


def example(name):
    """@return a script of examples/ as a module"""
    spec = importlib.util.spec_from_file_location(name, places.CHECKOUT / f'examples/{name}.py')
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


seek = example('seek')
OPTIONS = {name: default for name, (default, _, _) in seek.PARAMETERS.items()}


def messages(simulation):
    """What the node publishes of the base and the bins."""
    bins = simulation.bins
    columns = {field: [row[field] for row in bins.values()]
               for field in ('left', 'right', 'on_base', 'left_mass', 'right_mass')}
    return (types.SimpleNamespace(time=simulation.time, **simulation.base),
            types.SimpleNamespace(time=simulation.time, species=list(bins), **columns))


def found(seed, frequency=23.0, start=0.0, goal='quality', longest=1000.0, **options):
    """@return the search when it holds, and the simulated time"""
    scene = rs.Scene.load(places.SHARE / 'config/seek.yaml', {'seed': seed, 'base.frequency': frequency,
                                                              'base.inclination': start, 'duration': longest})
    simulation = rs.Simulation(scene)
    options = {**OPTIONS, **options}
    search = seek.Search(options, seek.Goal(goal, scene.species), -0.5, 0.5, start)
    trial = seek.Trial(options, search.next)
    while search.phase in ('scan', 'refine') and simulation.time < longest:
        simulation.advance(STEP)
        base, bins = messages(simulation)
        trial.take_base(base)
        result = trial.take_bins(bins)
        if result:
            search.take(*result)
            trial.begin(search.next)
            simulation.command(inclination=search.next)
    return search, simulation.time


def outcome(seed, **options):
    search, time = found(seed, **options)
    return search.phase, search.best, time, sum(trials for *_, trials in search.tried.values())


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--count', type=int, default=60)
    parser.add_argument('--start', type=float, default=0.0)
    parser.add_argument('--frequency', type=float, default=23.0)
    parser.add_argument('--least-disks', type=int, default=OPTIONS['least_disks'])
    options = parser.parse_args()
    search = functools.partial(outcome, frequency=options.frequency, start=options.start,
                               least_disks=options.least_disks)
    with concurrent.futures.ProcessPoolExecutor() as pool:
        phases, bests, times, trials = zip(*pool.map(search, range(1, options.count + 1)))
    print('found:', ', '.join(f'{best:.4g} rad {count} times' for best, count in collections.Counter(bests).most_common()))
    print('phases:', dict(collections.Counter(phases)))
    print(f'time: {sum(times) / len(times):.0f} s on average, {max(times):.0f} s at most; '
          f'{sum(trials) / len(trials):.1f} trials')


if __name__ == '__main__':
    main()
