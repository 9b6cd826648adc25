"""Scenes in Python: the same keys, errors and warnings as the programs have."""
import copy
import os
import pickle
import threading

import numpy as np
import pytest

import ratchet_sieve as rs


def test_values_are_those_of_the_text(scene):
    assert scene["species.0.radius"] == 0.001
    assert scene["species.1.name"] == "B"
    assert scene["boundary"] == "open"
    assert scene.species == ["A", "B"]
    assert scene["base.tooth_width"] == pytest.approx(0.02)
    with pytest.raises(KeyError):
        scene["base.nothing"]
    assert "seed" in scene and "species.2" not in scene
    with pytest.raises(TypeError):
        list(scene)


def test_a_file_and_its_text_are_one_scene(scene, tmp_path):
    path = tmp_path / "scene.yaml"
    path.write_text(scene.yaml)
    assert rs.Scene.load(path) == scene
    assert rs.Scene(scene.values) == scene


def test_overrides_take_numbers_arrays_texts_and_none(scene):
    other = scene.replace({"base.inclination": np.float64(0.06), "species.0.count": np.int64(3),
                           "boundary": "periodic"}, seed=11)
    assert (other["base.inclination"], other["species.0.count"], other["boundary"], other["seed"]) == \
        (0.06, 3, "periodic", 11)
    tooth = np.array([[0.0, 0.0], [0.01, 0.004], [0.02, 0.0]])
    shaped = scene.replace({"base.profile": tooth})
    assert np.array_equal(shaped.outline[:3], tooth)
    assert shaped.replace({"base.profile": None})["base.tooth_width"] == 0.02
    with pytest.raises(TypeError, match="cannot be a value of a scene"):
        scene.replace({"base.inclination": object()})


ODD = """
base: {teeth: 020}
boundary: open
species:
  - {name: NO, count: 010, radius: 0.0010, mass: 1e-3}
  - {name: 1.10, count: 3, radius: 0.001, density: 2500}
  - {name: 007, count: 3, radius: 0.001, mass: 0.001}
pairs: [{species: [007, 1.10], friction: 0.2}]
seed: 18446744073709551615
"""


def test_numbers_and_names_are_those_that_the_programs_read():
    scene = rs.Scene(ODD)
    assert (scene["base.teeth"], scene["species.0.count"], scene["seed"]) == (20, 10, 2 ** 64 - 1)
    assert scene.species == ["NO", "1.10", "007"]
    assert rs.Scene(scene.given) == scene == rs.Scene(scene.values)


def test_a_file_is_read_once_and_in_any_encoding_of_yaml(tmp_path):
    pipe = tmp_path / "pipe.yaml"
    os.mkfifo(pipe)
    writer = threading.Thread(target=pipe.write_text, args=(ODD,))
    writer.start()
    scene = rs.Scene.load(pipe)
    writer.join()
    assert rs.Scene(ODD) == scene == scene.replace() == pickle.loads(pickle.dumps(scene))
    path = tmp_path / "scene.yaml"
    path.write_text(ODD, encoding="utf-16")
    assert rs.Scene.load(path) == scene == scene.replace()
    path.write_text(ODD.replace("NO", "gr\xfcn"), encoding="latin-1")
    with pytest.raises(rs.SceneError, match="scene.yaml:5: species.0.name = gr\ufffdn: must be a name of"):
        rs.Scene.load(path)


def test_a_mapping_without_end_is_refused():
    deep = itself = {}
    for _ in range(5000):
        deep = {"a": deep}
    itself["a"] = itself
    for mapping in (deep, itself):
        with pytest.raises(rs.SceneError, match="lists and maps nest too deep"):
            rs.Scene(mapping)


