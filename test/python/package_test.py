"""What `import ratchet_sieve` costs, and what it finds."""
import subprocess
import sys
import unittest

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

    def test_has_nothing_else(self):
        with self.assertRaisesRegex(AttributeError, "module 'ratchet_sieve' has no attribute 'nonsense'"):
            import ratchet_sieve
            ratchet_sieve.nonsense
