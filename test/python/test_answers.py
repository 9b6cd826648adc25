"""separate(): the surface, the search, and what it answers."""
import dataclasses
import json

import numpy as np
import pandas
import pytest

import ratchet_sieve as rs
from feeder import SCENE, THETA, TWINS, changed
from ratchet_sieve import stats, tables
from ratchet_sieve.answers import answer as answer_module
from ratchet_sieve.answers import cost, final, intervals, search, stages
from ratchet_sieve.answers.machine import CUT, EMPTY, FILLING, LEAST_WORKING, Machine
from ratchet_sieve.answers.surface import OFFSET, Surface
from ratchet_sieve.plots.findings import best_setting, way_of
from ratchet_sieve.plots.means import Limits
from ratchet_sieve.texts import which_way


def data_of(page):
    """What a page's script shows."""
    return json.loads(page.partition(' id="data">')[2].partition("</script>")[0])


def test_a_surface_is_a_gaussian_process():
    generator = np.random.default_rng(1)
    places, variances = generator.random((12, 2)), np.full(12, 1e-4)
    values = np.sin(4.0 * places[:, 0]) * 0.2 + 0.1 * places[:, 1]
    surface = Surface(2)
    surface.fit(places, values, variances)
    amplitude, *lengths, excess = np.exp(surface._parameters)

    def matern(a, b):
        r = np.sqrt(5.0 * sum(((a[:, None, k] - b[None, :, k]) / lengths[k]) ** 2 for k in range(2)))
        return amplitude ** 2 * (1.0 + r + r ** 2 / 3.0) * np.exp(-r) + OFFSET ** 2

    inverse = np.linalg.inv(matern(places, places) + excess * np.diag(variances))
    there = generator.random((5, 2))
    found, variance, half = surface.at(there)
    across = matern(there, places)
    covariance = matern(there, there) - across @ inverse @ across.T
    np.testing.assert_allclose(found, across @ inverse @ values, atol=1e-6)
    np.testing.assert_allclose(variance, np.diag(covariance), rtol=1e-4, atol=1e-8)
    np.testing.assert_allclose(surface.covariance_with(there, half, 2), covariance[2], rtol=1e-4, atol=1e-7)
    truth = np.sin(4.0 * there[:, 0]) * 0.2 + 0.1 * there[:, 1]
    assert (np.abs(found - truth) < 4.0 * np.sqrt(variance) + 1e-3).all()


def test_more_runs_make_a_surface_surer_and_leave_it_where_it_is():
    surface, places = Surface(1), np.linspace(0.0, 1.0, 6)[:, None]
    surface.fit(places, 0.1 * places[:, 0], np.full(6, 1e-3))
    there = np.linspace(0.0, 1.0, 5)[:, None]
    value, before, half = surface.at(there)
    variances, half = surface.after(there, before, half, 2, 1e-3)
    more = Surface(1)
    more.__dict__.update(surface.__dict__, _places=np.vstack([places, there[2:3]]), _values=np.append(surface._values, value[2]),
                         _variances=np.append(surface._variances, 1e-3))
    more._condition()
    expected = more.at(there)
    assert variances == pytest.approx(expected[1], rel=1e-6) and (variances < before).all()
    assert surface.covariance_with(there, half, 0) == pytest.approx(more.covariance_with(there, expected[2], 0), abs=1e-9)
    assert expected[0] == pytest.approx(value, abs=1e-9)


