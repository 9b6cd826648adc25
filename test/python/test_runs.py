"""Whole runs and sweeps in Python: the results of the programs."""
import copy
import html
import json
import os
import pathlib
import pickle
import re
import signal
import sqlite3
import subprocess
import sys
import tempfile
import threading
import urllib.parse
import urllib.request
from xml.etree import ElementTree

import numpy as np
import pytest

import ratchet_sieve as rs
from conftest import program

OWN_TIME = ("wall_time",)


def summary_of(text):
    summary = json.loads(text)
    return {key: value for key, value in summary.items() if key not in OWN_TIME}


def sieve_run(scene, folder, *options):
    """Runs a scene by the program. @return its output"""
    path = folder / "scene.yaml"
    path.write_text(scene.yaml)
    return subprocess.run([program("sieve_run"), path, *options], capture_output=True, check=True, text=True).stdout


def test_the_summary_is_that_of_sieve_run(scene, tmp_path):
    said = sieve_run(scene, tmp_path)
    assert summary_of(said) == summary_of(json.dumps(rs.run(scene, progress=False).summary))


def test_results_are_attributes_with_units(scene):
    summary = rs.run(scene, progress=False).summary
    assert summary.species[0].mean_vx == summary["species"][0]["mean_vx"] == summary.of_species("A").mean_vx
    assert summary.unit("mean_vx") == "m/s" and summary.unit("quality") == ""
    assert summary.unit("accuracy.mean_vx.A.half_width") == "m/s" and summary.unit("mass_flow.right.mean.B") == "kg/s"
    assert "mean_vx" in repr(summary)
    with pytest.raises(AttributeError, match="there is no qualities; there are"):
        summary.qualities
    with pytest.raises(KeyError, match="no species 'C'"):
        summary.of_species("C")


@pytest.fixture
def full(scene):
    """A run whose summary has every part."""
    sizes = {"distribution": "uniform", "spread": 0.2}
    return rs.run(scene.replace({
        "species": scene.given["species"] + [{"name": "C", "count": 5, "radius": 0.003, "mass": 0.002, "size": sizes}],
        "observe": ["residence_times", "height_profile", "mass_flow"], "base.inclination": 0.3, "duration": 0.4,
        "base.profile": [[0, 0], [0.01, 0.004], [0.02, 0]]}), frames=20, progress=False)


def parts_of(value, name=""):
    """What a summary consists of, at any depth, with its name."""
    yield name, value
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, item in items:
        yield from parts_of(item, f"{name}.{key}" if name else str(key))


def test_every_part_of_a_summary_is_shown_and_copied(full):
    for name, part in parts_of(full.summary):
        for other in (copy.copy(part), copy.deepcopy(part), pickle.loads(pickle.dumps(part))):
            assert other == part and type(other) is type(part) and repr(other) == repr(part)
        if isinstance(part, dict):
            assert dict(part) == part and all(str(key) in repr(part) for key in part if name), name


def test_every_number_has_its_unit(full):
    for name, part in parts_of(full.summary):
        if isinstance(part, (int, float)):
            assert isinstance(rs.Summary.unit(name), str), name
    table = rs.sweep(full.scene, progress=False)
    others = {"run_hash", "physics", "version", "scene_hash", "status", "error", "host", "warning_text",
              "steady_reason"}
    assert all(isinstance(rs.Summary.unit(name), str) for name in table if name not in others)
    with pytest.raises(KeyError, match="no number speed"):
        rs.Summary.unit("speed")


def test_a_run_is_pickled_whole(full, tmp_path):
    other = pickle.loads(pickle.dumps(full))
    assert other.summary == full.summary and other.collisions == full.collisions
    assert np.array_equal(other.simulation.disks, full.simulation.disks)
    for run, name in ((full, "own.html"), (other, "other.html")):
        run.write(tmp_path / name)
    own, others = ((tmp_path / name).read_text().replace(name, "") for name in ("own.html", "other.html"))
    assert own == others


def test_a_process_forked_after_a_threaded_run_goes_on(scene):
    ensemble = scene.replace({"contact.pair_collisions": False, "species.0.count": 5000, "duration": 0.02,
                              "settle": 0.0})
    run = rs.run(ensemble, threads=4, progress=False)
    child = os.fork()
    if child == 0:
        signal.alarm(60)  # ends it if it waits for threads that it does not have
        run.simulation.advance(0.01)
        del run
        os._exit(0)
    assert os.waitpid(child, 0)[1] == 0


