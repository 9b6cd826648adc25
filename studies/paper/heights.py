"""Addition A8: whether the large disks of Fig. 9's mixture lie above the small ones, as section 3.2.2 suspects."""
from ratchet_sieve import plots
from study import D, Picture, Study, csv_lines, over
import verdicts

RADII = {"A": 0.001, "B": 0.005}  # m
KINDS = {"A": "A: 1 mm, 10 g", "B": "B: 5 mm, 1 g"}


def lowest(kind):
    """The mean height of the disks' lowest points [m]."""
    return lambda frame: frame[f"height_profile.mean_height.{kind}"] - RADII[kind]


def evaluate(rows):
    """@return of each density: of A, of B, and of B less A, seed by seed [m]"""
    def difference(frame):
        return lowest("B")(frame) - lowest("A")(frame)
    return over(rows["paper_heights"], (lowest("A"), lowest("B"), difference), D)


def draw(axes, heights):
    for k, (kind, colour) in enumerate(zip(KINDS, plots.COLOURS)):
        plots.curve(axes, [(d, found[k]) for d, found in heights.items()], plots.MM, color=colour, label=KINDS[kind])
    axes.set(xlabel="density $d$", ylabel="mean height of the lowest point [mm]")
    axes.set_ylim(bottom=0.0)
    axes.legend()


def rising(heights):
    found = [(d, own[2]) for d, own in heights.items()]
    for (low, first), (high, second) in zip(found, found[1:]):
        yield f"d = {low:g} to {high:g}", second.minus(first)


def claims(heights):
    first, last = (heights[choose(heights)][2].text(plots.MM) for choose in (min, max))
    says = (f"B's lowest points are higher than A's, by {first} mm at d = {min(heights):g} to {last} mm at "
            f"d = {max(heights):g}")
    return [verdicts.Claim("A8", "3.2.2", "the large disks of Fig. 9's mixture lie above the small ones, the more so "
                           "the higher d (the Brazil-nut remark)", (
                               verdicts.counted(says, [(f"d = {d:g}", found[2]) for d, found in heights.items()]
                                                ).about("B higher"),
                               verdicts.counted("the difference rises from each d to the next", rising(heights)
                                                ).about("the more so the higher d")))]


TEXT = ("Periodic base, θ = 0.2. The paper says that this \"might be related\" to the lower quality, which was not "
        "tested. B is also 10 times lighter than A, so that the difference is not one of size alone.")


STUDY = Study("heights", "The heights of both species of Fig. 9's mixture", ("paper_heights",), evaluate,
              (Picture("heights", "Mean heights of the disks' lowest points above the teeth's lowest corners over the "
                       "density, at θ = 0.2; bars: standard errors over the seeds", draw, size=(6.4, 3.6)),), claims,
              lambda heights: TEXT,
              tables=lambda heights: {"heights": csv_lines((D,), ("a_m", "b_m", "b_less_a_m"), heights)})
