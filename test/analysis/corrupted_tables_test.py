#!/usr/bin/python3
"""Plotting truncated or corrupted tables gives one line that names the file, and never a traceback.

Usage: corrupted_tables_test.py SIEVE_RUN SIEVE_ANALYZE SIEVE_SWEEP, the programs.
"""
import contextlib
import io
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

from matplotlib.figure import Figure

from ratchet_sieve.plots import analysis, seek, sweep

SIEVE_RUN, SIEVE_ANALYZE, SIEVE_SWEEP = sys.argv[1:]
sys.argv[1:] = []
PROJECT = pathlib.Path(__file__).resolve().parents[2]
SCENE = PROJECT / 'test/ros/mixture.yaml'

READ_BY = {analysis: ['run', 'drift', 'bins', 'segregation', 'drive', 'statistics', 'contacts', 'displacements',
                           'velocities', 'observed', 'residence_times', 'height_profile', 'mass_flow', 'size_classes'],
           seek: ['run', 'drive', 'bins'], sweep: ['cases']}
SEED = 7


def cut(content, chance):
    return content[:chance.randrange(len(content))]


def overwritten(content, chance):
    place = chance.randrange(len(content))
    return content[:place] + chance.randbytes(4) + content[place + 4:]


def write_tables(directory):
    """@return the directory of the tables of a run and a sweep"""
    def run(*command):
        subprocess.run([*map(str, command)], check=True, capture_output=True)

    run(SIEVE_RUN, SCENE, '--duration', 2, '--bag', directory / 'run.bag',
        '--set', 'observe=[residence_times, height_profile, mass_flow]',
        '--set', 'species.0.size={distribution: uniform, spread: 0.2}')
    run(SIEVE_ANALYZE, directory / 'run.bag', '--out', directory / 'tables')
    sweep = directory / 'sweep.yaml'
    sweep.write_text(f'{{scene: {SCENE}, set: {{duration: 0.2}}, grid: {{base.inclination: [0.0, 0.1]}}, seed: {{first: 1, count: 2}}}}')
    run(SIEVE_SWEEP, 'run', sweep)
    run(SIEVE_SWEEP, 'report', sweep, '--out', directory / 'tables')
    return directory / 'tables'


class Corrupted(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        cls.whole = write_tables(pathlib.Path(scratch.name))

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.directory = pathlib.Path(scratch.name) / 'tables'
        shutil.copytree(self.whole, self.directory)

    def draw(self, script):
        """@return exit status and standard error"""
        errors = io.StringIO()
        sys.argv = [script.__name__, str(self.directory)]
        with contextlib.redirect_stderr(errors), contextlib.redirect_stdout(io.StringIO()):
            try:
                script.main()
            except SystemExit as end:
                return end.code, errors.getvalue()
        return 0, errors.getvalue()

    def expect_refusal(self, script, path, because):
        status, said = self.draw(script)
        self.assertEqual((status, said), (2, f'{script.__name__}: {path}: {because}\n'))

    def test_whole_tables_are_drawn(self):
        for script in READ_BY:
            self.assertEqual(self.draw(script), (0, ''))

    def test_what_is_wrong_is_said(self):
        for script, table in ((analysis, 'segregation'), (seek, 'drive'), (sweep, 'cases')):
            path = self.directory / f'{table}.csv'
            whole = path.read_bytes()
            head, first = whole.splitlines()[:2]
            fields = head.count(b',') + 1
            for content, because in (
                    (b'', 'cut off, its last line has no end'),
                    (whole[:-3], 'cut off, its last line has no end'),
                    (head + b'\n' + b'1,2\n', f'line 2: 2 fields, must be {fields}'),
                    (b'\xff' + whole, "no table: 'utf-8' codec can't decode byte 0xff in position 0: invalid start byte"),
                    (head.replace(b'seed', b'sad').replace(b'time', b'tame') + b'\n' + first + b'\n',
                     'has no column ' + ('seed' if table == 'cases' else 'time'))):
                path.write_bytes(content)
                self.expect_refusal(script, path, because)
            path.write_bytes(whole)

    def test_a_text_is_no_number(self):
        path = self.directory / 'drive.csv'
        head = path.read_text().splitlines()[0]
        path.write_text(head + '\n' + ','.join(['1e'] * (head.count(',') + 1)) + '\n')
        self.expect_refusal(seek, path, 'time: 1e: must be a number')

    def test_what_the_table_lacks_is_that_of_a_sweep(self):
        path = self.directory / 'sweep.json'
        for text, because in (('{"seeds"', "no JSON: Expecting ':' delimiter: line 1 column 9 (char 8)"),
                              ('[]', 'has no command, seeds, warnings')):
            path.write_text(text)
            self.expect_refusal(sweep, path, because)

    def test_no_damage_ends_in_a_traceback(self):
        chance = random.Random(SEED)
        # Other tests check the pictures.
        drawn = mock.patch.object(Figure, 'savefig', lambda _, path, **__: pathlib.Path(path).touch())
        drawn.start()
        self.addCleanup(drawn.stop)
        for script, tables in READ_BY.items():
            for table in tables:
                path = self.directory / f'{table}.csv'
                whole = path.read_bytes()
                for damaged in (cut, overwritten):
                    path.write_bytes(damaged(whole, chance))
                    status, said = self.draw(script)
                    self.assertIn((status, said.count('\n')), ((0, 0), (2, 1)), said)
                path.write_bytes(whole)


if __name__ == '__main__':
    unittest.main()
