#!/usr/bin/python3
"""Commands a sieve over its setpoint topics at given simulated times.

Usage: rosrun ratchet_sieve schedule.py [_PARAMETER:=VALUE]... [ROS ARGUMENT...]

Parameters:
  ~sieve        name of the sieve's node (default: sieve)
  ~schedule     list of {time: [s], inclination: [rad], frequency: [Hz], amplitude: [m]}, with times in ascending
                order and at least one quantity in each entry
  ~exit_at_end  exit after the last entry; if false, repeat the schedule after a reset (default: false)

A sieve that was started paused is set running when this node is connected to it.

Exit status: 0 at the end of the schedule or if it is stopped; 2 for a bad parameter.

An example of a node that commands a sieve, to be copied.
"""
import sys
import time

import rospy
from std_msgs.msg import Float64
from std_srvs.srv import Empty

from ratchet_sieve.msg import BaseState

QUANTITIES = ('inclination', 'frequency', 'amplitude')
PERIOD = 0.05  # between two looks at the connections; also for the last setpoint to be sent [s of wall time]
WARN_EVERY = 10.0  # [s of wall time]


def checked(schedule):
    """Raises ValueError."""
    name, last = f'parameter {rospy.resolve_name("~schedule")}', float('-inf')
    if not isinstance(schedule, list):
        raise ValueError(f'{name}: must be a list of {{time, inclination, frequency, amplitude}}')
    for k, entry in enumerate(schedule):
        if not (isinstance(entry, dict) and 'time' in entry and len(entry) > 1 and {*entry} <= {'time', *QUANTITIES}
                and all(isinstance(value, (int, float)) for value in entry.values())):
            raise ValueError(f'{name}/{k}: must have time and inclination, frequency or amplitude, which are numbers')
        if entry['time'] < last:
            raise ValueError(f'{name}/{k}/time: must not be before that of the entry above')
        last = entry['time']
    return schedule


class Schedule:
    def __init__(self):
        self.entries = checked(rospy.get_param('~schedule', None))
        self.sieve = rospy.resolve_name(rospy.get_param('~sieve', 'sieve'))
        self.exit_at_end = rospy.get_param('~exit_at_end', False)
        self.due, self.last, self.started = 0, 0.0, False
        self.setpoints = {name: rospy.Publisher(f'{self.sieve}/{name}_setpoint', Float64, queue_size=10)
                          for name in QUANTITIES}
        self.base = rospy.Subscriber(f'{self.sieve}/base', BaseState, self.follow, tcp_nodelay=True)

    def follow(self, base):
        if base.time < self.last and self.due > 0:
            rospy.loginfo('time jumped back from %.3f to %.3f s: the schedule restarts', self.last, base.time)
            self.due = 0
        self.last = base.time
        while self.started and self.due < len(self.entries) and self.entries[self.due]['time'] <= base.time:
            entry = self.entries[self.due]
            for name in entry.keys() - {'time'}:
                self.setpoints[name].publish(entry[name])
                rospy.loginfo('%s %g, due at %.3f s, sent at %.3f s', name, entry[name], entry['time'], base.time)
            self.due += 1
            if self.due == len(self.entries):
                rospy.loginfo('the schedule is over at %.3f s', base.time)

    def watch(self):
        """Starts the schedule when the sieve is connected, and again when it comes again."""
        there = self.base.get_num_connections() > 0
        if not self.started and there and all(setpoint.get_num_connections() for setpoint in self.setpoints.values()):
            self.started = True
            rospy.loginfo('%s is running: the schedule starts', self.sieve)
            rospy.wait_for_service(f'{self.sieve}/unpause_physics')
            rospy.ServiceProxy(f'{self.sieve}/unpause_physics', Empty)()
        elif self.started and not there:
            if self.due < len(self.entries):
                rospy.logwarn('%s stopped at %.3f s, before the end of the schedule, which restarts when it is back',
                              self.sieve, self.last)
            self.due, self.last, self.started = 0, 0.0, False


def main():
    if '--help' in sys.argv:
        print(__doc__)
        return 0
    rospy.init_node('schedule')
    try:
        schedule = Schedule()
    except ValueError as error:
        print(f'schedule.py: {error}', file=sys.stderr)
        return 2
    warned = time.monotonic()
    while not rospy.is_shutdown():
        schedule.watch()
        if not schedule.started and time.monotonic() > warned + WARN_EVERY:
            rospy.logwarn('%s is not running: waiting for it', schedule.sieve)
            warned = time.monotonic()
        over = schedule.due == len(schedule.entries) and schedule.exit_at_end
        time.sleep(PERIOD)
        if over:
            break
    return 0


if __name__ == '__main__':
    sys.exit(main())
