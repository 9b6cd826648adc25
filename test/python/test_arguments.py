"""What a scene may be given as, and one line for each argument that is none."""
import pathlib
import warnings

import numpy as np
import pytest

import ratchet_sieve as rs
from conftest import SCENE


@pytest.fixture
def path(tmp_path):
    file = tmp_path / "scene.yaml"
    file.write_text(SCENE)
    return file


def test_a_scene_may_be_a_path_or_a_mapping(scene, path):
    for given in (path, str(path), scene.values):
        assert rs.run(given, progress=False).scene == scene
        assert rs.Simulation(given).scene == scene
        assert len(rs.sweep(given, {"duration": [0.3]}, progress=False)) == 1


def test_a_warning_names_the_line_of_the_user(path):
    with pytest.warns(rs.SieveWarning) as said:
        rs.run({**rs.Scene(SCENE, {"base.frequency": 0.023}).values, "settle": 0.0, "duration": 0.01}, progress=False)
    assert {pathlib.Path(each.filename) for each in said} == {pathlib.Path(__file__)}


@pytest.mark.parametrize("call, line", (
    (lambda scene: rs.run(5), "scene = 5: must be a Scene, the path of a scene file or a mapping"),
    (lambda scene: rs.run(scene, until=5), 'until = 5: must be a mapping, such as {"mean_vx": 0.001}'),
    (lambda scene: rs.run(scene, frames="x"), "frames = 'x': must be 0 to 100000 1/s"),
    (lambda scene: rs.run(scene, frames=float("nan")), "frames = nan: must be 0 to 100000 1/s"),
    (lambda scene: rs.run(scene, threads=-1), "threads = -1: must be an integer, 0 or more"),
    (lambda scene: rs.run(scene, threads=2 ** 64),
     "threads = 18446744073709551616: must be an integer, 0 to 18446744073709551615"),
    (lambda scene: rs.run(scene, collisions="x"), "collisions = 'x': must be True or False"),
    (lambda scene: rs.run(scene).separation(float("nan"), 5), "since = nan: must be a finite number"),
    (lambda scene: rs.run(scene).separation(0.0, "x"), "until = 'x': must be a finite number"),
    (lambda scene: rs.run(scene, frames=5).write(5), "path = 5: must be the path of a file"),
    (lambda scene: scene.replace(0), 'overrides = 0: must be a mapping, such as {"base.inclination": 0.1}'),
    (lambda scene: rs.Scene(SCENE, []), 'overrides = []: must be a mapping, such as {"base.inclination": 0.1}'),
    (lambda scene: rs.separate(scene, {"base.inclination": (0.0, 0.1)}, goal=0),
     "goal = 0: must be a column of numbers of a sweep's results, such as purity.left.mass.A"),
    (lambda scene: rs.separate(scene, {"base.inclination": (0.0, 0.1)}, goal=""),
     "goal = '': must be a column of numbers of a sweep's results, such as purity.left.mass.A"),
    (lambda scene: rs.env.SieveVectorEnv(scene, 2, threads=-1), "threads = -1: must be an integer, 0 or more"),
    (lambda scene: rs.read_sweep(1), "path = 1: must be the path of a file"),
    (lambda scene: rs.sweep(None), "scene = None: must be a Scene, the path of a scene file or a mapping"),
    (lambda scene: rs.sweep(scene, [1]), 'grid = [1]: must be a mapping, such as {"base.inclination": [0.0, 0.1]}'),
    (lambda scene: rs.sweep(scene, {"base.inclination": 0.1}),
     'base.inclination = 0.1: must be a list of values, or {"from": .., "to": .., "count": ..}'),
    (lambda scene: rs.sweep(scene, zip={"boundary": "open"}),
     'boundary = \'open\': must be a list of values, or {"from": .., "to": .., "count": ..}'),
    (lambda scene: rs.sweep(scene, cases=[0.1]),
     'cases[0] = 0.1: must be a mapping, such as {"base.inclination": 0.1}'),
    (lambda scene: rs.sweep(scene, cases=5),
     'cases = 5: must be a list of mappings, such as [{"base.inclination": 0.1}]'),
    (lambda scene: rs.sweep(scene, results=1), "results = 1: must be the path of a file"),
    (lambda scene: rs.sweep(scene, threads=-1), "threads = -1: must be an integer, 0 or more"),
    (lambda scene: rs.sweep(scene, seeds=0), "seeds = 0: must be an integer, 1 or more"),
    (lambda scene: rs.sweep(scene, seeds=(1, 0.5)), "seeds[1] = 0.5: must be an integer, 1 or more"),
    (lambda scene: rs.sweep(scene, seeds=[1, "x"]), "seeds[1] = 'x': must be an integer, 0 or more"),
    (lambda scene: rs.Simulation(scene).advance("x"), "duration = 'x': must be 0 s or more"),
    (lambda scene: rs.Simulation(scene).advance(-1.0), "duration = -1.0: must be 0 s or more"),
    (lambda scene: rs.Simulation(scene).advance_to(float("inf")), "time = inf: must be a finite number in s"),
    (lambda scene: rs.Simulation(scene, 0.5).advance_to(0.25),
     "time = 0.25: must be 0.5 s or more: a simulation does not go back"),
    (lambda scene: rs.Simulation(scene).command(inclination=[]), "inclination = []: must be a finite number"),
    (lambda scene: rs.Simulation(scene).set_slew_rates(amplitude="x"),
     "amplitude (slew rate) = 'x': must be a finite number"),
    (lambda scene: rs.Simulation(scene).pour("A", -1), "count = -1: must be an integer, 0 or more"),
    (lambda scene: rs.Simulation(scene).pour(-1, 1), "species = -1: must be an integer, 0 or more"),
    (lambda scene: rs.Simulation.restore(scene, "abc"),
     "state = 'abc': must be bytes, as Simulation.save() returns them"),
    (lambda scene: rs.Simulation.restore(scene, b"abc"), "the state cannot be restored: it is damaged"),
    (lambda scene: rs.stats.mean_of([0.3, float("nan")]), "values[1] = nan: must be a finite number"),
    (lambda scene: rs.stats.mean_of([0.3, None]), "values[1] = None: must be a finite number"),
))
def test_a_wrong_argument_is_one_line(scene, call, line):
    with pytest.raises(ValueError) as error:
        call(scene)
    assert str(error.value) == line


