"""What is run on several threads where the system has none left."""
import contextlib
import ctypes

import numpy as np
import pytest

import ratchet_sieve as rs
from ratchet_sieve.env import SieveVectorEnv

LIBC = ctypes.CDLL(None)


@contextlib.contextmanager
def no_threads():
    """New threads get stacks for which no system has room."""
    before, large = (ctypes.create_string_buffer(64) for _ in range(2))  # pthread_attr_t
    LIBC.pthread_getattr_default_np(before)
    LIBC.pthread_attr_init(large)
    LIBC.pthread_attr_setstacksize(large, ctypes.c_size_t(1 << 46))
    LIBC.pthread_setattr_default_np(large)
    try:
        yield
    finally:
        LIBC.pthread_setattr_default_np(before)


def test_a_sweep_goes_on_with_the_threads_there_are(scene):
    with no_threads(), pytest.warns(rs.SieveWarning, match="1 thread of 8 could be started"):
        table = rs.sweep(scene, seeds=3, threads=8, progress=False)
    assert list(table["status"]) == ["done"] * 3


def test_an_environment_goes_on_with_the_threads_there_are(scene):
    def observed(threads):
        sieves = SieveVectorEnv(scene, 4, threads=threads, episode=2.0)
        sieves.reset(seed=1)
        return sieves.step(np.zeros((4, 1)))[0]
    with no_threads(), pytest.warns(rs.SieveWarning, match="1 thread of 4 could be started"):
        alone = observed(4)
    assert np.array_equal(alone, observed(1))
