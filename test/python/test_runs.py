"""Whole runs and sweeps in Python: the results of the programs."""
import html
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import threading
import urllib.parse
import urllib.request

import numpy as np
import pytest

import ratchet_sieve as rs

OWN_TIME = ("wall_time",)


def program(name):
    """The program of this build; skips where it is none of the environment's."""
    path = os.environ.get("RATCHET_SIEVE_PROGRAMS")
    found = shutil.which(name, path=path) if path else None
    if not found:
        pytest.skip(f"{name}: RATCHET_SIEVE_PROGRAMS does not name where it is")
    return found


def summary_of(text):
    summary = json.loads(text)
    return {key: value for key, value in summary.items() if key not in OWN_TIME}


def test_the_summary_is_that_of_sieve_run(scene, tmp_path):
    path = tmp_path / "scene.yaml"
    path.write_text(scene.yaml)
    done = subprocess.run([program("sieve_run"), path], capture_output=True, check=True, text=True)
    run = rs.run(scene, progress=False)
    assert summary_of(done.stdout) == summary_of(json.dumps(run.summary))


def test_results_are_attributes_with_units(scene):
    summary = rs.run(scene, progress=False).summary
    assert summary.species[0].mean_vx == summary["species"][0]["mean_vx"] == summary.of_species("A").mean_vx
    assert summary.unit("mean_vx") == "m/s" and summary.unit("quality") == ""
    assert "mean_vx" in repr(summary)
    with pytest.raises(AttributeError, match="there is no qualities; there are"):
        summary.qualities
    with pytest.raises(KeyError, match="no species 'C'"):
        summary.of_species("C")


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
    path = tmp_path / "scene.yaml"
    path.write_text(scene.yaml)
    subprocess.run([program("sieve_run"), path, "--trajectory", tmp_path / "own.xyz", "--trajectory-rate", "20"],
                   capture_output=True, check=True)
    run = rs.run(scene, frames=20, progress=False)
    run.write(tmp_path / "python.xyz")
    for part in ("", "_base"):
        assert (tmp_path / f"python{part}.xyz").read_text() == (tmp_path / f"own{part}.xyz").read_text()
    with pytest.raises(OSError, match="xyz"):
        run.write(tmp_path / "run.abc")
    with pytest.raises(ValueError, match="no frames"):
        rs.run(scene, progress=False).write(tmp_path / "none.xyz")


def test_pages_are_those_of_sieve_run(scene, tmp_path):
    path = tmp_path / "scene.yaml"
    path.write_text(scene.yaml)
    subprocess.run([program("sieve_run"), path, "--html", tmp_path / "own.html", "--html-rate", "20"],
                   capture_output=True, check=True)
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
    monkeypatch.setattr(rs.runs.webbrowser, "open", opened.append)
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
