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
TYPED = ("__init__.pyi", "_engine.pyi", "arguments.py", "bags.py", "errors.py", "goals.py", "progress.py", "runs.py", "scene.py",
         "simulation.py", "sweeps.py", "values.py")


def names_of(stub):
    """The names that a stub exports or defines."""
    body = ast.parse((SOURCES / stub).read_text(encoding="utf-8")).body
    names = {alias.asname for line in body if isinstance(line, ast.ImportFrom) for alias in line.names if alias.asname}
    names |= {line.name for line in body if isinstance(line, (ast.ClassDef, ast.FunctionDef))}
    return names | {line.target.id for line in body if isinstance(line, ast.AnnAssign)}


def test_the_stub_has_the_names_of_the_package():
    there = {name for name in rs._SUBMODULES if importlib.util.find_spec(f"ratchet_sieve.{name}")}
    assert names_of("__init__.pyi") == {*rs._NAMES, *there}


def test_the_stub_of_the_engine_has_its_names():
    engine = importlib.import_module("ratchet_sieve._engine")
    there = {name for name in dir(engine) if not name.startswith("_")} | {"__version__"}
    assert names_of("_engine.pyi") == there


@pytest.mark.parametrize("name", ("Scene", "Simulation"))
def test_the_stub_of_the_engine_has_the_members_of_its_classes(name):
    stub = ast.parse((SOURCES / "_engine.pyi").read_text(encoding="utf-8"))
    of_stub = next(line for line in stub.body if isinstance(line, ast.ClassDef) and line.name == name)
    there = {member for member in vars(getattr(importlib.import_module("ratchet_sieve._engine"), name))
             if not member.startswith("_")}
    assert {line.name for line in of_stub.body} - {"__init__"} == there


@pytest.mark.skipif(not shutil.which("mypy"), reason="mypy is not installed")
def test_the_types_are_consistent(tmp_path):
    checked = subprocess.run(["mypy", "--config-file", HERE / "mypy.ini", "--cache-dir", tmp_path,
                              *(f"ratchet_sieve/{name}" for name in TYPED)], cwd=SOURCES.parent, capture_output=True,
                             text=True)
    assert checked.returncode == 0, checked.stdout + checked.stderr
