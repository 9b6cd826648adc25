#!/usr/bin/python3
"""Soaks a fed sieve_node at real time, with a command every second. Its lives end in turns: it is stopped, it is
killed, its disk is full, its master is restarted under it. The bag of every life is simulated again. Prints a table.
Exit status 1 where memory grows, a bag differs, or more is lost than docs/recording.md says.

By hand: PYTHONPATH=benchmark:$PYTHONPATH test/stability/soak.py DIR
"""
import argparse
import contextlib
import pathlib
import random
import resource
import subprocess
import sys
import time

import rosbag
import rosgraph
import rospy
from std_msgs.msg import Float64
from std_srvs.srv import Empty

import measure_memory
import ros_processes
from ratchet_sieve import processes
from ratchet_sieve.srv import PourDisks
from ratchet_sieve.texts import table
from report import ROOT

STOPPED, KILLED, FULL, RESTARTED = 'stopped', 'killed', 'disk full', 'master restarted'
STATUS = {STOPPED: 0, KILLED: -9, FULL: 1, RESTARTED: 0}
UNRECORDED = {STOPPED: 0.0, KILLED: 1.02, FULL: float('inf'), RESTARTED: 0.0}  # at the end, allowed [s]
RANGES = {'inclination': (-0.3, 0.3), 'frequency': (15.0, 40.0), 'amplitude': (0.001, 0.003)}
ROOM = 18e3         # of a disk that is full at about half of a life [bytes/s]
WITHOUT_MASTER = 5  # [s]
LATENCY = 0.5       # from a setpoint's sending to its taking, at most [s]
HEAD = ['life', 'wall time', 'setpoints sent', 'of them lost', 'simulated', 'not recorded', 'MB at half, at end',
        'simulated again']


