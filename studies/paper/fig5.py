"""Fig. 5: the mean velocity of single disks over the frequency, for nine asymmetries of the tooth."""
from ratchet_sieve import plots
from ratchet_sieve.stats import mean_of
from ratchet_sieve.texts import table
from study import Picture, Study, Sweep, axis
import verdicts

A = "base.asymmetry"
F = "base.frequency"
SYMMETRIC = 0.5
NO_DRIFT = 0.001  # m/s


def evaluate(rows):
    """@return mean velocities: of each (a, f), and of the symmetric tooth over all f [m/s]"""
    rows = rows["paper_fig5"]
    seeds = rows.where({A: SYMMETRIC}).by("seed").values()
    return {"means": {place: group.mean("mean_vx.A") for place, group in rows.by(A, F).items()},
            "symmetric": mean_of(group.mean("mean_vx.A").value for group in seeds)}


def draw(numbers):
    means = numbers["means"]
    figure, axes = plots.panels(1, 1, (6.4, 4.2))
    asymmetries = axis(means, 0)
    frequencies = axis(means, 1)
    ends = []
    for a, colour in zip(asymmetries, plots.signed_ramp([round(SYMMETRIC - a, 9) for a in asymmetries])):
        plots.curve(axes, [(f, means[a, f]) for f in frequencies], plots.MM, color=colour)
        ends.append((plots.MM * means[a, frequencies[-1]].value, f"{a:g}", colour))
    plots.signed(axes)
    axes.set(xlabel="$f$ [Hz]", ylabel=r"$\langle V_x \rangle$ [mm/s]")
    plots.end_labels(axes, ends, "$a$")
    return figure


def direction(means):
    for (a, f), mean in means.items():
        if a != SYMMETRIC:
            yield f"a = {a:g} at {f:g} Hz", mean.scaled(1.0 if a < SYMMETRIC else -1.0)


def order(means):
    """At each f, of each two neighbouring asymmetries on one side of 1/2."""
    for f in axis(means, 1):
        for side in (lambda a: a <= SYMMETRIC, lambda a: a >= SYMMETRIC):
            values = [a for a in axis(means, 0) if side(a)]
            for less, more in zip(values, values[1:]):
                yield f"{less:g} and {more:g} at {f:g} Hz", means[less, f].minus(means[more, f])


def claims(numbers):
    means = numbers["means"]
    return [verdicts.Claim("4", "Fig. 5", "the more asymmetric the tooth, the faster; a decides the direction", (
        verdicts.counted("to the right for a < 0.5, to the left for a > 0.5, at every f", direction(means)),
        verdicts.counted("of each two neighbouring a on one side of 0.5 the more asymmetric is faster, at every f",
                         order(means)),
        verdicts.within("at a = 0.5 less than 1 mm/s, in the mean over f", numbers["symmetric"], -NO_DRIFT, NO_DRIFT,
                        plots.MM, "mm/s")))]


def text(numbers):
    means = numbers["means"]
    asymmetries = axis(means, 0)
    return ("⟨V_x⟩ in mm/s:\n\n"
            + table(["f"] + [f"a = {a:g}" for a in asymmetries],
                    [[f"{f:g} Hz"] + [means[a, f].text(plots.MM) for a in asymmetries] for f in axis(means, 1)]))


STUDY = Study("fig5", "Fig. 5: velocity over frequency, for nine asymmetries",
              (Sweep("paper_fig5", {A: (0.5,)}),), evaluate,
              (Picture("fig5", "Mean velocity of single disks over the frequency; bars: standard errors over the seeds",
                       draw),), claims, text)
