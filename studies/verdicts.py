"""Whether a claim holds: by checks, each a comparison of a mean with a bound, and one rule for all claims."""
import dataclasses

from ratchet_sieve.plots import MM
from ratchet_sieve.stats import signs

RULE = ("A check compares a mean with a bound. It *holds* or *does not hold* where the 95 % interval (Student's t over "
        "the independent samples) lies wholly on one side of the bound, and is *undecided* otherwise. It is *possible* "
        "where it holds for a value that was chosen among several and not confirmed by fresh seeds. A check of many "
        "comparisons is corrected for their number by Holm's method: \"8 of 8\" says that all eight together are "
        "significant at 5 %. Different claims are not corrected for their number. A claim has the verdict of its checks; where they "
        "differ, it says which.")

HOLDS = "holds"
POSSIBLE = "possible"
FAILS = "does not hold"
UNDECIDED = "undecided"
OUTCOMES = {True: HOLDS, False: FAILS, None: UNDECIDED}
ORDER = (HOLDS, POSSIBLE, FAILS, UNDECIDED)


@dataclasses.dataclass(frozen=True)
class Check:
    says: str        # what should be, bound and all
    came_out: str    # with its error and number of samples
    passes: bool     # None: undecided
    is_searched: bool = False  # passes for a value that was chosen by the same samples
    part: str = ""   # what of the claim it is about, in few words

    def outcome(self):
        return POSSIBLE if self.passes and self.is_searched else OUTCOMES[self.passes]

    def text(self):
        outcome = self.outcome()
        return f"{self.says}: {self.came_out}: {f'**{outcome}**' if outcome == FAILS else outcome}"

    def about(self, part):
        return dataclasses.replace(self, part=part)


def shown(mean, scale, unit):
    return f"{mean.text(scale)}{' ' + unit if unit else ''} (n = {mean.count})"


def opposite(*pair):
    """Whether two means have opposite signs; None where one is not sure."""
    ways = [mean.surely_above(0.0) for mean in pair]
    return None if None in ways else ways[0] != ways[1]


def compared(says, mean, comparison, scale=1.0, unit=""):
    """A check of a mean; undecided where there is none. @param comparison Mean -> whether it passes"""
    if mean is None:
        return Check(says, "—", None)
    return Check(says, shown(mean, scale, unit), comparison(mean))


def above(says, mean, bound=0.0, scale=1.0, unit=""):
    """A check that a mean is above a bound."""
    return compared(says, mean, lambda mean: mean.surely_above(bound), scale, unit)


def below(says, mean, bound=0.0, scale=1.0, unit=""):
    return compared(says, mean, lambda mean: mean.surely_below(bound), scale, unit)


def right(says, mean):
    """A check that a velocity is to the right."""
    return above(says, mean, 0.0, MM, "mm/s")


def left(says, mean):
    return below(says, mean, 0.0, MM, "mm/s")


def speed(mean):
    """A velocity in words."""
    return shown(mean, MM, "mm/s")


def all_of(outcomes):
    """True if all are, False if one is, else None."""
    outcomes = list(outcomes)
    if not outcomes or any(outcome is None for outcome in outcomes) and False not in outcomes:
        return None
    return False not in outcomes


def is_within(mean, low, high):
    return all_of((mean.surely_above(low), mean.surely_below(high)))


def within(says, mean, low, high, scale=1.0, unit=""):
    return compared(says, mean, lambda mean: is_within(mean, low, high), scale, unit)


def both(first, second):
    """Two comparisons that one check asks for."""
    return Check(first.says, f"{first.came_out}, {second.came_out}", all_of((first.passes, second.passes)))


def counted(says, comparisons):
    """A check of many comparisons: passes if all of them do, fails if one is significantly the other way.
    @param comparisons pairs of a place and of the Mean that should be above 0 there"""
    comparisons = list(comparisons)
    outcomes = signs(mean for _, mean in comparisons)
    against = [place for (place, _), outcome in zip(comparisons, outcomes) if outcome is False]
    said = f"{outcomes.count(True)} of {len(outcomes)}"
    if against:
        said += f", {len(against)} significantly the other way ({'; '.join(against)})"
    return Check(says, said, all_of(outcomes))


@dataclasses.dataclass(frozen=True)
class Claim:
    number: str   # of the claim in the document's table; an addition's begins with a letter
    where: str    # in the paper
    text: str
    checks: tuple
    condition: str = ""  # under which the verdict stands, such as a range of a parameter

    def is_addition(self):
        """Not a claim of the paper."""
        return not self.number[0].isdigit()

    def verdict(self):
        """In one word, or with the parts of each where the checks differ."""
        parts = {}
        for check in self.checks:
            parts.setdefault(check.outcome(), []).append(check.part or check.says)
        if len(parts) > 1:
            return "; ".join(f"{outcome}: {', '.join(dict.fromkeys(parts[outcome]))}"
                             for outcome in ORDER if outcome in parts)
        return next(iter(parts), UNDECIDED)
