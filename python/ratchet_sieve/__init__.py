"""ratchet_sieve: the virtual vibrating-ratchet feeder.

A sawtooth base, inclined and shaken, drives grains sideways, and so separates kinds that no sieve could.

    import ratchet_sieve as rs
    scene = rs.Scene.load("config/demo.yaml", {"base.inclination": 0.19, "duration": 20})
    run = rs.run(scene, frames=20)
    run.summary.quality, run.plot()

Documentation: docs/python.md.
"""
import importlib.util
import pkgutil

# In ROS the messages, msg and srv, are in another directory of the same name.
__path__ = pkgutil.extend_path(__path__, __name__)

# Of each name its module. Imported when it is first used: the engine, pandas and matplotlib take longer to load than
# the rest, and what draws the tables of a run needs no engine.
_NAMES = {
    **dict.fromkeys(("BagError", "ResultsError", "SceneError", "SieveWarning", "StallError", "StateError"), "errors"),
    **dict.fromkeys(("KINDS", "Collisions", "Frames", "Recording", "Run", "run"), "runs"),
    **dict.fromkeys(("read_sweep", "sweep"), "sweeps"),
    **dict.fromkeys(("Summary", "Values"), "values"),
    "Answer": "answers.answer",
    "Grains": "answers.grains",
    "Front": "answers.front",
    "LivePage": "pages",
    "Scene": "scene",
    "Simulation": "simulation",
    "__version__": "_engine",
    "read_bag": "bags",
    "calibrate": "answers.calibrate",
    "front": "answers.front",
    "live": "pages",
    "separate": "answers",
    "size_table": "size_tables",
}
_SUBMODULES = ("documents", "env", "errors", "origin", "plots", "stats", "tables")

__all__ = sorted(name for name in _NAMES if not name.startswith("_"))


def __getattr__(name):
    if name in _NAMES:
        return getattr(importlib.import_module(f"{__name__}.{_NAMES[name]}"), name)
    if name in _SUBMODULES:
        return importlib.import_module(f"{__name__}.{name}")
    if name == "_engine" and importlib.util.find_spec(f"{__name__}._engine") is None:
        raise ImportError("the engine is not built: run scripts/build, or scripts/python")
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__():
    return sorted({*globals(), *_NAMES, *_SUBMODULES})
