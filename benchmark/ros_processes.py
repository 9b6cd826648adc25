"""Starts nodes and listeners, and takes the wall time of programs. As a program it is the listener to a
topic of a sieve: it prints a line when the first message is there. When a line comes on standard input it prints, as
JSON, the length in bytes of all messages, and their simulated times where they have a header and a time."""
import contextlib
import dataclasses
import json
import re
import select
import struct
import subprocess
import sys
import time

import rospy
from std_srvs.srv import Empty

from ratchet_sieve.processes import TIMEOUT, wait_for

LAST = 5.0        # for a listener's connection to end [s]
BUFFER = 1 << 24  # bytes: more than a message of very many disks


@dataclasses.dataclass
class Finished:
    """A program that has ended with status 0."""
    wall: float    # [s]
    output: str


def finish(process, begin):
    """Waits for a program and takes its time."""
    output, _ = process.communicate()
    wall = time.time() - begin
    if process.returncode != 0:
        raise RuntimeError(f'{process.args}: exit status {process.returncode}: {output}')
    return Finished(wall, output)


def run(command):
    """Runs a program to its end."""
    begin = time.time()
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        return finish(process, begin)


@contextlib.contextmanager
def listener(topic):
    """Another process that is subscribed to a topic of a node that runs, and has had its first message: a sieve
    greets who comes. Gives a function that ends it and says what came."""
    command = [sys.executable, __file__, topic]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as process:
        def received():
            return json.loads(process.communicate('end\n')[0])
        try:
            if not select.select([process.stdout], [], [], TIMEOUT)[0] or not process.stdout.readline():
                raise RuntimeError(f'{topic}: no message within {TIMEOUT:g} s')
            yield received
        finally:
            if process.poll() is None:
                process.kill()


def run_node(client, program, parameters, topics):
    """Runs a sieve_node, with a listener on each topic, from its unpausing to its scene's end: as fast as it goes,
    where its parameters ask for nothing else.
    @return what it took, and the times of the messages of each listener"""
    client.setParam('/use_sim_time', True)
    client.setParam('/sieve', {'real_time_factor': 0.0, **parameters, 'start_paused': True})
    command = [program, '__name:=sieve']
    with contextlib.ExitStack() as stack:
        process = stack.enter_context(
            subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True))
        stack.callback(lambda: process.poll() is None and process.kill())
        unpause = '/sieve/unpause_physics'
        wait_for(lambda: any(name == unpause for name, _ in client.getSystemState()[2]), 'the node is up')
        received = {topic: stack.enter_context(listener(topic)) for topic in topics}
        begin = time.time()
        rospy.ServiceProxy(unpause, Empty)()
        finished = finish(process, begin)
        # The node stays for a moment after its end, until its last messages are sent.
        finished.wall = float(re.search(r'([\d.]+) ended at', finished.output).group(1)) - begin
        return finished, {topic: end() for topic, end in received.items()}


def time_of(message):
    """The field `time` behind the header: sequence number, stamp, and a text that gives its length. Nothing else is
    unpacked."""
    length, = struct.unpack_from('<I', message, 12)
    return struct.unpack_from('<d', message, 16 + length)[0]


def listen(topic):
    messages = []
    rospy.init_node('listener', anonymous=True, disable_signals=True)

    def add(message):
        if not messages:
            print('there', flush=True)
        messages.append((len(message._buff), message._buff[:64]))

    subscriber = rospy.Subscriber(topic, rospy.AnyMsg, add, buff_size=BUFFER)
    sys.stdin.readline()
    # The last messages of the sieve may not have been read yet.
    deadline = time.monotonic() + LAST
    while subscriber.get_num_connections() > 0 and time.monotonic() < deadline:
        time.sleep(0.01)
    with_times = topic.rpartition('/')[2] not in ('markers', 'cloud')
    json.dump({'bytes': sum(size for size, _ in messages),
               'times': [time_of(start) for _, start in messages] if with_times else []}, sys.stdout)


if __name__ == '__main__':
    listen(sys.argv[1])