def test_values_of_a_sweep_may_be_a_range_or_any_sequence(scene):
    short = scene.replace(duration=0.0, settle=0.0)
    wanted = [0.0, 0.05, 0.1]
    for values in ({"from": 0.0, "to": 0.1, "count": 3}, wanted, tuple(wanted), np.array(wanted)):
        table = rs.sweep(short, {"base.inclination": values}, progress=False)
        assert table["base.inclination"].tolist() == wanted
    profiles = [np.array([[0.0, 0.0], [0.01, height], [0.02, 0.0]]) for height in (0.004, 0.005)]
    assert (rs.sweep(short, {"base.profile": profiles}, progress=False)["status"] == "done").all()


@pytest.mark.parametrize("seeds, all_of_them", ((2, [1, 2]), ((5, 2), [5, 6]), ([7, 3, 12], [7, 3, 12]),
                                                (range(2, 5), [2, 3, 4]), (np.array([9, 1]), [9, 1])))
def test_seeds_are_a_number_a_pair_or_a_list(scene, seeds, all_of_them):
    table = rs.sweep(scene.replace(duration=0.0, settle=0.0), seeds=seeds, progress=False)
    assert table["seed"].tolist() == all_of_them


def test_a_sweeps_table_takes_columns_without_a_warning(scene):
    table = rs.sweep(scene.replace(duration=0.1, settle=0.0), progress=False)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        table["own"] = 1.0
        rs.tables.rows_of(table)