class Master:
    """A master that can be killed and started again at the same address."""

    def __init__(self, scratch):
        self.port = processes.choose_master(scratch)
        self.client = rosgraph.Master('/soak')
        self.start()

    def start(self):
        self.process = subprocess.Popen(['rosmaster', '--core', '-p', self.port],
                                        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        processes.wait_for(self.client.is_online, 'the master answers')

    def kill(self):
        self.process.kill()
        self.process.wait()


class Commander:
    """Gives a sieve a command at each call; knows its time and which setpoints it was sent at which."""

    def __init__(self, stack):
        self.time, self.sent, self.calls = 0.0, [], 0
        self.publishers = {name: rospy.Publisher(f'/sieve/{name}_setpoint', Float64, queue_size=10) for name in RANGES}
        clock = rospy.Subscriber('/sieve/statistics', rospy.AnyMsg, self.see)
        for connection in (clock, *self.publishers.values()):
            stack.callback(connection.unregister)
        processes.wait_for(lambda: self.time > 0.0 and all(publisher.get_num_connections()
                                                                for publisher in self.publishers.values()), 'a sieve')
        rospy.wait_for_service('/sieve/pour', ros_processes.TIMEOUT)
        self.pour, self.pause, self.unpause = (
            rospy.ServiceProxy(f'/sieve/{name}', kind, persistent=True)
            for name, kind in (('pour', PourDisks), ('pause_physics', Empty), ('unpause_physics', Empty)))
        # The first call asks the master where the service is; later it may be gone.
        self.pour('B', 1)
        for proxy in (self.pause, self.unpause):
            proxy()
        for proxy in (self.pour, self.pause, self.unpause):
            stack.callback(proxy.close)

    def see(self, message):
        self.time = ros_processes.time_of(message._buff)

    def command(self):
        """A setpoint; at times disks, or a pause of four seconds with setpoints."""
        self.calls += 1
        calls = {11: self.pause, 15: self.unpause, 25: lambda: self.pour('B', 5)}
        if self.calls % 30 in calls:
            calls[self.calls % 30]()
            return
        name = list(RANGES)[self.calls % 3]
        value = random.uniform(*RANGES[name])
        self.sent.append((self.time, (f'/sieve/{name}_setpoint', value)))
        self.publishers[name].publish(value)


def live(program, master, ending, bag, seconds):
    """One life of the node. @return its commander, its exit status, its memory after each command as rows of
    measure_memory"""
    master.client.setParam('/sieve', {'scene_file': str(ROOT / 'config/seek.yaml'), 'set': '{duration: 1e6}',
                                      'record': str(bag)})
    rows = []
    with contextlib.ExitStack() as stack:
        log = stack.enter_context(open(bag.with_suffix('.log'), 'w', encoding='utf-8'))
        process = stack.enter_context(subprocess.Popen([program, '__name:=sieve'], stdout=log, stderr=log))
        stack.callback(lambda: process.poll() is None and process.kill())
        if ending == FULL:
            resource.prlimit(process.pid, resource.RLIMIT_FSIZE, (int(ROOM * seconds), resource.RLIM_INFINITY))
        commander = Commander(stack)
        start = time.monotonic()
        for second in range(seconds):
            if ending == RESTARTED and second == seconds // 2:
                master.kill()
            if ending == RESTARTED and second == seconds // 2 + WITHOUT_MASTER:
                master.start()
            commander.command()
            time.sleep(max(0.0, start + second + 1 - time.monotonic()))
            rows.append((second, measure_memory.resident(process)))
        (process.kill if ending == KILLED else process.terminate)()
        return commander, process.wait(ros_processes.TIMEOUT), rows


def judged(programs, ending, bag, commander, status, rows):
    """@return the row of the table, and what is wrong"""
    path = bag
    if ending == KILLED:
        path = pathlib.Path(f'{bag}.active')
        subprocess.run(['rosbag', 'reindex', '--quiet', path], check=True)
    with rosbag.Bag(str(path)) as recording:
        end = recording.get_end_time()
        taken = {(topic, message.data) for topic, message, _ in
                 recording.read_messages(topics=[f'/sieve/{name}_setpoint' for name in RANGES])}
    lost = [setpoint for sent, setpoint in commander.sent if sent < end - LATENCY and setpoint not in taken]
    unrecorded = max(0.0, commander.time - end)
    again = subprocess.run([programs / 'sieve_resimulate', path], capture_output=True, text=True, check=False)
    said = (again.stdout + again.stderr).strip()
    faults = [fault for wrong, fault in (
        (status != STATUS[ending], f'exit status {status}'), (lost, f'lost setpoints: {lost}'),
        (unrecorded > UNRECORDED[ending] + 1e-6, f'{unrecorded:g} s not recorded'),
        (commander.time < 0.5 * len(rows), f'{commander.time:g} s simulated in {len(rows)} s'),
        (again.returncode != 0, said), (measure_memory.grows(ending, rows), 'memory grows')) if wrong]
    if not faults:
        for file in bag.parent.glob(f'{bag.stem}.*'):
            file.unlink()
    return [ending, f'{len(rows)} s', len(commander.sent), len(lost), f'{commander.time:.1f} s', f'{unrecorded:.2f} s',
            f'{rows[len(rows) // 2][1]:.1f}, {rows[-1][1]:.1f}', said], faults


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('directory', type=pathlib.Path, help='for bags and logs; those of a life with a fault stay')
    parser.add_argument('--programs', type=pathlib.Path, default=ROOT / 'devel/lib/ratchet_sieve', metavar='DIR')
    parser.add_argument('--minutes', type=float, default=120.0, help='of all lives (default: 120)')
    parser.add_argument('--life', type=float, default=10.0, help='minutes of a life (default: 10)')
    arguments = parser.parse_args()
    scratch = arguments.directory.resolve()
    scratch.mkdir(parents=True, exist_ok=True)
    master = Master(scratch)
    rows, failed = [], False
    try:
        rospy.init_node('soak', disable_signals=True, disable_rostime=True)
        for k in range(round(arguments.minutes / arguments.life)):
            ending, bag = list(STATUS)[k % len(STATUS)], scratch / f'life{k + 1}.bag'
            seen = live(arguments.programs / 'sieve_node', master, ending, bag, round(60.0 * arguments.life))
            row, faults = judged(arguments.programs, ending, bag, *seen)
            rows.append(row)
            failed |= bool(faults)
            print(', '.join(map(str, row)), *(f'  WRONG: {fault}' for fault in faults), sep='\n', flush=True)
    finally:
        master.kill()
    print(table(HEAD, rows))
    return 1 if failed else 0


if __name__ == '__main__':
    sys.exit(main())
