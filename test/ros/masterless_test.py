"""sieve_node before there is a master, and where its master goes away and another one comes."""
import os
import signal
import subprocess
from pathlib import Path

import pytest
import rosbag
import rosgraph
import rospy
from std_msgs.msg import Float64
from std_srvs.srv import Empty

from ratchet_sieve.msg import BaseState, BinCounts
from ratchet_sieve.processes import TIMEOUT, free_port, wait_for

NODE = Path(os.environ['RATCHET_SIEVE_PROGRAMS']) / 'sieve_node'
SCENE = """base: {teeth: 4, inclination: 0.02}
duration: 1000
species: [{name: A, count: 20, radius: 0.001, mass: 0.01}]
"""


@pytest.fixture
def start():
    """Starts programs that end with the test. This process and they use one port for a master."""
    programs = []

    def start(*command):
        programs.append(subprocess.Popen(command, stderr=subprocess.PIPE, text=True))
        return programs[-1]

    os.environ.update(ROS_MASTER_URI=f'http://localhost:{free_port()}', ROS_HOSTNAME='localhost')
    yield start
    for program in programs:
        program.kill()
        program.communicate()


def start_master(start):
    master = start('rosmaster', '--core', '-p', os.environ['ROS_MASTER_URI'].rpartition(':')[2])
    wait_for(rosgraph.is_master_online, 'a master')
    return master


def test_a_node_says_that_it_waits_for_the_master_and_goes_on_once_there_is_one(start):
    def waiting(name):
        node = start(NODE, f'__name:={name}')
        assert any('Failed to contact master at [localhost:' in line for line in node.stderr)
        return node

    ended = waiting('ended')
    ended.send_signal(signal.SIGINT)
    assert ended.wait(TIMEOUT) == -signal.SIGINT
    early = waiting('early')
    start_master(start)
    # It proceeds to the missing scene.
    assert 'sieve_node: parameter /early/scene_file: not set' in early.communicate(timeout=TIMEOUT)[1]
    assert early.returncode == 2


def test_a_run_goes_on_where_the_master_goes_away(start, tmp_path):
    """The only test in which this process is a node, because it can use only one master."""
    master = start_master(start)
    rospy.init_node('masterless_test', disable_signals=True)
    (tmp_path / 'scene.yaml').write_text(SCENE)
    node = start(NODE, '__name:=orphan', f'_scene_file:={tmp_path}/scene.yaml', f'_record:={tmp_path}/run.bag',
                 '_start_paused:=true')
    bases, bins = [], []
    rospy.Subscriber('/orphan/base', BaseState, bases.append)
    rospy.Subscriber('/orphan/bins', BinCounts, bins.append)
    inclination = rospy.Publisher('/orphan/inclination_setpoint', Float64, queue_size=1)
    wait_for(lambda: bases and bins and inclination.get_num_connections(), 'the node is there')
    rospy.ServiceProxy('/orphan/unpause_physics', Empty)()
    master.kill()
    master.wait()
    assert not rosgraph.is_master_online()

    def expect_to_go_on():
        now = bases[-1].time
        wait_for(lambda: min(bases[-1].time, bins[-1].time) > now + 0.5, 'the run goes on')

    # Frames and setpoints are exchanged directly between nodes; only new connections need the master.
    expect_to_go_on()
    inclination.publish(0.125)
    wait_for(lambda: bases[-1].commanded_inclination == 0.125, 'the setpoint is taken')
    commanded = bases[-1].time
    expect_to_go_on()
    # A new master does not know the node, which continues and ends normally.
    start_master(start)
    expect_to_go_on()
    node.send_signal(signal.SIGINT)
    assert node.wait(TIMEOUT) == 0

    with rosbag.Bag(tmp_path / 'run.bag') as bag:
        recorded = {frame.time: frame for _, frame, _ in bag.read_messages('/orphan/bins')}
        last = [frame for _, frame, _ in bag.read_messages('/orphan/base')][-1]
    assert min(recorded) == 0.0 and max(recorded) > commanded and last.commanded_inclination == 0.125
    # The received frames are equal to those in the bag, to the end.
    for frame in bins:
        fields = frame.__slots__[1:]  # without the header
        assert [getattr(frame, name) for name in fields] == [getattr(recorded[frame.time], name) for name in fields]
