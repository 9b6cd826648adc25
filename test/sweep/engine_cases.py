"""Shared by the tests of the engines: a sweep, its table, and processes that are killed with all their children."""
import ctypes
import functools
import json
import os
import pathlib
import shutil
import signal
import sqlite3
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM = str(pathlib.Path(sys.argv.pop(1)).resolve())

TIME_LIMIT = 120  # of a test [s]; about ten times its duration on an idle machine
PR_SET_CHILD_SUBREAPER = 36  # of linux/prctl.h

SWEEP = '''
scene:
  base: {teeth: 4, asymmetry: 0.1}
  boundary: periodic
  species:
    - {name: A, count: 6, radius: 0.001, mass: 0.010}
    - {name: B, count: 6, radius: 0.003, mass: 0.001}
  duration: 200
grid: {base.inclination: [-0.1, 0, 0.1]}
seed: {first: 1, count: 12}
'''
CASES = 36


def table(path):
    """Every row, without the columns that differ between runs."""
    connection = sqlite3.connect(path)
    connection.row_factory = sqlite3.Row
    rows = {}
    for row in connection.execute('SELECT * FROM cases'):
        row = dict(row)
        summary = json.loads(row['summary'])
        del row['wall_time'], row['host'], summary['wall_time']
        rows[row['run_hash']] = dict(row, summary=summary)
    connection.close()
    return rows


def wait_for(condition, what, process=None):
    """Waits for a condition, at most until the test's time limit."""
    while not condition():
        if process is not None and process.poll() is not None:
            raise AssertionError(f'ended before {what}: {process.returncode}')
        time.sleep(0.02)


def descendants(pid):
    """All descendants of a process."""
    children = {}
    for directory in pathlib.Path('/proc').glob('[0-9]*'):
        try:
            parent = int((directory / 'stat').read_text().rsplit(')', 1)[1].split()[1])
        except OSError:
            continue
        children.setdefault(parent, []).append(int(directory.name))
    found = []
    waiting = [pid]
    while waiting:
        found += children.get(waiting[-1], [])
        waiting = waiting[:-1] + children.get(waiting[-1], [])
    return found


def kill_all(pid):
    """Kills a process and its descendants. Each is stopped first, so that none starts another meanwhile."""
    stopped = set()
    while True:
        alive = {pid, *descendants(pid)} - stopped
        if not alive:
            break
        send(alive, signal.SIGSTOP)
        stopped |= alive
    send(stopped, signal.SIGKILL)


def send(pids, number):
    """Sends a signal to those processes that still exist."""
    for pid in pids:
        try:
            os.kill(pid, number)
        except ProcessLookupError:
            pass


class EngineTest(unittest.TestCase):
    """A test with its own directory and time limit, which leaves no process behind in any case."""

    def setUp(self):
        # An orphaned process, for example a task of Slurm, becomes a child of this process.
        ctypes.CDLL(None).prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)
        signal.signal(signal.SIGALRM, self.give_up)
        signal.alarm(TIME_LIMIT)
        self.addCleanup(signal.alarm, 0)
        self.directory = pathlib.Path(tempfile.mkdtemp(prefix='ratchet_sieve_'))
        self.addCleanup(shutil.rmtree, self.directory, ignore_errors=True)
        self.addCleanup(self.kill_descendants)
        (self.directory / 's.yaml').write_text(SWEEP)

    @staticmethod
    def give_up(*_):
        raise TimeoutError(f'not through after {TIME_LIMIT} s')

    @staticmethod
    def kill_descendants():
        """Kills all children, including adopted ones."""
        for pid in descendants(os.getpid()):
            kill_all(pid)

    def background(self, *words, **options):
        """Starts a program. It ends with the test."""
        process = subprocess.Popen(words, **options)
        self.addCleanup(process.wait)
        self.addCleanup(kill_all, process.pid)
        return process

    def start_sweep(self, *options, sweep='s.yaml', **environment):
        process = self.background(PROGRAM, 'run', sweep, *options, cwd=self.directory, stderr=subprocess.PIPE, text=True,
                                  **environment)
        self.addCleanup(process.stderr.close)
        return process

    def rows(self):
        """Number of rows in the table; 0 if there is no table."""
        try:
            connection = sqlite3.connect(f'file:{self.directory}/s.db?mode=ro', uri=True)
            with connection:
                return connection.execute('SELECT COUNT(*) FROM cases').fetchone()[0]
        except sqlite3.OperationalError:
            return 0

    def expect_under_way(self):
        """Checks that some cases are not done yet; otherwise the test would show nothing."""
        self.assertLess(self.rows(), CASES)

    def expect_interrupted(self, process):
        process.send_signal(signal.SIGINT)
        errors = process.communicate()[1]
        self.assertEqual(process.returncode, 1, errors)
        self.assertIn('run the same command to continue', errors)
        self.expect_under_way()

    def expect_same_table(self, process):
        errors = process.communicate()[1]
        logs = ''.join(path.read_text() for path in self.directory.glob('s.db.d/*/log'))
        self.assertEqual(process.returncode, 0, errors + logs)
        self.assertEqual(table(self.directory / 's.db'), reference())
        self.assertFalse((self.directory / 's.db.d').exists())


@functools.lru_cache(maxsize=None)
def reference():
    """The table of a run on threads."""
    with tempfile.TemporaryDirectory(prefix='ratchet_sieve_') as name:
        directory = pathlib.Path(name)
        (directory / 's.yaml').write_text(SWEEP)
        subprocess.run([PROGRAM, 'run', 's.yaml'], cwd=directory, check=True, stderr=subprocess.DEVNULL)
        rows = table(directory / 's.db')
    assert len(rows) == CASES, len(rows)
    return rows
