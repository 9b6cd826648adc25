"""Goals of a search and of a reward, against counts worked out by hand and the scatter of many windows."""
import numpy as np
import pytest

from ratchet_sieve import _engine
from ratchet_sieve.goals import LEFT, LEFT_MASS, ON_BASE, RIGHT, RIGHT_MASS, Goal

NAMES = ["A", "B"]
# In 20 s 30 of A (10 g) and 10 of B (1 g) fell to the left, 20 of A and 40 of B to the right.
KNOWN = [[30, 20, 5, 0.3, 0.2], [10, 40, 6, 0.01, 0.04]]


def measured(text, bins, duration=20.0, species=NAMES):
    found = Goal(text, species).measured(np.array([bins], dtype=float), np.array([duration]))
    return tuple(column.item() for column in found)


def test_the_columns_are_those_of_the_engine():
    assert [_engine.BIN_FIELDS[k] for k in (LEFT, RIGHT, ON_BASE, LEFT_MASS, RIGHT_MASS)] == [
        "left", "right", "on_base", "left_mass", "right_mass"]


@pytest.mark.parametrize("text, value", [
    ("quality", 30 / 50 - 10 / 50),
    ("purity:A:left", 30 / 40), ("purity:A:left:mass", 0.3 / 0.31), ("purity:B:right", 40 / 60),
    ("recovery:A:left", 30 / 50), ("recovery:B:right:mass", 0.04 / 0.05),
    ("flow:A:right", 1.0), ("flow:A:right:mass", 0.01), ("throughput", 5.0), ("throughput:mass", 0.55 / 20.0)])
def test_a_goal_is_measured_by_number_and_by_mass(text, value):
    assert measured(text, KNOWN)[0] == pytest.approx(value, rel=1e-12)


def test_a_species_may_have_any_name():
    assert measured("purity:fine: dust:left", KNOWN, species=["fine: dust", "B"])[0] == 0.75
    assert measured("purity:mass:right", KNOWN, species=["mass", "B"])[0] == pytest.approx(1.0 / 3.0)


@pytest.mark.parametrize("text", [
    "", "Q", "quality:mass", "quality:A:left", "purity", "purity:A", "purity:left", "purity::left", "purity:A:up",
    "purity:A:left:", "purity:A:left:weight", "throughput:A:left", ":mass", "throughput:"])
def test_another_text_is_refused(text):
    with pytest.raises(ValueError, match=f"{text}: must be quality, purity:SPECIES:BIN"):
        Goal(text, NAMES)


def test_quality_is_of_the_pair_with_the_highest():
    three = [[50, 50, 0, 0, 0], [40, 60, 0, 0, 0], [100, 0, 0, 0, 0]]
    assert measured("quality", three, species=["A", "B", "C"])[0] == pytest.approx(0.6)


def test_of_nothing_a_goal_is_undefined():
    right_only = [[0, 20, 5, 0.0, 0.2], [0, 0, 6, 0.0, 0.0]]
    for text in ("quality", "purity:A:left", "recovery:B:left"):
        assert measured(text, right_only) == (0.0, 0.0, False)
    assert measured("throughput", np.zeros((2, 5))) == (0.0, 0.0, False)
    assert measured("quality", [KNOWN[0]], species=["A"]) == (0.0, 0.0, False)
    value, error, defined = measured("flow:B:right:mass", right_only)
    assert value == 0.0 and defined and error > 0.0  # none in 20 s, but perhaps in 40 s


@pytest.mark.parametrize("text", ["purity:A:left", "recovery:A:left", "recovery:A:left:mass"])
def test_of_all_a_goal_is_still_in_doubt(text):
    value, error, _ = measured(text, [[10, 0, 0, 0.1, 0.0], [0, 10, 0, 0.0, 0.01]])
    assert value == 1.0 and error > 0.05


@pytest.mark.parametrize("text", ["quality", "purity:A:left", "purity:A:left:mass", "purity:B:left:mass", "recovery:A:left:mass",
                                  "flow:B:right:mass", "throughput:mass", "throughput"])
def test_the_error_is_that_of_disks_that_leave_independently(text):
    counts = np.random.default_rng(1).poisson([[300, 200], [100, 400]], (20000, 2, 2)).astype(float)
    bins = np.zeros((20000, 2, 5))
    bins[..., (LEFT, RIGHT)] = counts
    bins[..., (LEFT_MASS, RIGHT_MASS)] = counts * np.array([[0.01], [0.001]])
    value, error, _ = Goal(text, NAMES).measured(bins, np.full(20000, 20.0))
    assert error.mean() / value.std() == pytest.approx(1.0, abs=0.05)
