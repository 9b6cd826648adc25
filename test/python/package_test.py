"""What `import ratchet_sieve` costs, and what it finds."""
import contextlib
import fcntl
import os
import pathlib
import pty
import struct
import subprocess
import sys
import tempfile
import termios
import textwrap
import unittest

from ratchet_sieve.places import SHARE
from ratchet_sieve.progress import Progress

HEAVY = ("matplotlib", "numpy", "pandas", "scipy", "yaml")


class Package(unittest.TestCase):
    def test_is_imported_without_what_takes_long(self):
        said = subprocess.run([sys.executable, "-c", "import ratchet_sieve, sys; print(*sys.modules)"], check=True,
                              capture_output=True, text=True).stdout.split()
        self.assertIn("ratchet_sieve", said)
        self.assertEqual([name for name in HEAVY if name in said], [])

    def test_imports_its_parts_when_they_are_used(self):
        subprocess.run([sys.executable, "-c", "import ratchet_sieve; ratchet_sieve.stats.mean_of([1.0]); "
                        "ratchet_sieve.plots.COLOURS; ratchet_sieve.tables.Rows()"], check=True)

    def test_its_help_begins_with_a_scene_that_answers(self):
        import ratchet_sieve

        example = textwrap.dedent("".join(line[4:] + "\n" for line in ratchet_sieve.__doc__.splitlines()
                                          if line.startswith("    ")))
        told = {}
        exec(example.replace('"config', f'"{SHARE}/config').replace(", run.plot()", ""), told)
        self.assertGreater(told["run"].summary.quality, 0.5)

    def test_a_program_that_is_stopped_while_it_loads_says_so(self):
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, "stopped.py").write_text("raise KeyboardInterrupt", encoding="utf-8")
            said = subprocess.run([sys.executable, "-c", "from ratchet_sieve.recommended import run; run('stopped', 'me')"],
                                  capture_output=True, text=True, env={**os.environ, "PYTHONPATH": os.pathsep.join(
                                      [folder, *filter(None, [os.environ.get("PYTHONPATH")])])})
        self.assertEqual((said.returncode, said.stderr), (1, "me: interrupted\n"))

    def test_progress_never_is_longer_than_the_terminal(self):
        for columns in (20, 60, 0):
            master, terminal = pty.openpty()
            fcntl.ioctl(terminal, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
            with open(terminal, "w") as screen, contextlib.redirect_stderr(screen), Progress(True, "separate") as bar:
                for part in (0.0, 0.5):
                    bar.show(part, "123 runs, best -0.0123 ± 0.01 at inclination 0.2516, frequency 15, asymmetry 0.25")
                    drawn = b""
                    while not drawn.endswith(b"\033[K"):
                        drawn += os.read(master, 1)
                    self.assertEqual(len(drawn.decode()), len("\r\033[K") + (columns or 80) - 1)
            os.close(master)

    def test_has_nothing_else(self):
        with self.assertRaisesRegex(AttributeError, "module 'ratchet_sieve' has no attribute 'nonsense'"):
            import ratchet_sieve
            ratchet_sieve.nonsense
