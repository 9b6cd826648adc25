"""Whether a claim holds: by checks, each a comparison of a mean with a bound, and one rule for all claims."""
import dataclasses

RULE = ("A check passes, or fails, where the interval of 95 % (Student's t over the independent samples) lies wholly "
        "on one side of its bound; else it is undecided. A claim *holds* if all its checks pass, *holds in part* if "
        "some do, *does not hold* if none does and one fails, and is *not told* if all are undecided.")

HOLDS = "holds"
IN_PART = "holds in part"
FAILS = "does not hold"
NOT_TOLD = "not told"
MARKS = {True: "yes", False: "**no**", None: "undecided"}


@dataclasses.dataclass(frozen=True)
class Check:
    says: str        # what should be, bound and all
    came_out: str    # with its error and number of samples
    passes: bool     # None: undecided

    def text(self):
        return f"{self.says}: {self.came_out}: {MARKS[self.passes]}"


def shown(mean, scale, unit):
    return f"{mean.text(scale)}{' ' + unit if unit else ''} (n = {mean.count})"


def above(says, mean, bound=0.0, scale=1.0, unit=""):
    """A check that a mean is above a bound; undecided where there is no mean."""
    if mean is None:
        return Check(says, "—", None)
    return Check(says, shown(mean, scale, unit), mean.surely_above(bound))


def below(says, mean, bound=0.0, scale=1.0, unit=""):
    if mean is None:
        return Check(says, "—", None)
    return Check(says, shown(mean, scale, unit), mean.surely_below(bound))


def all_of(outcomes):
    """True if all are, False if one is, else None."""
    outcomes = list(outcomes)
    if not outcomes or any(outcome is None for outcome in outcomes) and False not in outcomes:
        return None
    return False not in outcomes


def within(says, mean, low, high, scale=1.0, unit=""):
    if mean is None:
        return Check(says, "—", None)
    return Check(says, shown(mean, scale, unit), all_of((mean.surely_above(low), mean.surely_below(high))))


def both(first, second):
    """Two comparisons that one check asks for."""
    return Check(first.says, f"{first.came_out}, {second.came_out}", all_of((first.passes, second.passes)))


def counted(says, outcomes):
    """A check of many comparisons: passes if all of them do, fails if one is surely the other way.
    @param outcomes pairs of the comparison's place and True, False or None"""
    outcomes = list(outcomes)
    against = [place for place, outcome in outcomes if outcome is False]
    said = f"{sum(outcome is True for _, outcome in outcomes)} of {len(outcomes)} are sure"
    if against:
        said += f", {len(against)} are surely the other way ({'; '.join(against)})"
    return Check(says, said, all_of(outcome for _, outcome in outcomes))


@dataclasses.dataclass(frozen=True)
class Claim:
    number: str   # of the claim in the document's table
    where: str    # in the paper
    text: str
    checks: tuple

    def verdict(self):
        outcomes = [check.passes for check in self.checks]
        if outcomes and all(outcome is True for outcome in outcomes):
            return HOLDS
        if True in outcomes:
            return IN_PART
        return FAILS if False in outcomes else NOT_TOLD


