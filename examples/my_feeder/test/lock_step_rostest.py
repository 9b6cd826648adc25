#!/usr/bin/python3
"""The law in lock step: the same run each time, bit for bit, and it separates."""
import unittest

import rospy
import rostest

from my_feeder.climber import Climber
from ratchet_sieve.msg import BaseSetpoint
from ratchet_sieve.srv import LockStep, ResetSimulation

PERIOD = 0.5  # s


class InLockStep(unittest.TestCase):
    def run_once(self):
        """@return what the climber saw, and the last state"""
        rospy.ServiceProxy('/sieve/reset', ResetSimulation)()
        lock_step = rospy.ServiceProxy('/sieve/lock_step', LockStep, persistent=True)
        climber, seen = Climber(step=0.03, dwell=2.0), []
        answer = lock_step([], PERIOD)
        while answer.success and not answer.finished:
            seen.append(answer.bins)
            answer = lock_step([BaseSetpoint('inclination', climber.take(answer.bins))], PERIOD)
        self.assertTrue(answer.success, answer.message)
        return seen, answer

    def test_separates_the_same_each_time(self):
        rospy.wait_for_service('/sieve/lock_step', 60.0)
        seen, last = self.run_once()
        late = [abs(bins.window_separation) for bins in seen if bins.time > 120.0]
        self.assertGreater(sum(late) / len(late), 0.25)
        self.assertEqual(self.run_once(), (seen, last))


if __name__ == '__main__':
    rospy.init_node('lock_step_rostest')
    rostest.rosrun('my_feeder', 'lock_step', InLockStep)