@pytest.mark.parametrize("over, changes, line", (
    ({THETA: (0.2, 0.2)}, {}, "over['base.inclination'] = 0.2 to 0.2: must have a width: from below to"),
    ({THETA: 0.2}, {}, "over['base.inclination'] = 0.2: must be a pair (from, to)"),
    ({THETA: (0.0, "a")}, {}, "over['base.inclination'], to = 'a': must be a finite number"),
    ({}, {}, 'over: must name a range, such as {"base.inclination": (0.0, 0.35)}'),
    ({THETA: (0.0, 0.2)}, {"species": TWINS[:1]}, "species: A is alone: there is nothing to separate it from"),
    ({THETA: (0.0, 0.2)}, {"boundary": "periodic", "feed": {"rate": 0.0}, "density": 1.0,
                           "species": [*TWINS, {**TWINS[0], "name": "C"}]},
     "species: must be two, which are to be separated; there are 3: give a goal, one of mean_vx.A, mean_vx.B, mean_vx.C"),
    ({THETA: (0.0, 0.2)}, {"species": [*TWINS, {**TWINS[0], "name": "C"}]},
     "species: must be two, which are to be separated; there are 3: give a goal, one of purity.left.mass.A, "
     "purity.right.mass.A, purity.left.mass.B, purity.right.mass.B, purity.left.mass.C, purity.right.mass.C; or with "
     "recovery in place of purity"),
    ({"duration": (1, 10)}, {}, "over['duration']: must be a key whose value is a number, other than seed, duration, settle"),
    ({"species.0.name": (0, 1)}, {},
     "over['species.0.name']: must be a key whose value is a number, other than seed, duration, settle"),
    ({"feed.rate": (0, 10)}, {}, "over['feed.rate']: must begin above 0"),
    ({THETA: (0.0, 0.2)}, {"species": [TWINS[0], {**TWINS[1], "name": "a"}]},
     "species: A, a: must have names that differ in more than case"),
))
def test_bad_input_is_refused_in_one_line(over, changes, line):
    with pytest.raises(ValueError) as error:
        rs.separate(changed(**changes), over)
    assert str(error.value) == line


@pytest.mark.parametrize("over", ({"base.inclinatoin": (0.0, 0.2)}, {THETA: (0.0, 2.0)}))
def test_keys_and_ranges_are_those_of_a_scene(over):
    with pytest.raises(rs.SceneError) as error:
        rs.separate(SCENE, over)
    assert "inclination" in str(error.value)


@pytest.mark.parametrize("options, name", (({"budget": "2 weeks"}, "budget"), ({"budget": -1}, "budget"), ({"within": 0}, "within"), ({"within": 1}, "within"),
                                           ({"goal": "purity.left.mass.A"}, "within"), ({"seed": 1.5}, "seed"), ({"seed": 2 ** 63}, "seed")))
def test_bad_options_are_refused_before_anything_runs(options, name, monkeypatch):
    monkeypatch.setattr(Machine, "run", None)
    with pytest.raises(ValueError, match=name):
        rs.separate(SCENE, {THETA: (0.0, 0.2)}, **options)


def test_settings_have_few_digits_and_whole_numbers_where_the_key_has_them():
    machine = Machine(SCENE, {THETA: (0, 0.4), "base.frequency": (10, 50), "base.teeth": (8, 12)})
    assert machine.settings([1.0 / 3.0, 1.0 / 3.0, 0.4]) == {THETA: 0.1333, "base.frequency": 23.33, "base.teeth": 10}
    numpys = Machine(SCENE, {"base.teeth": (np.int64(8), np.int64(12)), THETA: (-0.1, 0.2)})
    assert str(numpys.settings([0.4, 1.0 / 3.0 - 1e-9])) == str({"base.teeth": 10, THETA: 0.0})  # not -0.0


def test_what_is_implausible_at_both_ends_of_a_range_is_said():
    with pytest.warns(rs.SieveWarning, match="did you mean 0.001 m"):
        Machine(SCENE, {"base.amplitude": (1, 3)})


def test_the_answer_is_that_of_many_runs(answer):
    assert answer.separated and answer.separation.half_width <= 0.06
    assert answer.separation.count >= LEAST_WORKING * final.FRESH
    table = rs.sweep(answer.scene.replace(duration=60.0), seeds=(10**9, 8))
    mean = rs.stats.mean_of(table["steady.separation.value"].dropna())
    assert abs(mean.value - answer.separation.value) < mean.half_width() + answer.separation.half_width
    others = rs.sweep(rs.Scene(SCENE, {"duration": 20.0}), {THETA: list(np.linspace(0.0, 0.4, 9))}, seeds=2)
    best = others.groupby(THETA).separation.mean().abs().max()
    assert best < abs(mean.value) + answer.within + 0.06  # of the highest of 9 means of two


