#!/usr/bin/python3
"""Several sieves on one master: the recipe of docs/node.md, line by line, and which of them publishes /clock.

Usage: plant_rostest.py [ROS ARGUMENT...]; part of plant.test, which has started a master.
"""

import os
import signal
import tempfile
import xmlrpc.client
from pathlib import Path

import rospy
import rosunit
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from rosgraph_msgs.msg import Clock
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import MarkerArray

from launched import PACKAGE, Launched, message, wait_for
from ratchet_sieve.msg import BaseState, ParticleStates, SceneDescription, SeekTrial
from ratchet_sieve.virtual_screen import VirtualScreen

RECIPE = '## Several sieves'
STILL = ['paused:=true', 'exit_at_end:=false', f'scene:={PACKAGE}/test/ros/mixture.yaml']


def recipe():
    """The commands that stand under that heading in docs/node.md."""
    section = (PACKAGE / 'docs/node.md').read_text().split(RECIPE)[1]
    return section.split('```sh\n')[1].split('```')[0].splitlines()


def gathered(topic, kind, entries, enough):
    """Collects `entries`, (key, value) pairs, from the messages on a topic until there are enough."""
    found = {}
    subscriber = rospy.Subscriber(topic, kind, lambda message: found.update(entries(message)))
    wait_for(lambda: enough(found), f'enough on {topic}')
    subscriber.unregister()
    return found


def clock_statuses(*sieves):
    """The clock status of each sieve (names without slash) on /diagnostics."""
    names = [f'{sieve}: clock' for sieve in sieves]
    found = gathered('/diagnostics', DiagnosticArray,
                     lambda array: [(s.name, s) for s in array.status if s.message != 'Node starting up'],
                     lambda found: all(name in found for name in names))
    return [found[name] for name in names]


def links(topic, count):
    """Parent, child and origin of the next `count` transforms."""
    return gathered(topic, TFMessage, lambda tf: [((t.header.frame_id, t.child_frame_id), t.transform.translation)
                                                  for t in tf.transforms], lambda found: len(found) >= count)


def frames_drawn_in(topic):
    return {marker.header.frame_id for marker in message(topic, MarkerArray).markers if marker.action == marker.ADD}


def captions(topic):
    return ' '.join(marker.text for marker in message(topic, MarkerArray).markers).split()


