"""Scenes: what is simulated."""
from __future__ import annotations

import json
import os
import warnings
from typing import Any, Mapping, Optional, Union

import numpy as np

from . import _engine
from .arguments import mapping
from .base import length, surface
from .errors import SceneError, SieveWarning, warn
from .values import Values

Overrides = Mapping[str, Any]


def yaml_text(value: Any) -> str:
    """A value as YAML text on one line. A str is taken for such a text itself, as after `--set KEY=`."""
    if isinstance(value, str):
        return value
    try:
        return json.dumps(value, default=_plain, ensure_ascii=False)
    except (RecursionError, ValueError):  # of lists and maps that contain themselves
        raise SceneError("scene: lists and maps nest too deep") from None


def _plain(value: Any) -> Any:
    if isinstance(value, (np.integer, np.floating, np.bool_)):
        return value.item()
    if isinstance(value, np.ndarray):
        return value.tolist()
    raise TypeError(f"{value!r} cannot be a value of a scene: allowed are numbers, texts, lists, maps and None")


class Scene:
    """A legal scene. It does not change: `replace()` gives another one.

    Keys, units and ranges: docs/scenes.md, or `sieve_run --keys`.
    """

    def __init__(self, text: Union[str, Mapping[str, Any]], overrides: Optional[Overrides] = None, *,
                 source: str = "scene"):
        """From YAML text, or from nested mappings.

        overrides  dotted key -> value; None takes a key out, as `--set KEY=null` does
        source     named in errors
        Raises SceneError. Warns (SieveWarning) of what is legal but implausible.
        """
        self._begin(yaml_text(text), _assignments(overrides), source)

    @classmethod
    def load(cls, path: Union[str, os.PathLike], overrides: Optional[Overrides] = None) -> Scene:
        """From a scene file; see __init__()."""
        scene = cls.__new__(cls)
        source = os.fspath(path)
        scene._begin(_engine.read_text(source), _assignments(overrides), source)
        return scene

    def _begin(self, text: Union[str, bytes], assignments: list[str], source: str) -> None:
        """The text and the overrides are kept, since a key may decide others: `density` the numbers of disks."""
        self._text = text
        self._assignments = assignments
        self._engine = _engine.scene_of_text(text, source, assignments)
        self._values: Optional[dict] = None
        self.source = source
        for warning in self._engine.warnings:
            warn(warning)

    def replace(self, overrides: Optional[Overrides] = None, **keys: Any) -> Scene:
        """The scene with other values: `replace({"base.inclination": 0.06}, seed=3)`. Raises SceneError."""
        scene = type(self).__new__(type(self))
        scene._begin(self._text, self._assignments + _assignments(overrides) + _assignments(keys), self.source)
        return scene

    @property
    def given(self) -> dict:
        """What the scene was given, without defaults, as nested dicts and lists: a copy."""
        return _engine.given_values(self._text, self.source, self._assignments)

    @property
    def yaml(self) -> str:
        """All keys with their values, defaults included, as YAML."""
        return self._engine.yaml

    @property
    def values(self) -> dict:
        """The same as nested dicts and lists: a copy."""
        return self._engine.values

    def __getitem__(self, key: str) -> Any:
        """The value of a dotted key: scene["species.0.radius"]. SI units. Raises KeyError."""
        if not isinstance(key, str):
            raise KeyError(key)
        if self._values is None:
            self._values = self._engine.values
        value: Any = self._values
        for part in key.split("."):
            try:
                value = value[int(part) if isinstance(value, list) else part]
            except (KeyError, IndexError, TypeError, ValueError):
                raise KeyError(key) from None
        return value

    def __contains__(self, key: Any) -> bool:
        """Whether the scene has a value of this dotted key: "species.0.radius" in scene."""
        try:
            self[key]
        except KeyError:
            return False
        return True

    __iter__ = None  # its keys are nested: scene.values

    @property
    def hash(self) -> str:
        """16 hexadecimal digits over every key that decides the disks' motion: not seed, duration, settle."""
        return self._engine.hash

    @property
    def species(self) -> list[str]:
        """The names of the species, in their order."""
        return self._engine.species

    @property
    def composition(self) -> Values:
        """What is fed, or poured where nothing is: the share of each species by `number` and by `mass`, as expected of
        its sizes; None where there are no disks."""
        values = self.values
        disks, names = values["feed"].get("disks"), self.species
        if disks:
            numbers = [sum(disk["species"] == name for disk in disks) for name in names]
            masses = [sum(disk["mass"] for disk in disks if disk["species"] == name) for name in names]
        else:
            if values["feed"]["rate"] > 0.0:
                numbers = [species["share"] for species in values["species"]]
            elif values["initial"]:
                numbers = [sum(disk["species"] == name for disk in values["initial"]) for name in names]
            else:
                numbers = [species["count"] for species in values["species"]]
            masses = [count * mass for count, mass in zip(numbers, self._engine.mean_masses)]
        return Values((by, Values((name, part / sum(parts) if sum(parts) > 0.0 else None)
                                  for name, part in zip(names, parts)))
                      for by, parts in (("number", numbers), ("mass", masses)))

    @property
    def width(self) -> float:
        """W, the length of the base [m]."""
        return float(length(self.values["base"]))

    @property
    def outline(self) -> np.ndarray:
        """The corners of all teeth, from left to right, in the frame of the base: an array (corners, 2) of s along
        the base and n normal to it [m]."""
        return np.array(surface(self.values["base"]))

    @property
    def warnings(self) -> list[str]:
        """What is legal but implausible, one line each."""
        return self._engine.warnings

    @property
    def feed_file(self) -> Optional[str]:
        """The path of the file of fed disks, as seen from anywhere."""
        file = (self.given.get("feed") or {}).get("file")
        folder = os.path.dirname(self.source) if os.path.exists(self.source) else ""
        return file and os.path.abspath(os.path.join(folder, file))

    def require_other(self, *outputs: tuple[str, Any]) -> None:
        """Of files to be written the arguments' names and paths, None: there is no file. Raises ValueError if one is
        the scene's own, its feed.file or another one of them."""
        inputs, written = ([_engine.NamedFile(name, os.fspath(path or "")) for name, path in files]
                           for files in ((("the scene", self.source), ("feed.file", self.feed_file)), outputs))
        _engine.require_distinct(inputs, written)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Scene) and self._engine.run_hash == other._engine.run_hash

    def __hash__(self) -> int:
        return hash(self._engine.run_hash)

    def __reduce__(self) -> tuple[Any, ...]:
        return _unpickled, (self._text, self._assignments, self.source)

    def __repr__(self) -> str:
        return f"<Scene {self.source}: {', '.join(self.species)}; hash {self.hash}>"


AnyScene = Union[Scene, str, os.PathLike, Mapping[str, Any]]


def scene_of(scene: AnyScene) -> Scene:
    """A scene as it is, that of a file by its path, of a mapping, or of an answer or grains. Raises SceneError,
    ValueError."""
    scene = getattr(scene, "scene", scene)
    if isinstance(scene, Scene):
        return scene
    if isinstance(scene, (str, os.PathLike)):
        return Scene.load(scene)
    if isinstance(scene, Mapping):
        return Scene(scene)
    raise ValueError(f"scene = {scene!r}: must be a Scene, the path of a scene file or a mapping")


def _unpickled(text: Union[str, bytes], assignments: list[str], source: str) -> Scene:
    scene = Scene.__new__(Scene)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", SieveWarning)
        scene._begin(text, assignments, source)
    return scene


def _assignments(overrides: Optional[Overrides]) -> list[str]:
    return [f"{key}={yaml_text(value)}" for key, value in
            mapping("overrides", {} if overrides is None else overrides, '{"base.inclination": 0.1}').items()]
