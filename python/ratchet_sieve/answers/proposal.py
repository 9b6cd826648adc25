"""Which measurement would narrow the intervals of a calibration most."""
from __future__ import annotations

import itertools
from typing import Any, Iterable, Mapping

import numpy as np

from ratchet_sieve.arguments import mapping
from ratchet_sieve.answers.machine import range_of
from ratchet_sieve.texts import shown
from ratchet_sieve.values import Values

POINTS = {1: 7, 2: 3}  # of a grid, along each of one and two ranges
FEWEST = 2             # of more
RUNS = 24              # at each setting, with coefficients as likely as those of the answer


def settings_of(scene: Any, over: Mapping[str, Any], unknown: Iterable[str]) -> list[dict]:
    """A grid over ranges. @param unknown keys, which have none. Raises ValueError, SceneError."""
    ends = [range_of(key, over[key]) for key in mapping("over", over, '{"base.inclination": (0.0, 0.35)}')]
    axes = [[float(f"{value:.4g}") for value in np.linspace(*each, POINTS.get(len(ends), FEWEST))] for each in ends]
    settings = [dict(zip(over, values)) for values in itertools.product(*axes)]
    for key in set(over) & set(unknown):
        raise ValueError(f"over[{key!r}]: is unknown as well")
    for setting in (settings[0], settings[-1]):
        scene.replace(setting)
    return settings


def proposed(calibration: Any, over: list[dict]) -> Values:
    """The setting of these at which another measurement like the first one would narrow the intervals most. What a
    number says of the coefficients is linear in them where these are likely, so that their covariance S becomes
    S − S G (Gᵀ S G + V)⁻¹ Gᵀ S, where G are the slopes of the numbers and V their variances."""
    settings = [{**calibration.data.settings[0], **setting} for setting in over]
    places = calibration.draws[:RUNS]
    rows = calibration.rows_of(places, settings)
    covariance = np.atleast_2d(np.cov(calibration.draws.T))
    design = np.column_stack([np.ones(RUNS), places])
    shrunk = []
    for k in range(len(settings)):
        left = covariance
        for number in calibration.data.numbers:
            if number.row > 0:
                break
            values, _ = calibration.values_of(number, rows[k])
            defined = np.isfinite(values)
            if defined.sum() < 2 * design.shape[1]:
                continue
            slopes, _, _, _ = np.linalg.lstsq(design[defined], values[defined], rcond=None)
            noise = float(((values - design @ slopes)[defined] ** 2).sum()) / (defined.sum() - design.shape[1])
            across = left @ slopes[1:]
            left = left - np.outer(across, across) / (slopes[1:] @ across + noise)
        shrunk.append(np.sqrt(np.diag(left) / np.diag(covariance)))
    best = int(np.log(shrunk).sum(axis=1).argmin())
    return Values(setting=over[best], errors=dict(zip(calibration.keys, map(float, shrunk[best]))))


def text_of(found: Values) -> str:
    key, part = min(found.errors.items(), key=lambda item: item[1])
    at = ", ".join(f"{name} = {shown(value)}" for name, value in found.setting.items())
    return f"measure next: {at}, as long as before: the error of {key} falls to {100.0 * part:.0f} % of what it is"
