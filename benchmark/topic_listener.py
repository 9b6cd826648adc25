#!/usr/bin/python3
"""Subscribes to a topic of a sieve until a line comes on standard input; prints, as JSON, the length in bytes
of all messages, and their simulated times where the message has a header and a time. Unpacks nothing else."""
import json
import struct
import sys

import rospy

BUFFER = 1 << 24  # bytes: more than a message of very many disks


def time_of(message):
    """The field `time` behind the header: sequence number, stamp, and a text that gives its length."""
    length, = struct.unpack_from('<I', message, 12)
    return struct.unpack_from('<d', message, 16 + length)[0]


def main():
    messages = []
    rospy.init_node('listener', anonymous=True, disable_signals=True)
    rospy.Subscriber(sys.argv[1], rospy.AnyMsg,
                     lambda message: messages.append((len(message._buff), message._buff[:64])), buff_size=BUFFER)
    sys.stdin.readline()
    with_times = sys.argv[1].rpartition('/')[2] not in ('markers', 'cloud')
    json.dump({'bytes': sum(size for size, _ in messages),
               'times': [time_of(start) for _, start in messages] if with_times else []}, sys.stdout)


if __name__ == '__main__':
    main()
