#!/usr/bin/python3
"""Runs the benchmarks of what a scene's plan leaves out and prints what each choice saves: the processor time with it
worked out all the same, over the time without.
"""
import argparse
import json
import pathlib
import statistics
import subprocess

import document
from peers import machine

ROOT = pathlib.Path(__file__).resolve().parent.parent


def measure(program, rounds):
    """@return per choice, "full" and "lean": the processor times of the rounds [ms]"""
    times = {}
    for _ in range(rounds):
        finished = subprocess.run([program, '--benchmark_filter=^plan/', '--benchmark_format=json'], check=True,
                                  stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        for run in json.loads(finished.stdout)['benchmarks']:
            _, choice, side, _ = run['name'].split('/')
            times.setdefault(choice, {'full': [], 'lean': []})[side].append(run['cpu_time'])
    return times


def lines(times, rounds):
    about = machine.describe()
    yield (f'{about["date"]}, {about["processor"]}, {about["cores"]} cores, {about["system"]}; {rounds} rounds; '
           'processor time of a stride. The ratio is that of the best rounds, in brackets the median of all.')
    yield ''
    yield '| | worked out all the same, ms | left out, ms | ratio |'
    yield '|---|---|---|---|'
    for choice, sides in times.items():
        full, lean = min(sides['full']), min(sides['lean'])
        median = statistics.median(a / b for a, b in zip(sides['full'], sides['lean']))
        yield f'| {choice} | {full:.3g} | {lean:.3g} | {full / lean:.2f} ({median:.2f}) |'


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--program', type=pathlib.Path, default=ROOT / 'devel/lib/ratchet_sieve/engine_benchmark',
                        metavar='FILE', help='the benchmark of the engine')
    parser.add_argument('--rounds', type=int, default=15, help='of all choices, one after the other')
    parser.add_argument('--write', type=pathlib.Path, metavar='FILE',
                        help='put the table between the marks of this document')
    arguments = parser.parse_args()
    if arguments.write:
        document.require_place(parser, arguments.write, 'plan')
    text = '\n'.join(lines(measure(arguments.program, arguments.rounds), arguments.rounds))
    print(text)
    if arguments.write:
        document.put(arguments.write, 'plan', text)


if __name__ == '__main__':
    main()
