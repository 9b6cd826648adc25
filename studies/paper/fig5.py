"""Fig. 5: the mean velocity of single disks over the frequency, for nine asymmetries of the tooth."""
from ratchet_sieve import plots
from ratchet_sieve.stats import mean_of
from study import A, F, Picture, Study, axis, csv_lines, means, named_curves
import verdicts

SYMMETRIC = 0.5
NO_DRIFT = 0.001  # m/s


def evaluate(rows):
    """@return mean velocities: of each (f, a), and of the symmetric tooth over all f [m/s]"""
    rows = rows["paper_fig5"]
    seeds = rows.where({A: SYMMETRIC}).by("seed").values()
    return {"means": means(rows, "mean_vx.A", F, A),
            "symmetric": mean_of(group.mean("mean_vx.A").value for group in seeds)}


def draw(axes, numbers):
    velocities = numbers["means"]
    frequencies, asymmetries = axis(velocities, 0), axis(velocities, 1)
    ends = named_curves(axes, {f"{a:g}": [(f, velocities[f, a]) for f in frequencies] for a in asymmetries},
                        plots.signed_ramp([round(SYMMETRIC - a, 9) for a in asymmetries]), plots.MM)
    plots.signed(axes)
    axes.set(xlabel="$f$ [Hz]", ylabel=r"$\langle V_x \rangle$ [mm/s]")
    plots.end_labels(axes, ends, "$a$")


def direction(velocities):
    for (f, a), mean in sorted(velocities.items(), key=lambda item: item[0][::-1]):
        if a != SYMMETRIC:
            yield f"a = {a:g} at {f:g} Hz", mean.scaled(1.0 if a < SYMMETRIC else -1.0)


def order(velocities):
    """At each f, of each two neighbouring asymmetries on one side of 1/2."""
    for f in axis(velocities, 0):
        for side in (lambda a: a <= SYMMETRIC, lambda a: a >= SYMMETRIC):
            values = [a for a in axis(velocities, 1) if side(a)]
            for less, more in zip(values, values[1:]):
                yield f"{less:g} and {more:g} at {f:g} Hz", velocities[f, less].minus(velocities[f, more])


def claims(numbers):
    velocities = numbers["means"]
    return [verdicts.Claim("4", "Fig. 5", "the more asymmetric the tooth, the faster; a decides the direction", (
        verdicts.counted("to the right for a < 0.5, to the left for a > 0.5, at every f", direction(velocities)).about(
            "the direction"),
        verdicts.counted("of each two neighbouring a on one side of 0.5 the more asymmetric is faster, at every f",
                         order(velocities)).about("the order of speeds"),
        verdicts.within("at a = 0.5 less than 1 mm/s, in the mean over f", numbers["symmetric"], -NO_DRIFT, NO_DRIFT,
                        plots.MM, "mm/s").about("none at a = 0.5")))]


STUDY = Study("fig5", "Fig. 5: velocity over frequency, for nine asymmetries",
              ("paper_fig5",), evaluate,
              (Picture("fig5", "Mean velocity of single disks over the frequency; bars: standard errors over the seeds",
                       draw, size=(6.4, 4.2)),), claims, tables=lambda numbers: {
                           "fig5": csv_lines(("f_hz", "a"), ("mean_vx_m_per_s",), numbers["means"])})
