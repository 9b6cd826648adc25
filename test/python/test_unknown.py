"""What is not known: priors, draws, and on what a result depends."""
import warnings

import numpy as np
import pytest

import ratchet_sieve as rs
from feeder import SCENE, THETA
from ratchet_sieve.answers.__main__ import read_unknown
from ratchet_sieve.answers.depends import SCREENED, Dependence, known_text, screening
from ratchet_sieve.answers.machine import Machine
from ratchet_sieve.answers.posterior import drawn
from ratchet_sieve.answers.unknown import Prior

E0, E1, MU = "species.0.restitution", "species.1.restitution", "species.0.friction"


@pytest.fixture(autouse=True)
def quiet():
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", rs.SieveWarning)
        yield


def test_a_range_is_uniform_and_a_value_with_an_error_normal():
    prior = Prior(rs.Scene(SCENE), {E0: (0.7, 0.9), MU: (0.3, "±", 0.1)})
    assert prior.table.mean(axis=0) == pytest.approx([0.8, 0.3], abs=1e-3)
    assert prior.table.std(axis=0) == pytest.approx([0.2 / 12 ** 0.5, 0.1 / 1.96], rel=0.02)
    assert prior.table[:, 0].min() >= 0.7 and prior.table[:, 0].max() <= 0.9
    assert (np.abs(prior.table[:, 1] - 0.3) < 0.1).mean() == pytest.approx(0.95, abs=0.005)
    at_end = Prior(rs.Scene(SCENE), {E0: (0.97, "±", 0.05)}).table
    assert 0.999 < at_end.max() <= 1.0 and at_end.min() == pytest.approx(0.97 - 3 * 0.05 / 1.96, abs=1e-3)


@pytest.mark.parametrize("unknown, line", (
    ({}, 'unknown: must name a key, such as {"species.0.restitution": (0.9, 0.98)}'),
    ([E0], "unknown = ['species.0.restitution']: must be a mapping, such as {\"species.0.restitution\": (0.9, 0.98)}"),
    ({E0: 0.9}, "unknown['species.0.restitution'] = 0.9: must be a pair (low, high), or (value, \"±\", error)"),
    ({E0: (0.9, 0.9)}, "unknown['species.0.restitution'] = 0.9 to 0.9: must have a width: low below high"),
    ({E0: (0.9, "±", 0.0)}, "unknown['species.0.restitution'], error = 0.0: must be above 0"),
    ({E0: ("a", 1.0)}, "unknown['species.0.restitution'], low = 'a': must be a finite number"),
    ({"seed": (1, 5)}, "unknown['seed']: must be another key than seed, duration, settle"),
))
def test_what_is_unknown_is_refused_in_one_line(unknown, line):
    with pytest.raises(ValueError) as error:
        Prior(rs.Scene(SCENE), unknown)
    assert str(error.value) == line


@pytest.mark.parametrize("unknown", ({E0: (0.9, 1.1)}, {"base.teeth": (6, 9)}, {"species.0.restitutoin": (0.5, 0.6)}))
def test_ends_are_those_of_a_scene(unknown):
    with pytest.raises(rs.SceneError, match="|".join(["restitution", "teeth", "restitutoin"])):
        Prior(rs.Scene(SCENE), unknown)


def test_options_of_the_program():
    assert read_unknown(["a=1:2", "b=0.5±0.1", "c=-0.5+-0.1"]) == {"a": (1, 2), "b": (0.5, "±", 0.1),
                                                                  "c": (-0.5, "±", 0.1)}
    assert read_unknown([]) is None
    for text in ("a", "a=1", "a=1±x"):
        with pytest.raises(ValueError, match="--unknown"):
            read_unknown([text])


def test_a_sweep_draws_by_seed_the_same_at_all_settings():
    scene = rs.Scene(SCENE, {"duration": 1.0})
    tables = [rs.sweep(scene, {THETA: [0.1, 0.2]}, seeds=3, unknown={E0: (0.4, 0.8)}, threads=threads, progress=False)
              for threads in (1, 2)]
    assert tables[0]["seed"].tolist() == [1, 2, 3, 1, 2, 3]
    draws = tables[0][E0].to_numpy()
    assert len(set(draws)) == 3 and (draws[:3] == draws[3:]).all() and (0.4 <= draws).all() and (draws <= 0.8).all()
    assert (tables[1][[E0, "left.A", "events"]] == tables[0][[E0, "left.A", "events"]]).all(axis=None)
    alone = rs.sweep(scene.replace({E0: draws[1]}), {THETA: [0.2]}, seeds=[2], progress=False)
    assert alone["events"][0] == tables[0]["events"][4]


@pytest.mark.parametrize("case", ({E0: 0.2}, {"seed": 7}))
def test_a_case_does_not_set_what_is_drawn(case):
    with pytest.raises(ValueError, match=r"cases\[0\]: .* must not be set, with `unknown`"):
        rs.sweep(SCENE, cases=[case], unknown={E0: (0.4, 0.8)}, progress=False)


