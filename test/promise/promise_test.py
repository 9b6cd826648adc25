"""Holds docs/promise.md to the files and names that write_files.py has written of earlier versions, in folders here."""
import csv
import json
import math
import shutil
import sqlite3
import subprocess
from pathlib import Path

import pytest
import yaml

import ratchet_sieve as rs
from write_files import PROGRAMS, bag_results, output, scene_values, write

UNSTABLE = ("version", "physics", "wall_time", "host", "warnings", "warning_text", "plan")  # values that are not kept


class Version:
    """The files of a version: paths by their names, names and results."""

    def __init__(self, folder):
        subprocess.run(["gzip", "-d", *folder.glob("*.gz")], check=True)
        self.folder = folder
        self.names = yaml.safe_load((folder / "names.yaml").read_text())
        self.results = json.loads((folder / "results.json").read_text())

    def __truediv__(self, name):
        return self.folder / name


@pytest.fixture(scope="module")
def now(tmp_path_factory):
    """Of the version that is built."""
    folder = tmp_path_factory.mktemp("now") / "files"
    write(folder)
    return Version(folder)


@pytest.fixture(params=sorted(path.parent for path in Path(__file__).parent.glob("*/names.yaml")),
                ids=lambda folder: folder.name)
def old(request, tmp_path):
    return Version(shutil.copytree(request.param, tmp_path / "old"))


def lost(old, new, values=True, path=""):
    """What `new` lacks of `old`, and what has another value there. Lists of texts are in no order; private names are not
    promised."""
    if isinstance(old, dict):
        return [line for key, value in old.items() for line in (
            lost(value, new[key], values and key not in UNSTABLE, f"{path}/{key}") if key in (new or {}) else
            [f"{path}/{key}"])]
    if isinstance(old, list) and all(isinstance(each, str) for each in old):
        gone = sorted({*old} - {*(new or ())})
        return [f"{path}: {each}" for each in gone if not each.startswith("_")] * values
    if isinstance(old, list):
        differ = [line for k, each in enumerate(zip(old, new or ())) for line in lost(*each, values, f"{path}/{k}")]
        return differ + [f"{path}: {new} in place of {old}"] * (values and len(old) != len(new or ()))
    same = math.isclose(old, new, rel_tol=1e-9) if isinstance(old, float) and isinstance(new, float) else old == new
    return [f"{path}: {new} in place of {old}"] * (values and not same)


def same_physics(old, now):
    return old.names["physics"] == now.names["physics"]


def test_names_are_kept(old, now):
    assert lost({**old.names, "calls": {}}, now.names) == []


def test_calls_of_python_are_kept(old, now):
    new = now.names["calls"]
    for name, parameters in old.names.get("calls", {}).items():
        assert name in new
        for parameter, place in (parameters or {}).items():
            assert new[name].get(parameter, "").startswith(place), f"{parameter} of {name}"
        if parameters is not None:
            assert {of for of, place in new[name].items() if place[-1] not in "=."} <= {*parameters}, name


def test_scenes_mean_the_same(old):
    assert lost(old.results["scenes"], scene_values(old.folder)) == []


def test_summary_has_its_fields(old, now):
    summary = json.loads(output("sieve_run", old / "machine.yaml"))
    assert lost(old.results["summary"], summary, same_physics(old, now)) == []


def test_bag_is_read(old, tmp_path):
    assert lost(old.results["bag"], bag_results(old / "run.bag", tmp_path)) == []


def test_bag_is_run_again(old, now):
    if not same_physics(old, now):
        pytest.skip("of another physics version")
    assert "the same, bit for bit" in output("sieve_resimulate", old / "run.bag")


def test_results_file_is_read_and_no_case_runs_again(old, now):
    def rows():
        with sqlite3.connect(old / "sweep.db") as results:
            return results.execute("SELECT run_hash, wall_time FROM cases").fetchall()

    def cases(file):
        return list(csv.DictReader(file.open(newline="")))

    before = rows()
    assert len(rs.read_sweep(old / "sweep.db")) == len(before)
    if not same_physics(old, now):
        assert f"{len(before)} results" in output("sieve_sweep", "status", old / "sweep.yaml")
        return
    for _ in range(2):
        assert f"{len(before)} done, 0 failed" in output("sieve_sweep", "status", old / "sweep.yaml")
        output("sieve_sweep", "export", old / "sweep.yaml", "--out", old / "now.csv")
        assert lost(cases(old / "cases.csv"), cases(old / "now.csv")) == []
        output("sieve_sweep", "run", old / "sweep.yaml")
    assert rows() == before


def test_checkpoint_is_resumed_in_its_minor_version_and_refused_elsewhere(old, now):
    done = subprocess.run([PROGRAMS / "sieve_run", old / "machine.yaml", "--resume", old / "run.checkpoint"],
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    versions = old.names["version"], now.names["version"]
    if len({version.rpartition(".")[0] for version in versions}) == 1:
        assert lost(old.results["summary"], json.loads(done.stdout)) == []
    else:
        assert done.returncode == 2
        assert 'its version is "{}", but this program\'s is "{}"'.format(*versions) in done.stderr.splitlines()[-1]
