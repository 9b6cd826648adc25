#!/usr/bin/python3
"""Runs the benchmarks of the parts that a scene's plan leaves out, and prints what each saves: the processor time with
the part over the time without it.
"""
import argparse
import json
import pathlib
import statistics
import subprocess

from ratchet_sieve import documents, origin

ROOT = pathlib.Path(__file__).resolve().parent.parent


def measure(program, rounds):
    """@return choice -> "full" and "lean" -> processor times of the rounds [ms]"""
    times = {}
    for _ in range(rounds):
        finished = subprocess.run([program, '--benchmark_filter=^plan/', '--benchmark_format=json'], check=True,
                                  stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        for run in json.loads(finished.stdout)['benchmarks']:
            _, choice, side, _ = run['name'].split('/')
            times.setdefault(choice, {'full': [], 'lean': []})[side].append(run['cpu_time'])
    return times


def lines(times, rounds):
    yield (f'{origin.text()}; {rounds} rounds; '
           'processor time of a stride. The ratio is that of the best rounds, in brackets the median of all.')
    yield ''
    yield '| | computed, ms | left out, ms | ratio |'
    yield '|---|---|---|---|'
    for choice, sides in times.items():
        full, lean = min(sides['full']), min(sides['lean'])
        median = statistics.median(a / b for a, b in zip(sides['full'], sides['lean']))
        yield f'| {choice} | {full:.3g} | {lean:.3g} | {full / lean:.2f} ({median:.2f}) |'


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--program', type=pathlib.Path, default=ROOT / 'devel/lib/ratchet_sieve/engine_benchmark',
                        metavar='FILE', help='the benchmark of the engine')
    parser.add_argument('--rounds', type=int, default=15, help='repetitions of all benchmarks (default: 15)')
    parser.add_argument('--write', type=pathlib.Path, metavar='FILE',
                        help='put the table between the marks of this document')
    arguments = parser.parse_args()
    if arguments.write:
        documents.require_place(parser, arguments.write, 'plan')
    text = '\n'.join(lines(measure(arguments.program, arguments.rounds), arguments.rounds))
    print(text)
    if arguments.write:
        documents.put(arguments.write, 'plan', text)


if __name__ == '__main__':
    main()
