#!/usr/bin/python3
"""hold.py as it is launched, in step: with exact sensors and drives, those of a machine, and one that is stuck."""
import unittest

import rospy
import rostest

from my_feeder.msg import Holding
from ratchet_sieve.in_step import InStep
from ratchet_sieve.msg import BaseState, BinCounts
from ratchet_sieve.srv import SetFault

STEP = 0.5  # s: a reading of each sensor (rate: 2)


class Line:
    """A sieve with its controller, which has unpaused it."""

    def __init__(self, line):
        self.sieve, self.reports, self.bins, self.base = InStep(f'/{line}/sieve'), [], [], []
        rospy.Subscriber(f'/{line}/hold/report', Holding, self.reports.append, tcp_nodelay=True)
        rospy.Subscriber(f'/{line}/sieve/bins', BinCounts, self.bins.append, tcp_nodelay=True)
        rospy.Subscriber(f'/{line}/sieve/base', BaseState, self.base.append, tcp_nodelay=True)
        self.sieve.wait_for(lambda: self.reports and self.reports[-1].header.stamp.to_sec() > 0.0, 'report of a run')

    def begin(self, *overrides):
        self.sieve.reset(overrides=overrides)
        self.sieve.wait_for(lambda: self.bins and self.bins[-1].time == 0.0, 'bins of the new run')
        del self.bins[:-1]

    def run(self, duration):
        """@return the setpoints, one for each step"""
        run = []
        for _ in range(round(duration / STEP)):
            self.answered()
            self.sieve.step(STEP)
            run.append(self.answered())
        self.sieve.wait_for(lambda: self.bins[-1].time == self.base[-1].time == self.sieve.time, 'state')
        return run

    def answered(self):
        """Waits until the sieve has the setpoint of this time. @return it"""
        self.sieve.wait_for(lambda: self.reports[-1].header.stamp.to_sec() == self.sieve.time, 'report of this step')
        inclination = self.reports[-1].inclination
        self.sieve.wait_for_setpoint('inclination', inclination)
        return inclination

    def purity_since(self, time):
        """What is true of the right end, and what no sensor says."""
        then = next(bins for bins in self.bins if bins.time >= time)
        a, b = (now - before for now, before in zip(self.bins[-1].right, then.right))
        return a / (a + b)


class TestHold(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.exact, cls.real = Line('exact'), Line('real')

    def holds(self, line, within):
        line.begin()
        run = line.run(180.0)
        self.assertAlmostEqual(line.purity_since(80.0), 0.62, delta=within)
        line.begin()
        self.assertEqual(line.run(40.0), run[:80])

    def test_with_exact_sensors(self):
        self.holds(self.exact, 0.02)

    def test_with_those_of_a_real_machine(self):
        self.holds(self.real, 0.03)

    def test_a_feed_that_ends_is_no_fault_of_a_sensor(self):
        self.exact.begin('feed.rate=0')
        run = self.exact.run(60.0)
        self.assertEqual(sum(self.exact.bins[-1].on_base), 0)
        self.assertEqual((run[-1], self.exact.reports[-1].fault), (run[-2], ''))

    def test_a_sensor_that_is_stuck_is_noticed(self):
        line = self.real
        for sensor in ('right/count', 'right/scale'):
            line.begin()
            self.assertGreater(min(line.run(60.0)[-20:]), 0.02)
            self.assertTrue(rospy.ServiceProxy('/real/sieve/fault', SetFault)(sensor, 'stuck').success)
            self.assertEqual(line.run(10.0)[-1], 0.0)
            line.run(10.0)
            self.assertAlmostEqual(line.base[-1].inclination, 0.01, delta=1e-9)  # the drive's offset


if __name__ == '__main__':
    rospy.init_node('hold_rostest')
    rostest.rosrun('my_feeder', 'hold', TestHold)
