import pathlib
import sys
import tempfile
import unittest

from ratchet_sieve.reproduce.costs import Costs, SweepFailed


class KeptCosts(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.results = pathlib.Path(scratch.name) / "results.db"
        self.file = self.results.with_name("results.db.seconds.json")

    def test_are_read_again(self):
        self.assertIsNone(Costs(self.results).of("sweep"))
        costs = Costs(self.results)
        self.assertEqual(costs.run("sweep", ["true"], sys.stderr), 0)
        self.assertEqual(Costs(self.results).of("sweep"), costs.of("sweep"))
        self.assertEqual([path.name for path in self.results.parent.iterdir()], [self.file.name])

    def test_a_file_that_is_cut_off_is_named(self):
        for text in ('{"sweep": 1.0', "", "[]", '{"sweep": "long"}'):
            self.file.write_text(text, encoding="utf-8")
            with self.assertRaisesRegex(SweepFailed, f"^{self.file}: [^\\n]*$"):
                Costs(self.results)
