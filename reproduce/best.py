"""What is reached at the best value of a key, without the luck of having chosen it by the same samples."""
import dataclasses

from reproduce.crossings import curve_of
from reproduce.samples import mean_of


@dataclasses.dataclass(frozen=True)
class Best:
    at: float       # the key's value that is best in the mean over all seeds
    mean: object    # Mean of the field: of each seed at the value that is best in the mean over the others


def best_of(rows, key, field):
    """@return None where the field is defined nowhere, or there is one seed alone"""
    seeds = rows.values("seed")
    samples = []
    for seed in seeds:
        curve = curve_of(rows, key, field, [other for other in seeds if other != seed])
        if curve:
            x = max(curve, key=lambda point: point[1])[0]
            samples += rows.where({key: x, "seed": seed}).samples(field)
    curve = curve_of(rows, key, field, seeds)
    if not samples or not curve:
        return None
    return Best(max(curve, key=lambda point: point[1])[0], mean_of(samples))
