"""Which way a current goes: with the ratchet, against it, or nowhere."""
from ratchet_sieve import plots
from ratchet_sieve.reproduce import verdicts

NORMAL = "normal"      # to where the gentler slopes face: to the right, as a < 0.5
REVERSED = "reversed"
NONE = "none"
UNTOLD = "undecided"
STILL = 0.00001  # m/s
COLOURS = {NORMAL: plots.COLOURS[0], NONE: "#D9D9D9", REVERSED: plots.COLOURS[1], UNTOLD: "#FFFFFF"}


def regime(mean, least):
    """@param least speed that counts as a current [m/s]"""
    if mean is None:
        return UNTOLD
    if mean.surely_above(least):
        return NORMAL
    if mean.surely_below(-least):
        return REVERSED
    return NONE if verdicts.all_of((mean.surely_above(-least), mean.surely_below(least))) else UNTOLD


def speed_text(mean):
    """In mm/s. A grain that stays in its groove moves by the remainder of a bounce, which is no current."""
    if mean.error is not None and abs(mean.value) + mean.error < STILL:
        return f"below {STILL * plots.MM:g}"
    return mean.text(plots.MM)


def exists(says, means, least, wanted):
    """A check that a regime is somewhere, by a search of the places; it fails only where each surely has another.
    @param means map from the place's name to its Mean"""
    found = {place: mean for place, mean in means.items() if regime(mean, least) == wanted}
    if not found:
        open_ = any(regime(mean, least) == UNTOLD for mean in means.values())
        return verdicts.Check(says, f"at none of {len(means)}", None if open_ else False)
    if wanted == NONE:
        return verdicts.Check(says, f"at {len(found)} of {len(means)}", True, is_searched=True)
    place = max(found, key=lambda name: abs(found[name].value))
    shown = verdicts.shown(found[place], plots.MM, "mm/s")
    return verdicts.Check(says, f"at {len(found)} of {len(means)}, most at {place}: {shown}", True,
                          is_searched=True)
