"""Fig. 7: the mean velocity of small and of large single disks over the frequency, for several inclinations."""
from reproduce import drawing, verdicts
from reproduce.document import table
from reproduce.study import Picture, Study, Sweep

THETA = "base.inclination"
F = "base.frequency"
KINDS = {"A": "r = 1 mm", "B": "r = 4 mm"}
SHOWN = 23.0  # Hz


def velocities(rows):
    """@return of each kind: map from (θ, f) to the mean velocity [m/s]"""
    groups = rows.by(THETA, F)
    return {kind: {place: group.mean(f"mean_vx.{kind}") for place, group in groups.items()} for kind in KINDS}


def evaluate(rows):
    return velocities(rows["paper_fig7"])


def axis(means, index):
    return sorted({place[index] for place in means})


def draw_kinds(means, names):
    """A panel for each kind: a curve over f for each inclination."""
    figure, both = drawing.panels(1, 2, (8.6, 4.2), sharey=True)
    for axes, (kind, name) in zip(both, names.items()):
        inclinations = axis(means[kind], 0)
        for theta, colour in zip(inclinations, drawing.ramp(len(inclinations))):
            points = [(f, means[kind].get((theta, f))) for f in axis(means[kind], 1)]
            drawing.curve(axes, points, drawing.MM, color=colour, label=rf"$\theta$ = {theta:g}".replace("-", "−"))
        drawing.signed(axes)
        axes.set_title(name)
        axes.set_xlabel("$f$ [Hz]")
    both[0].set_ylabel(r"$\langle V_x \rangle$ [mm/s]")
    both[1].legend(loc="center left", bbox_to_anchor=(1.0, 0.5))
    return figure


def draw(means):
    return draw_kinds(means, KINDS)


def range_over_inclinations(means, f):
    """What a kind loses from the least inclination to the greatest [m/s]."""
    inclinations = axis(means, 0)
    return means[inclinations[0], f].minus(means[inclinations[-1], f])


def more_moved(means):
    """At each f: that θ moves the large ones more than the small ones, over all its range."""
    for f in axis(means["A"], 1):
        small, large = (range_over_inclinations(means[kind], f) for kind in KINDS)
        yield f"{f:g} Hz", large.minus(small).surely_above(0.0)


def claims(means):
    ranges = {kind: range_over_inclinations(means[kind], SHOWN) for kind in KINDS}
    factor = ranges["B"].value / ranges["A"].value
    return [verdicts.Claim("5", "Fig. 7", "θ moves large disks (r = 4 mm) more than small ones (r = 1 mm), over f", (
        verdicts.above(f"at {SHOWN:g} Hz the large lose more from the least θ to the greatest, {factor:.2f} times as "
                       "much", ranges["B"].minus(ranges["A"]), 0.0, drawing.MM, "mm/s more"),
        verdicts.counted("and so they do at every f", more_moved(means))))]


def text(means):
    frequencies = axis(means["A"], 1)
    lines = [[f"{theta:g}".replace("-", "−"), kind] + [means[kind][theta, f].text(drawing.MM) for f in frequencies]
             for theta in axis(means["A"], 0) for kind in KINDS]
    return "⟨V_x⟩ in mm/s:\n\n" + table(["θ [rad]", ""] + [f"{f:g} Hz" for f in frequencies], lines)


STUDY = Study("fig7", "Fig. 7: velocity over frequency, for small and large disks",
              (Sweep("paper_fig7", {F: (SHOWN,), THETA: (0.0, 0.262)}),), evaluate,
              (Picture("fig7", "Mean velocity of single disks of 1 mm and of 4 mm over the frequency, for ten "
                       "inclinations; bars: standard errors over the seeds", draw),), claims, text)
