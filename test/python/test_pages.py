"""rs.live(): what is offered, and what is said without an engine. What runs in the page: test/page/browsers."""
import json
import pathlib
import re

import pytest

import ratchet_sieve as rs
from ratchet_sieve import pages


@pytest.fixture(name="engine")
def fixture_engine(tmp_path, monkeypatch):
    """The folder in which the engine for browsers is looked for; it is not there yet."""
    monkeypatch.setattr(pages._engine, "__file__", str(tmp_path / "_engine.so"))
    return tmp_path / "engine.wasm"


def offered_by(page, path):
    page.write(path)
    return json.loads(re.search(r'id="data">(.*?)</script>', path.read_text()).group(1))["scenes"]


def test_a_live_page_has_the_definitions_of_its_scenes(scene, engine, tmp_path):
    engine.write_bytes(b"\0asm")
    single = {"species": [{"name": "A", "count": 1, "radius": 0.001, "mass": 0.01}]}
    page = rs.live(scene, scene.replace(seed=3), single)
    offered = offered_by(page, tmp_path / "live.html")
    assert [(each["name"], each["seed"]) for each in offered] == [("scene", 7), ("scene (2)", 3), ("scene (3)", 1)]
    assert rs.Scene(offered[1]["yaml"]) == scene.replace(seed=3)
    assert len({each["definition"] for each in offered}) == 3
    assert repr(page) == "<LivePage of scene, scene (2), scene (3)>"
    assert 'sandbox="allow-scripts"' in page._repr_html_()


def test_scenes_have_the_titles_of_their_files(scene, engine, tmp_path):
    engine.write_bytes(b"\0asm")
    (tmp_path / "titled.yaml").write_text(f"# Two kinds: one sees them part.\n{scene.yaml}")
    offered = offered_by(rs.live(tmp_path / "titled.yaml", scene), tmp_path / "live.html")
    headings = [(each["title"], each["sentence"]) for each in offered]
    assert headings == [("Two kinds", "One sees them part."), ("scene", "")]
    for name in pages.OFFERED:
        title, sentence = pages.heading(rs.Scene.load(pages.SHARE / f"config/{name}.yaml"), "")
        assert 4 < len(title) < 40 and sentence.endswith("."), name


def test_without_an_engine_it_says_how_it_is_compiled(scene, engine, tmp_path):
    with pytest.raises(FileNotFoundError, match=r"engine\.wasm is missing: \./scripts/live"):
        rs.live(scene).write(tmp_path / "live.html")
    assert not (tmp_path / "live.html").exists()


def test_a_scene_that_is_none_is_refused():
    with pytest.raises(rs.SceneError):
        rs.live(pathlib.Path("none.yaml"))
