"""Runs the sweeps of a study by sieve_sweep and reads their rows."""
import pathlib
import subprocess
import sys
import tempfile

import yaml

from ratchet_sieve.places import SHARE
from ratchet_sieve.reproduce.costs import Costs, SweepFailed
from ratchet_sieve.reproduce.quick import quick_definition
from ratchet_sieve.tables import Rows, read_rows
from ratchet_sieve.texts import counted

DIRECTORY = SHARE / "config/sweeps"


class Runner:
    def __init__(self, program, results, jobs, is_quick, draw_only):
        self.program = program
        self.results = results
        self.jobs = jobs
        self.is_quick = is_quick
        self.draw_only = draw_only
        self.costs = Costs(results)
        self.rows = {}  # of each sweep that was run, as studies may share one

    def take(self, study):
        """Runs the cases without a result. @return rows of each sweep of the study"""
        return {sweep.name: self.rows_of(sweep) for sweep in study.sweeps}

    def rows_of(self, sweep):
        if self.is_quick and not sweep.is_quick:
            return Rows()
        if sweep.name not in self.rows:
            with tempfile.TemporaryDirectory() as directory:
                self.rows[sweep.name] = self.run(self.file_of(sweep, pathlib.Path(directory)), sweep.name)
        return self.rows[sweep.name]

    def file_of(self, sweep, directory):
        path = DIRECTORY / f"{sweep.name}.yaml"
        if not self.is_quick:
            return path
        definition = yaml.safe_load(path.read_text(encoding="utf-8"))
        quick = quick_definition(definition, sweep.needed)
        if isinstance(quick["scene"], str):
            quick["scene"] = str((DIRECTORY / quick["scene"]).resolve())
        file = directory / path.name
        file.write_text(yaml.safe_dump(quick, sort_keys=False), encoding="utf-8")  # the last key varies fastest
        return file

    def run(self, file, name):
        common = [str(file), "--db", str(self.results)]
        if not self.draw_only:
            print(f"{name}:", file=sys.stderr, flush=True)
            self.call(["run", *common, "--threads", str(self.jobs)], name, may_fail=True)
        table = file.parent / "rows.csv" if self.is_quick else pathlib.Path(f"{self.results}.{name}.csv")
        self.call(["export", *common, "--out", str(table)], name)
        rows = read_rows(table)
        table.unlink()
        self.require_all(rows, common, name)
        return rows

    def call(self, arguments, name, may_fail=False):
        """@param may_fail failed cases of a sweep do not end the program: they are counted"""
        try:
            code = self.costs.run(name, [str(self.program), *arguments], sys.stderr)
        except OSError as error:
            raise SweepFailed(f"{self.program}: {error.strerror}") from error
        if code == 2 or (code != 0 and not may_fail):
            raise SweepFailed(f"sieve_sweep {arguments[0]} {name} ended with {code}")

    def require_all(self, rows, common, name):
        """A missing case would not be seen in a picture."""
        listed = subprocess.run([str(self.program), "run", *common, "--dry-run"], capture_output=True, text=True,
                                check=True).stdout
        missing = len(listed.splitlines()) - len(rows) - rows.failed
        if missing:
            raise SweepFailed(f"{counted(missing, 'case')} of {name} without a result in {self.results}"
                              + ("; run it without --draw-only" if self.draw_only else ""))
