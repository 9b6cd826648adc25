#!/usr/bin/python3
"""Trajectories of sieve_run as VTK, and so ParaView, reads them: the same as in extended XYZ.

Usage: vtk_trajectory_test.py SIEVE_RUN SCENE...
"""
import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

import ase.io
import numpy
from vtk import vtkXMLPolyDataReader
from vtk.util.numpy_support import vtk_to_numpy

SIEVE_RUN, *SCENES = sys.argv[1:]
sys.argv[1:] = []

# No disk at any time: the feed is too slow.
EMPTY = '{base: {inclination: 0.1}, species: [{name: A, count: 0, radius: 0.002, mass: 0.01}], feed: {rate: 0.001}}'


def read(path):
    """A PolyData file; an error of VTK's reader is one of the test."""
    errors = []
    reader = vtkXMLPolyDataReader()
    reader.AddObserver('ErrorEvent', lambda *_: errors.append(path))
    reader.SetFileName(str(path))
    reader.Update()
    assert not errors and reader.GetErrorCode() == 0, path
    return reader.GetOutput()


def series(collection):
    """The time and the data of each frame of a collection."""
    for data_set in ElementTree.parse(collection).iter('DataSet'):
        data = read(collection.parent / data_set.get('file'))
        time = float(data_set.get('timestep'))
        assert vtk_to_numpy(data.GetFieldData().GetArray('TimeValue')).tolist() == [time]
        yield time, data


def positions(data):
    return vtk_to_numpy(data.GetPoints().GetData()).reshape(-1, 3)


class VtkTrajectory(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.directory = pathlib.Path(scratch.name)

    def both(self, scene, *options):
        """The run as XYZ and as VTK: the frames of the disks, and those of the base."""
        for name in ('run & rest.xyz', 'run & rest.pvd'):
            subprocess.run([SIEVE_RUN, scene, '--trajectory', self.directory / name, '--trajectory-rate', '20', *options],
                           capture_output=True, check=True)
        for name in ('run & rest', 'run & rest_base'):
            frames = ase.io.read(self.directory / (name + '.xyz'), ':')
            shown = list(series(self.directory / (name + '.pvd')))
            self.assertEqual([frame.info['Time'] for frame in frames], [time for time, _ in shown])
            yield [(frame, data) for frame, (_, data) in zip(frames, shown)]

    def compare(self, scene, *options):
        """Returns the number of disks at the end."""
        disks, base = self.both(scene, *options)
        for frame, data in disks:
            numpy.testing.assert_array_equal(positions(data), frame.positions)
            self.assertEqual(data.GetNumberOfVerts(), len(frame))
            names = data.GetFieldData().GetAbstractArray('species_names')
            arrays = data.GetPointData()
            shown = {arrays.GetArrayName(k): vtk_to_numpy(arrays.GetArray(k)) for k in range(arrays.GetNumberOfArrays())}
            self.assertEqual([names.GetValue(k) for k in shown.pop('species')], list(frame.arrays['type']))
            expected = {key: frame.arrays[key] for key in ('id', 'radius', 'mass', 'angle', 'displacement')}
            expected.update(velocity=frame.arrays['velo'], spin=frame.arrays['omega'][:, 2])
            self.assertEqual(set(shown), set(expected))
            for key, values in expected.items():
                numpy.testing.assert_array_equal(shown[key].reshape(values.shape), values, key)
        for frame, data in base:
            numpy.testing.assert_array_equal(positions(data), frame.positions)
            self.assertEqual((data.GetNumberOfLines(), data.GetCell(0).GetNumberOfPoints()), (1, len(frame)))
        return len(disks[-1][0])

    def test_it_reads_scenes(self):
        for scene in SCENES:
            with self.subTest(scene):
                self.assertGreater(self.compare(scene, '--duration', '2'), 0)

    def test_it_reads_a_machine_without_disks(self):
        scene = self.directory / 'empty.yaml'
        scene.write_text(EMPTY)
        self.assertEqual(self.compare(scene, '--duration', '0.2'), 0)


if __name__ == '__main__':
    unittest.main()
