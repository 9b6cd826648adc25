"""Starts launch files of this package during a test, on its master, as users start them."""

import os
import signal
import subprocess
import unittest
from pathlib import Path

import rosgraph
import rospy

from ratchet_sieve.processes import TIMEOUT, wait_for  # noqa: F401

PACKAGE = Path(__file__).resolve().parents[2]


def message(topic, kind):
    """The next or latched message on a topic."""
    return rospy.wait_for_message(topic, kind, TIMEOUT)


class Launched(unittest.TestCase):
    """A test with launch files, which end with it."""

    def setUp(self):
        self.master = rosgraph.Master('/launched')

    def launch(self, *arguments, namespace='', **environment):
        return self.start(['roslaunch', 'ratchet_sieve', *arguments], ROS_NAMESPACE=namespace, **environment)

    def start(self, command, stdout=subprocess.DEVNULL, stderr=None, **environment):
        program = subprocess.Popen(command, cwd=PACKAGE, env=dict(os.environ, **environment), start_new_session=True,
                                   stdout=stdout, stderr=stderr)
        self.addCleanup(self.end, program)
        return program

    @staticmethod
    def end(program):
        """Like Ctrl-C, which roslaunch forwards to its nodes."""
        if program.poll() is None:
            program.send_signal(signal.SIGINT)
        program.wait(TIMEOUT)

    def publishers(self, topic):
        """The names of a topic's publishers, according to the master."""
        return dict(self.master.getSystemState()[0]).get(topic, [])

    def subscribers(self, topic):
        return dict(self.master.getSystemState()[1]).get(topic, [])
