"""The best setting of a sweep, and what a check of the minimum rebound speed says."""
import collections
import math

import pytest

from ratchet_sieve.plots.findings import FLOOR, best_setting, findings_of, floor_lines, setting_of
from ratchet_sieve.plots.means import Limits
from ratchet_sieve.plots.sweep import write_each
from ratchet_sieve.tables import Rows

KEY = "base.inclination"
SWEEP = {"command": "sieve_run scene.yaml", "seeds": 3, "warnings": ["warning in every case: hot"]}
LIMITS = Limits(0.5, 50.0)


def rows_of(separations, processed=1.0, counted=200.0, inclination=0.0):
    return [{KEY: inclination, "arguments": f"--set {KEY}={inclination:g} --seed {seed}", "separation": separation,
             "quality": separation and abs(separation), "processed": processed, "counted": counted}
            for seed, separation in enumerate(separations, 1)]


@pytest.fixture
def cases():
    return [*rows_of([-0.95, -0.1, -0.15], inclination=0.0),
            *rows_of([-0.5, -0.6, -0.55], 0.9, 100.0, inclination=0.1),
            *rows_of([-0.3, -0.3, -0.3], inclination=0.2),
            *rows_of([-1.0, -1.0, -1.0], 1.0, 4.0, inclination=0.3),
            *rows_of([-0.9, -0.9, -0.9], 0.04, 100.0, inclination=0.4)]


def ended(cases):
    return collections.Counter(setting_of(case["arguments"]) for case in cases)


def best_of(cases, limits=LIMITS, of=None):
    found = best_setting(Rows(cases), ended(of or cases), 3, limits)
    return found and found[0].partition("=")[2]


def findings(cases, limits=LIMITS):
    return findings_of(Rows(cases), ended(cases), [KEY], SWEEP, limits)[0]


def test_the_best_setting_is_of_the_highest_mean_not_of_one_lucky_seed(cases):
    found = findings(cases)
    assert found["best"] == {
        "values": {KEY: "0.1"}, "quality": pytest.approx(0.55), "separation": pytest.approx(-0.55),
        "quality_stderr": pytest.approx(0.05 / math.sqrt(3)), "seeds": 3, "processed": pytest.approx(0.9),
        "counted": 100.0, "at_edge": [], "steady": None}
    assert found["lines"] == ["best mean Q 0.550 ± 0.029 over 3 seeds, P 0.90, 100 disks counted: "
                              "base.inclination=0.1", "warning in every case: hot"]


def test_the_sign_of_the_best_says_which_way(cases):
    for case in cases:
        case.update({"left.A": 1, "left.B": 2, "recovery.left.number.A": 0.2, "recovery.left.number.B": 0.75})
    assert findings(cases)["lines"][0].endswith("base.inclination=0.1; s -0.550: A goes to the right, B to the left")
    for case in cases:
        case.update({"recovery.left.number.A": 0.9, "separation": -case["separation"]})
    assert findings(cases)["lines"][0].endswith("; s +0.550: B goes more to the right, A more to the left")


def test_machines_with_a_feed_are_compared_once_they_have_filled(cases):
    steady = {"0.1": [-0.1] * 3, "0.2": [-0.2, -0.22, -0.24], "0": [0.9, None, None]}  # at 0 one run has filled it
    for case in cases:
        of_seed = steady.get(case["arguments"].split("=")[1].split()[0], [None] * 3)
        case["steady.separation.value"] = of_seed[int(case["arguments"][-1]) - 1]
        case["steady.quality.value"] = None if case["steady.separation.value"] is None else abs(case["steady.separation.value"])
    found = findings(cases)
    assert found["lines"][0] == (
        "best mean Q of the filled machine 0.220 ± 0.012 over 3 seeds (since the start 0.300 ± 0.000 over 3 seeds), "
        "P 1.00, 200 disks counted: base.inclination=0.2")
    assert found["best"]["steady"] == {"quality": pytest.approx(0.22), "separation": pytest.approx(-0.22),
                                       "quality_stderr": pytest.approx(0.02 / math.sqrt(3)), "seeds": 3}
    assert found["best"]["quality"] == pytest.approx(0.3)


def test_settings_of_few_disks_or_a_low_p_are_left_out(cases):
    assert best_of(cases, Limits(0.5, 0.0)) == "0.3"
    assert best_of(cases, Limits(0.0, 50.0)) == "0.4"
    found = findings(cases, Limits(0.0, 1000.0))
    assert (found["best"], found["lines"][0]) == (None, (
        "no best Q: no setting with all seeds completed has a mean P >= 0 and a mean of 1000 counted disks "
        "(--least-processed, --least-counted)"))


def test_settings_that_are_not_done_are_left_out_and_cases_that_failed(cases):
    without = cases[:4] + cases[5:]
    assert best_of(without) == "0"
    assert best_of(without[1:]) == "0.2"
    assert best_of(without, of=cases) == "0.1"  # the missing one has failed


def test_the_edge_of_the_grid_is_told_and_one_seed_has_no_error(cases):
    for case in cases:
        if not case["arguments"].endswith("--seed 1"):
            case["separation"] = case["quality"] = None
    assert findings(cases)["lines"][0] == (
        "best mean Q 0.950 over 1 seed (error unknown), P 1.00, 200 disks counted: base.inclination=0; at the grid's "
        "edge in base.inclination")


def test_what_may_be_chance_is_not_separated(cases):
    for case in cases:
        case["separation"] *= 2 - int(case["arguments"][-1])
    assert findings(cases)["lines"][0].startswith(
        "not separated: the interval of 95 % contains 0 even at the largest mean Q, 0.")


def test_means_at_two_floors_are_compared_by_students_t():
    def at(mean, error):
        step = error * math.sqrt(3.0)  # of four seeds
        return Rows(rows_of([mean - step, mean - step, mean + step, mean + step]))

    # Student's t with 3 degrees of freedom is 3.182: 3.182 sqrt(0.03^2 + 0.04^2) = 0.159
    lines, found = floor_lines([(0.05, at(0.6, 0.03)), (0.0125, at(0.4, 0.04))])
    assert lines[-1] == f"quality changes by -0.2 ± 0.16 from 0.05 to 0.0125 m/s: it depends on {FLOOR} " \
                        "(half-width of 95 %)"
    assert found[1] == {"min_rebound_speed": 0.0125, "quality": pytest.approx(0.4),
                        "quality_stderr": pytest.approx(0.04), "seeds": 4}
    lines, found = floor_lines([(0.05, at(0.6, 0.03)), (0.0125, Rows())])
    assert lines[1:] == [f"best setting at {FLOOR} = 0.0125 m/s: Q not defined",
                         f"no error is known, so a dependence on {FLOOR} cannot be tested"]


def test_files_after_one_that_cannot_be_written_are_written(capsys):
    written = []

    def fail():
        raise OSError(28, "No space left on device", "map.png")

    with pytest.raises(SystemExit) as end:
        write_each("report", [fail, lambda: written.append(1), fail])
    assert (end.value.code, written) == (1, [1])
    assert capsys.readouterr().err == 2 * "report: map.png: No space left on device\n"
