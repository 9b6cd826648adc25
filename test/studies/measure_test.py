"""Trivial jobs through scripts/measure's program."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import measure

PROGRAM = pathlib.Path(measure.__file__)
JOBS = """
first: echo one >> {0}/ran
second: echo two >> {0}/ran; {1}
third: echo three >> {0}/ran
"""


class Measure(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.directory = pathlib.Path(scratch.name)

    def measure(self, second, *options):
        """@return the exit status, and what ran since the last call"""
        jobs, ran = self.directory / "jobs.yaml", self.directory / "ran"
        jobs.write_text(JOBS.format(self.directory, second), encoding="utf-8")
        ran.write_text("", encoding="utf-8")
        done = subprocess.run(
            [sys.executable, str(PROGRAM), "--busy", "--jobs", str(jobs), "--folder", str(self.directory / "kept"),
             *options], capture_output=True, text=True, check=False, env=os.environ)
        self.said = done.stdout + done.stderr
        return done.returncode, ran.read_text(encoding="utf-8").split()

    def test_jobs_run_in_order_and_say_the_load(self):
        self.assertEqual(self.measure("true"), (0, ["one", "two", "three"]))
        self.assertIn("others use", self.said)
        record = json.loads((self.directory / "kept/first.json").read_text(encoding="utf-8"))
        self.assertEqual(record["status"], 0)
        self.assertIn("physics version", record["version"])

    def test_what_is_done_is_not_run_again(self):
        self.measure("true")
        self.assertEqual(self.measure("true")[0], 2)
        self.assertIn("3 of 3 jobs done: --continue keeps them", self.said)
        self.assertEqual(self.measure("true", "--continue"), (0, []))

    def test_a_failed_job_does_not_end_the_others_and_runs_again(self):
        self.assertEqual(self.measure("exit 3"), (1, ["one", "two", "three"]))
        self.assertIn("failed with 3", self.said)
        self.assertEqual(self.measure("true", "--continue"), (0, ["two"]))

    def test_an_interruption_loses_one_job(self):
        self.assertEqual(self.measure("kill -INT $PPID; sleep 60"), (130, ["one", "two"]))
        self.assertEqual(self.measure("true", "--continue"), (0, ["two", "three"]))

    def test_the_results_of_another_version_do_not_count(self):
        self.measure("true")
        path = self.directory / "kept/first.json"
        path.write_text(path.read_text(encoding="utf-8").replace("physics version ", "physics version 0"), "utf-8")
        self.assertEqual(self.measure("true", "--continue"), (0, ["one"]))

    def test_an_unknown_job_is_refused(self):
        self.assertEqual(self.measure("true", "--only", "fourth"), (2, []))
        self.assertIn("--only fourth: no such job; there are first, second, third", self.said)

    def test_the_jobs_of_the_project_name_files_that_are_there(self):
        import yaml
        root = PROGRAM.parent.parent
        for command in yaml.safe_load(PROGRAM.with_name("measurements.yaml").read_text(encoding="utf-8")).values():
            for word in command.split():
                if word.endswith((".py", ".md", ".yaml")) or word.startswith("scripts/"):
                    self.assertTrue((root / word).exists(), word)
