"""calibrate(): what was measured, and which coefficients explain it."""
import dataclasses
import json
import subprocess

import numpy as np
import pandas
import pytest

import ratchet_sieve as rs
from conftest import program
from feeder import THETA
from ratchet_sieve import sweeps
from ratchet_sieve.answers.measured import Measured

E, MU = "species.0.restitution", "species.0.friction"
SCENE = {"base": {"teeth": 8, "frequency": 20.0}, "boundary": "open", "feed": {"rate": 40.0}, "duration": 4.0,
         "species": [{"name": "A", "radius": 0.0015, "density": 2500, "restitution": 0.5, "friction": 0.3}]}
UNKNOWN = {E: (0.4, 0.99)}
TRUTH = 0.9
ROW = {THETA: 0.1, "left.A": 30, "right.A": 50, "on_base.A": 20}


@pytest.fixture(scope="module")
def rows():
    """Counted at a feeder of the true restitution."""
    table = rs.sweep(rs.Scene(SCENE, {E: TRUTH, "duration": 8.0}), {THETA: [0.0, 0.2]}, seeds=[10 ** 9],
                     progress=False)
    return [{THETA: row[THETA], "duration": 8.0, "left.A": int(row["left.A"]), "right.A": int(row["right.A"]),
             "on_base.A": int(row["count.A"] - row["left.A"] - row["right.A"])} for _, row in table.iterrows()]


@pytest.fixture(scope="module")
def grains(rows):
    return rs.calibrate(SCENE, UNKNOWN, rows, over={THETA: (0.0, 0.3)}, progress=False)


def test_finds_the_coefficients_of_the_feeder(grains):
    found = grains[E]
    assert grains.agrees and grains.added < 0.5
    assert abs(found.value - TRUTH) < 1.5 * found.half_width and 0.0 < found.half_width < 0.2
    assert f"{E} {found} (95 %)" in str(grains) and "measured and computed agree" in str(grains)
    following = grains.next_measurement
    assert set(following.setting) == {THETA} and 0.0 < following.errors[E] < 1.0 and "measure next" in str(grains)


def test_goes_where_a_scene_goes_and_is_drawn(grains):
    assert rs.run(grains, progress=False).scene[E] == pytest.approx(grains[E].value, abs=1e-4)
    table = rs.sweep(grains, {THETA: [0.1]}, seeds=8, unknown=grains.unknown, progress=False)
    assert len(set(table[E])) == 8 and (table[E] - grains[E].value).abs().max() < 0.2
    assert len(grains.plot().figure.axes) == 2 and len(grains.table) == 4


def test_threads_and_a_file_of_runs_change_nothing(grains, rows, tmp_path):
    file = tmp_path / "rows.csv"
    pandas.DataFrame(rows).to_csv(file, index=False, sep=";", decimal=",")  # as in German Excel
    again = rs.calibrate(SCENE, UNKNOWN, file, threads=1, results=tmp_path / "runs.db", progress=False)
    assert again.draws.equals(grains.draws)


def test_what_no_coefficients_explain_is_refused(rows):
    wrong = [{**rows[0], "left.A": rows[0]["right.A"], "right.A": rows[0]["left.A"]}, rows[1]]
    found = rs.calibrate(SCENE, UNKNOWN, wrong, progress=False)
    assert not found.agrees and found[E].half_width is None
    assert "worst: the share of A that left to the left at base.inclination = 0" in str(found)
    with pytest.raises(ValueError, match="do not agree"):
        found.unknown


def test_intervals_hold_and_what_was_not_measured_is_left_open(monkeypatch):
    """With runs of known shares, which do not depend on the second key."""
    def of(keys, seed):
        drawn, e = np.random.default_rng(seed), keys[E]
        fed = drawn.poisson(800)
        deck = drawn.binomial(fed, 0.02 + 0.1 * e ** 2)
        left = drawn.binomial(fed - deck, 1.0 / (1.0 + np.exp(1.0 - 5.0 * keys[THETA] * e - np.sin(3.0 * e))))
        return {"left.A": left, "right.A": fed - deck - left, "on_base.A": deck}

    def swept(_, cases, **_options):
        rows = [of(case, case["seed"]) for case in cases]
        return pandas.DataFrame([{**row, "count.A": sum(row.values()), "simulated_time": 1.0} for row in rows])

    monkeypatch.setattr(sweeps, "sweep", swept)
    held = 0
    for seed, truth in enumerate(np.random.default_rng(2).uniform(0.4, 0.99, 8)):
        rows = [{THETA: angle, **of({E: truth, THETA: angle}, 10 ** 9 + 10 * seed + k)}
                for k, angle in enumerate((0.0, 0.2))]
        grains = rs.calibrate(SCENE, {**UNKNOWN, MU: (0.1, 0.5)}, rows, progress=False)
        found = grains[E]
        assert grains.agrees and found.half_width < 0.2
        assert f"{MU} 0.1 to 0.5, as before: the measurements tell hardly more" in str(grains)
        assert (grains[MU].value, grains[MU].half_width) == pytest.approx((0.3, 0.2))
        held += abs(found.value - truth) <= found.half_width
    assert held >= 6  # of 8, where 95 % hold on the average


