#!/usr/bin/python3
"""The launch files one after the other on one master, and in a namespace.

Usage: launch_rostest.py BAG [ROS ARGUMENT...]; part of launch.test, which has started a master. BAG is a recorded run.
"""

import json
import os
import re
import shlex
import signal
import subprocess
import sys
import tempfile
import xmlrpc.client
from pathlib import Path

import rosbag
import roslaunch.config
import rospy
import rosunit
import yaml
from geometry_msgs.msg import TransformStamped
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import PointCloud2
from std_msgs.msg import Float64
from std_srvs.srv import Empty
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import MarkerArray

from launched import PACKAGE, TIMEOUT, Launched, message, wait_for
from ratchet_sieve import Scene, SceneError
from ratchet_sieve.in_step import InStep
from ratchet_sieve.msg import BaseState, BinCounts, SceneDescription, SeekTrial

# A paused sieve that does not exit.
STILL = ['paused:=true', 'exit_at_end:=false']


# ROS's reader of YAML takes 020 for 16, NO for false, and no such seed.
ODD_SCENE = b"""base: {teeth: 020}
species:
  - {name: NO, count: 010, radius: 0.001, mass: 1e-3}
  - {name: 1.10, count: 1, radius: 0.001, mass: 0.001}
  - {name: 007, count: 1, radius: 0.001, mass: 0.001}
  - {name: 1_0, count: 1, radius: 0.001, mass: 0.001}
seed: 18446744073709551615
"""
SPOILING = [b'duration: 1:30', b'duration: 1_0', b'seed: 7', b'pour: {speed: &v 0.1, drop_height: *v}',
            b'boundary: gr\xfcn']


def scene_of(sieve):
    return yaml.safe_load(message(f'{sieve}/scene', SceneDescription).yaml)


