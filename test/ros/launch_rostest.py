#!/usr/bin/python3
"""The launch files one after the other on one master, and in a namespace.

Usage: launch_rostest.py BAG [ROS ARGUMENT...]; part of launch.test, which has started a master. BAG is a recorded run.
"""

import sys
import tempfile
from pathlib import Path

import roslaunch.config
import rospy
import rosunit
import yaml
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import MarkerArray

from launched import PACKAGE, Launched, message, wait_for
from ratchet_sieve.msg import BaseState, SceneDescription, SeekTrial

# A sieve that stands still and stays.
STILL = ['paused:=true', 'exit_at_end:=false']


def scene_of(sieve):
    return yaml.safe_load(message(f'{sieve}/scene', SceneDescription).yaml)


class Launch(Launched):
    # On a master that goes on, each launch has its own parameters and no others.

    def test_leaves_no_key_of_the_scene_before(self):
        seek = self.launch('sieve.launch', f'scene:={PACKAGE}/config/seek.yaml', *STILL)
        self.assertEqual(scene_of('/sieve')['feed']['rate'], 40.0)
        self.end(seek)
        self.assertTrue(self.master.hasParam('/sieve/scene/feed'))
        self.launch('sieve.launch', *STILL)
        self.assertEqual(scene_of('/sieve')['feed']['rate'], 0.0)
        self.assertFalse(self.master.hasParam('/sieve/scene/feed'))

    def test_recovers_from_a_scene_with_a_misspelt_key(self):
        with tempfile.TemporaryDirectory() as scratch:
            scene = Path(scratch) / 'misspelt.yaml'
            scene.write_text((PACKAGE / 'test/ros/mixture.yaml').read_text() + 'bundary: open\n')
            self.launch('sieve.launch', f'scene:={scene}', *STILL).wait()
        self.assertTrue(self.master.hasParam('/sieve/scene/bundary'))
        self.launch('sieve.launch', *STILL)
        self.assertEqual(scene_of('/sieve')['boundary'], 'open')

    def test_leaves_no_limit_of_the_launch_before(self):
        demo = self.launch('demo.launch')
        scene_of('/sieve')
        self.assertEqual(self.master.getParam('/sieve/limits/inclination/slew_rate'), 0.5)
        self.end(demo)
        self.launch('sieve.launch', 'params:={limits: {frequency: {max: 50}}, rates: {base: 7.0}}', *STILL)
        scene_of('/sieve')
        self.assertEqual(self.master.getParam('/sieve/limits'), {'frequency': {'max': 50}})
        self.assertEqual(self.master.getParam('/sieve/rates'), {'base': 7.0})

    def test_every_node_is_cleared(self):
        for path in PACKAGE.glob('launch/*.launch'):
            arguments = {'replay.launch': [f'bag:={sys.argv[1]}'], 'seek.launch': ['disturb:=true', 'rviz:=true'],
                         'rviz.launch': []}.get(path.name, ['rviz:=true'])
            config = roslaunch.config.load_config_default([(str(path), arguments)], None)
            ours = [f'{node.namespace}{node.name}/' for node in config.nodes if node.package == 'ratchet_sieve']
            self.assertTrue(ours)
            self.assertEqual([name for name in ours if name not in config.clear_params], [], path.name)

    # What is launched under ROS_NAMESPACE finds itself there.

    def test_demo_in_a_namespace(self):
        self.launch('demo.launch', namespace='plant1')
        self.assertEqual(scene_of('/plant1/sieve')['base']['teeth'], 40)
        self.assertEqual(self.master.getParam('/plant1/sieve/limits/inclination/slew_rate'), 0.5)
        wait_for(lambda: message('/plant1/sieve/base', BaseState).commanded_inclination == 0.19,
                 'the schedule commands the sieve')
        transforms = message('/tf', TFMessage).transforms
        self.assertEqual([(t.header.frame_id, t.child_frame_id) for t in transforms],
                         [('world', 'plant1/sieve/sieve_mount'),
                          ('plant1/sieve/sieve_mount', 'plant1/sieve/sieve_base')])

    def test_seek_in_a_namespace(self):
        self.launch('seek.launch', 'real_time_factor:=0', namespace='plant1')
        self.assertGreater(sum(message('/plant1/seek/trials', SeekTrial).right), 0)

    def test_replay_in_a_namespace(self):
        self.launch('replay.launch', f'bag:={sys.argv[1]}', 'loop:=true', 'rviz:=false', namespace='plant1')
        shown = '/plant1/sieve_display/markers'
        wait_for(lambda: 'disks' in (marker.ns for marker in message(shown, MarkerArray).markers), 'a run is shown')


if __name__ == '__main__':
    rospy.init_node('launch_rostest', disable_signals=True)
    rosunit.unitrun('ratchet_sieve', 'launch', Launch)
