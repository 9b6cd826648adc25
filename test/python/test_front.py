"""front(): what nothing beats in both separation and throughput."""
import datetime
import json
import pathlib
import subprocess
import sys
from unittest import mock

import numpy as np
import optuna
import pandas
import pytest

import ratchet_sieve as rs
from feeder import SCENE, THETA, TWINS, changed
from ratchet_sieve import stats
from ratchet_sieve.answers import front
from ratchet_sieve.answers.machine import Machine

RANGES = {THETA: (0.0, 0.4), "feed.rate": (20.0, 60.0)}
START = [{THETA: 0.123}]


@pytest.fixture(scope="module")
def kept(tmp_path_factory):
    """A front of fewer runs than a user's, and the file that keeps them."""
    path = tmp_path_factory.mktemp("front") / "runs.db"
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(front, "PROMISING", 4)
        patch.setattr(front, "RUNS", 3)
        yield rs.front(SCENE, RANGES, trials=16, start=START, results=path), path


def test_a_front_is_what_nothing_beats_in_both(kept, tmp_path):
    found, path = kept
    pandas.testing.assert_frame_equal(found.table, rs.front(SCENE, RANGES, trials=16, start=START, results=path,
                                                                threads=1).table)
    assert len(found.tried) == 16 and len(found.table) > 1
    assert found.table.throughput.is_monotonic_increasing
    row = found.best_row(30.0)
    assert row["throughput"] >= 30.0
    assert row["lower"] == found.table.lower[found.table.throughput >= 30.0].max()
    assert found.scene(30.0)[THETA] == found.best(30.0)[THETA]
    assert found.best(1e4) is None
    with pytest.raises(ValueError, match="throughput = 10000"):
        found.scene(1e4)
    found.write(tmp_path / "front.png")
    found.write(tmp_path / "front.csv")
    assert len(pandas.read_csv(tmp_path / "front.csv")) == len(found.table)


def test_what_is_reported_of_a_front_comes_from_seeds_that_had_no_part_in_the_choice(kept):
    found, path = kept
    runs = rs.read_sweep(path)
    for row in found.table.to_dict("records"):
        own = runs[(runs[THETA] == row[THETA]) & (runs["feed.rate"] == row["feed.rate"])]
        own = own.sort_values(["seed", "duration"]).drop_duplicates("seed", keep="last")  # the last one had settled
        assert len(own) == 1 + 2 * front.RUNS
        steady = own["steady.separation.value"]
        assert abs(steady.tail(front.RUNS).mean()) == pytest.approx(row["value"])
        chose = steady.iloc[1:-front.RUNS]
        assert row["lower"] == pytest.approx(abs(chose.mean()) - stats.mean_of(chose).half_width())


def test_a_front_does_not_part_two_kinds_that_differ_by_name_alone(monkeypatch):
    monkeypatch.setattr(front, "RUNS", 6)
    machine = Machine(changed(species=TWINS), {THETA: (0.0, 0.2)})
    table = pandas.concat(front._measured(machine, np.array([[k / 9.0]]), 1000 * k + 1, {}) for k in range(10))
    parted = table.value > table.value_half_width
    assert parted.sum() <= 2  # 0.5 are expected at 95 %
    table = table[~parted].assign(lower=0.01)
    assert len(table) and front.Front(machine, table, table).best() is None


TOGETHER = """
import json, sys
import ratchet_sieve as rs
from ratchet_sieve.answers import front
front.PROMISING, front.RUNS = 2, 3
scene, ranges, storage = json.loads(sys.argv[1])
found = rs.front(scene, ranges, trials=8, storage=storage, progress=False)
print(json.dumps([len(found.tried), found.tried.to_json(), found.table.to_json()]))
"""


def test_two_processes_search_one_front(tmp_path):
    given = json.dumps([SCENE, RANGES, f"sqlite:///{tmp_path}/front.db"])
    both = [subprocess.Popen([sys.executable, "-c", TOGETHER, given], stdout=subprocess.PIPE, text=True) for _ in "12"]
    first, second = (json.loads(one.communicate()[0]) for one in both)
    assert first == second and first[0] == 8
    tried = pandas.DataFrame(json.loads(first[1]))
    assert not tried.duplicated([THETA, "feed.rate"]).any()


def test_a_dead_process_is_not_waited_for():
    class Trial:
        def __init__(self, state, age, duration=None):
            self.state, self.duration, self.user_attrs = type("State", (), {"name": state}), duration, {}
            self.datetime_start = datetime.datetime.now() - datetime.timedelta(seconds=age)

    running = [Trial("RUNNING", 10), Trial("RUNNING", 900)]
    assert front._under_way(running, 1.0) == []
    assert front._under_way(running, 100.0) == running[:1]
    assert front._under_way([Trial("COMPLETE", 1000, datetime.timedelta(seconds=100)), *running], 1.0) == running[:1]


