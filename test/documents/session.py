"""A user's terminals in a checkout, with a ROS master of their own."""

import os
import re
import shutil
import signal
import sqlite3
import subprocess
import time
from contextlib import ExitStack, closing
from fnmatch import fnmatch
from pathlib import Path

from commands import PACKAGE
from plan import BEFORE, GOES_ON, READS_RECORDING, STAYING
from ratchet_sieve.processes import free_port, wait_for
from ratchet_sieve.virtual_screen import VirtualScreen

LONGEST = 180.0  # of a command that is run [s]
NOT_IN_CHECKOUT = ('.git', 'build*', 'devel', 'out', '.ccache')


def lookup(table, command):
    """The entry with the longest prefix of a command."""
    matches = [start for start in table if re.sub(r'\s+#.*', '\n', command + '\n').startswith(start)]
    return max(matches, key=len, default=None)


class Failed(Exception):
    """A command does not do what the document says."""


class Session:
    """Commands are run as written, one after the other, in a copy of the sources beside the given devel space."""

    def __init__(self, scratch, devel):
        self.scratch, self.checkout, self.here = scratch, scratch / 'checkout', scratch / 'checkout'
        shutil.copytree(PACKAGE, self.checkout, ignore=lambda folder, names: [
            name for name in names if Path(folder) == PACKAGE and any(fnmatch(name, what) for what in NOT_IN_CHECKOUT)])
        (self.checkout / 'devel').symlink_to(devel)
        self.terminals, self.services = [], ExitStack()

    def start(self):
        """Starts a screen and a master, which close() ends."""
        screen = self.services.enter_context(VirtualScreen())
        port = free_port()
        self.environment = dict(
            screen.environment, HOME=str(self.scratch), ROS_HOME=str(self.scratch / 'ros'), PYTHONUNBUFFERED='1',
            ROS_HOSTNAME='localhost', ROS_MASTER_URI=f'http://localhost:{port}',
            PATH='/usr/bin:' + screen.environment['PATH'])
        sourced = subprocess.run(['bash', '-c', f'. "{self.checkout}/devel/setup.bash"; env -0'], env=self.environment,
                                 stdout=subprocess.PIPE, text=True, check=True).stdout
        self.environment = dict(entry.split('=', 1) for entry in sourced.split('\0') if entry)
        # Programs by their names, as where the Debian packages are installed.
        self.environment['PATH'] = f'{self.checkout}/devel/lib/ratchet_sieve:' + self.environment['PATH']
        master = self.open(f'roscore -p {port}')
        self.services.callback(self.end, master)
        wait_for(lambda: 'started core service' in master.log.read_text(), 'roscore')

    def close(self):
        self.end_terminals()
        self.services.close()

    def open(self, command):
        """A terminal in which a command is run."""
        log = self.scratch / f'terminal{time.monotonic_ns()}.log'
        script = f'cd "{self.here}"\n{command}\nstatus=$?; pwd > "{self.scratch}/here"; exit $status'
        with log.open('w') as output:
            program = subprocess.Popen(['bash', '-c', script], env=self.environment, stdout=output,
                                       stderr=subprocess.STDOUT, start_new_session=True,
                                       # A background process ignores SIGINT by default.
                                       preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))
        program.command, program.log = command, log
        return program

    def run(self, command):
        """Runs a command, or starts one that keeps running. @throws Failed"""
        if command.startswith(tuple(READS_RECORDING)):
            self.end_terminals()
        before = lookup(BEFORE, command)
        if before:
            self.run(BEFORE[before])
        goes_on = lookup(GOES_ON, command)
        terminal = self.open(command)
        if goes_on is None:
            try:
                terminal.wait(LONGEST)
            except subprocess.TimeoutExpired:
                self.end(terminal)
            if terminal.returncode != 0:
                raise Failed(f'{command}\nexit status {terminal.returncode}\n{terminal.log.read_text()[-3000:]}')
            self.here = Path((self.scratch / 'here').read_text().strip())
            return
        self.terminals.append(terminal)
        self.wait_until_up(terminal, GOES_ON[goes_on])
        if not any(mark in command for mark in STAYING):
            self.end(self.terminals.pop())

    def wait_until_up(self, terminal, sign):
        def gone():
            text = terminal.log.read_text()
            if terminal.poll() not in (None, 0) or 'process has died' in text:
                raise Failed(f'{terminal.command}\nhas ended\n{text[-3000:]}')

        if sign is None:
            up = terminal.log.read_text
        elif sign.startswith('/'):
            echo = self.open(f'rostopic echo -n 1 {sign} > /dev/null')
            self.terminals.insert(0, echo)
            up = lambda: echo.poll() == 0  # noqa: E731
        else:
            first = self.results(sign)
            up = lambda: self.results(sign) > first  # noqa: E731
        wait_for(lambda: gone() or up(), terminal.command)

    def results(self, name):
        """Number of completed cases in a results file."""
        path = self.here / name
        if not path.exists():
            return 0
        with closing(sqlite3.connect(path)) as database:
            try:
                return database.execute("SELECT COUNT(*) FROM cases WHERE status = 'done'").fetchone()[0]
            except sqlite3.OperationalError:  # not there yet
                return 0

    def end(self, terminal):
        """Ctrl-C."""
        if terminal.poll() is None:
            os.killpg(terminal.pid, signal.SIGINT)
        terminal.wait(LONGEST)

    def end_terminals(self):
        while self.terminals:
            self.end(self.terminals.pop())

    def output(self, command):
        """The output of a command, including standard error."""
        terminal = self.open(command)
        terminal.wait(LONGEST)
        return terminal.log.read_text()

    def words(self, command):
        return set(re.findall(r'--[a-zA-Z][a-zA-Z-]*', self.output(command)))
