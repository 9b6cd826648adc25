"""Draws from a probability density over ranges: adaptive multiple importance sampling (Cornuet, Marin, Mira, Robert,
Scand. J. Stat. 39, 798 (2012))."""
from __future__ import annotations

from typing import Callable

import numpy as np
from scipy import stats

from ratchet_sieve.answers.places import spread

FIRST, EACH = 4096, 1024  # places: spread over the ranges, and of each proposal
PROPOSALS = 5
WIDER = 1.5       # a proposal's variance over that of the weights
LEAST = 20.0      # of the weights, the effective number for each range that a proposal is made from
TINY = 1e-10


def drawn(log_density: Callable, ranges: int, count: int, seed: int) -> tuple[np.ndarray, np.ndarray]:
    """@param log_density of places (n, d) from 0 to 1, but for a constant
    @return places (count, d), in random order, and the one with the highest density"""
    generator = np.random.default_rng(seed)
    places, proposals = spread(ranges, FIRST, seed), []
    logs = log_density(places)
    for _ in range(PROPOSALS):
        weights = _tempered(_log_weights(places, logs, proposals), LEAST * ranges)
        mean = weights @ places
        covariance = WIDER * np.atleast_2d(np.cov(places.T, aweights=weights, ddof=0)) + TINY * np.eye(ranges)
        proposals.append(stats.multivariate_normal(mean, covariance))
        more = proposals[-1].rvs(EACH, random_state=generator).reshape(EACH, ranges)
        more = more[((more >= 0.0) & (more <= 1.0)).all(axis=1)]
        places, logs = np.vstack([places, more]), np.concatenate([logs, log_density(more)])
    weights = _tempered(_log_weights(places, logs, proposals), 0.0)
    steps = (np.arange(count) + generator.random()) / count
    picked = np.minimum(np.searchsorted(np.cumsum(weights), steps), len(places) - 1)
    return places[generator.permutation(picked)], places[logs.argmax()]


def _log_weights(places: np.ndarray, logs: np.ndarray, proposals: list) -> np.ndarray:
    """Of all places as if each had come from the mixture of all proposals."""
    density = FIRST + EACH * sum(proposal.pdf(places) for proposal in proposals)
    return logs - np.log(density)


def _tempered(log_weights: np.ndarray, least: float) -> np.ndarray:
    """Weights, flatter where their effective number would be below the least."""
    while True:
        weights = np.exp(log_weights - log_weights.max())
        weights /= weights.sum()
        if 1.0 / (weights ** 2).sum() >= least:
            return weights
        log_weights = 0.7 * log_weights
