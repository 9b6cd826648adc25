"""On which coefficients a result depends: a linear regression of what runs say on the values that they had (Saltelli et
al., Global Sensitivity Analysis: The Primer, Wiley 2008, sect. 1.2.5)."""
from __future__ import annotations

import itertools
from typing import Any, Optional

import numpy as np
import pandas
from scipy import linalg, special

from ratchet_sieve.answers.unknown import Unknown
from ratchet_sieve.texts import at_most, plus_minus

SURE = 0.05      # of the test whether there is any dependence
ENOUGH = 2.0     # runs for each key and the mean, at least
SMALL = 0.05     # a share that is not named
SCREENED = {"restitution": 0.05, "friction": 0.3, "tangential_restitution": 0.2}  # by how much they may be wrong
RELATIVE = ("friction",)
PART = 0.12      # of the cost so far, that the line about what is known may cost
SIGNIFICANT = 2.0  # standard errors of an effect that is named


class Dependence:
    """@ivar spread (low, high) of 95 % of the grains, at a setting, with the error of what the runs say; None: too few
    runs @ivar table a row for each key: its `share` of the variance, alone, with the standard `error`; None: no
    dependence is seen @ivar explained R² of the runs"""

    def __init__(self, unknown: Unknown, draws: np.ndarray, values: np.ndarray):
        """@param draws (n, d) of the keys, of each run @param values (n,)"""
        count, keys = draws.shape
        self.spread, self.table, self.explained = None, None, 0.0
        if count < ENOUGH * (keys + 1):
            return
        centre, scale = unknown.table.mean(axis=0), unknown.table.std(axis=0)
        design, inverse, slopes = _fitted((draws - centre) / scale, values)
        freedom = count - keys - 1
        residual = float(((values - design @ slopes) ** 2).sum()) / freedom
        errors = np.sqrt(residual * np.diag(inverse))[1:]
        self.explained = 1.0 - residual * freedom / max(float(((values - values.mean()) ** 2).sum()), 1e-300)
        grains = (unknown.table - centre) / scale
        covariance = np.cov(grains.T, ddof=0).reshape(keys, keys)
        noise = float(np.trace(covariance @ inverse[1:, 1:])) * residual  # what errors of the slopes add
        variance = float(slopes[1:] @ covariance @ slopes[1:])
        shrink = np.sqrt(max(1.0 - noise / max(variance, 1e-300), 0.0))
        low, high = np.quantile(shrink * grains @ slopes[1:], [0.025, 0.975])
        error = special.stdtrit(freedom, 0.975) * np.sqrt(residual * inverse[0, 0] + noise)
        self.spread = float(slopes[0] - np.hypot(low, error)), float(slopes[0] + np.hypot(high, error))
        if special.fdtrc(keys, freedom, variance / max(noise, 1e-300)) > SURE:
            return
        alone = covariance @ slopes[1:]
        shares = np.maximum(alone ** 2 - errors ** 2, 0.0) / max(variance - noise, 1e-300)
        self.table = pandas.DataFrame({"key": unknown.keys, "share": np.minimum(shares, 1.0),
                                       "error": np.minimum(2.0 * np.abs(alone) * errors / variance, 1.0)}) \
            .sort_values("share", ascending=False, ignore_index=True)

    def lines(self, unit: str) -> list[str]:
        lines = []
        if self.spread:
            low, high = (_rounded(end, self.spread[1] - self.spread[0]) for end in self.spread)
            lines.append(f"{low} to {high}{unit} for 95 % of the grains that it may be")
        if self.table is None:
            return [*lines, "on what is unknown no dependence is seen: more runs, or a smaller `within`, may tell"]
        named = self.table[self.table.share >= SMALL]
        rest = "; on the rest less than 5 % each" if len(named) < len(self.table) else ""
        return [*lines,
                "it depends on: " + ", ".join(f"{row.key} {100.0 * row.share:.0f} %" for row in named.itertuples())
                + f"{rest} (linear; of all runs it explains R² = {self.explained:.2f})"]


def _fitted(draws: np.ndarray, values: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """@return the design of a linear regression with a mean, the inverse of its normal matrix, and the slopes"""
    design = np.column_stack([np.ones(len(draws)), draws])
    inverse = np.linalg.pinv(design.T @ design)
    return design, inverse, inverse @ design.T @ values


def _rounded(value: float, width: float) -> str:
    return plus_minus(value, 0.05 * width or 1.0).partition(" ")[0]


def screening(scene: Any) -> Optional[Unknown]:
    """The coefficients that a scene takes as known, with values of both sides of them, each as often and all
    combinations of two alike (Plackett and Burman, Biometrika 33, 305 (1946)). None: it has none but at their ends"""
    keys, values, steps = [], [], []
    for k, name in itertools.product(range(len(scene.species)), SCREENED):
        key = f"species.{k}.{name}"
        value = float(scene[key])
        step = SCREENED[name] * (value if name in RELATIVE else 1.0)
        top = value if name in RELATIVE else 1.0 - value
        if step > 0.0 and top > 0.0:
            keys.append(key)
            values.append(value)
            steps.append(min(step, 0.9 * top, 0.9 * value if value > 0.0 else step))
    if not keys:
        return None
    signs = linalg.hadamard(1 << len(keys).bit_length())[:, 1:len(keys) + 1]
    return Unknown(keys, np.array(values) + signs * np.array(steps))


def known_text(unknown: Unknown, values: np.ndarray, variance: float) -> str:
    """@param values of a run of each row of the table; NaN: it says nothing @param variance of one"""
    steps = unknown.table.std(axis=0)
    signs = (unknown.table - unknown.table.mean(axis=0)) / steps
    defined = np.isfinite(values)
    names = "taken as known: restitution, friction and tangential_restitution of all species"
    if defined.sum() <= len(unknown.keys):
        return f"{names}; too few runs tell on which it depends"
    _, inverse, effects = _fitted(signs[defined], values[defined])
    effects = effects[1:]
    errors = np.sqrt(variance * np.diag(inverse))[1:]
    order = [k for k in np.argsort(-np.abs(effects))[:2] if abs(effects[k]) > SIGNIFICANT * errors[k]]
    if not order:
        return f"{names}; no dependence on them seen: each changes it by less than " \
               f"{at_most(float((np.abs(effects) + SIGNIFICANT * errors).max()))}"
    parts = [f"{unknown.keys[k]} (+{steps[k]:.2g}: {'+' if effects[k] > 0 else ''}"
             f"{plus_minus(effects[k], SIGNIFICANT * errors[k])})" for k in order]
    return f"{names}; it depends most on {' and '.join(parts)}: measure " + ("these" if len(parts) > 1 else "this")
