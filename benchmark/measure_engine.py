#!/usr/bin/python3
"""Measures the engine: collisions per second of processor time of layers of many sizes and of
single disks, and the memory of a disk. Prints figures.
"""
import json
import math
import os
import pathlib
import statistics
import subprocess
import tempfile

from ratchet_sieve import origin
from report import arguments_of, benchmarks, quote

LARGE = 38168  # teeth: a million disks
LARGE_SCENE = '''
base: {{teeth: {teeth}}}
species:
  - {{name: A, count: {count}, radius: 0.001, mass: 0.010}}
  - {{name: B, count: {count}, radius: 0.002, mass: 0.001}}
duration: 0.07
'''


def collisions(arguments):
    """Of the best round, which other load on the machine disturbs least.
    @return benchmark -> collisions per second; processor time of an iteration [ms]"""
    best, times = {}, {}
    for run in benchmarks(arguments, 'mixture/|singleParticles|wideSizes|lognormalSizes|slewing', arguments.rounds):
        if 'collisions' in run:
            name = run['name'].replace('/real_time', '')
            best[name] = max(best.get(name, 0.0), run['collisions'])
            times[name] = min(times.get(name, math.inf), run['cpu_time'])
    return best, times


def at_once(program, jobs):
    """Runs layers in so many processes at once, each on a processor of its own.
    @return benchmark -> mean of the processes' collisions per second"""
    processors = sorted(os.sched_getaffinity(0))[:jobs]
    command = [program, '--benchmark_filter=^mixture/(20|382|3817)$', '--benchmark_format=json']
    running = [subprocess.Popen(['taskset', '--cpu-list', str(processor), *command], stdout=subprocess.PIPE,
                                stderr=subprocess.DEVNULL) for processor in processors]
    runs = [json.loads(process.communicate()[0])['benchmarks'] for process in running]
    return {same[0]['name']: statistics.mean(run['collisions'] for run in same) for same in zip(*runs)}


def two_over_one(program, rounds):
    """@return benchmark -> collisions per second of each of two jobs at once, over those of a job alone; medians"""
    pairs = [(at_once(program, 1), at_once(program, 2)) for _ in range(rounds)]
    return {name: statistics.median(two[name] / alone[name] for alone, two in pairs) for name in pairs[0][0]}


def bytes_per_disk(sieve_run, teeth, threads):
    """Memory per disk of a run until the layer has come down, everything included."""
    count = teeth * 131 // 10
    with tempfile.TemporaryDirectory() as directory:
        scene = pathlib.Path(directory) / 'large.yaml'
        scene.write_text(LARGE_SCENE.format(teeth=teeth, count=count))
        with subprocess.Popen([sieve_run, scene, '--threads', str(threads)], stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL) as process:
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        raise SystemExit(f'{sieve_run} ended with {process.returncode}')
    return usage.ru_maxrss * 1024 / (2 * count)


def figures(best, times_of, two_jobs):
    """Those of performance.json that the benchmarks tell."""
    def millions(name):
        return f'{best[name] / 1e6:.2f} M'

    def ratio(name, other):
        return f'{best[name] / best[other]:.2f}'

    layers = {20: 'fig8', 382: 'disks_1e4', 3817: 'disks_1e5'}  # teeth and name
    known = {f'{name}.collisions': millions(f'mixture/{teeth}') for teeth, name in layers.items()}
    known['size_cost'] = ratio('mixture/38', 'mixture/3817')  # of a collision among 10^5 disks, over that among 10^3
    known.update({f'two_jobs.{name}': f'{two_jobs[f"mixture/{teeth}"]:.2f}' for teeth, name in layers.items()})
    for teeth in (20, 382):
        turns, rests = (times_of[f'slewing/{teeth}/{turns}/iterations:6'] for turns in (1, 0))
        known[f'slewing.{teeth}'] = f'{turns / rests:.2f}'
    known.update({f'wide.{times}': ratio('wideSizes/1', f'wideSizes/{times}') for times in (5, 10, 25, 50)})
    known.update({f'lognormal.{percent}': ratio('wideSizes/1', f'lognormalSizes/{percent}') for percent in (25, 50)})
    known['single.collisions'] = millions('singleParticles')
    known.update({f'single.lanes_{lanes}': millions(f'singleParticlesInLanes/{lanes}') for lanes in (2, 4, 8)
                  if f'singleParticlesInLanes/{lanes}' in best})
    known['single.two_threads'] = ratio('singleParticlesOnThreads/2', 'singleParticlesOnThreads/1')
    return known


def main():
    arguments = arguments_of(__doc__, rounds=5)
    memory = {f'bytes_per_disk{name}': f'{bytes_per_disk(arguments.programs / "sieve_run", LARGE, threads):.0f}'
              for threads, name in ((1, ''), (2, '_two_threads'))}
    two_jobs = two_over_one(arguments.programs / 'engine_benchmark', arguments.rounds)
    about = origin.describe_physics()
    quote(arguments, 'engine', {**figures(*collisions(arguments), two_jobs), **memory}, about)


if __name__ == '__main__':
    main()