class Plant(Launched):
    def test_recipe(self):
        screen = VirtualScreen().__enter__()
        self.addCleanup(screen.__exit__)
        first, second, third, tilt = recipe()
        self.shell(first, screen.environment)
        self.assertEqual(message('/s1/particles', ParticleStates).header.frame_id, 'world')
        self.expect_rviz('s1')  # two that open at once crash more often
        self.shell(second, screen.environment)
        self.assertEqual(message('/s2/particles', ParticleStates).header.frame_id, 's2/sieve_world')
        self.shell(third, screen.environment)
        self.assertGreater(sum(message('/line2/seek/trials', SeekTrial).right), 0)
        self.shell(tilt, screen.environment)
        wait_for(lambda: message('/s2/base', BaseState).commanded_inclination == 0.1, 's2 is tilted')
        self.assertEqual(message('/s1/base', BaseState).commanded_inclination, 0.0)

        self.assertEqual(set(links('/tf', 6)), {
            ('world', 's1/sieve_mount'), ('s1/sieve_mount', 's1/sieve_base'),
            ('s2/sieve_world', 's2/sieve_mount'), ('s2/sieve_mount', 's2/sieve_base'),
            ('world', 'line2/sieve/sieve_mount'), ('line2/sieve/sieve_mount', 'line2/sieve/sieve_base')})
        self.assertEqual({link: origin.z for link, origin in links('/tf_static', 1).items()},
                         {('world', 's2/sieve_world'): -0.2})
        for sieve, frame in (('s1', 'world'), ('s2', 's2/sieve_world')):
            self.expect_rviz(sieve)
            self.assertEqual(frames_drawn_in(f'/{sieve}/markers'), {frame})
            self.assertIn(sieve, captions(f'/{sieve}/markers'))

        self.assertEqual(self.publishers('/clock'), ['/s1'])
        clock, *others = clock_statuses('s1', 's2', 'line2/sieve')
        self.assertEqual(clock.level, DiagnosticStatus.OK)
        for status in others:
            self.assertEqual(status.level, DiagnosticStatus.WARN)
            self.assertIn('/s1 already publishes /clock', status.message)
            behind = {entry.key: float(entry.value) for entry in status.values}['simulated time minus /clock [s]']
            self.assertNotEqual(behind, 0.0)

    def expect_rviz(self, sieve):
        wait_for(lambda: all(f'/{sieve}_rviz' in self.subscribers(topic) for topic in ('/tf', f'/{sieve}/markers')),
                 f'RViz shows {sieve}')

    def shell(self, line, environment):
        # The shell is replaced by the last command, so that a signal reaches it.
        return self.start(['bash', '-c', line.replace('roslaunch', 'exec roslaunch', 1)], **environment)

    def test_two_that_start_at_once_have_one_clock(self):
        for _ in range(2):
            with tempfile.TemporaryDirectory() as scratch:
                both = Path(scratch) / 'both.launch'
                both.write_text('<launch>' + ''.join(
                    f'<group ns="{ns}"><include file="{PACKAGE}/launch/sieve.launch">'
                    '<arg name="paused" value="true"/><arg name="exit_at_end" value="false"/></include></group>'
                    for ns in ('a', 'b')) + '</launch>')
                launch = self.start(['roslaunch', str(both)])
                levels = [status.level for status in clock_statuses('a/sieve', 'b/sieve')]
            self.assertEqual(sorted(levels), [DiagnosticStatus.OK, DiagnosticStatus.WARN])
            self.assertEqual(self.publishers('/clock'), [['/a/sieve', '/b/sieve'][levels.index(DiagnosticStatus.OK)]])
            self.end(launch)

    def test_what_a_killed_one_left_is_no_clock(self):
        for name, advertised in (('s1', ['/s1']), ('s1', ['/s1']), ('s3', ['/s1', '/s3'])):
            self.launch('sieve.launch', f'name:={name}', *STILL)
            message(f'/{name}/scene', SceneDescription)
            self.assertEqual(self.publishers('/clock'), advertised)
            self.assertEqual(clock_statuses(name)[0].level, DiagnosticStatus.OK)
            self.assertEqual(message('/clock', Clock)._connection_header['callerid'], f'/{name}')
            with xmlrpc.client.ServerProxy(self.master.lookupNode(f'/{name}')) as node:
                os.kill(node.getPid('/plant')[2], signal.SIGKILL)

    def test_replays_one_with_a_prefix(self):
        with tempfile.TemporaryDirectory() as scratch:
            bag = Path(scratch) / 'run.bag'
            self.launch('sieve.launch', 'name:=s2', f'record:={bag}', 'real_time_factor:=0', STILL[-1],
                        'params:={mount: {x: 1.0}}').wait()
            self.launch('replay.launch', f'bag:={bag}', 'loop:=true', 'rviz:=false')
            self.assertEqual(message('/s2/scene', SceneDescription).header.frame_id, 's2/sieve_world')
            self.assertEqual(frames_drawn_in('/sieve_display/markers'), {'s2/sieve_world'})
            self.assertIn('s2', captions('/sieve_display/markers'))
            self.assertEqual(set(links('/tf', 2)), {('s2/sieve_world', 's2/sieve_mount'),
                                                    ('s2/sieve_mount', 's2/sieve_base')})


if __name__ == '__main__':
    rospy.init_node('plant_rostest', disable_signals=True)
    rosunit.unitrun('ratchet_sieve', 'plant', Plant)
