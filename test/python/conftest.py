"""What the tests of the engine in Python share."""
import contextlib
import locale
import os
import resource
import shutil
import subprocess
import warnings

import pytest

import feeder
import ratchet_sieve as rs

SCENE = """
base: {teeth: 6}
boundary: open
species:
  - {name: A, count: 20, radius: 0.001, mass: 0.010}
  - {name: B, count: 20, radius: 0.002, mass: 0.001}
duration: 1.0
settle: 0.2
seed: 7
"""


def program(name):
    """The program of this build; skips where it is none of the environment's."""
    path = os.environ.get("RATCHET_SIEVE_PROGRAMS")
    found = shutil.which(name, path=path) if path else None
    if not found:
        pytest.skip(f"{name}: RATCHET_SIEVE_PROGRAMS does not name where it is")
    return found


@pytest.fixture
def scene():
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", rs.SieveWarning)
        return rs.Scene(SCENE)


@pytest.fixture(scope="session")
def runs(tmp_path_factory):
    """The file that keeps the answer's runs."""
    return tmp_path_factory.mktemp("answer") / "runs.db"


@pytest.fixture(scope="session")
def answer(runs):
    return rs.separate(feeder.SCENE, {feeder.THETA: (0.0, 0.4)}, within=0.06, results=runs)


@pytest.fixture
def small_files():
    """A context in which no file gets longer than 100 bytes, as on a full disk."""
    @contextlib.contextmanager
    def limited():
        before = resource.getrlimit(resource.RLIMIT_FSIZE)
        resource.setrlimit(resource.RLIMIT_FSIZE, (100, before[1]))
        try:
            yield
        finally:
            resource.setrlimit(resource.RLIMIT_FSIZE, before)

    return limited()


@pytest.fixture
def decimal_comma(tmp_path):
    """A locale whose numbers have a comma where others have a point."""
    (tmp_path / "comma").write_text('LC_NUMERIC\ndecimal_point "<U002C>"\nthousands_sep "."\ngrouping 3\nEND LC_NUMERIC\n')
    subprocess.run(["localedef", "-c", "-i", tmp_path / "comma", tmp_path / "xx_XX"], stderr=subprocess.DEVNULL)
    before, path = locale.setlocale(locale.LC_NUMERIC), os.environ.get("LOCPATH")
    os.environ["LOCPATH"] = str(tmp_path)
    locale.setlocale(locale.LC_NUMERIC, "xx_XX")
    assert locale.localeconv()["decimal_point"] == ","
    yield
    locale.setlocale(locale.LC_NUMERIC, before)
    del os.environ["LOCPATH"]
    if path is not None:
        os.environ["LOCPATH"] = path


@pytest.fixture
def layer(scene):
    """A ring, from which no disk leaves."""
    return scene.replace({"boundary": "periodic"})