@pytest.mark.parametrize("measured, line", (
    ([], "measured = []: must be the path of a CSV file or a bag"),
    ([3], "measured[0] = 3: must be a mapping"),
    ([{THETA: 0.1}], "measured, row 1: nothing was measured: give counts, such as left.A, right.A"),
    ([{**ROW, "left.A": -1}], "measured, row 1: left.A = -1: must be 0 or more"),
    ([ROW, {"left.A": 1}], "measured, row 2: left.A and right.A must be given, both"),
    ([{"left.A": 0, "right.A": 0}], "measured, row 1: no A was counted"),
    ([{"left.B": 1, "right.B": 1}], "measured, row 1: left.B: there is no such species; there are A"),
    ([{**ROW, "mean_vx.B": 0.1}], "measured, row 1: mean_vx.B: there is no such species; there are A"),
    ([{**ROW, "mean_vx.A": "x"}], "measured, row 1: mean_vx.A = 'x': must be a finite number"),
    ([{**ROW, "base.inclinatoin": 1}], "measured, row 1: neither a number of results nor a setting: "),
    ([{**ROW, "throughput": 2.0, "throughput.stderr": 0.0}], "measured, row 1: throughput.stderr = 0.0: must be above 0"),
    (pandas.DataFrame([[1, 2]]), "measured, row 1: 0: must be the name of a column"),
    ([{**ROW, "seed": 3}], "measured, row 1: seed: must not be set: each run has its own"),
    ([{**ROW, E: 0.9}], f"measured, row 1: {E}: must not be set: it is unknown"),
))
def test_what_was_measured_is_refused_in_one_line(measured, line):
    with pytest.raises(ValueError) as error:
        rs.calibrate(SCENE, UNKNOWN, measured)
    assert str(error.value).startswith(line)


def test_counts_are_shares_and_numbers_have_their_errors():
    data = Measured(rs.Scene(SCENE), [{**ROW, "mean_vx.A": 0.05, "mean_vx_stderr.A": 0.01, "throughput": 2.0,
                                       "throughput.stderr": 0.5}], [E])
    left, deck, speed, flow = data.numbers
    assert (left.value, deck.value) == (30 / 80, 20 / 100)
    assert left.variance == pytest.approx(0.375 * 0.625 / 80, rel=0.01)
    assert (speed.value, speed.variance, flow.variance) == (0.05, 1e-4, 0.25)
    assert data.settings == [{THETA: 0.1}] and "the share of A still on the deck" in str(data)


def test_tables_are_read_as_they_are_meant(tmp_path):
    """With keys in the index, as groupby() leaves them; nothing that left; and decimal commas between commas refused."""
    indexed = pandas.DataFrame([{THETA: 0.1, "left.A": 0, "right.A": 0, "on_base.A": 25}]).set_index(THETA)
    data = Measured(rs.Scene(SCENE), indexed, [E])
    assert data.settings == [{THETA: 0.1}] and [str(number) for number in data.numbers] == ["the share of A still on the deck"]
    (tmp_path / "tray.csv").write_text(f"{THETA},left.A,right.A\n0,1,30,50\n", encoding="utf-8")
    with pytest.raises(ValueError, match="decimal commas need semicolons"):
        Measured(rs.Scene(SCENE), tmp_path / "tray.csv", [E])


def test_a_bag_has_its_last_counts(tmp_path):
    pytest.importorskip("rosbag")
    scene = rs.Scene(SCENE)
    (tmp_path / "scene.yaml").write_text(scene.yaml, encoding="utf-8")
    run = subprocess.run([program("sieve_run"), "scene.yaml", "--bag", "run.bag", "--summary", "run.json"],
                         cwd=tmp_path, capture_output=True, text=True)
    if "this build has none" in run.stderr:
        pytest.skip("built without ROS")
    species = json.loads((tmp_path / "run.json").read_text())["species"][0]
    data = Measured(scene, tmp_path / "run.bag", [E, "base.amplitude"])
    assert data.settings == [{"duration": 4.0, THETA: 0.0, "base.frequency": 20.0}]
    assert data.numbers[0].value == species["left"] / (species["left"] + species["right"])
    assert data.numbers[1].value == pytest.approx(1.0 - (species["left"] + species["right"]) / species["count"])


def test_two_that_count_alike_cannot_be_told_apart(grains):
    both = np.random.default_rng(1).normal(size=500)
    pair = dataclasses.replace(grains, draws=pandas.DataFrame({E: 0.8 + 0.05 * both, MU: 0.3 - 0.1 * both}))
    assert f"of both only {E} + 0.5 {MU} = 0.95" in pair._together()[0]