def test_what_is_undefined_is_none(layer):
    run = rs.run(layer.replace(duration=0.05, settle=0.05), progress=False)
    assert run.summary.quality is None and run.summary.species[0].mean_vx is None


def test_frames_are_at_equal_steps_and_at_the_end(scene):
    run = rs.run(scene.replace(duration=0.55), frames=20, progress=False)
    assert run.frames.time.tolist() == pytest.approx([k / 20 for k in range(12)])
    assert len(run.frames) == len(run.frames.disks) == len(run.frames.base) == 12
    simulation = rs.Simulation(run.scene)
    for time, disks, base in zip(run.frames.time, run.frames.disks, run.frames.base):
        simulation.advance_to(time)
        assert np.array_equal(simulation.disks, disks)
        assert simulation.base == dict(zip(base.dtype.names, base))
    bins = run.frames.bins.A
    assert (bins["left"] + bins["right"] + bins["on_base"] == 20).all()
    assert bins["left"][-1] == run.summary.species[0].left


def test_a_second_stage_has_exactly_the_disks_that_left_the_first(scene, tmp_path):
    fed = scene.replace({"base.inclination": 0.3, "boundary": "open", "feed.rate": 300.0, "duration": 3.0})
    first = rs.run(fed, progress=False)
    exits = first.exits
    assert len(exits) == sum(of.left + of.right for of in first.summary.species) > 100
    assert len(exits.left) + len(exits.right) == len(exits)
    assert (np.diff(exits["time"]) >= 0.0).all() and set(exits["species"]) == {"A", "B"}
    for of in first.summary.species:
        assert (exits.left["species"] == of.name).sum() == of.left
    assert first.separation() == first.summary.separation
    late = exits[exits["time"] > 2.0]
    shares = [(late[late["species"] == name]["side"] == "left").mean() for name in first.scene.species]
    assert first.separation(since=2.0) == pytest.approx(shares[0] - shares[1])
    assert first.separation(until=0.0) is None

    emptied = scene.replace({"species.0.count": 0, "species.1.count": 0, "duration": 3.0, "feed.rate": 7.0})
    second = rs.run(emptied.replace({"base.inclination": -0.3}), feed=exits.left, progress=False)
    fed_disks = np.concatenate([second.exits["id"], second.simulation.disks["id"]])
    assert sorted(fed_disks) == list(range(len(exits.left)))
    for name in ("species", "radius", "mass"):
        assert (second.exits[name] == exits.left[name][second.exits["id"]]).all()
    assert (second.simulation.disks["mass"] == exits.left["mass"][second.simulation.disks["id"]]).all()

    path = tmp_path / "exits.csv"
    np.savetxt(path, exits.left[["time", "species", "radius", "mass"]], fmt=("%.17g", "%s", "%.17g", "%.17g"),
               delimiter=",", header="time,species,radius,mass", comments="")
    read = second.scene.replace({"feed.disks": None, "feed.file": str(path)})
    assert read == second.scene
    with pytest.raises(ValueError, match="must have columns time, species, radius and mass"):
        rs.run(scene, feed=[1.0], progress=False)
    with pytest.raises(rs.SceneError, match="unknown species; must be one of A, B"):
        rs.run(scene, feed={"time": [1.0], "species": ["C"], "radius": [0.001], "mass": [0.001]}, progress=False)


def test_collisions_are_counted_and_kept_if_wanted(scene):
    run = rs.run(scene, collisions=True, progress=False)
    records = run.collisions.records
    assert len(records) == sum(run.collisions.values())
    for number, kind in enumerate(rs.KINDS):
        assert (records["kind"] == number).sum() == run.collisions[kind]
    assert ((records["j"] == -1) == (records["kind"] != rs.KINDS.index("disk_disk"))).all()
    assert (np.diff(records["time"]) >= 0.0).all() and (records["normal_speed"] > 0.0).all()
    assert rs.run(scene, progress=False).collisions.records is None


def test_a_run_ends_when_it_is_accurate(layer):
    run = rs.run(layer.replace(duration=200.0), until={"mean_vx": 0.01}, progress=False)
    assert run.summary.simulated_time < 200.0 and run.summary.accuracy.reached
    with pytest.raises(rs.SceneError, match="accuracy.mean_vy"):
        rs.run(layer, until={"mean_vy": 0.01}, progress=False)


def test_a_run_too_short_for_its_accuracy_warns(layer):
    with pytest.warns(rs.SieveWarning, match="accuracy.mean_vx"):
        rs.run(layer, until={"mean_vx": 1e-7}, progress=False)


