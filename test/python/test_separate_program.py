"""sieve_separate: the program of separate()."""
import contextlib
import json
import os
import pathlib
import re
import shutil
import signal
import sqlite3
import subprocess
import sys

import pytest

import ratchet_sieve as rs
from feeder import SCENE, THETA


def program(*arguments, cwd):
    return subprocess.run([sys.executable, "-m", "ratchet_sieve.answers", *arguments], cwd=cwd, capture_output=True,
                          text=True)


def test_the_program_answers_as_the_function_does_with_the_runs_that_are_kept(answer, runs, tmp_path):
    kept = pathlib.Path(shutil.copy(runs, tmp_path / "feeder.separate.db"))
    (tmp_path / "feeder.yaml").write_text(rs.Scene(SCENE).yaml, encoding="utf-8")
    ran = program("feeder.yaml", "--over", f"{THETA}=0:0.4", "--within", "0.06", "--json", "answer.json", "--html", "answer.html",
                  "--plot", "answer.png", "--best", "best.yaml", cwd=tmp_path)
    assert ran.returncode == 0, ran.stderr
    assert ran.stdout.splitlines()[:2] == str(answer).splitlines()[:2]
    assert re.match(r"separate: each run is [0-9.]+ s long: about ", ran.stderr.splitlines()[0])
    assert ran.stderr.splitlines()[1:] == [
        "sieve_separate: the runs are kept in feeder.separate.db; the same command continues"]
    written = json.loads((tmp_path / "answer.json").read_text(encoding="utf-8"))
    assert written["best"] == answer.best and written["separation"]["value"] == answer.separation.value
    assert rs.Scene.load(tmp_path / "best.yaml")[THETA] == answer.best[THETA]
    assert (tmp_path / "answer.png").stat().st_size > 10_000
    assert str(answer).splitlines()[0] in (tmp_path / "answer.html").read_text(encoding="utf-8")
    assert len(rs.read_sweep(kept)) == len(rs.read_sweep(runs))
    (tmp_path / "answer.json").unlink()
    for output, reason in ((subprocess.DEVNULL, ""), (open("/dev/full", "w"), "No space left on device"),
                           (closed_pipe(), "Broken pipe")):
        ran = subprocess.run([sys.executable, "-m", "ratchet_sieve.answers", "feeder.yaml", "--over", f"{THETA}=0:0.4",
                              "--within", "0.06", "--json", "answer.json"], cwd=tmp_path, stdout=output,
                             stderr=subprocess.PIPE, text=True)
        assert ran.stderr.splitlines()[2:] == [f"sieve_separate: standard output: {reason}"] * bool(reason)
        assert ran.returncode == bool(reason) and json.loads((tmp_path / "answer.json").read_text(encoding="utf-8"))
        (tmp_path / "answer.json").unlink()


def closed_pipe():
    """The end for writing of a pipe that nobody reads."""
    end, other = os.pipe()
    os.close(end)
    return os.fdopen(other, "w")


SIGNALLED = """
import os, sys
from ratchet_sieve.answers import final
from ratchet_sieve.answers.machine import Machine
from ratchet_sieve.recommended import run

whole, budgets, number = Machine.run, [], int(sys.argv.pop(1))

def signalled(*arguments, **options):
    budgets.append(options.pop("budget"))
    if len(budgets) > 3:  # in the search; once more in the fresh runs
        options["progress"] = lambda *_: os.kill(os.getpid(), number)
    assert len(budgets) < 5 or budgets[-1] <= final.AFTER_INTERRUPT
    return whole(*arguments, **options)

Machine.run, final.OF_INTERRUPTED = signalled, 1e9
run("ratchet_sieve.answers", "sieve_separate")
"""


@pytest.mark.parametrize("number", (signal.SIGTERM, signal.SIGHUP))
def test_the_program_answers_at_a_signal_when_standard_error_is_gone(number, tmp_path):
    (tmp_path / "feeder.yaml").write_text(rs.Scene(SCENE).yaml, encoding="utf-8")
    ran = subprocess.run([sys.executable, "-c", SIGNALLED, str(int(number)), "feeder.yaml", "--over", f"{THETA}=0:0.4",
                          "--json", "answer.json"], cwd=tmp_path, stdout=subprocess.DEVNULL, stderr=closed_pipe(),
                         preexec_fn=lambda: signal.signal(number, signal.SIG_DFL))  # also under nohup
    assert ran.returncode == 0
    assert json.loads((tmp_path / "answer.json").read_text(encoding="utf-8"))["separation"]["count"] > 1
    with contextlib.closing(sqlite3.connect(tmp_path / "feeder.separate.db")) as kept:
        assert kept.execute("SELECT COUNT(*) FROM under_way").fetchone() == (0,)


@pytest.mark.parametrize("arguments, status, line", (
    (("none.yaml", "--over", f"{THETA}=0:0.4"), 2, "none.yaml"),
    (("feeder.yaml", "--over", THETA), 2, "must be KEY=FROM:TO"),
    (("feeder.yaml",), 2, "--over"),
    (("feeder.yaml", "--over", f"{THETA}=0:0.4", "--over", f"{THETA}=0:0.3"), 2, "is there twice"),
    (("feeder.yaml", "--over", f"{THETA}=0:0.4", "--html", "none/answer.html"), 2, "there is no such directory"),
    (("feeder.yaml", "--over", f"{THETA}=0:0.4", "--unknown", "species.0.restitution=0.5±0.2.1"), 2,
     "--unknown species.0.restitution=0.5±0.2.1: must be"),
    (("feeder.yaml", "--over", f"{THETA}=0:0.4", "--plot", "answer.xyz"), 2, "must end in .png or .svg or .pdf"),
    (("feeder.yaml", "--over", f"{THETA}=0:0.4", "--best", "./feeder.yaml"), 2,
     "--best feeder.yaml: is the file of the scene; must be another one"),
    (("feeder.yaml", "--over", f"{THETA}=0:0.4", "--best", "a", "--db", "../" * 20 + "{here}/a"), 2,
     "--best a: is the file of --db; must be another one"),
))
def test_the_program_refuses_bad_arguments(arguments, status, line, tmp_path):
    (tmp_path / "feeder.yaml").write_text(rs.Scene(SCENE).yaml, encoding="utf-8")
    ran = program(*(each.format(here=tmp_path) for each in arguments), cwd=tmp_path)
    assert ran.returncode == status and line in ran.stderr and not (tmp_path / "feeder.separate.db").exists()
