"""Places within ranges, each from 0 to 1."""
import numpy as np


def spread(ranges, count, seed):
    """Places that fill the ranges evenly: a Kronecker sequence of the generalised golden ratio (Schretter et al., Math.
    Comput. Simul. 82, 2012), from a random one on."""
    ratio = 2.0
    for _ in range(60):
        ratio = (1.0 + ratio) ** (1.0 / (ranges + 1.0))
    steps = ratio ** -np.arange(1.0, ranges + 1.0)
    return (np.random.default_rng(seed).random(ranges) + np.arange(count)[:, None] * steps) % 1.0