@pytest.mark.parametrize("end, told", (("interrupted", "FAIL"), ("killed", "RUNNING")))
def test_a_front_goes_on_after_its_first_settings_were_cut_short(end, told, monkeypatch):
    call = {"trials": 8, "start": START, "storage": optuna.storages.InMemoryStorage(), "progress": False}
    with monkeypatch.context() as patch:
        patch.setattr(front, "_seen", mock.Mock(side_effect=KeyboardInterrupt))
        if end == "killed":
            patch.setattr(optuna.Study, "tell", mock.Mock())
        with pytest.raises(KeyboardInterrupt):
            rs.front(SCENE, RANGES, **call)
    study = optuna.load_study(study_name=None, storage=call["storage"])
    assert [trial.state.name for trial in study.trials] == [told] * 8
    if end == "killed":
        monkeypatch.setattr(front, "PATIENCE", 0.0)
    monkeypatch.setattr(front, "PROMISING", 2)
    monkeypatch.setattr(front, "RUNS", 3)
    tried = rs.front(SCENE, RANGES, **call).tried
    assert len(tried) == 8 and list(tried[THETA]).count(START[0][THETA]) == 1


def test_settings_that_are_tried_twice_have_their_own_values():
    found = rs.front(SCENE, {"base.teeth": (6, 9)}, trials=16)
    works = found.tried.dropna(subset=["value"])
    assert set(works["base.teeth"]) == {6, 7, 8, 9} and len(works) == 16
    assert (works.groupby("base.teeth").value.nunique() == 1).all() and works.value.nunique() == 4


def test_a_setting_that_fills_up_is_given_up(tmp_path):
    machine, path = Machine(SCENE, {THETA: (0.0, 0.36), "base.amplitude": (0.001, 0.002)}), tmp_path / "runs.db"
    places = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 0.5], [1.0, 1.0]])
    seen = front._seen(machine, places, 1.0, (1, 1), {"results": path})
    assert list(seen.why) == ["still filling", "", "", ""]
    assert list(rs.read_sweep(path).duration) == pytest.approx([machine.shortest] * 4, rel=1e-3)


def test_unbeaten_points_against_each_pair():
    values, throughputs = np.random.default_rng(1).integers(0, 6, (2, 40)).astype(float)
    beaten = {k for k in range(40) for other in range(40)
              if values[other] >= values[k] and throughputs[other] >= throughputs[k]
              and (values[other], throughputs[other]) != (values[k], throughputs[k])}
    assert set(front._unbeaten(values, throughputs)) == set(range(40)) - beaten


def test_a_front_begins_with_the_settings_that_are_given(kept):
    found, _ = kept
    assert found.tried[THETA][0] == 0.123 and found.tried["feed.rate"][0] == 60.0


@pytest.mark.parametrize("scene, start, message", [
    (changed(feed={"rate": 0.0}, density=1.0), [], "feed.rate"),
    (SCENE, [{THETA: 0.5}], "base.inclination = 0.5: must be 0 to 0.4"),
    (SCENE, [{"base.inclinatoin": 0.1}], "start: base.inclinatoin: must be one of base.inclination"),
    (SCENE, {THETA: 0.1}, "start = .base.inclination.: must be a mapping"),
])
def test_what_a_front_cannot_be_made_of(scene, start, message):
    with pytest.raises(ValueError, match=message):
        rs.front(scene, {THETA: (0.0, 0.4)}, start=start, trials=8)


def test_nothing_replaces_what_an_answer_is_made_from(kept, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    pathlib.Path("feeder.csv").write_text("time,species,radius,mass\n0.1,A,0.001,0.01\n", encoding="utf-8")
    pathlib.Path("feeder.html").write_text(json.dumps(changed(feed={"file": "feeder.csv"})), encoding="utf-8")
    found = front.Front(Machine("feeder.html", {THETA: (0.0, 0.4)}), kept[0].table, kept[0].tried)
    with pytest.raises(ValueError, match="^path ./feeder.csv: is the file of feed.file; must be another one$"):
        found.write("./feeder.csv")
    with pytest.raises(ValueError, match="^path feeder.html: is the file of the scene; must be another one$"):
        rs.run("feeder.html", frames=1).write("feeder.html")
    with pytest.raises(ValueError, match="is the file of the scene"):
        rs.live("feeder.html").write(tmp_path / "feeder.html")
