"""What mypy sees of the package is what is there."""
import ast
import importlib.util
import pathlib
import shutil
import subprocess

import pytest

import ratchet_sieve as rs

HERE = pathlib.Path(__file__).resolve().parent
SOURCES = HERE.parents[1] / "python/ratchet_sieve"
TYPED = ("__init__.pyi", "arguments.py", "bags.py", "errors.py", "goals.py", "progress.py", "runs.py", "scene.py",
         "simulation.py", "sweeps.py", "values.py")


def test_the_stub_has_the_names_of_the_package():
    stub = ast.parse((SOURCES / "__init__.pyi").read_text(encoding="utf-8"))
    there = {name for name in rs._SUBMODULES if importlib.util.find_spec(f"ratchet_sieve.{name}")}
    assert {alias.asname for line in stub.body if isinstance(line, ast.ImportFrom) for alias in line.names} == {
        *rs._NAMES, *there}


@pytest.mark.skipif(not shutil.which("mypy"), reason="mypy is not installed")
def test_the_types_are_consistent(tmp_path):
    checked = subprocess.run(["mypy", "--config-file", HERE / "mypy.ini", "--cache-dir", tmp_path,
                              *(f"ratchet_sieve/{name}" for name in TYPED)], cwd=SOURCES.parent, capture_output=True,
                             text=True)
    assert checked.returncode == 0, checked.stdout + checked.stderr
