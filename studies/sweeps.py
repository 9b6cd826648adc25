"""Runs the sweeps of studies by sieve_sweep and reads their rows."""
import pathlib
import re
import resource
import subprocess
import sys
import tempfile

from ratchet_sieve.places import SHARE
from ratchet_sieve.tables import Refusal, read_rows
from ratchet_sieve.texts import counted

DIRECTORY = SHARE / "config/sweeps"


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
    """@param allowed exit statuses. @throws SweepFailed"""
    try:
        done = subprocess.run([str(program), *arguments], stdout=output or subprocess.DEVNULL,
                              stderr=None if output else subprocess.PIPE, text=True, check=False)
    except OSError as error:
        raise SweepFailed(f"{program}: {error.strerror}") from error
    if done.returncode not in allowed:
        said = (done.stderr or "").strip().splitlines()
        raise SweepFailed(said[-1] if said else f"sieve_sweep {arguments[0]} ended with {done.returncode}")


def processor_time():
    """Of all programs that were run and have ended [s]."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def rows_of(options, name):
    """Runs the cases of a sweep that have no result. @return its Rows"""
    print(f"{name}:", file=sys.stderr, flush=True)
    file = DIRECTORY / f"{name}.yaml"
    rows = export(options.program, file, options.results, options.jobs, options.draw_only, sys.stderr)
    # A missing case would not be seen in a picture.
    status = subprocess.run([str(options.program), "status", str(file), "--db", str(options.results)],
                            capture_output=True, text=True, check=True).stdout
    missing = int(re.search(r"(\d+) to go", status).group(1))
    if missing:
        raise SweepFailed(f"{counted(missing, 'case')} of {name} without a result in {options.results}"
                          + ("; run it without --draw-only" if options.draw_only else ""))
    return rows
