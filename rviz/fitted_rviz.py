#!/usr/bin/python3
"""Opens RViz with its camera on a sieve; rviz.launch runs it.

Usage: rosrun ratchet_sieve fitted_rviz.py CONFIG.rviz [RVIZ ARGUMENT...] [ROS ARGUMENT...]

Waits until the sieve is drawn, then starts RViz on a copy of CONFIG.rviz in ~/.ros. Starts it again if it crashes.

Parameters:
  ~display  node whose ~markers and ~cloud are shown; empty: the only one (default: sieve)
  ~view     what the camera shows: the whole machine (machine), or ten teeth in the middle of the base (teeth)
            (default: machine)
  ~fit      false: takes CONFIG.rviz as it is, before anything is drawn (default: true)
"""

import math
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import rospkg
import rospy
import yaml
from visualization_msgs.msg import Marker, MarkerArray

# Width over height of the part of the window that shows the scene: 1248 by 640 of 1280 by 800 pixels.
ASPECT = 1.95

# What is seen of the machine below the left end of the base, and above the middle of the caption [widths of the base].
BELOW = 0.3
ABOVE = 0.05

TEETH = 10
TEETH_WIDTH = 1.05   # of their picture [widths of the teeth]
TEETH_MIDDLE = 0.35  # their height above its lower edge [its heights]

RUN = '--run'  # the first argument of this program when it runs RViz: the others are the command
STARTS = 3  # of RViz, if it crashes

VIEWS = {'machine': 'Whole machine', 'teeth': 'Ten teeth in the middle'}


def pictures(markers):
    """What the saved views show: the middle x, z and the width of the picture."""
    outline = next(m for m in markers if m.ns == 'base' and m.type == Marker.LINE_LIST)
    caption = next(m for m in markers if m.ns == 'caption').pose.position.z
    heights, width = [point.z for point in outline.points], outline.points[-1].x
    # All teeth have the same corners.
    tooth = next(k for k in range(2, len(heights) + 1, 2) if heights[k:] == heights[:len(heights) - k])
    length = min(width, TEETH * outline.points[tooth - 1].x)
    inclination = -2.0 * math.atan2(outline.pose.orientation.y, outline.pose.orientation.w)

    def teeth_around(along_base):
        shown = TEETH_WIDTH * length
        return (along_base * math.cos(inclination),
                along_base * math.sin(inclination) + (0.5 - TEETH_MIDDLE) * shown / ASPECT, shown)

    low, high = -BELOW * width, caption + ABOVE * width
    return {'Whole machine': (0.5 * width, 0.5 * (low + high), ASPECT * (high - low)),
            'Ten teeth in the middle': teeth_around(0.5 * width),
            'Ten teeth at the left end': teeth_around(0.5 * length)}


def fit(config, markers, view):
    """Moves the cameras of an RViz configuration, which look along y."""
    def show(camera, x, z, width):
        camera['Distance'] = width / (2.0 * ASPECT * math.tan(0.5 * camera['Field of View']))
        camera['Focal Point'] = {'X': x, 'Y': 0.0, 'Z': z}

    shown, views = pictures(markers), config['Visualization Manager']['Views']
    for saved in views['Saved']:
        if saved['Name'] in shown:
            show(saved, *shown[saved['Name']])
    show(views['Current'], *shown[VIEWS[view]])
    config['Visualization Manager']['Global Options']['Fixed Frame'] = markers[-1].header.frame_id


def only_display():
    """The node that draws a sieve, once there is one."""
    rospy.loginfo('RViz opens as soon as a sieve is drawn')
    while not rospy.is_shutdown():
        for topic, kind in sorted(rospy.get_published_topics()):
            if kind == MarkerArray._type and topic.endswith('/markers'):
                return topic[:-len('/markers')]
        time.sleep(0.1)
    raise rospy.ROSInterruptException('no sieve was drawn')


def fitted(path, display, view):
    """A copy of the configuration that shows what is drawn."""
    config = yaml.safe_load(path.read_text())
    rospy.loginfo('RViz opens as soon as there is a picture on %s/markers', display)
    fit(config, rospy.wait_for_message(f'{display}/markers', MarkerArray).markers, view)
    # Nodes with the same name may run in different namespaces.
    copy = Path(rospkg.get_ros_home()) / (rospy.get_name().strip('/').replace('/', '_') + '.rviz')
    copy.parent.mkdir(parents=True, exist_ok=True)
    copy.write_text(yaml.safe_dump(config))
    return copy


def run(command):
    """Runs RViz, and hands signals on to it. It may crash as it opens, where the X server does not know its window
    yet. @return its exit status"""
    received = []

    def hand_on(number, _):
        received.append(number)
        rviz.send_signal(number)

    for _ in range(STARTS):
        rviz = subprocess.Popen(command)
        for request in (signal.SIGINT, signal.SIGTERM):
            signal.signal(request, hand_on)
        status = rviz.wait()
        if received or status not in (-signal.SIGSEGV, -signal.SIGABRT):
            break
    return status


def main():
    rospy.init_node('fitted_rviz')
    path, view = Path(sys.argv[1]), rospy.get_param('~view', 'machine')
    if view not in VIEWS:
        sys.exit(f'fitted_rviz.py: ~view = {view}: must be {" or ".join(VIEWS)}')
    display = rospy.resolve_name(rospy.get_param('~display', 'sieve') or only_display())
    if rospy.get_param('~fit', True):
        path = fitted(path, display, view)
    if rospy.is_shutdown():
        return
    rospy.signal_shutdown('RViz takes its name')
    # A new process image: the server that rospy leaves behind polls a closed socket and occupies a core.
    os.execv(sys.executable, [sys.executable, __file__, RUN, 'rviz', '-d', path, *sys.argv[2:],
                              *(f'/sieve/{topic}:={display}/{topic}' for topic in ('markers', 'cloud'))])


if __name__ == '__main__':
    if len(sys.argv) < 2 or '--help' in sys.argv:
        print(__doc__)
        sys.exit()
    try:
        if sys.argv[1] == RUN:
            sys.exit(run(sys.argv[2:]))
        main()
    except OSError as error:
        sys.exit(f'fitted_rviz.py: {error.filename or "rviz"}: {error.strerror}')
    except (KeyboardInterrupt, rospy.ROSInterruptException):
        pass
