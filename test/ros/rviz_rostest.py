#!/usr/bin/python3
"""RViz on a virtual screen shows a sieve that runs or is replayed, fitted to its window, and no disks otherwise.

Usage: rviz_rostest.py BAG [ROS ARGUMENT...]; part of rviz.test, which has started a master. BAG is a run of mixture.yaml.
"""

import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy
import rosunit

from ratchet_sieve.processes import wait_for
from ratchet_sieve.virtual_screen import VirtualScreen

PACKAGE = Path(__file__).resolve().parents[2]

# The colours of the first two species, of the base (scene_markers.cpp) and of RViz's background (sieve.rviz).
SPECIES = ((0, 114, 178), (213, 94, 0))
BASE = (140, 140, 140)
BACKGROUND = (250, 250, 250)

# The columns of the window that show the scene.
LEFT, RIGHT = 16, 1264

# Shading changes a sphere's brightness within these factors, and its hue by at most this much.
SHADES = (0.3, 1.3)
HUE_TOLERANCE = 40.0

# A pixel with this many pixels of the same colour on each side is not part of a letter.
INSIDE = 3

# Far more than stray pixels, less than half of the pixels of the disks of mixture.yaml.
DISK_PIXELS = 90

# An RViz that crashes when it is started for the first time, and lists the threads of the program that started it.
CRASHES_ONCE = """#!/bin/sh
[ -e "$0.crashed" ] && exec RVIZ "$@"
ls /proc/$PPID/task >"$0.crashed"
kill -SEGV $$
"""

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


def base_columns(pixels):
    """The first and the last column that show the base; none where it is not drawn."""
    columns = numpy.flatnonzero(numpy.all(pixels == BASE, axis=2).sum(axis=0) > 2 * INSIDE)
    return columns[[0, -1]] if columns.size else ()


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

    def test_shows_no_disks_without_a_sieve_and_starts_again_after_a_crash(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        rviz = Path(directory.name) / 'rviz'
        rviz.write_text(CRASHES_ONCE.replace('RVIZ', shutil.which('rviz')))
        rviz.chmod(0o755)
        self.screen.environment['PATH'] = f'{directory.name}:{os.environ["PATH"]}'
        goes_on = self.start(['roslaunch', 'ratchet_sieve', 'rviz.launch', f'config:={PACKAGE}/rviz/sieve.rviz'])
        wait_for(lambda: goes_on() and count_background(self.screen.pixels()) > DRAWN_PIXELS, 'RViz draws')
        threads = rviz.with_suffix('.crashed').read_text().split()
        self.assertEqual(len(threads), 1, 'a thread that rospy leaves behind occupies a core')
        self.assertEqual(disk_pixels(self.screen.pixels()), [0, 0])

    def test_shows_a_sieve_in_a_namespace_and_elsewhere(self):
        self.screen.environment['ROS_NAMESPACE'] = 'plant1'
        self.expect_machine(['sieve.launch', 'rviz:=true', 'rviz_view:=teeth', 'paused:=true',
                             'params:={mount: {x: 5.0, z: -3.0}}', f'scene:={PACKAGE / "test/ros/mixture.yaml"}'],
                            0.95)

    def test_shows_a_recorded_run(self):
        self.expect_machine(['replay.launch', f'bag:={sys.argv[1]}', 'rate:=0.2', 'loop:=true'], 0.67)

    def expect_machine(self, launch, share):
        """Its disks, and its base in the middle, with this share of the window's width."""
        goes_on = self.start(['roslaunch', 'ratchet_sieve', *launch])
        columns = []

        def are_shown():  # in one picture: a replay that begins again clears both
            pixels = self.screen.pixels()
            columns[:] = base_columns(pixels)
            return goes_on() and columns and min(disk_pixels(pixels)) > DISK_PIXELS
        wait_for(are_shown, f'RViz shows the base, and more than {DISK_PIXELS} pixels of each species')
        first, last = columns
        self.assertAlmostEqual(first + last, LEFT + RIGHT, delta=6)
        self.assertAlmostEqual((last - first) / (RIGHT - LEFT), share, delta=0.02)


if __name__ == '__main__':
    rosunit.unitrun('ratchet_sieve', 'rviz', Rviz)
