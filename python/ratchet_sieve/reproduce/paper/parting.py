"""Which way both kinds of Fig. 8's mixture go, and where they part as the paper's do."""
from ratchet_sieve import plots
from ratchet_sieve.reproduce import verdicts

THETA = "base.inclination"
D = "density"
PRINTED = 3.93           # the paper's density
ANGLES = (0.105, 0.157)  # where the paper has A go to the right and B to the left [rad]

PARTED = "A right, B left"
RIGHT = "both right"
LEFT = "both left"
OTHER = "A left, B right"
UNTOLD = "undecided"
COLOURS = {PARTED: plots.COLOURS[2], RIGHT: plots.COLOURS[5], LEFT: plots.COLOURS[4], OTHER: plots.COLOURS[3],
           UNTOLD: "#EEEEEE"}
CLASSES = {(True, False): PARTED, (True, True): RIGHT, (False, False): LEFT, (False, True): OTHER}


def ways(rows):
    """@return of each kind its mean velocity [m/s]"""
    return rows.mean("mean_vx.A"), rows.mean("mean_vx.B")


def class_of(pair):
    """@param pair of ways(); None in either is undecided"""
    return CLASSES.get(tuple(mean and mean.surely_above(0.0) for mean in pair), UNTOLD)


def parted(says, pair):
    """A check that A goes to the right and B to the left."""
    a, b = pair
    return verdicts.both(verdicts.above(says, a, 0.0, plots.MM, "mm/s"),
                         verdicts.below(says, b, 0.0, plots.MM, "mm/s"))
