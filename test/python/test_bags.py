"""A bag gives back the frames of its run."""
import subprocess
import sys

import numpy as np
import pytest

import ratchet_sieve as rs
from conftest import program

SCENE = """
base: {teeth: 6, inclination: 0.1}
boundary: open
species:
  - {name: A, count: 20, radius: 0.001, mass: 0.010, size: {distribution: uniform, spread: 0.2, mass_exponent: 2}}
  - {name: B, count: 20, radius: 0.002, mass: 0.001}
duration: 1.0
settle: 0.0
"""
RATE = 20  # of the disks; base and bins are recorded at 60 Hz


@pytest.fixture(scope="module")
def bag(tmp_path_factory):
    """Of sieve_run, where it is built with ROS."""
    pytest.importorskip("rosbag")
    folder = tmp_path_factory.mktemp("bag")
    (folder / "scene.yaml").write_text(SCENE, encoding="utf-8")
    run = subprocess.run([program("sieve_run"), "scene.yaml", "--bag", "run.bag", "--bag-rate", str(RATE)], cwd=folder,
                         capture_output=True, text=True)
    if "this build has none" in run.stderr:
        pytest.skip("built without ROS")
    assert run.returncode == 0, run.stderr
    return folder / "run.bag"


def test_has_the_frames_of_the_run_bit_for_bit(bag):
    recording = rs.read_bag(bag)
    run = rs.run(rs.Scene(SCENE), frames=RATE)
    assert recording.scene == run.scene
    assert len(recording.frames) == RATE + 1
    assert np.array_equal(recording.frames.time, run.frames.time)
    for found, expected in zip(recording.frames.disks, run.frames.disks):
        assert found.dtype == expected.dtype
        assert np.array_equal(found, expected)
    assert np.array_equal(recording.frames.base, run.frames.base)
    for name in ("A", "B"):
        assert np.array_equal(recording.frames.bins[name], run.frames.bins[name])


def test_what_is_no_sound_bag_is_one_error_line(bag, tmp_path):
    (tmp_path / "cut.bag").write_bytes(bag.read_bytes()[:5000])
    (tmp_path / "text.bag").write_text("no bag", encoding="utf-8")
    for name in ("cut.bag", "text.bag", "missing.bag"):
        with pytest.raises(rs.BagError, match=rf"^.*{name}: .+$"):
            rs.read_bag(tmp_path / name)


def test_says_what_it_needs_without_rosbag(monkeypatch, tmp_path):
    monkeypatch.setitem(sys.modules, "rosbag", None)
    with pytest.raises(rs.BagError, match="python3-rosbag"):
        rs.read_bag(tmp_path / "run.bag")


def test_columns_that_do_not_fit_the_scene_are_refused():
    engine = rs.Scene(SCENE)._engine
    columns = {name: [0.0] for name in ("id", "species", "x", "y", "angle", "vx", "vy", "spin", "displacement")}
    assert engine.disks_of({**columns, "radius": []})["radius"][0] == 0.001
    with pytest.raises(ValueError, match="there are 1 id and 2 x"):
        engine.disks_of({**columns, "radius": [], "x": [0.0, 0.0]})
    with pytest.raises(ValueError, match="no species 2"):
        engine.disks_of({**columns, "radius": [], "species": [2]})