def test_ctrl_c_ends_a_run(layer):
    threading.Timer(0.3, signal.raise_signal, [signal.SIGINT]).start()
    with pytest.raises(KeyboardInterrupt):
        rs.run(layer.replace(duration=1e6), progress=False)


def test_an_error_in_the_progress_ends_the_run(layer, monkeypatch):
    monkeypatch.setattr(rs.runs.Progress, "show", lambda *_: 1 / 0)
    with pytest.raises(ZeroDivisionError):
        rs.run(layer.replace(duration=1e6), progress=False)


def test_trajectories_are_those_of_sieve_run(scene, tmp_path):
    sieve_run(scene, tmp_path, "--trajectory", tmp_path / "own.xyz", "--trajectory-rate", "20")
    run = rs.run(scene, frames=20, progress=False)
    run.write(tmp_path / "python.xyz")
    for part in ("", "_base"):
        assert (tmp_path / f"python{part}.xyz").read_text() == (tmp_path / f"own{part}.xyz").read_text()
    with pytest.raises(ValueError, match="must end in .html, .xyz, .extxyz or .pvd"):
        run.write(tmp_path / "run.abc")
    with pytest.raises(ValueError, match="no frames"):
        rs.run(scene, progress=False).write(tmp_path / "none.xyz")


def pvd_frames(path):
    """Times and meshes of a collection, as meshio reads them; None for a frame without points, which it can't read."""
    meshio = pytest.importorskip("meshio")
    for frame in ElementTree.parse(path).iter("DataSet"):
        file = path.parent / frame.get("file")
        empty = 'NumberOfPoints="0"' in file.read_text()
        yield float(frame.get("timestep")), None if empty else meshio.read(file)


@pytest.mark.parametrize("change", [
    {}, {"boundary": "walled", "base.wall_height": 0.1, "base.inclination": 0.1, "base.horizontal_amplitude": 0.001},
    {"species.0.count": 0, "species.1.count": 0, "feed.rate": 20.0}])
def test_meshio_reads_what_is_written_for_paraview(scene, tmp_path, change):
    run = rs.run(scene.replace({"duration": 0.5, **change}), frames=20, progress=False)
    run.write(tmp_path / "a & b.pvd")
    run.write(tmp_path / "a & b.xyz")
    disks = list(pvd_frames(tmp_path / "a & b.pvd"))
    assert [time for time, _ in disks] == list(run.frames.time)
    for (_, mesh), of in zip(disks, run.frames.disks):
        if mesh is None:
            assert not len(of)
            continue
        assert np.array_equal(mesh.points, np.column_stack([of["x"], of["y"], 0.0 * of["x"]]))
        assert np.array_equal(mesh.point_data["velocity"][:, :2], np.column_stack([of["vx"], of["vy"]]))
        for name in ("id", "species", "radius", "mass", "angle", "spin", "displacement"):
            assert np.array_equal(mesh.point_data[name], of[name]), name
    assert any(mesh is not None for _, mesh in disks)
    base = list(pvd_frames(tmp_path / "a & b_base.pvd"))
    rows = re.findall("^base (.*)$", (tmp_path / "a & b_base.xyz").read_text(), re.MULTILINE)
    corners = np.array([[float(number) for number in row.split()[:3]] for row in rows])
    assert np.allclose(np.concatenate([mesh.points for _, mesh in base]), corners, rtol=0, atol=1e-15)
    assert all(len(mesh.cells[0].data) == len(mesh.points) - 1 for _, mesh in base)


def test_a_shorter_run_takes_the_place_of_a_longer_one(scene, tmp_path):
    pytest.importorskip("meshio")
    (tmp_path / "run_frames").mkdir()
    (tmp_path / "run_frames" / "notes.txt").write_text("mine")
    for duration in (0.4, 0.2):
        rs.run(scene.replace({"duration": duration, "settle": 0.0}), frames=10, progress=False).write(tmp_path / "run.pvd")
    files = {file.name for file in (tmp_path / "run_frames").iterdir()}
    assert files == {"notes.txt"} | {f"{series}_{k:06}.vtu" for series in ("disks", "base") for k in range(3)}