def test_a_sweep_with_fresh_seeds_its_report_and_a_page_say_the_same(answer, tmp_path):
    scene = answer.scene.replace(duration=40.0)
    table = rs.sweep(scene, {THETA: [answer.best[THETA]]}, seeds=(10**8, 8))
    rows = tables.rows_of(table.assign(arguments=""))
    setting, group = best_setting(rows, {"": 8}, 8, Limits())
    mean = group.mean(tables.STEADY_QUALITY)
    assert abs(mean.value - abs(answer.separation.value)) < np.hypot(mean.half_width(), answer.separation.half_width)
    assert way_of(group, tables.STEADY_QUALITY).endswith(str(answer).splitlines()[0].partition(": ")[2])
    run = rs.run(scene, frames=1.0)
    run.write(tmp_path / "run.html")
    page = data_of((tmp_path / "run.html").read_text(encoding="utf-8"))["results"]["steady"]["separation"]
    assert page["value"] == run.summary.steady.separation.value
    assert abs(page["value"] - answer.separation.value) < np.hypot(page["half_width"], answer.separation.half_width)


def test_the_best_is_of_fresh_seeds_and_among_those_as_good(answer):
    fresh = answer.runs.seed % search.SEEDS >= search.SEEDS // 2
    assert answer.separation.value == pytest.approx(answer.seen.value[fresh].mean())
    good = answer.as_good[THETA]
    assert good.min() <= answer.best[THETA] <= good.max() and len(good) < len(answer.map)


def test_products_add_up(answer):
    for side in ("left", "right"):
        assert sum(share.value for share in answer.purity[side].mass.values()) == pytest.approx(1.0)
    for name in "AB":
        assert sum(answer.recovery[side].number[name].value for side in ("left", "right")) == pytest.approx(1.0)
    assert answer.throughput.disks.value == pytest.approx(60.0, rel=0.1)
    assert answer.throughput.mass.value == pytest.approx(60.0 * 0.0055, rel=0.1)
    assert answer.throughput.mass_per_depth.value == pytest.approx(answer.throughput.mass.value / 0.003, rel=0.05)


def test_it_says_which_way_and_products_beside_the_feed(answer):
    lines = str(answer).splitlines()
    to_left, to_right = "AB" if answer.separation.value > 0.0 else "BA"
    assert f"{to_right} goes " in lines[0] and f" the right, {to_left} " in lines[0] and lines[0].endswith(" the left")
    left = answer.recovery.left.number
    assert ("more" not in lines[0]) == (left[to_left].value > 0.5 > left[to_right].value)
    assert answer.feed.number == {"A": 0.5, "B": 0.5} and answer.feed.mass.A == pytest.approx(10.0 / 11.0)
    assert lines[3].startswith(f"left: A purity {answer.purity.left.mass.A} by mass (feed 0.91), "
                               f"{answer.purity.left.number.A} by number (feed 0.5); recovery ")
    assert which_way(-0.3, "AB") == "A goes more to the right, B more to the left"  # their shares are not known
    assert answer.plot().get_ylabel() == "separation $s$, above 0: more A to the left"
    shown = data_of(answer._page())
    assert shown["result"] == lines[0] and shown["lines"] == lines[1:] and shown["picture"]["bytes"]
    assert [len(table["rows"]) for table in shown["tables"][:1]] == [len(answer.as_good)]
    assert shown["tables"][-1]["note"] == f"It takes {answer.batch(100).hours} h."
    alone = dataclasses.replace(answer, as_good=answer.as_good[:1].assign(may_lose=0.0), idle=3 * len(answer.map))
    assert f"({25.0 / len(answer.map):.2g} % of the ranges); no other setting is as good" in str(alone)


def test_a_batch_takes_its_time_and_loses_nothing(answer):
    batch = answer.batch(10)
    flow = answer.throughput.mass_per_depth
    assert batch.hours.value * 3600.0 * flow.value == pytest.approx(10.0)
    assert batch.hours.half_width / batch.hours.value == pytest.approx(flow.half_width / flow.value)
    assert sum(mass.value for side in batch.products.values() for mass in side.values()) == pytest.approx(10.0)
    for side in ("left", "right"):
        of_side = sum(mass.value for mass in batch.products[side].values())
        purity = answer.purity[side].mass.A
        assert abs(batch.products[side].A.value / of_side - purity.value) < 2.0 * purity.half_width + 0.01
    assert str(batch).splitlines()[0] == f"10 kg per metre of depth: {batch.hours} h"
    assert answer.batch(20).products.left.A.half_width == pytest.approx(2.0 * batch.products.left.A.half_width)
    for kilograms in (0, -1.0, float("nan"), "10 kg"):
        with pytest.raises(ValueError, match="kilograms"):
            answer.batch(kilograms)


