#!/usr/bin/python3
"""The programs that draw tables: whole ones, those in which nothing is defined, and truncated or corrupted ones, which
give one line that names the file, and never a traceback.

Usage: corrupted_tables_test.py SIEVE_RUN SIEVE_ANALYZE SIEVE_SWEEP, the programs.
"""
import contextlib
import io
import pathlib
import random
import re
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
OPTIONS = {seek: ['--window', '0.1', '--best', '0', '1', '0.1', '0.5']}
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

    def draw(self, script, *options):
        """@return exit status and standard error"""
        errors = io.StringIO()
        sys.argv = [script.__name__, str(self.directory), *OPTIONS.get(script, ()), *options]
        with contextlib.redirect_stderr(errors), contextlib.redirect_stdout(io.StringIO()):
            try:
                script.main()
            except SystemExit as end:
                return end.code, errors.getvalue()
        return 0, errors.getvalue()

    def test_whole_tables_are_drawn(self):
        for script in READ_BY:
            self.assertEqual(self.draw(script), (0, ''))

    def test_tables_in_which_nothing_is_defined_are_drawn(self):
        """Of a base that nothing leaves: the drift is drawn in place of the bins."""
        for path in self.directory.glob('*.csv'):
            if path.stem == 'run':
                path.write_text(re.sub(r'(?m)^(\w+,\d+,[^,]+),1,', r'\1,0,', path.read_text()))
            elif path.stem not in ('observed', *READ_BY[sweep]):
                path.write_text(path.read_text().splitlines()[0] + '\n')
        for script in (analysis, seek):
            self.assertEqual(self.draw(script), (0, ''))
        self.assertTrue((self.directory / 'drift.png').exists())

    def test_what_is_wrong_is_said(self):
        for script, table in ((analysis, 'segregation'), (seek, 'drive'), (sweep, 'cases')):
            path = self.directory / f'{table}.csv'
            path.write_bytes(path.read_bytes()[:-3])
            self.assertEqual(self.draw(script), (2, f'{script.__name__}: {path}: cut off, its last line has no end\n'))
            path.unlink()
            self.assertIn(f'{script.__name__}: {path}: ', ''.join(map(str, self.draw(script))))

    def test_what_the_table_lacks_is_that_of_a_sweep(self):
        path = self.directory / 'sweep.json'
        path.write_text('[]')
        self.assertEqual(self.draw(sweep), (2, f'{sweep.__name__}: {path}: has no command, seeds, warnings\n'))

    def test_a_report_of_what_there_is_not_is_refused(self):
        for options, line in ((('--x', 'density'), '--x density: no such name; there are base.inclination\n'),
                              (('--field', 'speed'), '--field speed: no such name; there are seed, status, '),
                              (('--where', 'base.inclination=7'), 'no case is done of those that --where asks for\n')):
            status, said = self.draw(sweep, *options)
            self.assertEqual((status, said.count('\n')), (2, 1))
            self.assertTrue(said.startswith(f'{sweep.__name__}: {line}'), said)

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