def test_a_run_that_cannot_be_written_for_paraview_leaves_the_earlier_one(scene, tmp_path, small_files):
    pytest.importorskip("meshio")
    run = rs.run(scene.replace({"duration": 0.2, "settle": 0.0}), frames=10, progress=False)
    run.write(tmp_path / "run.pvd")
    before = {file: file.read_bytes() for file in tmp_path.rglob("*.*")}
    with small_files, pytest.raises(OSError, match=r"File too large: '.*/run\.pvd'"):
        run.write(tmp_path / "run.pvd")
    assert {file: file.read_bytes() for file in tmp_path.rglob("*.*")} == before


def test_paraview_needs_meshio(scene, tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "meshio", None)
    with pytest.raises(ImportError, match=r"run\.pvd: is written by meshio \(Debian: python3-meshio\)"):
        rs.run(scene, frames=1, progress=False).write(tmp_path / "run.pvd")
    assert not list(tmp_path.iterdir())


def test_pages_are_those_of_sieve_run(scene, tmp_path):
    sieve_run(scene, tmp_path, "--html", tmp_path / "own.html", "--html-rate", "20")
    run = rs.run(scene, frames=20, progress=False)
    run.write(tmp_path / "python.html")

    def parts(name):
        text = (tmp_path / name).read_text()
        found = dict(re.findall('<script type="[^"]*" id="([a-z]+)">([^<]*)', text))
        return json.loads(found["data"]), found["motion"]

    (own, own_motion), (python, python_motion) = parts("own.html"), parts("python.html")
    assert python_motion == own_motion
    for key in ("scene", "plan", "machine", "warnings", "motion", "results"):
        assert python[key] == own[key], key
    for megabytes in (0.4, 101, float("nan")):
        with pytest.raises(ValueError, match="must be 0.5 to 100"):
            run.write(tmp_path / "python.html", megabytes=megabytes)
    with pytest.raises(OSError, match="none"):
        run.write(tmp_path / "none" / "run.html")


def test_a_page_is_shown_in_a_notebook_or_the_browser(scene, monkeypatch):
    run = rs.run(scene, frames=20, progress=False)
    opened = []
    monkeypatch.setattr("webbrowser.open", opened.append)
    monkeypatch.delitem(sys.modules, "ipykernel", raising=False)
    assert run.show() is None
    page = pathlib.Path(urllib.request.url2pathname(urllib.parse.urlsplit(opened[0]).path))
    text = page.read_text()
    page.unlink()
    monkeypatch.setitem(sys.modules, "ipykernel", object())
    shown = run.show(height=500).data
    assert html.unescape(re.search('srcdoc="([^"]*)"', shown).group(1)) == text
    assert 'sandbox="allow-scripts"' in shown and "height: 500px" in shown


def test_a_sweep_has_the_rows_of_its_runs_in_order(scene):
    inclinations = np.linspace(0.0, 0.1, 3)
    table = rs.sweep(scene.replace(duration=0.3), {"base.inclination": inclinations}, seeds=2, progress=False)
    assert table["base.inclination"].tolist() == np.repeat(inclinations, 2).tolist()
    assert table["seed"].tolist() == [1, 2] * 3 and (table["status"] == "done").all()
    run = rs.run(scene.replace({"base.inclination": inclinations[1]}, seed=2, duration=0.3), progress=False)
    assert table["mean_vx.A"][3] == run.summary.species[0].mean_vx
    assert table["collisions.apex"][3] == run.collisions.apex


def test_results_are_kept_and_shared_with_sieve_sweep(scene, tmp_path):
    short = scene.replace(duration=0.2)
    path = tmp_path / "results.db"
    first = rs.sweep(short, {"base.inclination": [0.0, 0.1]}, results=path, progress=False)
    second = rs.sweep(short, {"base.inclination": [0.1, 0.0, 0.05]}, results=path, progress=False)
    assert len(first) == 2 and len(second) == 3 and len(rs.read_sweep(path)) == 3
    assert second["wall_time"][0] == first["wall_time"][1]  # not run again
    (tmp_path / "scene.yaml").write_text(short.yaml)
    (tmp_path / "sweep.yaml").write_text("scene: scene.yaml\ngrid: {base.inclination: [0.0, 0.1, 0.05]}\n")
    status = subprocess.run([program("sieve_sweep"), "status", tmp_path / "sweep.yaml", "--db", path],
                            capture_output=True, check=True, text=True)
    assert "3" in status.stdout + status.stderr


