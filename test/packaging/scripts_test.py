"""Scripts in a directory of the user's: what is there stays as it is, and is not run. They run in a checkout of them
alone, in which nothing is installed or built."""

import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

SCRIPTS = Path(__file__).resolve().parents[2] / 'scripts'


class Scripts(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.checkout = Path(folder.name) / 'checkout'
        self.own = Path(folder.name) / 'own'
        for directory in ('build', 'scripts'):
            (self.checkout / directory).mkdir(parents=True)
        for name in ('environment.sh', 'live', 'package'):
            shutil.copy(SCRIPTS / name, self.checkout / 'scripts')
        for name in ('build', 'setup'):
            (self.checkout / 'scripts' / name).symlink_to('/bin/true')
        self.own.mkdir()

    def output_of(self, script, *arguments):
        return subprocess.run([self.checkout / 'scripts' / script, *arguments], cwd=self.own, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True).stdout

    def test_package_removes_earlier_packages_alone(self):
        for name in ('mine', 'mine.deb', 'ratchet-sieve_1.0.0_amd64.deb', 'ros-ratchet-sieve_1.0.0_amd64.deb'):
            (self.own / name).touch()
        self.assertIn('cpack failed', self.output_of('package', '.'))  # nothing is built
        self.assertEqual(sorted(os.listdir(self.own)), ['mine', 'mine.deb'])

    def test_live_imports_nothing_of_the_users(self):
        package = self.checkout / 'devel/lib/python3/dist-packages/ratchet_sieve'
        package.mkdir(parents=True)
        (package / 'engine.wasm').touch()
        (package / 'pages.py').write_text('import random; print(random.__name__)')
        (self.own / 'random.py').write_text('print("the file of the user")')
        self.assertEqual(self.output_of('live'), 'random\n')


if __name__ == '__main__':
    unittest.main()
