#!/usr/bin/python3
"""Learns at which inclination a fed sieve separates best, by the cross-entropy method: each generation tries
inclinations drawn from a normal distribution, one in each of many sieves, and fits the distribution to the best ones.
Draws what was tried and learned. The sieve is that of docs/seeking.md, where seek.py and a sweep find 0.15 rad.
"""
import argparse

import numpy as np
from matplotlib.figure import Figure

import ratchet_sieve as rs
from ratchet_sieve import places

SIEVES, ELITE = 16, 4
STEP, WINDOW, EPISODE = 20.0, 40.0, 60.0  # [s]; the first step is left for the base to turn and the layer to settle
KNOWN_BEST = 0.15  # [rad], by the sweep of docs/seeking.md


def learn(sieves, generations, random):
    """@return of each generation: the inclinations tried, their Q, mean and deviation of the next distribution"""
    low, high = sieves.single_action_space.low, sieves.single_action_space.high
    mean, deviation = 0.0, 0.25
    for generation in range(generations):
        inclinations = np.clip(random.normal(mean, deviation, (SIEVES, 1)), low, high)
        sieves.reset(seed=1000 * generation)
        ended = np.zeros(SIEVES, dtype=bool)
        while not ended.any():
            _, quality, terminated, truncated, _ = sieves.step(inclinations)
            ended = terminated | truncated
        best = inclinations[np.argsort(quality)[-ELITE:], 0]
        mean, deviation = best.mean(), max(best.std(), 0.5 * deviation, 0.005)
        print(f"generation {generation + 1}: mean Q {quality.mean():.3f}, best {quality.max():.3f}; "
              f"next {mean:.3f} ± {deviation:.3f} rad")
        yield inclinations[:, 0], quality, mean, deviation


def draw(generations, path):
    figure = Figure(figsize=(8.0, 4.0), layout="constrained")
    axes = figure.subplots()
    number = np.arange(1, len(generations) + 1)
    tried = axes.scatter(np.repeat(number, SIEVES), [theta for row in generations for theta in row[0]], s=18,
                         c=[quality for row in generations for quality in row[1]], cmap="viridis")
    mean, deviation = np.array([row[2:] for row in generations]).T
    axes.plot(number + 0.5, mean, color="black", label="learned: mean ± deviation of the best")
    axes.fill_between(number + 0.5, mean - deviation, mean + deviation, color="black", alpha=0.15, linewidth=0.0)
    axes.axhline(KNOWN_BEST, color="tab:red", linestyle="--", label="best by a sweep")
    axes.set(xlabel="generation", ylabel="inclination [rad]", xlim=(0.5, len(generations) + 1.0))
    axes.legend()
    figure.colorbar(tried, label="Q of the last 40 s")
    figure.savefig(path)


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seed", type=int, default=1, help="of the inclinations that are drawn (default: 1)")
    parser.add_argument("--generations", type=int, default=10)
    parser.add_argument("--picture", default="learn_inclination.png", metavar="FILE")
    arguments = parser.parse_args(arguments)
    scene = rs.Scene.load(places.SHARE / "config/seek.yaml")
    sieves = rs.env.SieveVectorEnv(scene, SIEVES, step=STEP, window=WINDOW, episode=EPISODE, autoreset="disabled")
    generations = list(learn(sieves, arguments.generations, np.random.default_rng(arguments.seed)))
    print(f"learned {generations[-1][2]:.3f} rad; best by a sweep {KNOWN_BEST} rad")
    draw(generations, arguments.picture)
    return generations[-1][2]


if __name__ == "__main__":
    main()
