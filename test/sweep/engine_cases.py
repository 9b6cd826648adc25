"""What the tests of the engines share: a sweep, its table, and processes that are killed with all that they started."""
import json
import os
import pathlib
import signal
import sqlite3
import subprocess
import time

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
    """Every row, without what differs from run to run."""
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


def count(path):
    """Rows so far; 0 while there is no table."""
    try:
        connection = sqlite3.connect(f'file:{path}?mode=ro', uri=True)
        with connection:
            return connection.execute('SELECT COUNT(*) FROM cases').fetchone()[0]
    except sqlite3.OperationalError:
        return 0


def wait_for(condition, what, process=None):
    """Waits until it holds; the test's own time limit is the only other one."""
    while not condition():
        if process is not None and process.poll() is not None:
            raise AssertionError(f'ended before {what}: {process.returncode}')
        time.sleep(0.02)


def descendants(pid):
    """The processes that one has started, and those have."""
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


def kill_all(process):
    """Kills a process and all that it has started, at once."""
    for pid in [process.pid] + descendants(process.pid):
        try:
            os.kill(pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
    process.wait()


def reference(program, directory):
    """The table as the threads of one program make it."""
    (directory / 's.yaml').write_text(SWEEP)
    subprocess.run([program, 'run', 's.yaml', '--db', 'reference.db'], cwd=directory, check=True,
                   stderr=subprocess.DEVNULL)
    rows = table(directory / 'reference.db')
    assert len(rows) == CASES, len(rows)
    return rows
