#!/usr/bin/python3
"""Watches the memory of sieve_node over an hour of simulated time, and prints a table: a machine that is fed, so that
disks come and go, recorded and not, and one whose disks stay. Needs ROS on the path, but no master: it starts its own.
Exit status 1 where the memory grows by more than it may.
"""
import contextlib
import pathlib
import re
import subprocess
import sys
import tempfile

import rospy
import yaml

import ros_processes
from ratchet_sieve import origin, processes
from ratchet_sieve.msg import BinCounts
from ratchet_sieve.srv import StepSimulation
from ratchet_sieve.texts import table
from report import ROOT, arguments_of, publish


FED_RECORDED, FED, STAYING = 'fed, recorded', 'fed, not recorded', 'not fed, recorded'

FEED_RATE = 20.0  # disks per second
TEETH = 10

# Allowed growth in the second half [MB]: pages of the heap, a bag's index, and, where it is fed, the places of a thousand
# disks that have left, which the engine frees only then.
ALLOWED = 2.0


def scene(case, duration):
    """The mixture of config/demo.yaml on a short base."""
    tree = yaml.safe_load((ROOT / 'config/demo.yaml').read_text())
    tree['base'].update(teeth=TEETH, inclination=0.1)
    tree['duration'] = duration
    if case == STAYING:
        tree['boundary'] = 'periodic'
    else:
        tree['feed'] = {'rate': FEED_RATE}
    return tree


def resident(process):
    """The resident memory of a process [MB]."""
    status = pathlib.Path(f'/proc/{process.pid}/status').read_text()
    return int(re.search(r'VmRSS:\s+(\d+) kB', status).group(1)) * 1024 / 1e6


def disks_so_far():
    bins = rospy.wait_for_message('/sieve/bins', BinCounts, ros_processes.TIMEOUT)
    return sum(bins.left) + sum(bins.right) + sum(bins.on_base)


def watch(client, program, scratch, case, times):
    """@return per time, the disks so far and the memory [MB]; and the size of the bag [MB]"""
    bag = scratch / 'run.bag'
    client.setParam('/sieve', {'scene': scene(case, times[-1]), 'start_paused': True, 'exit_at_end': False,
                               'record': str(bag) if 'not recorded' not in case else ''})
    rows = []
    with contextlib.ExitStack() as stack:
        process = stack.enter_context(subprocess.Popen([program, '__name:=sieve'], stdout=subprocess.DEVNULL))
        stack.callback(lambda: process.poll() is None and process.kill())
        rospy.wait_for_service('/sieve/step', ros_processes.TIMEOUT)
        step = rospy.ServiceProxy('/sieve/step', StepSimulation)
        now = 0.0
        for time in times:
            answer = step(time - now)
            if not answer.success:
                raise RuntimeError(f'{case}: {answer.message}')
            now = answer.time
            rows.append((disks_so_far(), resident(process)))
            print(f'{case}: {now:g} s, {rows[-1][0]} disks so far, {rows[-1][1]:.1f} MB', flush=True)
        process.terminate()
        if process.wait() != 0:
            raise RuntimeError(f'{case}: exit status {process.returncode}')
    size = bag.stat().st_size / 1e6 if bag.exists() else 0.0
    bag.unlink(missing_ok=True)
    return rows, size


def grows(case, rows):
    """Whether the memory grows by more than is allowed in the second half. In the first half buffers reach their
    sizes."""
    (_, before), (_, after) = rows[len(rows) // 2 - 1], rows[-1]
    if after - before <= ALLOWED:
        return False
    print(f'{case}: {after - before:.1f} MB more in the second half, {ALLOWED:.1f} MB are allowed', file=sys.stderr)
    return True


def tables(times, watched):
    yield table(['simulated time', *(f'{case}: MB' for case in watched), 'disks fed so far'],
                [[f'{time / 60:g} min', *(f'{rows[k][1]:.1f}' for rows, _ in watched.values()),
                  f'{watched[FED_RECORDED][0][k][0]:,}'] for k, time in enumerate(times) if k % 4 == 3])
    yield ''
    sizes = ', '.join(f'{size:.0f} MB ({case})' for case, (_, size) in watched.items() if size)
    yield f'The bags: {sizes}.'


def main():
    arguments = arguments_of(__doc__, 'memory', short='two simulated minutes, for a test')
    duration = 120.0 if arguments.short else 3600.0
    times = [duration * k / 12 for k in range(1, 13)]
    with tempfile.TemporaryDirectory() as directory:
        scratch = pathlib.Path(directory)
        with processes.master(scratch) as client:
            rospy.init_node('measure_memory', disable_signals=True, disable_rostime=True)
            watched = {case: watch(client, arguments.programs / 'sieve_node', scratch, case, times)
                       for case in (FED_RECORDED, FED, STAYING)}
    publish(arguments, 'memory', [f'{origin.text()}.', '', *tables(times, watched)])
    return 1 if any([grows(case, rows) for case, (rows, _) in watched.items()]) else 0


if __name__ == '__main__':
    sys.exit(main())