def test_the_floor_is_checked_at_the_best(answer):
    floor = answer.floor
    assert floor["to"] == 0.5 * floor["from"] and not floor.depends and floor.change.half_width < 0.1


def test_the_same_kinds_are_not_separated(tmp_path):
    found = rs.separate(changed(species=TWINS), {THETA: (0.0, 0.4)}, within=0.1)
    assert found.best is None and not found.separated and found.bound < 0.05
    assert str(found).startswith("not separated: |separation| < 0.0")
    with pytest.raises(ValueError, match="nothing is separated"):
        found.scene
    found.write(tmp_path / "twins.html")
    shown = data_of((tmp_path / "twins.html").read_text(encoding="utf-8"))
    assert shown["result"].startswith("not separated: |separation| < 0.0")
    assert not shown["tables"] and not shown["picture"] and not shown["scene"]
    assert found.plot().get_title() == str(found).splitlines()[0]


def test_a_closed_machine_is_judged_by_its_drifts():
    ring = changed(boundary="periodic", feed={"rate": 0.0}, density=0.5, duration=20.0)
    found = rs.separate(ring, {THETA: (0.0, 0.1)}, within=0.02)
    assert found.machine.goal == "difference of mean_vx" and found.purity is None
    assert "m/s" in str(found)
    if found.separated:
        first, second = "AB" if found.separation.value > 0.0 else "BA"
        assert str(found).splitlines()[0].endswith(f": {first} drifts to the right of {second}")
    with pytest.raises(ValueError, match="batch: there are no runs of an open machine"):
        found.batch(10)
    drifts = {"mean_vx.A": 0.1, "mean_vx.B": 0.2, "mean_vx_stderr.A": 0.01}
    common = {"events": 100.0, "simulated_time": 20.0, "status": "done"}
    seen = found.machine.observed(pandas.DataFrame([{**common, **drifts, "mean_vx_stderr.B": error} for error in (0.01, np.nan)]))
    assert seen.value.notna().tolist() == [True, False] and seen.why[1] != ""


def test_a_goal_is_any_column_and_another_seed_has_runs_of_its_own(answer):
    found = rs.separate(SCENE, {THETA: (0.0, 0.4)}, goal="purity.left.number.B", within=0.06, seed=2)
    assert set(found.runs.seed).isdisjoint(answer.runs.seed)
    assert found.separation.value > 0.5
    assert found.separation.value == pytest.approx(found.purity.left.number.B.value)


def test_a_goal_must_be_a_number_of_the_results():
    for goal in ("purity.left.mass.Z", "host", "seed"):
        with pytest.raises(ValueError, match=f"goal = '{goal}': must be a column of numbers"):
            rs.separate(SCENE, {THETA: (0.0, 0.4)}, goal=goal, within=0.05)


def test_a_tooth_is_searched_on_a_base_of_one_length():
    scene = changed(base={"length": 0.16})
    machine = Machine(scene, {"base.tooth_width": (0.016, 0.04)})
    rows = machine.run(np.array([[0.0], [1.0]]), [1.0, 1.0], (1, 1))
    assert [machine.scene.replace({"base.tooth_width": width})["base.teeth"] for width in rows["base.tooth_width"]] == [10, 4]
    machine = Machine(SCENE, {"base.length": (0.1, 0.3)})
    assert sorted(machine.run(np.array([[0.0], [1.0]]), [1.0, 1.0], (1, 1))["base.length"]) == [0.1, 0.3]


def test_whole_numbers_are_run_once_each():
    found = rs.separate(SCENE, {"base.teeth": (8, 10)}, within=0.9)
    assert sorted(set(found.runs["base.teeth"])) == [8, 9, 10] and len(found.map) == 3


def test_a_poured_machine_runs_for_its_duration():
    poured = changed(feed={"rate": 0.0}, density=1.0, duration=5.0)
    found = rs.separate(poured, {THETA: (0.2, 0.4)}, within=0.2)
    assert set(found.runs.simulated_time) == {5.0} and "duration" not in found.runs