def test_each_seed_is_exact_also_where_version_1_0_has_rounded_it(scene, tmp_path):
    seeds = [7, 2**53 + 1, 2**63, 2**64 - 1]
    path = tmp_path / "results.db"
    table = rs.sweep(scene.replace(duration=0.0, settle=0.0), seeds=seeds, results=path, progress=False)
    assert table["seed"].tolist() == seeds
    with sqlite3.connect(path) as connection:
        connection.execute("UPDATE cases SET seed = CAST(seed AS REAL) WHERE typeof(seed) = 'text'")
    connection.close()
    assert sorted(rs.read_sweep(path)["seed"]) == seeds
    again = rs.sweep(scene.replace(duration=0.0, settle=0.0), seeds=seeds, results=path, progress=False)
    assert again["seed"].tolist() == seeds and again["wall_time"].tolist() == table["wall_time"].tolist()


def test_a_locale_with_a_decimal_comma_changes_no_number(scene, tmp_path, request):
    def written(name):
        """All that a run and a sweep write, but the wall times."""
        folder = tmp_path / f"with_{name}"
        folder.mkdir()
        run = rs.run(scene.replace(duration=0.3), frames=20, progress=False)
        table = rs.sweep(run.scene, {"base.inclination": {"from": 0.0, "to": 0.1, "count": 4}, "gravity": [9.5]},
                         results=folder / "results.db", progress=False)
        for file in ("run.xyz", "run.html"):
            run.write(folder / file)
        return (run.scene.yaml, summary_of(json.dumps(run.summary)), (folder / "run.xyz").read_text(),
                (folder / "run.html").read_text(), table.drop(columns=["wall_time"]).to_csv())

    before = written("point")
    request.getfixturevalue("decimal_comma")
    assert written("comma") == before


@pytest.mark.parametrize("name", ("a%41.db", "a b?c#d.db", "\N{GREEK SMALL LETTER THETA}.db", b"\xff.db"))
def test_a_results_file_may_have_any_name(scene, tmp_path, name):
    for path in (os.path.join(tmp_path, os.fsdecode(name)), os.path.join(f"/{tmp_path}", os.fsdecode(name))):
        table = rs.sweep(scene.replace(duration=0.0, settle=0.0), seeds=2, results=path, progress=False)
        assert len(rs.read_sweep(path)) == len(table) == 2
    assert os.listdir(tmp_path) == [os.fsdecode(name)]


def test_a_reader_who_may_not_write_the_file_leaves_nothing_and_sees_a_killed_writers_log(scene):
    reader = ("import os, sys, pandas, ratchet_sieve as rs; rs.read_sweep; os.getuid() or os.setuid(65534); "
              "print(len(rs.read_sweep(sys.argv[1])))")
    writer = ("import os, sqlite3, sys; "
              "sqlite3.connect(sys.argv[1], isolation_level=None).execute('DELETE FROM cases'); os._exit(0)")
    with tempfile.TemporaryDirectory() as folder:  # tmp_path is closed to others
        path = os.path.join(folder, "results.db")
        rs.sweep(scene.replace(duration=0.0, settle=0.0), seeds=2, results=path, progress=False)
        os.chmod(folder, 0o777)
        os.chmod(path, 0o444)
        assert subprocess.check_output([sys.executable, "-c", reader, path]) == b"2\n"
        assert os.listdir(folder) == ["results.db"]
        os.chmod(path, 0o644)
        subprocess.run([sys.executable, "-c", writer, path], check=True)
        os.chmod(path, 0o444)
        assert subprocess.check_output([sys.executable, "-c", reader, path]) == b"0\n"


def test_a_wrong_sweep_is_refused_before_any_run(scene, tmp_path):
    with pytest.raises(rs.SceneError, match="base.inclination"):
        rs.sweep(scene, {"base.inclination": [0.0, 60.0]}, results=tmp_path / "results.db", progress=False)
    (tmp_path / "none.db").write_text("no results at all, but long enough to be looked at " * 20)
    with pytest.raises(rs.ResultsError):
        rs.read_sweep(tmp_path / "none.db")
    with pytest.raises(rs.ResultsError, match="no such file"):
        rs.read_sweep(tmp_path / "missing.db")
    assert not pathlib.Path(tmp_path / "missing.db").exists()


def test_ctrl_c_ends_a_sweep_and_the_file_goes_on(layer, tmp_path):
    threading.Timer(0.5, signal.raise_signal, [signal.SIGINT]).start()
    with pytest.raises(KeyboardInterrupt):
        rs.sweep(layer.replace(duration=1e6), seeds=2, results=tmp_path / "results.db", progress=False)
    assert len(rs.read_sweep(tmp_path / "results.db")) == 0
