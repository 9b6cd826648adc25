#!/usr/bin/python3
"""Both controllers as they are launched, in step: the same run each time, bit for bit."""
import unittest

import rospy
import rostest

from my_feeder.msg import Report
from ratchet_sieve.in_step import InStep

STEP = 0.25  # s: the controllers get one message of ~bins in each (rates/bins: 4)
END = 30.0   # s: the law has turned round


class Line:
    """A sieve with its controller, which has unpaused it."""

    def __init__(self, line):
        self.sieve, self.reports = InStep(f'/{line}/sieve'), []
        rospy.Subscriber(f'/{line}/climb/report', Report, self.reports.append, tcp_nodelay=True)
        self.sieve.wait_for(lambda: self.reports and self.reports[-1].bins.time > 0.0, 'report of a run')

    def run(self):
        """@return what the controller reported at each step"""
        run = []
        self.sieve.reset()
        while True:
            self.sieve.wait_for(lambda: self.reports[-1].bins.time == self.sieve.time, 'report of this step')
            run.append(self.reports[-1])
            run[-1].bins.header.seq = 0  # goes on from run to run
            self.sieve.wait_for_setpoint('inclination', run[-1].inclination)
            if self.sieve.time >= END:
                return run
            self.sieve.step(STEP)


class TestInStep(unittest.TestCase):
    def test_runs_the_same_each_time_in_python_and_in_cpp(self):
        python, cpp = Line('line1'), Line('line2')
        run = python.run()
        self.assertGreater(len({report.inclination for report in run}), 1)
        self.assertEqual(python.run(), run)
        self.assertEqual(cpp.run(), run)


if __name__ == '__main__':
    rospy.init_node('in_step_rostest')
    rostest.rosrun('my_feeder', 'in_step', TestInStep)
