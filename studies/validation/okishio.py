"""One ball over the asymmetry of the teeth (Okishio, Ito, Kitahata 2022)."""
from ratchet_sieve import plots
from ratchet_sieve.stats import mean_of
from ratchet_sieve.tables import Rows
from study import Picture, Study, Sweep, axis, means, velocity_table
import verdicts

E = "species.0.restitution"
A = "base.asymmetry"
SYMMETRIC = 0.5
NO_DRIFT = 0.001  # m/s


def evaluate(rows):
    """@return mean velocities [m/s]: of each (a, e); of symmetric teeth over all e; mirror_of()"""
    rows = rows["validation_okishio"]
    symmetric = rows.where({A: SYMMETRIC}).by("seed").values()
    return {"means": means(rows, "mean_vx.A", A, E),
            "symmetric": mean_of(group.mean("mean_vx.A").value for group in symmetric), "mirror": mirror_of(rows)}


def draw(numbers):
    velocities = numbers["means"]
    figure, axes = plots.panels(1, 1, (6.4, 4.0))
    for e, colour in zip(axis(velocities, 1), plots.COLOURS):
        plots.curve(axes, [(a, velocities[a, e]) for a in axis(velocities, 0)], plots.MM, color=colour,
                    label=f"e = {e:g}")
    plots.signed(axes)
    axes.axvline(SYMMETRIC, color=plots.GREY, linewidth=0.8, zorder=1)
    axes.set(xlabel="asymmetry $a$", ylabel=r"$\langle V_x \rangle$ [mm/s]")
    axes.legend()
    return figure


def gentler(velocities):
    """To where the gentler slopes face: to the right for a < 1/2."""
    for (a, e), mean in sorted(velocities.items(), key=lambda item: item[0][::-1]):
        if a != SYMMETRIC:
            yield f"e = {e:g}, a = {a:g}", mean.scaled(1.0 if a < SYMMETRIC else -1.0)


def mirror_of(rows):
    """v(a) + v(1 − a) in the mean over all a and e, a sample a seed: zero where they are mirror images."""
    pairs = Rows(rows.frame[rows.frame[A] != SYMMETRIC])
    return mean_of(2.0 * group.mean("mean_vx.A").value for group in pairs.by("seed").values())


def no_drift(says, mean):
    return verdicts.within(says, mean, -NO_DRIFT, NO_DRIFT, plots.MM, "mm/s")


def claims(numbers):
    return [verdicts.Claim("5", "Okishio 2022, abstract", "one ball is transported to where the gentler slopes face; "
                           "its mean velocity is a function of the asymmetry", (
                               verdicts.counted("so it is at every asymmetry and restitution", gentler(numbers["means"])),
                               no_drift("at a = 0.5 less than 1 mm/s, in the mean over e", numbers["symmetric"]),
                               no_drift("1 − a is the mirror image of a: v(a) + v(1 − a), in the mean over all, is "
                                        "less than 1 mm/s", numbers["mirror"])))]


def text(numbers):
    return velocity_table(numbers["means"], "a", "{:g}".format, "e = {:g}".format)


STUDY = Study("okishio", "One ball over the asymmetry (Okishio and others 2022)",
              (Sweep("validation_okishio", {A: (SYMMETRIC,)}),), evaluate,
              (Picture("okishio", "Mean velocity of single balls over the asymmetry of the teeth; bars: standard "
                       "errors over the seeds", draw),), claims, text)
