"""Measures machines by sieve_sweep, each once."""
import pathlib
import subprocess
import tempfile

import yaml

from ratchet_sieve.optimise.machine import changed, measured, read_scene, require_goal
from ratchet_sieve.reproduce.sweeps import SweepFailed
from ratchet_sieve.tables import read_rows


class Trials:
    def __init__(self, program, results, jobs, search):
        self.program, self.results, self.jobs, self.search = program, results, jobs, search
        self.scene = changed(read_scene(search.scene), search.settings)
        self.version = None  # of the program that made the results

    def measure(self, machines, seeds):
        """@param machines all with the same keys. @return their results, in their order"""
        sweep = {"scene": self.search.scene, "set": self.search.settings,
                 "cases": [machine.values for machine in machines],
                 "seed": {"first": seeds.first, "count": seeds.count}}
        with tempfile.TemporaryDirectory() as directory:
            file = pathlib.Path(directory) / "machines.yaml"
            file.write_text(yaml.safe_dump(sweep, sort_keys=False), encoding="utf-8")
            table = file.with_suffix(".csv")
            common = [str(file), "--db", str(self.results)]
            # A machine whose run fails is not allowed: the search goes on.
            self.call(["run", *common, "--threads", str(self.jobs)], (0, 1))
            self.call(["export", *common, "--out", str(table)], (0,))
            rows = read_rows(table)
        if rows:
            require_goal(self.search.goal, rows, self.search.path)
            self.version = f"{rows[-1]['version']}, physics version {rows[-1]['physics']:g}"
        return [measured(rows.where(machine.values), self.scene, machine, seeds, self.search.goal)
                for machine in machines]

    def call(self, arguments, allowed):
        process = subprocess.run([str(self.program), *arguments], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                                 text=True, check=False)
        if process.returncode not in allowed:
            raise SweepFailed(process.stderr.strip().splitlines()[-1] if process.stderr.strip()
                              else f"sieve_sweep {arguments[0]} ended with {process.returncode}")
