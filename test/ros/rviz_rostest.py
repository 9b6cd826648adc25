#!/usr/bin/python3
"""RViz on a screen in memory: shows disks where a sieve runs or is replayed, and none where none does.

Usage: rviz_rostest.py BAG [ROS ARGUMENT...]; part of rviz.test, which has started a master. BAG is a run of mixture.yaml.
"""

import subprocess
import sys
import unittest
from pathlib import Path

import numpy
import rosunit

PACKAGE = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(PACKAGE / 'scripts'))
from virtual_screen import VirtualScreen, wait_for  # noqa: E402

# The colours of the first two species (marker_style.cpp) and of RViz's background (sieve.rviz).
SPECIES = ((0, 114, 178), (213, 94, 0))
BACKGROUND = (250, 250, 250)

# A sphere's shading makes its colour darker or lighter by these factors, and leaves its hue but for so much.
SHADES = (0.3, 1.3)
HUE_TOLERANCE = 40.0

# A pixel inside something so wide that no letter is drawn with such strokes [pixels to each side].
INSIDE = 3

# Far more than a stray pixel, less than half of what the disks of mixture.yaml are seen to have.
DISK_PIXELS = 400

# Half the window: RViz has come up and has drawn.
DRAWN_PIXELS = 400000


def count_background(pixels):
    return int(numpy.all(pixels == BACKGROUND, axis=2).sum())


def coloured(pixels, colour):
    """Where the pixels are a shade of the colour."""
    colour = numpy.array(colour, float)
    pixels = pixels.astype(float)
    shade = pixels @ colour / (colour @ colour)
    distance = numpy.linalg.norm(pixels - shade[..., None] * colour, axis=2)
    return (shade > SHADES[0]) & (shade < SHADES[1]) & (distance < HUE_TOLERANCE)


def inside(mask):
    """Where all of the neighbourhood is set."""
    for axis in (0, 1):
        mask = numpy.logical_and.reduce([numpy.roll(mask, k, axis) for k in range(-INSIDE, INSIDE + 1)])
    return mask


def disk_pixels(pixels):
    """Per species, the pixels inside a disk of its colour."""
    return [int(inside(coloured(pixels, colour)).sum()) for colour in SPECIES]


class Rviz(unittest.TestCase):
    def setUp(self):
        self.screen = VirtualScreen()
        self.screen.__enter__()
        self.addCleanup(self.screen.__exit__)

    def start(self, command):
        """Starts a program; it has to go on running while something is waited for."""
        program = self.screen.start(command, stdout=subprocess.DEVNULL)

        def goes_on():
            self.assertIsNone(program.poll(), f'{command[0]} has ended')
            return True
        return goes_on

    def test_shows_no_disks_without_a_sieve(self):
        goes_on = self.start(['rviz', '-d', str(PACKAGE / 'rviz/sieve.rviz'), '--splash-screen', ''])
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

    def expect_disks(self, launch):
        goes_on = self.start(['roslaunch', 'ratchet_sieve', *launch])
        wait_for(lambda: goes_on() and min(disk_pixels(self.screen.pixels())) > DISK_PIXELS,
                 f'RViz shows more than {DISK_PIXELS} pixels of each species')


if __name__ == '__main__':
    rosunit.unitrun('ratchet_sieve', 'rviz', Rviz)
