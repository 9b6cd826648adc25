"""Pages for any browser: how they are shown, and the live one, in which the engine itself runs."""
from __future__ import annotations

import argparse
import html
import os
import pathlib
import re
import sys
import tempfile
import webbrowser
from typing import Any, Callable, Union

from . import _engine
from .arguments import path_of
from .places import SHARE, WORK
from .scene import AnyScene, Scene, scene_of

OFFERED = ("machine_fig9", "demo", "paper_fig8", "paper_fig9", "paper_fig3", "machine_mass", "glass_rubber",
           "sized_mixture", "circular_feeder", "profile_castle")
"""The scenes of config/ that are offered where none is asked for; the first opens."""
TITLE = "Ratchet sieve, live"
HEIGHT = 720  # in a notebook [pixels]


def framed(write: Callable[[pathlib.Path], None], title: str, height: int) -> str:
    """What `write` writes to a path, in a frame `height` pixels high, as HTML."""
    with tempfile.TemporaryDirectory() as folder:
        page = pathlib.Path(folder) / "page.html"
        write(page)
        text = html.escape(page.read_text(encoding="utf-8"))
    return (f'<div><iframe srcdoc="{text}" sandbox="allow-scripts" title="{html.escape(title)}" '
            f'style="width: 100%; height: {height}px; border: 0"></iframe></div>')


def show_page(write: Callable[[pathlib.Path], None], title: str, height: int) -> Any:
    """Shows what `write` writes to a path: in a notebook below the cell, `height` pixels high, else in the browser."""
    if "ipykernel" in sys.modules:
        from IPython.display import HTML

        return HTML(framed(write, title, height))
    with tempfile.NamedTemporaryFile(prefix="ratchet_sieve_", suffix=".html", delete=False) as file:
        page = pathlib.Path(file.name)
    try:
        write(page)
    except BaseException:
        page.unlink()
        raise
    webbrowser.open(page.as_uri())
    return None


def heading(scene: Scene, name: str) -> tuple[str, str]:
    """A scene's title and what one sees: the first line of its file, where that is a comment `# TITLE: SENTENCE`."""
    try:
        with open(scene.source, encoding="utf-8") as file:
            found = re.fullmatch(r"# ([^:]{1,60}): (.+)", file.readline().strip())
    except (OSError, UnicodeDecodeError):
        found = None
    return (found[1], found[2][0].upper() + found[2][1:]) if found else (name, "")


class LivePage:
    """A page in which scenes run live. `show()` shows it, `write(path)` writes it: one file of HTML."""

    def __init__(self, *scenes: AnyScene):
        """Of these scenes, or of some of config/. Raises SceneError, ValueError."""
        self._given = [scene_of(scene) for scene in scenes or [SHARE / f"config/{name}.yaml" for name in OFFERED]]
        self._scenes: list[tuple[str, str, str, Any]] = []
        for scene in self._given:
            stem = os.path.basename(scene.source).partition(".")[0]
            taken = sum(name.partition(" (")[0] == stem for name, *_ in self._scenes)
            name = f"{stem} ({taken + 1})" if taken else stem
            self._scenes.append((name, *heading(scene, name), scene._engine))

    def write(self, path: Union[str, os.PathLike]) -> None:
        """Raises FileNotFoundError if the engine was not compiled for browsers, OSError, ValueError."""
        for scene in self._given:
            scene.require_other(("path", path_of("path", path)))
        engine = pathlib.Path(_engine.__file__).parent / "engine.wasm"
        if not engine.exists():
            raise FileNotFoundError(f"{engine} is missing: ./scripts/live compiles the engine for browsers")
        _engine.write_live_page(os.fspath(path), self._scenes, engine.read_bytes())

    def show(self, *, height: int = HEIGHT) -> Any:
        """Shows the page: in a notebook below the cell, `height` pixels high, else in the browser."""
        return show_page(self.write, TITLE, height)

    def _repr_html_(self) -> str:
        return framed(self.write, TITLE, HEIGHT)

    def __repr__(self) -> str:
        return f"<LivePage of {', '.join(name for name, *_ in self._scenes)}>"


def live(*scenes: AnyScene) -> LivePage:
    """The page of LivePage; a notebook shows it below the cell."""
    return LivePage(*scenes)


def main() -> None:
    parser = argparse.ArgumentParser(
        prog="live", description="Writes one file of HTML in which the engine runs live, in any browser, offline.")
    parser.add_argument("scenes", metavar="SCENE", nargs="*", help="scene files (default: some of config/)")
    parser.add_argument("-o", "--output", metavar="FILE", type=pathlib.Path, default=WORK / "out/live.html",
                        help="the page (default: out/live.html)")
    arguments = parser.parse_args()
    try:
        page = LivePage(*arguments.scenes)
        arguments.output.parent.mkdir(parents=True, exist_ok=True)
        page.write(arguments.output)
    except (ValueError, OSError) as error:
        print(f"live: {error}", file=sys.stderr)
        sys.exit(2 if isinstance(error, ValueError) else 1)
    print(f"{arguments.output}: {arguments.output.stat().st_size / 1e6:.1f} MB, {page!r}. Open it in any browser.")


if __name__ == "__main__":
    main()