class Launch(Launched):
    # With a master that keeps running, each launch sees only its own parameters.

    def test_leaves_nothing_of_the_launch_before(self):
        demo = self.launch('demo.launch')
        scene_of('/sieve')
        self.assertEqual(self.master.getParam('/sieve/limits/inclination/slew_rate'), 0.5)
        self.end(demo)
        self.master.setParam('/sieve/scene/bundary', 'open')
        self.launch('sieve.launch', f'scene:={PACKAGE}/config/seek.yaml',
                    'params:={limits: {frequency: {max: 50}}, rates: {base: 7.0}}', *STILL)
        self.assertEqual(scene_of('/sieve')['feed']['rate'], 40.0)
        self.assertEqual(self.master.getParam('/sieve/limits'), {'frequency': {'max': 50}})
        self.assertEqual(self.master.getParam('/sieve/rates'), {'base': 7.0})

    def test_a_file_is_one_scene_for_every_program(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        file = Path(scratch.name) / 'scene.yaml'

        def run(*command):
            return subprocess.run(['rosrun', 'ratchet_sieve', *command], capture_output=True, timeout=TIMEOUT)

        file.write_bytes(ODD_SCENE)
        self.launch('sieve.launch', f'scene:={file}', *STILL)
        read, described = Scene.load(file), message('/sieve/scene', SceneDescription)
        summary = json.loads(run('sieve_run', file, '--duration', '0').stdout)
        self.assertEqual((read['base.teeth'], read.species), (20, ['NO', '1.10', '007', '1_0']))
        self.assertEqual((read.yaml, read.hash, read['seed']), (described.yaml, described.scene_hash, described.seed))
        self.assertEqual((read.hash, read['seed']), (summary['scene_hash'], summary['seed']))
        for line in SPOILING:
            file.write_bytes(ODD_SCENE + line)
            with self.assertRaises(SceneError) as refused:
                Scene.load(file)
            for command in (['sieve_run', file], ['sieve_node', '__name:=spoilt', f'_scene_file:={file}']):
                self.assertEqual(run(*command).stderr.decode(errors='replace'), f'{command[0]}: {refused.exception}\n')

    def test_params_come_last(self):
        for name in ('sieve', 'demo', 'seek'):
            config = roslaunch.config.load_config_default([(str(PACKAGE / f'launch/{name}.launch'), [
                'params:={real_time_factor: 3, recording: {particles: 4}, limits: {inclination: {slew_rate: 0.7}}}',
                'real_time_factor:=2', 'set:={base.teeth: 020}', 'seed:=3000000000'])], None)
            values = {key: parameter.value for key, parameter in config.params.items()}
            self.assertEqual([values[f'/sieve/{key}'] for key in (
                'real_time_factor', 'recording/particles', 'limits/inclination/slew_rate', 'set', 'seed')],
                [3, 4, 0.7, '{base.teeth: 020}', '3000000000'])

    def test_comes_again_where_that_is_asked_for(self):
        self.launch('sieve.launch', 'respawn:=true', *STILL)
        message('/sieve/scene', SceneDescription)
        first = self.master.lookupNode('/sieve')
        with xmlrpc.client.ServerProxy(first) as node:
            os.kill(node.getPid('/launch_rostest')[2], signal.SIGKILL)
        wait_for(lambda: self.master.lookupNode('/sieve') != first, 'it comes again')
        message('/sieve/scene', SceneDescription)

    def test_in_step(self):
        # Under a name of its own: rospy gives later subscribers of a topic messages of the first one's type.
        self.launch('sieve.launch', 'name:=stepped', f'scene:={PACKAGE}/test/ros/mixture.yaml', *STILL)
        bases = []
        rospy.Subscriber('/stepped/base', BaseState, bases.append)
        sieve = InStep('stepped')
        setpoint = rospy.Publisher('/stepped/inclination_setpoint', Float64, queue_size=1)
        wait_for(setpoint.get_num_connections, 'the sieve takes setpoints')
        sieve.reset(3, ['base.inclination=0.02'])
        self.assertEqual(bases[-1].inclination, 0.02)
        for inclination in (0.05, 0.1):
            sieve.step(0.25)
            setpoint.publish(inclination)
            sieve.wait_for_setpoint()
            sieve.wait_for_setpoint('inclination', inclination)
        sieve.step(0.25)
        sieve.timeout = 0.1
        with self.assertRaisesRegex(RuntimeError, '^/stepped at 0.75 s: no setpoint of inclination within 0.1 s$'):
            sieve.wait_for_setpoint()
        with self.assertRaisesRegex(RuntimeError, '^/stepped at 0.75 s: no inclination = 0.2 within 0.1 s$'):
            sieve.wait_for_setpoint('inclination', 0.2)
        rospy.ServiceProxy('/stepped/unpause_physics', Empty)()
        with self.assertRaisesRegex(RuntimeError, '^/stepped/step: the simulation is not paused'):
            sieve.step(0.25)

    def test_every_node_is_cleared(self):
        for path in PACKAGE.glob('launch/*.launch'):
            arguments = {'replay.launch': [f'bag:={sys.argv[1]}'], 'seek.launch': ['disturb:=true', 'rviz:=true'],
                         'rviz.launch': []}.get(path.name, ['rviz:=true'])
            config = roslaunch.config.load_config_default([(str(path), arguments)], None)
            ours = [f'{node.namespace}{node.name}/' for node in config.nodes if node.package == 'ratchet_sieve']
            self.assertTrue(ours)
            self.assertEqual([name for name in ours if name not in config.clear_params], [], path.name)

    def test_ends_at_once_without_a_program(self):
        """The package is found, but nothing is built."""
        for path in {*PACKAGE.glob('launch/*.launch')} - {PACKAGE / 'launch/rviz.launch'}:
            launch = subprocess.run(['roslaunch', str(path), *(['bag:=run.bag'] if path.name == 'replay.launch' else [])],
                                    env=dict(os.environ, CMAKE_PREFIX_PATH='', ROS_PACKAGE_PATH=str(PACKAGE)),
                                    capture_output=True, text=True, timeout=TIMEOUT)
            self.assertEqual(launch.returncode, 1, path.name)
            self.assertRegex(launch.stderr, r'no such command \[\[.*/sieve_')

    # Topics of the display, and their times.

    def test_log_lines_are_there_at_once(self):
        """The log of a running node."""
        self.master.setParam('/hasty/scene', yaml.safe_load((PACKAGE / 'test/ros/mixture.yaml').read_text()))
        self.master.setParam('/hasty/start_paused', True)
        with tempfile.NamedTemporaryFile('r') as log:
            self.start(['rosrun', 'ratchet_sieve', 'sieve_node', '__name:=hasty'], stdout=log)
            wait_for(lambda: '30 disks, 20 s, seed 7' in Path(log.name).read_text(), 'the start is logged')

    def test_replay_brings_every_frame_and_shows_it(self):
        """The bag again and again, in a namespace."""
        recorded, received, pictures, places = {}, {}, [], {}
        with rosbag.Bag(sys.argv[1]) as bag:
            for topic, (_, content, *_), _ in bag.read_messages(raw=True):
                recorded.setdefault(topic, []).append(content)
            for _, frame, _ in bag.read_messages('/sieve/particles'):
                disks = [*zip(frame.species, frame.x, frame.y)]
                places[frame.header.stamp] = [[(x, y) for of, x, y in disks if of == species] for species in (0, 1)]
        for topic in recorded:
            received[topic] = []
            rospy.Subscriber(topic, rospy.AnyMsg, lambda frame, topic=topic: received[topic].append(frame._buff))
        rospy.Subscriber('/plant1/sieve_display/markers', MarkerArray, lambda array: pictures.append(array.markers))
        self.launch('replay.launch', f'bag:={sys.argv[1]}', 'rate:=5', 'loop:=true', 'rviz:=false', namespace='plant1')

        def whole_pass(topic):
            starts = [k for k, content in enumerate(received[topic]) if content == recorded[topic][0]]
            return received[topic][starts[0]:starts[1]] if len(starts) > 1 else []

        def shown_again():
            stamps = [picture[-1].header.stamp for picture in pictures]
            return any(later < earlier for earlier, later in zip(stamps, stamps[1:]))

        wait_for(lambda: all(map(whole_pass, recorded)) and shown_again(), 'the bag is played again')
        for topic, contents in recorded.items():
            self.assertTrue(whole_pass(topic) == contents, topic)
        self.assertEqual(message('/sieve/scene', rospy.AnyMsg)._buff, recorded['/sieve/scene'][0])  # also for a late one
        for picture in pictures:
            for marker in picture:
                if marker.ns == 'disks' and marker.action == marker.ADD:
                    self.assertEqual([(point.x, point.z) for point in marker.points],
                                     places[marker.header.stamp][marker.id])

        with tempfile.NamedTemporaryFile('r') as log:
            display = ['rosrun', 'ratchet_sieve', 'sieve_display']
            self.start([*display, '__name:=lost', '_sieve:=/s1'], stdout=log, stderr=log)
            late = self.start([*display, '__name:=late'])
            wait_for(lambda: message('/late/cloud', PointCloud2).width > 0, 'a display that comes late shows the disks')
            self.end(late)
            self.assertEqual(late.returncode, 0)
            wait_for(lambda: 'nothing to show: no scene of /s1 yet; there is /sieve' in Path(log.name).read_text(),
                     'a display says that it finds nothing')

    def test_replay_ends_where_the_bag_cannot_be_played(self):
        with tempfile.TemporaryDirectory() as scratch:
            content = Path(sys.argv[1]).read_bytes()
            (Path(scratch) / 'cut.bag').write_bytes(content[:len(content) // 2])
            for name in ('missing.bag', 'cut.bag'):
                launch = subprocess.run(['roslaunch', 'ratchet_sieve', 'replay.launch', 'rviz:=false',
                                         f'bag:={scratch}/{name}'], capture_output=True, text=True, timeout=TIMEOUT)
                self.assertIn(name, launch.stderr)

    def test_replay_of_all_topics(self):
        """A bag with what the player and the display publish, too, as `rosbag record -a` makes it."""
        clocks, stamps = [], []
        rospy.Subscriber('/clock', Clock, lambda clock: clocks.append(clock.clock))
        rospy.Subscriber('/tf', TFMessage, lambda message: stamps.append(message.transforms[0].header.stamp))
        with tempfile.TemporaryDirectory(prefix="one's two words ") as scratch:
            bag = Path(scratch) / "one's run.bag"
            with rosbag.Bag(sys.argv[1]) as run, rosbag.Bag(bag, 'w') as everything:
                for topic, recorded, time, connection in run.read_messages(return_connection_header=True):
                    everything.write(topic, recorded, time, connection_header=connection)
                    if topic == '/sieve/base':
                        everything.write('/clock', Clock(), time)
                        everything.write('/tf', TFMessage([TransformStamped(header=recorded.header)]), time)
                        last = recorded.header.stamp
                # The player ends, and the display with it, a second after the last picture.
                everything.write('/later', Clock(), time + rospy.Duration(1))
            self.launch('replay.launch', f'bag:={bag}', 'exit_at_end:=true', 'rviz:=false').wait(TIMEOUT)
        self.assertTrue(clocks)
        self.assertEqual(clocks, sorted(clocks))
        self.assertEqual(stamps[-1], last)
        self.assertEqual(len(stamps), len(set(stamps)))

    def test_replay_splits_between_bags(self):
        for given, names in (('run.bag', ['run.bag']), ("a's b/run_0.bag a's b/run_1.bag", ["a's b/run_0.bag", "a's b/run_1.bag"]),
                             ('run_0.bag run.bag.active ', ['run_0.bag', 'run.bag.active'])):
            config = roslaunch.config.load_config_default(
                [(str(PACKAGE / 'launch/replay.launch'), [f'bag:={given}', 'rviz:=false'])], None)
            player = next(node for node in config.nodes if node.name == 'player')
            self.assertEqual(shlex.split(player.args)[-len(names):], names)

    # The controller of docs/node.md, saved as it says there.

    def launch_for_control(self, duration):
        """@return the command that runs the controller"""
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        controller, scene = Path(scratch.name) / 'controller.py', Path(scratch.name) / 'scene.yaml'
        page = (PACKAGE / 'docs/node.md').read_text()
        controller.write_text(re.search(r'^```python\n(.*?)^```', page, re.DOTALL | re.MULTILINE)[1])
        scene.write_text((PACKAGE / 'test/ros/mixture.yaml').read_text().replace('duration: 20.0', f'duration: {duration}'))
        self.launch('sieve.launch', f'scene:={scene}', *STILL)
        return ['/usr/bin/python3', controller]

    def test_controller_runs_to_the_end(self):
        done = subprocess.run(self.launch_for_control(20.0), capture_output=True, text=True, timeout=TIMEOUT)
        self.assertEqual((done.returncode, done.stderr), (0, ''))
        self.assertRegex(done.stdout, r'^20\.0 [0-9.]+ $')

    def test_controller_says_in_one_line_that_its_sieve_is_gone(self):
        run = subprocess.Popen(self.launch_for_control(1e6), stderr=subprocess.PIPE, text=True)
        wait_for(lambda: message('/sieve/base', BaseState).header.stamp.to_sec() > 1.0, 'it is under way')
        with xmlrpc.client.ServerProxy(self.master.lookupNode('/sieve')) as node:
            os.kill(node.getPid('/launch_rostest')[2], signal.SIGKILL)
        self.assertRegex(run.communicate(timeout=TIMEOUT)[1], r'\Acontroller.py: /sieve/lock_step: .*\n\Z')
        self.assertEqual(run.returncode, 1)

    # Nodes launched under ROS_NAMESPACE find each other.

    def test_demo_separates_its_mixture_also_in_a_namespace(self):
        self.launch('demo.launch', 'real_time_factor:=6', 'exit_at_end:=false', namespace='plant1')
        self.assertEqual(scene_of('/plant1/sieve')['base']['teeth'], 40)
        self.assertEqual(self.master.getParam('/plant1/sieve/limits/inclination/slew_rate'), 0.5)
        transforms = message('/tf', TFMessage).transforms
        self.assertEqual([(t.header.frame_id, t.child_frame_id) for t in transforms],
                         [('world', 'plant1/sieve/sieve_mount'),
                          ('plant1/sieve/sieve_mount', 'plant1/sieve/sieve_base')])
        wait_for(lambda: message('/plant1/sieve/base', BaseState).time == 30.0, 'its end')
        base, bins = message('/plant1/sieve/base', BaseState), message('/plant1/sieve/bins', BinCounts)
        self.assertEqual((base.inclination, base.frequency), (0.16, 23.0))  # as its schedule has it
        self.assertGreater(bins.processed, 0.9)
        self.assertGreater(bins.quality, 0.5)
        # Small and heavy to the right, large and light to the left.
        self.assertTrue(bins.right[0] > bins.left[0] and bins.left[1] > bins.right[1])

    def test_seek_in_a_namespace(self):
        self.launch('seek.launch', 'real_time_factor:=0', 'goal:=recovery:B:left:mass', namespace='plant1')
        trial = message('/plant1/seek/trials', SeekTrial)
        self.assertGreater(sum(trial.right), 0)
        self.assertEqual(trial.goal, 'recovery:B:left:mass')
        self.assertAlmostEqual(trial.value, trial.left[1] / (trial.left[1] + trial.right[1]))  # all of one mass


if __name__ == '__main__':
    rospy.init_node('launch_rostest', disable_signals=True)
    rosunit.unitrun('ratchet_sieve', 'launch', Launch)