def test_each_run_of_a_search_has_values_and_a_seed_of_its_own():
    machine = Machine(SCENE, {THETA: (0.0, 0.4)}, unknown={E0: (0.4, 0.8), MU: (0.1, 0.3)})
    assert machine.scene[E0] == pytest.approx(0.6, abs=1e-3)
    rows = machine.run(np.array([[0.2], [0.7]]), [1.0, 1.0], (5, 3))
    assert rows["seed"].tolist() == [5, 6, 7] * 2 and rows[THETA].tolist() == [0.08] * 3 + [0.28] * 3
    assert len(set(zip(rows[E0], rows["seed"]))) == 6
    with pytest.raises(ValueError, match="over.*is unknown as well"):
        Machine(SCENE, {E0: (0.0, 0.4)}, unknown={E0: (0.4, 0.8)})


def test_shares_of_the_variance_are_those_of_a_linear_result():
    unknown = Prior(rs.Scene(SCENE), {E0: (0.5, 0.9), E1: (0.5, 0.9), MU: (0.1, 0.5)})
    draws = unknown.table[:200]
    values = 0.3 * draws[:, 0] - 0.15 * draws[:, 1] + np.random.default_rng(1).normal(0.0, 0.02, 200)
    found = Dependence(unknown, draws, values)
    assert found.table["key"].tolist() == [E0, E1, MU]
    for row, share in zip(found.table.itertuples(), (0.8, 0.2, 0.0)):
        assert abs(row.share - share) < 3.0 * row.error + 0.01
    low, high = np.quantile(0.3 * unknown.table[:, 0] - 0.15 * unknown.table[:, 1], [0.025, 0.975])
    assert found.spread == pytest.approx((low, high), abs=0.008)
    assert "on the rest less than 5 % each" in "\n".join(found.lines(""))


@pytest.mark.parametrize("effect", (0.0, 0.1, 1.0))
def test_the_spread_holds_the_true_grains_however_few_the_runs(effect):
    unknown, held = Prior(rs.Scene(SCENE), {E0: (0.5, 0.9), E1: (0.5, 0.9), MU: (0.1, 0.5)}), 0
    for seed in range(200):
        drawn = np.random.default_rng(seed)
        draws, truth = unknown.table[40 * seed % 4000:][:24], drawn.choice(unknown.table)
        low, high = Dependence(unknown, draws, effect * draws[:, 0] + drawn.normal(0.0, 0.05, 24)).spread
        held += low <= effect * truth[0] <= high
    assert held >= 180  # of 200, where 95 % hold on the average


def test_where_runs_tell_nothing_it_is_said_so():
    unknown = Prior(rs.Scene(SCENE), {E0: (0.5, 0.9), E1: (0.5, 0.9)})
    seen = [Dependence(unknown, unknown.table[:20], np.random.default_rng(seed).normal(size=20)).table is not None
            for seed in range(60)]
    assert sum(seen) <= 9  # of 60 at 5 %
    few = Dependence(unknown, unknown.table[:4], np.arange(4.0))
    assert few.table is None and "no dependence is seen" in few.lines("")[0]


def test_what_is_taken_as_known_is_screened_at_both_sides():
    scene = rs.Scene(SCENE)
    unknown = screening(scene)
    assert len(unknown.keys) == 6 and len(unknown.table) == 8
    steps = unknown.table - unknown.table.mean(axis=0)
    assert np.abs(steps.T @ steps - np.diag(np.diag(steps.T @ steps))).max() < 1e-12  # effects that do not mix
    assert steps[:, 0].max() == pytest.approx(SCREENED["restitution"])
    for row in range(8):
        scene.replace(unknown.draw(row))
    values = 0.1 + 2.0 * steps[:, 0] - 1.0 * steps[:, 4] / steps[:, 4].max() * 0.05
    text = known_text(unknown, values, 1e-4)
    assert f"depends most on {E0} (+0.05: +0.100 ± 0.007) and species.1.friction" in text and "measure these" in text
    assert "no dependence on them seen: each changes it by less than 0.71" in known_text(unknown, 0.0 * values, 1.0)
    edge = scene.replace({key: 1.0 for key in (E0, E1)})
    assert E0 not in screening(edge).keys


def test_draws_are_those_of_a_density():
    def log_density(places):
        x, y = (places[:, 0] - 0.3) / 0.02, (places[:, 1] - 0.5 - 0.8 * (places[:, 0] - 0.3)) / 0.01
        return -0.5 * (x ** 2 + y ** 2)

    places, best = drawn(log_density, 2, 4000, 1)
    assert best == pytest.approx([0.3, 0.5], abs=0.01)
    assert places.mean(axis=0) == pytest.approx([0.3, 0.5], abs=0.002)
    assert np.cov(places.T) == pytest.approx(np.array([[4e-4, 3.2e-4], [3.2e-4, 3.56e-4]]), rel=0.1)
    flat, _ = drawn(lambda places: np.zeros(len(places)), 3, 3000, 2)
    assert flat.std(axis=0) == pytest.approx(1 / 12 ** 0.5, rel=0.05)
