"""ratchet_sieve: the virtual vibrating-ratchet feeder.

A sawtooth base, inclined and shaken, drives grains sideways, and so separates kinds that no sieve could.

    import ratchet_sieve as rs
    scene = rs.Scene.load("config/paper_fig8.yaml", {"base.inclination": 0.06})
    run = rs.run(scene, frames=60)
    run.summary.quality, run.plot()
"""
from ._engine import __version__
from .errors import ResultsError, SceneError, SieveWarning, StallError, StateError
from .runs import KINDS, Collisions, Frames, Run, run
from .scene import Scene
from .simulation import Simulation
from .sweeps import read_sweep, sweep
from .values import Summary, Values

__all__ = ["KINDS", "Collisions", "Frames", "ResultsError", "Run", "Scene", "SceneError", "SieveWarning", "Simulation",
           "StallError", "StateError", "Summary", "Values", "__version__", "read_sweep", "run", "sweep"]
