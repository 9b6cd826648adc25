"""Which cases of a sweep --quick runs: one rule for all sweeps."""
import math

QUICK_SEEDS = 3   # --quick runs a quarter of the seeds, and so many at least
QUICK_VALUES = 4  # of a key with more values than these, every second one
QUICK_RULE = (f"a quarter of the seeds, but {QUICK_SEEDS} at least, and of a key with more than {QUICK_VALUES} values "
              "every second one and those that a claim needs; the longest sweeps are left out")


def thinned(values, needed):
    if isinstance(values, dict):  # from, to, count
        step = (values["to"] - values["from"]) / (values["count"] - 1)
        values = [float(f"{values['from'] + k * step:.15g}") for k in range(values["count"])]
    if len(values) <= QUICK_VALUES:
        return values
    return [value for k, value in enumerate(values)
            if k % 2 == 0 or any(math.isclose(value, kept, abs_tol=1e-12) for kept in needed)]


def quick_definition(definition, needed):
    """A sweep's definition as --quick runs it: its cases are among those of the whole."""
    quick = dict(definition)
    if "grid" in definition:
        quick["grid"] = {key: thinned(values, needed.get(key, ())) for key, values in definition["grid"].items()}
    if "seed" in definition:
        seed = definition["seed"]
        count = min(seed["count"], max(QUICK_SEEDS, seed["count"] // 4))
        quick["seed"] = {"first": seed["first"], "count": count}
    return quick
