#!/usr/bin/python3
"""Measures environments for learning: simulated time per time of one sieve and of many, over that of the engine alone.
Each round measures all in turn. The results are medians of the ratios within a round, because other load on the machine
changes from round to round. Of a machine that others use, only the ratios of processor time say something, and that of
the wall time of many sieves over that of as many engines without an environment.
"""
import concurrent.futures
import os
import statistics
import time

import numpy as np

import ratchet_sieve as rs
from ratchet_sieve import origin, places
from ratchet_sieve.texts import table
from report import arguments_of, publish

STEP = 1.0   # [s]
BEGIN = 5.0  # until the feed has filled the base [s]


def rates_of(work, simulated):
    """@return simulated seconds per second of wall time and of processor time"""
    wall, processor = time.perf_counter(), time.process_time()
    work()
    return simulated / (time.perf_counter() - wall), simulated / (time.process_time() - processor)


def rate_of_engines(scene, count, threads, seconds):
    """Of engines without an environment, each of which goes all the way in one call."""
    simulations = [rs.Simulation(scene.replace(seed=seed + 1)) for seed in range(count)]
    with concurrent.futures.ThreadPoolExecutor(threads) as pool:
        def advance(duration):
            list(pool.map(lambda simulation: simulation.advance(duration), simulations))

        advance(BEGIN)
        return rates_of(lambda: advance(seconds), count * seconds)


def rate_of_env(env, actions, seconds):
    env.reset(seed=1)

    def steps(duration):
        for _ in range(round(duration / env.task.step)):
            env.step(actions)

    steps(BEGIN)
    return rates_of(lambda: steps(seconds), getattr(env, "num_envs", 1) * seconds)


def main():
    arguments = arguments_of(__doc__, "env", rounds=9, sieves=32, threads=os.cpu_count(), seconds=20.0)
    scene, seconds = rs.Scene.load(places.SHARE / "config/seek.yaml"), arguments.seconds
    settings = {"episode": BEGIN + seconds + 1.0, "step": STEP}
    single = rs.env.SieveEnv(scene, **settings)
    many = rs.env.SieveVectorEnv(scene, arguments.sieves, threads=arguments.threads, **settings)
    action = [scene["base.inclination"]]
    actions = np.tile(action, (arguments.sieves, 1))
    rounds = [{
        "engine": rate_of_engines(scene, 4, 1, seconds),
        "SieveEnv": rate_of_env(single, action, seconds),
        "engines": rate_of_engines(scene, arguments.sieves, arguments.threads, seconds),
        "SieveVectorEnv": rate_of_env(many, actions, seconds),
    } for _ in range(arguments.rounds)]
    lines = []
    for name, one, other, threads in (
            ("SieveEnv over one engine", "SieveEnv", "engine", 1),
            ("SieveVectorEnv over as many engines on as many threads", "SieveVectorEnv", "engines", 1),
            ("SieveVectorEnv per thread over one engine", "SieveVectorEnv", "engine", arguments.threads)):
        wall, processor = (statistics.median(row[one][clock] / row[other][clock] for row in rounds) for clock in (0, 1))
        lines.append([name, f"{wall / threads:.2f}", f"{processor:.2f}"])
    publish(arguments, "env", [f"{origin.text()}; {arguments.sieves} sieves, {arguments.threads} threads, steps of "
                               f"{STEP:g} s, medians of {arguments.rounds} rounds.", "",
                               table(["", "wall time", "processor time"], lines)])


if __name__ == "__main__":
    main()
