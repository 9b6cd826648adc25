#!/usr/bin/python3
"""Measures the engine: collisions per second of processor time of layers of many sizes and of
single disks, and the memory of a disk. Prints a Markdown table.
"""
import json
import math
import os
import pathlib
import statistics
import subprocess
import tempfile

from ratchet_sieve import origin
from ratchet_sieve.texts import table
from report import parsed, parser_of, quote

LARGE = 38168  # teeth: a million disks
LARGE_SCENE = '''
base: {{teeth: {teeth}}}
species:
  - {{name: A, count: {count}, radius: 0.001, mass: 0.010}}
  - {{name: B, count: {count}, radius: 0.002, mass: 0.001}}
duration: 0.07
'''


def collisions(program, rounds):
    """Of the best round, which other load on the machine disturbs least.
    @return benchmark -> collisions per second; processor time of an iteration [ms]"""
    best, times = {}, {}
    command = [program, '--benchmark_filter=^(mixture/|singleParticles|wideSizes|lognormalSizes|slewing)',
               '--benchmark_format=json']
    for _ in range(rounds):
        finished = subprocess.run(command, check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        for run in json.loads(finished.stdout)['benchmarks']:
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


def rows(best, times_of, two_jobs, memory, memory_of_two):
    """@return of each row its key in performance.json, what it is, measured"""
    def millions(name):
        return f'{best[name] / 1e6:.2f} M'

    def times(name, other):
        return f'{best[name] / best[other]:.2f}'

    def turning(teeth):
        turns, rests = (times_of[f'slewing/{teeth}/{turns}/iterations:6'] for turns in (1, 0))
        return f'{turns / rests:.2f}'

    yield 'fig8.collisions', 'Fig. 8, 524 disks, θ = 0: collisions per second', millions('mixture/20')
    yield 'disks_1e4.collisions', 'the same layer with 10⁴ disks', millions('mixture/382')
    yield 'disks_1e5.collisions', 'with 10⁵ disks', millions('mixture/3817')
    yield ('size_cost', 'cost of a collision among 10⁵ disks, over that among 10³',
           times('mixture/38', 'mixture/3817'))
    for teeth, name in ((20, 'fig8'), (382, 'disks_1e4'), (3817, 'disks_1e5')):
        yield (f'two_jobs.{name}', f'two jobs at once, one a core, over a lone job: {teeth} teeth',
               f'{two_jobs[f"mixture/{teeth}"]:.2f}')
    for teeth in (20, 382):
        yield (f'slewing.{teeth}', f'a periodic base of {teeth} teeth that turns at 0.1 rad/s, over one at rest: '
               'processor time', turning(teeth))
    for times_as_large in (5, 10, 25, 50):
        yield (f'wide.{times_as_large}', f'one disk {times_as_large} times as large among 2000: cost of a collision, '
               'over that of equal disks', times('wideSizes/1', f'wideSizes/{times_as_large}'))
    for percent in (25, 50):
        yield (f'lognormal.{percent}', f'2000 disks of lognormal radii, σ = {percent / 100:g}: the same',
               times('wideSizes/1', f'lognormalSizes/{percent}'))
    yield 'bytes_per_disk', '10⁶ disks, one thread: bytes a disk, everything included', f'{memory:.0f}'
    yield 'bytes_per_disk_two_threads', 'the same, two threads', f'{memory_of_two:.0f}'
    yield ('single.collisions', 'single disks (Fig. 3): collisions per second, as many lanes as there are',
           millions('singleParticles'))
    for lanes in (2, 4, 8):
        if f'singleParticlesInLanes/{lanes}' in best:
            yield (f'single.lanes_{lanes}', f'in {lanes} lanes, in long steps',
                   millions(f'singleParticlesInLanes/{lanes}'))
    yield ('single.two_threads', '10⁴ single disks: two threads over one, wall time',
           times('singleParticlesOnThreads/2', 'singleParticlesOnThreads/1'))


def main():
    arguments = parsed(parser_of(__doc__, rounds=5))
    memory = [bytes_per_disk(arguments.programs / 'sieve_run', LARGE, threads) for threads in (1, 2)]
    program = arguments.programs / 'engine_benchmark'
    two_jobs = two_over_one(program, arguments.rounds)
    about, found = origin.describe_physics(), list(rows(*collisions(program, arguments.rounds), two_jobs, *memory))
    print(f'{origin.text(about)}; the best of {arguments.rounds} rounds.',
          table(['', 'measured'], [row[1:] for row in found]), sep='\n\n')
    quote(arguments, 'engine', {key: measured for key, _, measured in found}, about)


if __name__ == '__main__':
    main()
