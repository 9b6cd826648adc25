#!/usr/bin/python3
"""RViz on a virtual screen shows disks if a sieve runs or is replayed, and none otherwise.

Usage: rviz_rostest.py BAG [ROS ARGUMENT...]; part of rviz.test, which has started a master. BAG is a run of mixture.yaml.
"""

import contextlib
import ctypes
import subprocess
import sys
import unittest
from pathlib import Path

import numpy
import rospy
import rosunit
from rosgraph_msgs.msg import Clock
from visualization_msgs.msg import MarkerArray

from ratchet_sieve.processes import wait_for
from ratchet_sieve.virtual_screen import VirtualScreen

PACKAGE = Path(__file__).resolve().parents[2]

# The colours of the first two species (marker_style.cpp) and of RViz's background (sieve.rviz).
SPECIES = ((0, 114, 178), (213, 94, 0))
BACKGROUND = (250, 250, 250)

# Shading changes a sphere's brightness within these factors, and its hue by at most this much.
SHADES = (0.3, 1.3)
HUE_TOLERANCE = 40.0

# A pixel with this many pixels of the same colour on each side is not part of a letter.
INSIDE = 3

# Far more than stray pixels, less than half of the pixels of the disks of mixture.yaml.
DISK_PIXELS = 90

# Messages on /clock, a hundred per second: in a running simulation, all but the first few are later than the first.
CLOCKS = 50

# First time on /clock, because 0 means "no time" in ROS [s].
FIRST_CLOCK = 1e-9

# Half the window: RViz has started and drawn.
DRAWN_PIXELS = 400000


def count_background(pixels):
    return int(numpy.all(pixels == BACKGROUND, axis=2).sum())


def coloured(pixels, colour):
    """Mask of the pixels with a shade of the colour."""
    colour = numpy.array(colour, float)
    pixels = pixels.astype(float)
    shade = pixels @ colour / (colour @ colour)
    distance = numpy.linalg.norm(pixels - shade[..., None] * colour, axis=2)
    return (shade > SHADES[0]) & (shade < SHADES[1]) & (distance < HUE_TOLERANCE)


def inside(mask):
    """Mask of the pixels whose whole neighbourhood is set."""
    for axis in (0, 1):
        mask = numpy.logical_and.reduce([numpy.roll(mask, k, axis) for k in range(-INSIDE, INSIDE + 1)])
    return mask


def disk_pixels(pixels):
    """Per species, the number of pixels inside disks of its colour."""
    return [int(inside(coloured(pixels, colour)).sum()) for colour in SPECIES]


# Xlib, and the calls that sieve_rviz replaces in RViz (rviz_windows.cpp). One window in twenty is missing for Xlib.
XLIB = ctypes.CDLL('libX11.so.6')
WINDOW_CALLS = ctypes.CDLL('libratchet_sieve_rviz_windows.so')
XLIB.XOpenDisplay.restype = ctypes.c_void_p
XLIB.XCloseDisplay.argtypes = [ctypes.c_void_p]
XLIB.XDefaultRootWindow.argtypes = [ctypes.c_void_p]
XLIB.XDefaultRootWindow.restype = ctypes.c_ulong
WINDOW_CALLS.XCreateWindow.argtypes = [
    ctypes.c_void_p, ctypes.c_ulong, ctypes.c_int, ctypes.c_int, ctypes.c_uint, ctypes.c_uint, ctypes.c_uint,
    ctypes.c_int, ctypes.c_uint, ctypes.c_void_p, ctypes.c_ulong, ctypes.c_void_p]
WINDOW_CALLS.XCreateWindow.restype = ctypes.c_ulong
WINDOW_CALLS.XGetGeometry.argtypes = [ctypes.c_void_p, ctypes.c_ulong] + 7 * [ctypes.c_void_p]
WINDOWS = 1000


@ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_void_p)
def ignore_error(_display, _event):
    """Prevents Xlib from ending this program if a window does not exist."""
    return 0


XLIB.XSetErrorHandler(ignore_error)