def test_errors_name_key_value_and_what_is_allowed(scene):
    with pytest.raises(rs.SceneError) as error:
        scene.replace({"base.inclination": 60})
    assert (error.value.key, error.value.value) == ("base.inclination", "60")
    assert error.value.allowed.startswith("must be a number from -1.5 to 1.5 rad")
    assert str(error.value).endswith(error.value.allowed)
    with pytest.raises(rs.SceneError, match="unknown key") as error:
        scene.replace({"base.incline": 0.1})
    assert error.value.key == "base.incline"
    with pytest.raises(rs.SceneError, match="no such file"):
        rs.Scene.load("/nowhere.yaml")
    again = pickle.loads(pickle.dumps(error.value))
    assert (str(again), again.key) == (str(error.value), error.value.key)


def test_an_implausible_scene_warns(scene):
    with pytest.warns(rs.SieveWarning):
        other = scene.replace({"base.frequency": 0.023})
    assert other.warnings


def test_copies_are_equal(scene):
    for other in (copy.deepcopy(scene), pickle.loads(pickle.dumps(scene))):
        assert other == scene and other.hash == scene.hash and hash(other) == hash(scene)
    assert scene.replace(seed=8) != scene
    assert scene.replace(seed=8).hash == scene.hash


KINDS = [{"name": "A", "radius": 0.001, "mass": 0.010, "share": 3, "share_by": "mass"},
         {"name": "B", "radius": 0.002, "mass": 0.001, "share": 1, "share_by": "mass",
          "size": {"distribution": "uniform", "spread": 0.5}}]


def test_what_is_fed_or_poured_is_told_by_number_and_by_mass():
    fed = rs.Scene({"species": KINDS, "feed": {"rate": 10}})
    assert fed.composition.mass == pytest.approx({"A": 0.75, "B": 0.25})
    counts = np.array([3.0 / 0.010, 1.0 / (0.001 * 1.25)])  # of a uniform spread s the mean of r^3 is 1 + s^2
    assert list(fed.composition.number.values()) == pytest.approx(list(counts / counts.sum()), rel=1e-4)
    poured = fed.replace({"feed": None, "density": 2.0})
    assert poured.composition.mass.A == pytest.approx(0.75, abs=0.01)
    listed = fed.replace({"feed": {"disks": [{"time": 1, "species": "A", "radius": 0.001, "mass": 0.3},
                                             {"time": 2, "species": "B", "radius": 0.001, "mass": 0.1}]}})
    assert listed.composition.number == {"A": 0.5, "B": 0.5}
    assert listed.composition.mass == pytest.approx({"A": 0.75, "B": 0.25})
    placed = fed.replace({"feed": None, "initial": [{"species": "A", "x": 0.1, "y": 0.1}]})
    assert placed.composition.number == {"A": 1.0, "B": 0.0}
    with pytest.warns(rs.SieveWarning):
        none = fed.replace({"feed.rate": 0, "species.0.count": 0, "species.1.count": 0})
    assert none.composition.mass.A is None


def test_shares_by_mass_are_those_of_the_mass_that_is_fed():
    table = {"distribution": "table", "radii": [0.001, 0.003], "weights": [10, 90], "by": "mass"}
    kinds = [{**KINDS[0], "share": 1}, {**KINDS[1], "size": table}]
    simulation = rs.Simulation(rs.Scene({"base": {"teeth": 200}, "species": kinds, "feed": {"rate": 2000},
                                         "contact": {"pair_collisions": False}}))
    simulation.advance(10.0)
    disks = simulation.disks
    mass = [disks["mass"][disks["species"] == k].sum() for k in range(2)]
    assert len(disks) > 19000 and mass[0] / sum(mass) == pytest.approx(0.5, abs=0.02)


def test_the_outline_is_of_all_teeth(scene):
    outline = scene.outline
    assert outline.shape == (13, 2)
    assert outline[0].tolist() == [0.0, 0.0]
    assert outline[-1, 0] == pytest.approx(scene.width) == pytest.approx(0.12)
    assert outline[:, 1].max() == scene["base.tooth_height"]
