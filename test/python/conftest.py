"""What the tests of the engine in Python share."""
import warnings

import pytest

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


@pytest.fixture
def scene():
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", rs.SieveWarning)
        return rs.Scene(SCENE)


@pytest.fixture
def layer(scene):
    """A ring, from which no disk leaves."""
    return scene.replace({"boundary": "periodic"})
