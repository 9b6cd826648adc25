#!/usr/bin/python3
"""Trajectories of sieve_run as ASE reads them.

Usage: trajectory_test.py SIEVE_RUN
"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

import ase.io
import numpy

SIEVE_RUN = sys.argv.pop(1)

FLIGHT = """
base: {teeth: 10, inclination: 0.2, amplitude: 0.001}
boundary: periodic
species:
  - {name: flat.stone, radius: 0.004, mass: 0.02}
  - {name: pebble_2, radius: 0.002, mass: 0.01}
  - {name: Fe, radius: 0.001, mass: 0.005}
initial:
  - {species: flat.stone, x: -0.05, y: 0.5, vx: 0.1, vy: 0.3, spin: -2.0}
  - {species: pebble_2, x: 0.05, y: 0.45, vx: -0.2, vy: 0.0, spin: 5.0}
duration: 0.25
"""

FED = """
base: {teeth: 6, inclination: -0.3, horizontal_amplitude: 0.001, drive_frame: base,
       profile: [[0, 0], [0, 0.003], [0.01, -0.001], [0.015, 0]]}
boundary: open
species:
  - {name: A, count: 0, radius: 0.002, mass: 0.02, size: {distribution: lognormal, spread: 0.2, mass_exponent: 2}}
  - {name: B, count: 0, radius: 0.001, mass: 0.01}
  - {name: C, count: 0, share: 0, radius: 0.001, mass: 0.01}
feed: {rate: 60}
duration: 3
"""


class Trajectory(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.directory = pathlib.Path(scratch.name)

    def run_scene(self, text, *options):
        """Returns the summary."""
        scene = self.directory / 'scene.yaml'
        scene.write_text(text)
        done = subprocess.run([SIEVE_RUN, scene, *map(str, options)], capture_output=True, text=True, check=True)
        return json.loads(done.stdout)

    def frames(self, text, *options, name='run.xyz'):
        """Returns the summary, and the frames of the disks and of the base as ASE reads them."""
        path = self.directory / name
        summary = self.run_scene(text, '--trajectory', path, *options)
        base = path.with_name(path.stem + '_base' + path.suffix)
        return summary, ase.io.read(path, ':'), ase.io.read(base, ':')

    def test_the_cell_is_periodic_along_the_base(self):
        _, frames, base = self.frames(FLIGHT, '--trajectory-rate', 0, name='run.extxyz')
        self.assertEqual(len(frames), 2)
        for frame in frames + base:
            self.assertEqual(list(frame.pbc), [True, False, False])
            numpy.testing.assert_allclose(frame.cell[0], [0.2 * math.cos(0.2), 0.2 * math.sin(0.2), 0.0], rtol=1e-15)
            self.assertAlmostEqual(frame.cell.volume, 0.2 * 0.2 * 0.008)
        for frame in base:
            # Both ends of the base are one place.
            numpy.testing.assert_allclose(frame.positions[-1] - frame.positions[0], frame.cell[0], atol=1e-15)

    def test_fed_disks_come_and_go(self):
        summary, frames, base = self.frames(FED)
        self.assertEqual(len(frames), 181)
        self.assertEqual(len(frames[0]), 0)
        self.assertEqual(list(frames[0].pbc), [False, False, False])
        last = list(frames[-1].arrays['type'])
        for species in summary['species']:
            self.assertEqual(last.count(species['name']), species['count'] - species['left'] - species['right'])
        self.assertEqual(last.count('C'), 0)
        self.assertGreater(sum(species['left'] + species['right'] for species in summary['species']), 0)
        radius_of = {}
        for frame in frames:
            for disk, radius in zip(frame.arrays['id'], frame.arrays['radius']):
                self.assertEqual(radius_of.setdefault(disk, radius), radius)
            sizes = numpy.where(frame.arrays['type'] == 'A', 0.02 / 0.002 ** 2, 0.01 / 0.001 ** 2)
            numpy.testing.assert_allclose(frame.arrays['mass'], sizes * frame.arrays['radius'] ** 2, rtol=1e-14)
        self.assertGreater(len(set(radius_of.values())), len(radius_of) / 4)
        for frame in base:
            self.assertEqual(len(frame), 6 * 3 + 1)
            heights = (frame.positions - frame.positions[0]) @ (frame.cell[1] / numpy.linalg.norm(frame.cell[1]))
            numpy.testing.assert_allclose(heights[:4], [0, 0.003, -0.001, 0], rtol=0, atol=1e-15)
            numpy.testing.assert_array_equal(frame.positions[0], frame.info['Origin'] * [1, 1, 0])

    def test_a_resumed_run_writes_the_rest(self):
        checkpoint = self.directory / 'run.checkpoint'
        _, through, _ = self.frames(FED)
        _, first, _ = self.frames(FED, '--duration', 1.5, '--checkpoint', checkpoint)
        _, second, _ = self.frames(FED, '--resume', checkpoint)
        self.assertEqual(first[-1].info['Time'], second[0].info['Time'])
        self.assertEqual(len(first) + len(second) - 1, len(through))
        for frame, expected in zip(first + second[1:], through):
            self.assertEqual(frame.info['Time'], expected.info['Time'])
            self.assertEqual(frame, expected)


if __name__ == '__main__':
    unittest.main()
