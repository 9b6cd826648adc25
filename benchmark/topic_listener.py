#!/usr/bin/python3
"""Subscribes to a topic of a sieve; prints a line when the first message is there. When a line comes on standard
input it prints, as JSON, the length in bytes of all messages, and their simulated times where they have a header
and a time. Unpacks nothing else."""
import json
import struct
import sys
import time

import rospy

TIMEOUT = 5.0  # for the connection to end [s]
BUFFER = 1 << 24  # bytes: more than a message of very many disks


def time_of(message):
    """The field `time` behind the header: sequence number, stamp, and a text that gives its length."""
    length, = struct.unpack_from('<I', message, 12)
    return struct.unpack_from('<d', message, 16 + length)[0]


def main():
    messages = []
    rospy.init_node('listener', anonymous=True, disable_signals=True)

    def take(message):
        if not messages:
            print('there', flush=True)
        messages.append((len(message._buff), message._buff[:64]))

    subscriber = rospy.Subscriber(sys.argv[1], rospy.AnyMsg, take, buff_size=BUFFER)
    sys.stdin.readline()
    # The last messages of the sieve may not have been read yet.
    deadline = time.monotonic() + TIMEOUT
    while subscriber.get_num_connections() > 0 and time.monotonic() < deadline:
        time.sleep(0.01)
    with_times = sys.argv[1].rpartition('/')[2] not in ('markers', 'cloud')
    json.dump({'bytes': sum(size for size, _ in messages),
               'times': [time_of(start) for _, start in messages] if with_times else []}, sys.stdout)


if __name__ == '__main__':
    main()
