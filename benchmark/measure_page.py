#!/usr/bin/python3
"""Measures how fast pages of runs are drawn: pictures per second as a page plays, and the time of one picture, of some
500 and some 10,000 disks in Chromium and Firefox. Without a window and a graphics card the processor does all of it.
Needs the group all of scripts/packages.txt.
"""
import argparse
import dataclasses
import json
import os
import pathlib
import subprocess
import tempfile

from ratchet_sieve import origin

HERE = pathlib.Path(__file__).resolve().parent
PROJECT = HERE.parent
MARGIN = 1.0  # of a run's duration over the time for which it is played [s]


@dataclasses.dataclass
class Case:
    name: str
    teeth: int
    wanted: float  # pictures per second


CASES = (Case('the layer of Fig. 8', 20, 60.0), Case('the same, 19 times as long', 382, 30.0))


def make_page(programs, case, seconds, out):
    subprocess.run([programs / 'sieve_run', PROJECT / 'config/paper_fig8.yaml', '--set', f'base.teeth={case.teeth}',
                    '--set', 'settle=0', '--duration', str(seconds + MARGIN), '--html', out],
                   check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def measure(browser, page, seconds, modules):
    command = ['node', HERE / 'measure_page.mjs', browser, page, str(seconds)]
    environment = {**os.environ, 'PAGE_TEST_MODULES': str(modules)}
    return json.loads(subprocess.run(command, check=True, capture_output=True, text=True, env=environment).stdout)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--programs', type=pathlib.Path, default=PROJECT / 'devel/lib/ratchet_sieve', metavar='DIR')
    parser.add_argument('--modules', type=pathlib.Path, default=PROJECT / 'build/test/page/browsers/modules',
                        metavar='DIR', help='where the modules of Node.js are, or are installed')
    parser.add_argument('--seconds', type=float, default=8.0, help='of playing (default: 8)')
    parser.add_argument('--short', action='store_true', help='one second each: to see that it runs')
    arguments = parser.parse_args()
    seconds = 1.0 if arguments.short else arguments.seconds
    modules = arguments.modules.resolve()
    subprocess.run([PROJECT / 'test/page/browsers/install_modules', modules], check=True, stdout=subprocess.DEVNULL)
    print(f'{origin.text()}; played at the speed of the machine for {seconds:g} s.\n')
    print('| | disks | browser | pictures per second: wanted | measured | one picture [ms] |\n' + '|---' * 6 + '|')
    with tempfile.TemporaryDirectory() as scratch:
        for case in CASES:
            page = pathlib.Path(scratch) / f'{case.teeth}.html'
            make_page(arguments.programs, case, seconds, page)
            for browser in ('chromium', 'firefox'):
                found = measure(browser, page, seconds, modules)
                print(f'| {case.name} | {found["disks"]} | {browser} | {case.wanted:g} | {found["rate"]:.1f} | '
                      f'{found["milliseconds"]:.1f} |')


if __name__ == '__main__':
    main()
