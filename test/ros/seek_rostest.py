#!/usr/bin/python3
"""seek.py on a running sieve: its topics, parameters and setpoints; the search itself is tested in test/seeking.

Usage: seek_rostest.py [ROS ARGUMENT...]; part of seek.test, which has started a paused sieve and the node.
"""

import subprocess
import unittest

import rospy
import rosunit
from std_msgs.msg import Float64
from std_srvs.srv import Empty

from launched import TIMEOUT, message, wait_for
from ratchet_sieve.msg import BaseState, SeekTrial
from ratchet_sieve.srv import ResetSimulation


class Seek(unittest.TestCase):
    def setUp(self):
        self.trials = []
        subscriber = rospy.Subscriber('/seek/trials', SeekTrial, self.trials.append)
        self.addCleanup(subscriber.unregister)
        wait_for(subscriber.get_num_connections, 'the node is there')

    def call(self, name, kind=Empty, **request):
        rospy.wait_for_service(f'/sieve/{name}', TIMEOUT)
        return rospy.ServiceProxy(f'/sieve/{name}', kind)(**request)

    def wait_for_phase(self, phase):
        wait_for(lambda: self.trials and self.trials[-1].next_phase == phase, phase)
        return self.trials[-1]

    def test_1_scans_also_after_a_reset_and_holds_the_best(self):
        self.call('unpause_physics')
        wait_for(lambda: len(self.trials) >= 3, 'three trials')
        first, second = self.trials[:2]
        self.assertEqual((first.trial, first.phase, first.inclination, first.next_inclination), (1, 'scan', 0.0, 0.1))
        self.assertEqual((second.trial, second.inclination), (2, 0.1))
        self.assertEqual((first.goal, first.value, first.species), ('quality', first.quality, ['A', 'B']))
        self.assertGreater(first.balance, 0.5)  # nearly all disks leave on the right
        self.assertGreaterEqual(min(left + right for left, right in zip(first.left, first.right)), 100)
        self.assertGreaterEqual(first.begin, 4.0)
        self.assertEqual(len(second.granular_temperature), 2)

        # Time jumps back and the base is level: the setpoint is sent again, and the trial begins again.
        self.call('pause_physics')
        before = len(self.trials)
        self.assertTrue(self.call('reset', ResetSimulation).success)
        wait_for(lambda: message('/sieve/base', BaseState).commanded_inclination != 0.0, 'the setpoint is sent again')
        self.assertEqual(message('/sieve/base', BaseState).time, 0.0)
        self.call('unpause_physics')
        wait_for(lambda: len(self.trials) > before, 'a trial after the reset')
        wait_for(lambda: self.trials[-1].time < self.trials[before - 1].time, 'a trial by the new time')

        held = self.wait_for_phase('hold')
        # By docs/data/seek.csv: Q is 0.43 at 0.15 rad, above 0.33 from 0.1 to 0.175, and 0.15 on the level.
        self.assertLess(abs(held.best_inclination - 0.15), 0.06)
        self.assertGreater(held.best_quality, first.quality + 0.1)
        wait_for(lambda: message('/sieve/base', BaseState).inclination == held.best_inclination, 'it is held')

    def test_2_searches_again_where_the_drive_is_changed(self):
        held = self.wait_for_phase('hold').best_inclination
        self.trials.clear()
        frequency = rospy.Publisher('/sieve/frequency_setpoint', Float64, queue_size=1)
        wait_for(frequency.get_num_connections, 'the sieve takes setpoints')
        frequency.publish(26.0)
        self.wait_for_phase('scan')
        self.assertIn(held, [trial.inclination for trial in self.trials if trial.phase == 'scan'])

    def test_3_refuses_what_it_cannot_do(self):
        for parameter, error in (
                ('goal:=flow:C:left', 'flow:C:left: there is no species C; there are A, B'),
                ('inclination/min:=-1', '-1: must be a number from -0.5 to 0.5')):
            run = subprocess.run(['rosrun', 'ratchet_sieve', 'seek.py', '__name:=refused', f'_{parameter}'],
                                 capture_output=True, text=True, timeout=TIMEOUT)
            self.assertEqual(run.returncode, 2)
            name = parameter.partition(':=')[0]
            self.assertIn(f'seek.py: parameter /refused/{name}: {error}\n', run.stderr)
            rospy.delete_param(f'/refused/{name}')


if __name__ == '__main__':
    rospy.init_node('seek_rostest', disable_signals=True)
    rosunit.unitrun('ratchet_sieve', 'seek', Seek)
