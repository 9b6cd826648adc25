"""Runs the sweeps of studies by sieve_sweep and reads their rows."""
import math
import pathlib
import re
import resource
import subprocess
import sys
import tempfile

import yaml

from ratchet_sieve.places import SHARE
from ratchet_sieve.tables import Refusal, Rows, read_rows
from ratchet_sieve.texts import counted

DIRECTORY = SHARE / "config/sweeps"
QUICK_SEEDS = 3   # --quick runs a quarter of the seeds, and so many at least
QUICK_VALUES = 4  # of a key with more values than these, every second one


class SweepFailed(Refusal):
    """What sieve_sweep says."""


def run_program(name, work):
    """Does a program's work. An error is one line."""
    try:
        work()
    except Refusal as refusal:
        sys.exit(f"{name}: {refusal}")
    except OSError as error:
        sys.exit(f"{name}: {error.filename}: {error.strerror}")
    except KeyboardInterrupt:
        sys.exit(130)


def export(program, definition, results, jobs, draw_only=False, output=None):
    """Runs the cases of a sweep that have no result, and reads all.
    @param definition its file. @param output where sieve_sweep says how far it is; None: nowhere
    @return Rows; failed cases are counted, and do not end the program. @throws SweepFailed"""
    common = [str(definition), "--db", str(results)]
    if not draw_only:
        call(program, ["run", *common, "--threads", str(jobs)], (0, 1), output)
    with tempfile.TemporaryDirectory() as directory:
        table = pathlib.Path(directory) / "rows.csv"
        call(program, ["export", *common, "--out", str(table)], (0,), output)
        return read_rows(table)


def call(program, arguments, allowed, output):
    """@return the exit status, one of those allowed. @throws SweepFailed"""
    try:
        done = subprocess.run([str(program), *arguments], stdout=output or subprocess.DEVNULL,
                              stderr=None if output else subprocess.PIPE, text=True, check=False)
    except OSError as error:
        raise SweepFailed(f"{program}: {error.strerror}") from error
    if done.returncode not in allowed:
        said = (done.stderr or "").strip().splitlines()
        raise SweepFailed(said[-1] if said else f"sieve_sweep {arguments[0]} ended with {done.returncode}")
    return done.returncode


def processor_time():
    """Of all programs that were run and have ended [s]."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


class Runner:
    """The rows of each sweep, which is run once: studies may share one."""

    def __init__(self, options):
        self.options = options
        self.rows = {}

    def rows_of(self, sweep):
        """Runs its cases without a result."""
        if self.options.quick and not sweep.is_quick:
            return Rows()
        if sweep.name not in self.rows:
            with tempfile.TemporaryDirectory() as directory:
                self.rows[sweep.name] = self.run(self.file_of(sweep, pathlib.Path(directory)), sweep.name)
        return self.rows[sweep.name]

    def file_of(self, sweep, directory):
        path = DIRECTORY / f"{sweep.name}.yaml"
        if not self.options.quick:
            return path
        quick = quick_definition(yaml.safe_load(path.read_text(encoding="utf-8")), sweep.needed)
        if isinstance(quick["scene"], str):
            quick["scene"] = str((DIRECTORY / quick["scene"]).resolve())
        file = directory / path.name
        file.write_text(yaml.safe_dump(quick, sort_keys=False), encoding="utf-8")  # the last key varies fastest
        return file

    def run(self, file, name):
        print(f"{name}:", file=sys.stderr, flush=True)
        options = self.options
        rows = export(options.program, file, options.results, options.jobs, options.draw_only, sys.stderr)
        # A missing case would not be seen in a picture.
        status = subprocess.run([str(options.program), "status", str(file), "--db", str(options.results)],
                                capture_output=True, text=True, check=True).stdout
        missing = int(re.search(r"(\d+) to go", status).group(1))
        if missing:
            raise SweepFailed(f"{counted(missing, 'case')} of {name} without a result in {options.results}"
                              + ("; run it without --draw-only" if options.draw_only else ""))
        return rows


def thinned(values, needed):
    if isinstance(values, dict):  # from, to, count
        step = (values["to"] - values["from"]) / (values["count"] - 1)
        values = [float(f"{values['from'] + k * step:.15g}") for k in range(values["count"])]
    if len(values) <= QUICK_VALUES:
        return values
    return [value for k, value in enumerate(values)
            if k % 2 == 0 or any(math.isclose(value, kept, abs_tol=1e-12) for kept in needed)]


def quick_definition(definition, needed):
    """A sweep's definition as --quick runs it: its cases are among those of the whole."""
    quick = dict(definition)
    if "grid" in definition:
        quick["grid"] = {key: thinned(values, needed.get(key, ())) for key, values in definition["grid"].items()}
    if "seed" in definition:
        seed = definition["seed"]
        quick["seed"] = {**seed, "count": min(seed["count"], max(QUICK_SEEDS, seed["count"] // 4))}
    return quick