def test_a_machine_that_works_nowhere_is_an_error():
    with pytest.raises(RuntimeError, match="works nowhere in these ranges: in 11 runs: 11 not emptied by half"):
        rs.separate(changed(feed={"rate": 0.0}, density=1.0, duration=0.05), {THETA: (0.0, 0.1)})


def test_a_machine_whose_runs_fail_says_why(monkeypatch):
    run = Machine.run
    monkeypatch.setattr(Machine, "run", lambda *a, **k: run(*a, **k).assign(
        status="failed", error="inelastic collapse", events=np.nan))
    with pytest.raises(RuntimeError, match="in 11 runs: 11 failed; inelastic collapse"):
        rs.separate(changed(feed={"rate": 0.0}, density=1.0, duration=0.05), {THETA: (0.0, 0.1)})


def test_a_machine_that_works_at_one_setting_says_so():
    with pytest.raises(RuntimeError, match="works at one setting alone, too few for a search"):
        rs.separate(rs.Scene(SCENE).replace({THETA: 0.3}), {"base.frequency": (5.0, 11.16)})


def test_a_run_that_was_cut_is_not_what_tells_of_a_setting():
    found = search.Search(Machine(SCENE, {THETA: (0.0, 0.4)}), 0.06, 1)
    found.measure(np.array([0, 40, 80]), np.full(3, 4.0))
    found._places = np.vstack([found._places, found._places[:1]])
    found.runs = pandas.concat([found.runs, found.runs[:1].assign(status="cut", simulated_time=0.1)], ignore_index=True)
    found.runs.loc[3, [name for name in found.runs if name.startswith(("steady.", "left.", "right."))]] = np.nan
    assert found.machine.observed(found.runs).why[3] == CUT and found.assess()
    assert found.why[0] == "" and found.last[0] == 0


def interrupted_after(calls, monkeypatch):
    run = Machine.run

    def counted(self, *arguments, **options):
        nonlocal calls
        calls -= 1
        if calls < 0:
            raise KeyboardInterrupt
        return run(self, *arguments, **options)

    monkeypatch.setattr(Machine, "run", counted)


def test_an_interrupt_gives_the_answer_so_far_and_the_same_call_continues_on_any_threads(answer, monkeypatch, tmp_path):
    call = {"over": {THETA: (0.0, 0.4)}, "within": 0.06, "results": tmp_path / "runs.db", "threads": 1}
    with monkeypatch.context() as patch:
        interrupted_after(3, patch)
        part = rs.separate(SCENE, **call)
    assert part.warnings[0].startswith("interrupted") and part.separation.count == 0
    whole = rs.separate(SCENE, **call)
    assert (whole.best, whole.separation) == (answer.best, answer.separation)
    bits = [found.runs.drop(columns=["wall_time", "host"]).sort_index(axis=1) for found in (whole, answer)]
    assert bits[0].equals(bits[1])


def test_an_interrupt_before_there_is_an_answer_is_one(monkeypatch):
    interrupted_after(1, monkeypatch)
    with pytest.raises(KeyboardInterrupt):
        rs.separate(SCENE, {THETA: (0.0, 0.4)})


def test_a_budget_ends_the_search(monkeypatch):
    with pytest.raises(ValueError, match="budget: too small for any answer, of about .*: in 0 runs: none has ended"):
        rs.separate(SCENE, {THETA: (0.0, 0.4)}, budget=0)
    monkeypatch.setattr(search.Search, "is_late", lambda self: len(self.runs) >= 11)
    found = rs.separate(SCENE, {THETA: (0.0, 0.4)}, budget="1 h", within=0.01)
    assert any(text.startswith("the budget ended the search: another setting may be") for text in found.warnings)
    assert LEAST_WORKING * final.FRESH <= found.separation.count <= final.FRESH and found.floor is None
    fresh = found.runs.seed % search.SEEDS >= search.SEEDS // 2
    assert found.separation.value == pytest.approx(found.seen.value[fresh].mean())


