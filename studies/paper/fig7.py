"""Fig. 7: the mean velocity of small and of large single disks over the frequency, for several inclinations."""
from ratchet_sieve import plots
from ratchet_sieve.texts import shown
from study import F, THETA, Picture, Study, axis, csv_lines, means
import verdicts

KINDS = {"A": "r = 1 mm", "B": "r = 4 mm"}
SHOWN = 23.0  # Hz


def velocities(rows):
    """@return of each kind: map from (θ, f) to the mean velocity [m/s]"""
    return {kind: means(rows, f"mean_vx.{kind}", THETA, F) for kind in KINDS}


def draw_kinds(means, names):
    """A panel for each kind: a curve over f for each inclination."""
    figure, both = plots.panels(1, 2, (8.6, 4.2), sharey=True)
    labels = []
    for axes, (kind, name) in zip(both, names.items()):
        inclinations, frequencies = axis(means[kind], 0), axis(means[kind], 1)
        colours = plots.signed_ramp(inclinations)
        for theta, colour in zip(inclinations, colours):
            plots.curve(axes, [(f, means[kind].get((theta, f))) for f in frequencies], plots.MM, color=colour)
        plots.signed(axes)
        axes.set(title=name, xlabel="$f$ [Hz]")
        labels.append([(plots.MM * means[kind][theta, frequencies[-1]].value, shown(theta), colour)
                       for theta, colour in zip(inclinations, colours)])
    both[0].set_ylabel(r"$\langle V_x \rangle$ [mm/s]")
    for axes, ends in zip(both, labels):
        plots.end_labels(axes, ends, r"$\theta$ [rad]")
    return figure


def range_over_inclinations(means, f):
    """What a kind loses from the least inclination to the greatest [m/s]."""
    inclinations = axis(means, 0)
    return means[inclinations[0], f].minus(means[inclinations[-1], f])


def more_moved(means):
    """At each f: how much more the large ones lose over the range of θ than the small ones."""
    for f in axis(means["A"], 1):
        small, large = (range_over_inclinations(means[kind], f) for kind in KINDS)
        yield f"{f:g} Hz", large.minus(small)


def claims(means):
    ranges = {kind: range_over_inclinations(means[kind], SHOWN) for kind in KINDS}
    factor = ranges["B"].value / ranges["A"].value
    return [verdicts.Claim("5", "Fig. 7", "θ moves large disks (r = 4 mm) more than small ones (r = 1 mm), over f", (
        verdicts.above(f"at {SHOWN:g} Hz the large lose more from the least θ to the greatest, {factor:.2f} times as "
                       "much", ranges["B"].minus(ranges["A"]), 0.0, plots.MM, "mm/s more").about(
                           f"at {SHOWN:g} Hz"),
        verdicts.counted("and so they do at every f", more_moved(means)).about("at every f")))]


def velocity_lines(means):
    return csv_lines(("kind", "theta_rad", "f_hz"), ("mean_vx_m_per_s",), {
        (kind, *place): mean for kind in KINDS for place, mean in means[kind].items()})


STUDY = Study("fig7", "Fig. 7: velocity over frequency, for small and large disks",
              ("paper_fig7",), lambda rows: velocities(rows["paper_fig7"]),
              (Picture("fig7", "Mean velocity of single disks of 1 mm and of 4 mm over the frequency, for ten "
                       "inclinations; bars: standard errors over the seeds", lambda means: draw_kinds(means, KINDS)),),
              claims, tables=lambda means: {"fig7": velocity_lines(means)})
