#!/usr/bin/python3
"""Both controllers on topics, in fast time: after 200 s what leaves is separated."""
import threading
import unittest

import rospy
import rostest

from my_feeder.msg import Report
from ratchet_sieve.msg import BinCounts

LIMIT = 180.0  # s of wall time


class Fast(unittest.TestCase):
    def test_both_controllers_separate(self):
        reports, over = {}, {}
        for line in ('line1', 'line2'):  # under climb.py, under climb
            reports[line], over[line] = [], threading.Event()
            rospy.Subscriber(f'/{line}/climb/report', Report, reports[line].append)
            rospy.Subscriber(f'/{line}/sieve/bins', BinCounts,
                             lambda bins, line=line: bins.time >= 200.0 and over[line].set())
        for line in reports:
            self.assertTrue(over[line].wait(LIMIT), f'/{line}/sieve has not reached 200 s')
            late = [abs(report.bins.window_separation) for report in reports[line] if report.bins.time > 120.0]
            # |s| is 0.14 on the level, 0.4 at the best inclination.
            self.assertGreater(sum(late) / len(late), 0.25)


if __name__ == '__main__':
    rospy.init_node('fast_rostest')
    rostest.rosrun('my_feeder', 'fast', Fast)
