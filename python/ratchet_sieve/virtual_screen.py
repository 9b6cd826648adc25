"""A screen in memory, for programs that draw where there is none, and pictures of it.

Needs xvfb and imagemagick: the group `tests` of packages.txt.
"""

import os
import signal
import subprocess

import numpy

from ratchet_sieve.processes import TIMEOUT


class VirtualScreen:
    """An X server without a display. It ends with its `with` block, with all programs that were started on it."""

    def __init__(self, width=1280, height=800):
        self.width, self.height = width, height
        self._programs = []

    def __enter__(self):
        read_end, write_end = os.pipe()
        # Without -noreset it restarts when its last client ends, and meanwhile refuses clients, such as RViz.
        self._server = subprocess.Popen(
            ['Xvfb', '-displayfd', str(write_end), '-screen', '0', f'{self.width}x{self.height}x24',
             '-nolisten', 'tcp', '-noreset'],
            pass_fds=[write_end], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(write_end)
        with os.fdopen(read_end) as pipe:
            number = pipe.readline().strip()
        if not number:
            raise RuntimeError('Xvfb does not start')
        # Software rendering, in one thread, is the same everywhere.
        self.environment = dict(os.environ, DISPLAY=f':{number}', LIBGL_ALWAYS_SOFTWARE='1', LP_NUM_THREADS='0')
        return self

    def __exit__(self, *_):
        for program in reversed(self._programs):
            self.end(program)
        self._server.terminate()
        self._server.wait()

    def start(self, command, **options):
        """Starts a program on this screen, in a process group of its own."""
        program = subprocess.Popen(command, env=self.environment, start_new_session=True, **options)
        self._programs.append(program)
        return program

    def end(self, program):
        """Interrupts a program and its children, and waits; kills those that do not end."""
        for request in (signal.SIGINT, signal.SIGKILL):
            if program.poll() is None:
                os.killpg(program.pid, request)
                try:
                    program.wait(TIMEOUT)
                except subprocess.TimeoutExpired:
                    continue
        if program in self._programs:
            self._programs.remove(program)

    def pixels(self):
        """The screen: rows of pixels of red, green and blue, 0 to 255."""
        raw = subprocess.run(['import', '-silent', '-window', 'root', '-depth', '8', 'rgb:-'],
                             env=self.environment, check=True, stdout=subprocess.PIPE)
        return numpy.frombuffer(raw.stdout, numpy.uint8).reshape(self.height, self.width, 3)
