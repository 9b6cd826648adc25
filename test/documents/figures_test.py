#!/usr/bin/python3
"""ratchet_sieve.documents on documents of a few lines."""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

from ratchet_sieve.documents import write_figures

FIGURES = {"date": "2026-11-22", "version": "0.1.0", "machine": "two cores", "speed": "1.6", "q": "0.526 ± 0.001",
           "drift": "-5.6"}


class Figures(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.root = pathlib.Path(directory.name)
        write_figures(self.root / "docs/data/study.json", FIGURES)

    def check(self, text, *options):
        """@return exit status, error lines, and the document afterwards"""
        document = self.root / "docs/page.md"
        document.write_text(text, encoding="utf-8")
        done = subprocess.run([sys.executable, "-m", "ratchet_sieve.documents", "--root", self.root, *options], text=True,
                              stderr=subprocess.PIPE, check=False)
        return done.returncode, done.stderr, document.read_text(encoding="utf-8")

    def assert_refused(self, text, message):
        code, errors, after = self.check(text)
        self.assertEqual(code, 1)
        self.assertEqual(len(errors.splitlines()), 1, errors)
        self.assertIn(message, errors)
        self.assertEqual(after, text)

    def assert_updated(self, text, expected):
        self.assertEqual(self.check(text, "--update"), (0, "", expected))

    def test_takes_what_the_study_says(self):
        text = "By 1.6<!--study:speed-->, on two cores<!--study:machine-->; Q = 0.526 ± 0.001<!--study:q-->\n"
        self.assertEqual(self.check(text), (0, "", text))

    def test_refuses_a_stale_figure(self):
        self.assert_refused("One.\nBy 1.8<!--study:speed--> times\n", "page.md:2: study:speed is 1.6")

    def test_refuses_a_figure_that_only_ends_alike(self):
        for wrong in ("11.6", "0.1.6", "-1.6", "−1.6"):
            self.assert_refused(f"{wrong}<!--study:speed-->\n", "study:speed is 1.6")

    def test_refuses_an_unknown_study(self):
        self.assert_refused("1.6<!--studies:speed-->\n", "page.md:1: studies:speed: there is no docs/data/studies.json")

    def test_refuses_an_unknown_key(self):
        self.assert_refused("1.6<!--study:sped-->\n", "page.md:1: study:sped: docs/data/study.json has no such key")

    def test_updates_a_figure_whatever_its_old_form(self):
        self.assert_updated("By 1.81<!--study:speed-->, 0.75<!--study:q-->\n",
                            "By 1.6<!--study:speed-->, 0.526 ± 0.001<!--study:q-->\n")
        self.assert_updated("(0.75 ± 0.1<!--study:q-->)", "(0.526 ± 0.001<!--study:q-->)")
        self.assert_updated("0.75 ± 0.1<!--study:speed-->", "1.6<!--study:speed-->")
        self.assert_updated("of 5.5<!--study:drift-->", "of -5.6<!--study:drift-->")
        self.assert_updated("2025-01-02<!--study:date-->", "2026-11-22<!--study:date-->")

    def test_says_where_it_cannot_update(self):
        code, errors, _ = self.check("fast<!--study:speed-->\n", "--update")
        self.assertEqual((code, len(errors.splitlines())), (1, 1))

    def test_writes_no_figures_without_their_origin(self):
        path = self.root / "docs/data/other.json"
        for wrong in ({"speed": "1.6"}, {**FIGURES, "speed": 1.6}, {**FIGURES, "Speed": "1.6"}):
            with self.assertRaises(ValueError):
                write_figures(path, wrong)
        self.assertFalse(path.exists())
        self.assertEqual(json.loads((self.root / "docs/data/study.json").read_text(encoding="utf-8")), FIGURES)


if __name__ == "__main__":
    unittest.main()