@contextlib.contextmanager
def display_of(screen):
    """A connection to the screen's X server."""
    display = XLIB.XOpenDisplay(screen.environment['DISPLAY'].encode())
    try:
        yield display
    finally:
        XLIB.XCloseDisplay(display)


def size_of(display, window):
    """Width and height of a window, as Mesa sees them [pixels]."""
    root, x, y, width, height, border, depth = (ctypes.c_ulong() for _ in range(7))
    WINDOW_CALLS.XGetGeometry(display, window, *map(ctypes.byref, (root, x, y, width, height, border, depth)))
    return width.value, height.value


class Rviz(unittest.TestCase):
    def setUp(self):
        self.screen = VirtualScreen()
        self.screen.__enter__()
        self.addCleanup(self.screen.__exit__)

    def start(self, command):
        """Starts a program, which must keep running while the test waits."""
        program = self.screen.start(command, stdout=subprocess.DEVNULL)

        def goes_on():
            self.assertIsNone(program.poll(), f'{command[0]} has ended')
            return True
        return goes_on

    def test_shows_no_disks_without_a_sieve(self):
        goes_on = self.start(['rosrun', 'ratchet_sieve', 'sieve_rviz', str(PACKAGE / 'rviz/sieve.rviz'), '_view:=config',
                              '--splash-screen', ''])
        wait_for(lambda: goes_on() and count_background(self.screen.pixels()) > DRAWN_PIXELS, 'RViz draws')
        self.assertEqual(disk_pixels(self.screen.pixels()), [0, 0])

    def test_shows_the_disks_of_a_sieve(self):
        self.expect_disks(['sieve.launch', 'rviz:=true', 'paused:=true',
                           f'scene:={PACKAGE / "test/ros/mixture.yaml"}'])

    def test_shows_the_disks_of_a_sieve_in_a_namespace_and_elsewhere(self):
        self.screen.environment['ROS_NAMESPACE'] = 'plant1'
        self.expect_disks(['sieve.launch', 'rviz:=true', 'paused:=true', 'params:={mount: {x: 5.0, z: -3.0}}',
                           f'scene:={PACKAGE / "test/ros/mixture.yaml"}'])

    def test_shows_the_disks_of_a_recorded_run(self):
        self.expect_disks(['replay.launch', f'bag:={sys.argv[1]}', 'rate:=0.2', 'loop:=true'])

    def test_finds_a_window_that_another_connection_has_created(self):
        with display_of(self.screen) as creator, display_of(self.screen) as looker:
            root = XLIB.XDefaultRootWindow(creator)
            for _ in range(WINDOWS):
                window = WINDOW_CALLS.XCreateWindow(creator, root, 0, 0, 30, 20, 0, 0, 0, None, 0, None)
                self.assertEqual(size_of(looker, window), (30, 20))

    def test_takes_a_window_that_is_gone_for_one_of_one_pixel(self):
        with display_of(self.screen) as display:
            self.assertEqual(size_of(display, 12345), (1, 1))

    def test_holds_a_run_until_it_is_watched(self):
        goes_on = self.start(['roslaunch', 'ratchet_sieve', 'sieve.launch', 'wait_for_rviz:=60',
                              f'scene:={PACKAGE / "test/ros/mixture.yaml"}'])
        # Not with the arguments of this program: RViz has its name.
        rospy.init_node('watcher', argv=[], disable_signals=True)
        times = []
        rospy.Subscriber('/clock', Clock, lambda message: times.append(message.clock.to_sec()))
        wait_for(lambda: goes_on() and len(times) > CLOCKS, 'the sieve is the clock')
        self.assertEqual(max(times), FIRST_CLOCK)
        rospy.Subscriber('/sieve/markers', MarkerArray)
        wait_for(lambda: goes_on() and times[-1] > FIRST_CLOCK, 'the run begins')

    def expect_disks(self, launch):
        goes_on = self.start(['roslaunch', 'ratchet_sieve', *launch])
        wait_for(lambda: goes_on() and min(disk_pixels(self.screen.pixels())) > DISK_PIXELS,
                 f'RViz shows more than {DISK_PIXELS} pixels of each species')


if __name__ == '__main__':
    rosunit.unitrun('ratchet_sieve', 'rviz', Rviz)