def test_runs_end_when_their_time_is_over_and_count_for_what_they_have():
    machine = Machine(changed(feed={"rate": 2000.0}), {THETA: (0.1, 0.4)})
    places = np.array([[0.0], [1.0]])
    rows = machine.run(places, [1e6, 1e6], (1, 2), budget=0.3, threads=1)
    assert 0 < len(rows) < 4 and set(rows.status) == {"cut"} and (rows.simulated_time < 1e6).all()
    assert [machine.settings(places[k // 2])[THETA] for k in rows.index] == list(rows[THETA])
    assert (machine.observed(rows).why.isin(["", CUT])).all()


@pytest.mark.parametrize("over, line", (
    ({"base.frequency": (5.0, 40.0)}, "below base.frequency = 11.1 nothing is thrown: left out"),  # sqrt(g / A) / 2 pi
    ({"base.amplitude": (2e-4, 0.004), THETA: (0.0, 0.3)}, "below base.amplitude = 0.00047 nothing is thrown: left out"),
    ({"base.frequency": (5.0, 40.0), "base.amplitude": (0.0005, 0.004)},
     " % of the ranges are left out: nothing is thrown there, for the base accelerates by less than gravity"),
    ({THETA: (0.0, 0.3)}, None),
))
def test_where_nothing_is_thrown_is_left_out_and_said(over, line):
    machine = Machine(SCENE, over)
    found = search.Search(machine, 0.02, 1)
    assert [text.endswith(line) for text in cost.idle_text(found)] == ([True] if line else [])
    own = machine.scene.values
    for places, throws in ((found.grid, True), (found.idle, False)):
        for settings in map(machine.settings, places):
            frequency = settings.get("base.frequency", own["base"]["frequency"])
            amplitude = settings.get("base.amplitude", own["base"]["amplitude"])
            assert (amplitude * (2.0 * np.pi * frequency) ** 2 >= 9.81) == throws


def test_where_nothing_is_thrown_anywhere_all_is_searched():
    found = search.Search(Machine(SCENE, {"base.frequency": (2.0, 5.0)}), 0.02, 1)
    assert len(found.grid) == 81 and len(found.idle) == 0


def test_any_number_of_the_first_places_is_spread():
    for over in ({THETA: (0.0, 0.3)}, {THETA: (0.0, 0.3), "feed.rate": (30.0, 60.0)}):
        found = search.Search(Machine(SCENE, over), 0.02, 1)
        first = found.grid[found.first()]
        assert len(first) == search.FIRST[len(over)] == len(np.unique(first, axis=0))
        for count in (4, 8):  # no half of any range is empty
            assert (first[:count].min(axis=0) < 0.5).all() and (first[:count].max(axis=0) > 0.5).all()


def told(rows):
    """What a machine whose goal is the purity of A on the left says of runs with these columns."""
    machine = Machine(SCENE, {THETA: (0.0, 0.4)}, "purity.left.number.A")
    common = {"events": 100.0, "simulated_time": 40.0, "duration": 40.0, "processed": 0.9, "status": "done",
              "counted": 100}
    return machine, pandas.DataFrame([{**common, **row} for row in rows])


def steady(left, right, **others):
    exits = {f"steady.exits.{side}.number.{name}": count for side, counts in (("left", left), ("right", right))
             for name, count in zip("AB", counts)}
    masses = {name.replace("number", "mass"): 0.01 * count for name, count in exits.items()}
    return {**exits, **masses, "steady.from": 5.0, "steady.inside.value": 4.0, "steady.throughput.number.value": 2.0,
            "steady.purity.left.number.value.A": left[0] / sum(left) if sum(left) else None, **others}


def test_runs_that_say_nothing_say_why():
    machine, rows = told([steady((29, 0), (30, 60)), steady((0, 0), (50, 50)),
                          {"steady_reason": "still filling: 515 inside after 240 s and rising"},
                          {"steady_reason": "choked: by 12 s", "simulated_time": 12.0},
                          {"steady_reason": "too short: 3 s", "simulated_time": 3.0, "status": "cut"},
                          {"status": "failed", "events": None, "simulated_time": None}])
    seen = machine.observed(rows)
    assert list(seen.why) == ["", EMPTY, "still filling", "choked", CUT, "failed"]
    assert list(seen.open) == [False, False, True, False, True, False]
    assert seen.value[0] == 1.0 and 0.0 < seen.variance[0] < 0.01 and seen.value[1:].isna().all()
    assert seen.residence[0] == 2.0
    assert seen.rate[5] == seen.rate[4] == 101.0 / 3.0  # of a run that ended its process, the highest
    assert cost.whys(seen.iloc[[1, 1, 3]]) == f"2 {EMPTY}, 1 choked"


def test_a_run_that_has_not_settled_is_run_again_as_long_as_it_needs_or_given_up():
    short = Machine(SCENE, {THETA: (0.0, 0.4)}).shortest

    def row(units, needs, **others):
        reason = {"steady_reason": "too short: of all"}
        return {"simulated_time": units * short, "duration": units * short, "steady_needs": needs and needs * short,
                **reason, **others}

    machine, rows = told([row(1, None), row(1, 3), row(1, 60), row(4, 13), row(10, 40), row(40, None), row(1, 3, status="cut"),
                          row(1, None, steady_reason="choked: by 1 s"), steady((29, 0), (30, 60))])
    seen = machine.observed(rows).assign(rate=1.0)
    assert list(machine.longer(rows, seen)) == pytest.approx([2.0, 3.3, 4.0, 14.3, np.inf, np.inf, 1.0, np.inf, np.inf])
    # Of the run that is to be 40 times as long at last the first step is too costly, too; one that was cut is continued.
    most = 14.5 * machine.usual_events(seen.assign(rate=[np.nan] + [1.0] * 8))
    assert list(machine.longer(rows, seen, most)) == pytest.approx([2.0, 3.3, np.inf, 14.3, np.inf, np.inf, 1.0, np.inf, np.inf])
    assert list(machine.longer(rows, seen.assign(why=FILLING), most)[:4]) == pytest.approx([2.0, 3.3, np.inf, np.inf])
    assert search.usual_length(machine, rows.iloc[:3]) == pytest.approx(3.3)
    assert search.usual_length(machine, rows.iloc[-1:]) == pytest.approx(40.0 / short)


def test_a_setting_near_lift_off_is_warned_of_and_must_be_better():
    frequency = np.sqrt(1.05 * 9.81 / 0.002) / (2.0 * np.pi)
    machine = Machine(SCENE, {"base.frequency": (8.0, 20.0)})
    text, = cost.lift_off_text(machine, machine.place({"base.frequency": frequency}))
    assert text.startswith("the base's peak acceleration is 1.05 g there")
    assert cost.lift_off_text(machine, [1.0]) == cost.lift_off_text(Machine({**SCENE, "feed": {"rate": 0.0}, "density": 1.0},
                                                                            {"base.frequency": (8.0, 20.0)}), [0.3]) == []
    found = search.Search(machine, 0.02, 1)
    places = machine.low + found.grid[:, 0] * (machine.high - machine.low)
    near = 0.002 * (2.0 * np.pi * places) ** 2 < 1.1 * 9.81
    assert near.any() and (found._handicap == np.where(near, 0.02, 0.0)).all()


def test_fresh_runs_that_fill_up_are_told_with_their_number():
    machine, rows = told([steady((29, 1), (30, 60))] * 11 + [{"steady_reason": "still filling: 99 inside"}])
    fresh, notes = final.Fresh(), []
    fresh.rows = rows
    assert len(fresh.working(machine, notes)) == 11
    assert notes == ["of 12 fresh runs some are left out: 1 still filling",
                     "it may not stay as it is: about once in 8 min of work it fills up"]


def test_equal_values_are_no_certainty():
    machine, rows = told([steady((0, 45), (30, 60))] * 3)
    found = intervals.interval_of(machine, rows)
    assert (found.value, found.count) == (0.0, 3) and found.half_width == pytest.approx(stats.wilson(0, 135)[1])
    shares = intervals._of_share(found, machine.bins(rows).sum(axis=0), "purity", "left", "mass", 0)
    high = stats.wilson(0, 135)[1]
    assert shares.half_width == pytest.approx(high)  # each disk has the same mass
    machine = Machine(SCENE, {THETA: (0.0, 0.4)})
    rows["steady.separation.value"] = -1.0
    rows[[f"steady.exits.right.number.{name}" for name in "AB"]] = [[30, 0]] * 3
    found = intervals.interval_of(machine, rows)
    assert found.value == -1.0 and found.half_width == pytest.approx(np.hypot(stats.wilson(0, 90)[1], high), rel=1e-6)


def test_what_has_no_counts_and_no_spread_has_no_interval():
    machine = Machine(SCENE, {THETA: (0.0, 0.4)}, "counted")
    rows = told([steady((10, 10), (10, 10))] * 2)[1]
    assert intervals.interval_of(machine, rows) == answer_module.Interval(100.0, None, 2)


def test_one_interrupt_leaves_time_for_fresh_seeds(monkeypatch):
    run, calls = Machine.run, []

    def once(self, *arguments, **options):
        calls.append(arguments)
        if len(calls) == 4:
            raise KeyboardInterrupt
        return run(self, *arguments, **{**options, "budget": None})

    monkeypatch.setattr(Machine, "run", once)
    found = rs.separate(SCENE, {THETA: (0.0, 0.4)}, within=0.01)
    assert final.INTERRUPTED in found.warnings and found.separation.count > 1
    fresh = found.runs.seed % search.SEEDS >= search.SEEDS // 2
    assert found.separation.value == pytest.approx(found.seen.value[fresh].mean())


def test_a_machine_that_fills_up_is_no_answer(tmp_path):
    found = rs.separate(SCENE, {"feed.rate": (30.0, 600.0)}, within=0.2)
    filled = found.map[found.map.why != ""]
    assert len(filled) and filled.value.isna().all() and filled["feed.rate"].min() > found.as_good["feed.rate"].max()
    assert set(filled.why) <= {"choked", "still filling", "not settled", "too short"}
    assert any(name in [text.get_text() for text in found.plot().get_legend().get_texts()] for name in set(filled.why))
    assert found.as_good.may_lose.between(0.0, abs(found.separation.value) + 0.2).all() and found.as_good.inside.notna().all()


def test_a_second_machine_closes_the_balance(answer, monkeypatch):
    monkeypatch.setattr(stages, "RUNS", 2)
    second = answer.next_stage("right", {THETA: (0.0, 0.4)}, within=0.1)
    given = second.machine.scene
    left = 0.5 * sum(share.value for share in answer.recovery.left.number.values())
    right = answer.throughput.disks.value * (1.0 - left)
    assert given["feed.rate"] == pytest.approx(right, rel=0.2)
    assert given["species.0.share"] == pytest.approx(answer.purity.right.number.A.value, abs=0.05)
    assert [(of.stage, of.side) for of in second.stages.products] == [(1, "left"), (2, "left"), (2, "right")]
    for own in second.stages.balance.values():
        assert own["fed"] > 100 and own["fed"] == sum(own.values()) - own["fed"]
    for name in "AB":
        assert sum(of.recovery.mass[name].value for of in second.stages.products) == pytest.approx(1.0)
        assert f"{name} purity {second.stages.products[0].purity.mass[name]} by mass" in str(second)
    assert json.dumps(second.as_json()["stages"])
    monkeypatch.setattr(answer, "separation", dataclasses.replace(answer.separation, value=-second.separation.value))
    assert any(text.startswith("this stage undoes the one before") for text in
               answer.next_stage("right", {THETA: (0.0, 0.4)}, within=0.1).warnings) == second.separated


@pytest.mark.parametrize("side, over", (("up", {THETA: (0.0, 0.4)}), ("left", {})))
def test_a_second_machine_needs_a_side_and_ranges(answer, side, over, monkeypatch):
    monkeypatch.setattr(stages, "RUNS", 2)
    with pytest.raises(ValueError, match="side = 'up'" if side == "up" else "over: must name a range"):
        answer.next_stage(side, over)


@pytest.mark.parametrize("name", ("a.html", "a.json", "a.csv", "a.png"))
def test_an_answer_is_written_as_a_whole_or_not_at_all(answer, name, tmp_path, small_files):
    (tmp_path / "good").write_text("good", encoding="utf-8")
    (tmp_path / name).symlink_to("good")
    with small_files, pytest.raises(OSError, match=f"File too large: '.*/{name}'"):
        answer.write(tmp_path / name)
    assert (tmp_path / "good").read_text(encoding="utf-8") == "good" and len(list(tmp_path.iterdir())) == 2
    with pytest.raises(ValueError, match="must end in .html, .csv, .json, .png, .svg or .pdf"):
        answer.write(tmp_path / "answer.txt")
    answer.write(tmp_path / name)
    assert (tmp_path / name).is_symlink() and (tmp_path / "good").stat().st_size > 1000
