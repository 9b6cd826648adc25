"""Additions A2a and A2b, by fresh seeds: claim 6 on the teeth that the maps of two parameters found."""
from ratchet_sieve import plots
from paper import parting
from paper.parting import ANGLES
from study import THETA, WAYS, Picture, Study, csv_lines, ways
import verdicts

W, H = "base.tooth_width", 0.009  # m: the height of all of them
LEVEL, TILTED = 0.0, 0.052


def name(w):
    return f"w = {plots.MM * w:g} mm, h = {plots.MM * H:g} mm"


def parted(means):
    """At both angles: A's mean velocity and B's to the left."""
    for theta in ANGLES:
        a, b = means[theta]
        yield f"A at {theta:g}", a
        yield f"B at {theta:g}", b.scaled(-1.0)


def level(means):
    a, b = means[LEVEL]
    return (("A at 0", a), ("B at 0", b), ("B less A at 0", b.minus(a)))


def claims(numbers):
    """@param numbers of each width: map from θ to both species' mean velocities [m/s]"""
    return [whole(f"A2{letter}", w, means) for letter, (w, means) in zip("ab", numbers.items())]


def whole(number, w, means):
    """All of claim 6 on these teeth."""
    return verdicts.Claim(number, "Fig. 8", f"all of claim 6 comes out on narrower and higher teeth: {name(w)}", (
        verdicts.counted("θ = 0: both to the right, and B is faster", level(means)).about("θ = 0"),
        parting.differ_little("θ = 0.052: they differ by less than a third of that at 0",
                              *(means[theta][1].minus(means[theta][0]) for theta in (LEVEL, TILTED))
                              ).about("θ = 0.052"),
        verdicts.counted("θ = 0.105 and 0.157: A right and B left", parted(means)).about("θ = 0.105 and 0.157")))


TEXT = ("The paper gives w = 20 mm and h = 6 mm; that its Fig. 8 was made with other teeth is a possibility, and no "
        "more.")

STUDY = Study("parting_teeth", "Claim 6 on narrower and higher teeth, by fresh seeds",
              ("parting_teeth_fresh",),
              lambda rows: {w: ways(group, THETA) for w, group in sorted(rows["parting_teeth_fresh"].by(W).items())},
              (Picture("parting_teeth", "Mean velocities of Fig. 8's mixture on narrower and higher teeth, d = 3.93; "
                       "bars: standard errors over the seeds",
                       lambda numbers: parting.draw_ways({name(w): means for w, means in numbers.items()})),),
              claims, lambda numbers: TEXT,
              tables=lambda numbers: {"parting_teeth": csv_lines(("w_m", "theta_rad"), WAYS, {
                  (w, theta): pair for w, means in numbers.items() for theta, pair in means.items()})})
