"""Sieves to be controlled, and to learn from: environments with the methods of Gymnasium's.

    import ratchet_sieve as rs
    env = rs.env.SieveEnv(rs.Scene.load("config/seek.yaml"), step=1.0, episode=100.0)
    observation, info = env.reset(seed=1)
    observation, reward, terminated, truncated, info = env.step([0.15])

    sieves = rs.env.SieveVectorEnv(rs.Scene.load("config/seek.yaml"), 16)    # on all cores

Where gymnasium is installed, they are derived from its classes. Documentation: docs/python_env.md.
"""
from .environments import SieveEnv, SieveVectorEnv
from .readings import Readings
from .task import Task

__all__ = ["Readings", "SieveEnv", "SieveVectorEnv", "Task"]
