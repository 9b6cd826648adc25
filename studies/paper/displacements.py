"""Figs. 3 and 4: distributions of the displacement of single disks at several times. Each run has one disk."""
import math

from ratchet_sieve import plots
from ratchet_sieve.stats import density_of, mean_of, variance_of
from study import Picture, Study, csv_lines
import verdicts

TIME = "duration"
BIN = 0.04  # m: two teeth; narrower bins would show the valleys in which disks rest
FIGURES = {"fig3": 0.0, "fig4": 0.209}  # and their inclinations [rad]


def displacement(row):
    """A run counts from its start: settle is 0."""
    return row["mean_vx.A"] * row["simulated_time"]


def evaluate(rows):
    """@return of each figure: map from time to the displacements, one of each disk [m]"""
    return {name: {time: group.samples(displacement) for time, group in sorted(rows[f"paper_{name}"].by(TIME).items())}
            for name in FIGURES}


def draw(axes, samples):
    for (time, values), colour in zip(samples.items(), plots.ramp(len(samples))):
        plots.distribution(axes, *density_of(values, BIN), color=colour, label=f"{time:g} s")
    axes.axvline(0.0, color=plots.GREY, linewidth=0.8, zorder=1)
    axes.set(xlabel="displacement [m]", ylabel="density [1/m]")
    axes.set_ylim(bottom=0.0)
    axes.legend(title="after")


def pairs(samples):
    return zip(samples, list(samples)[1:])


def further(samples, sign):
    """That the mean moves on from one time to the next; the same disks, so their steps are the samples."""
    for early, late in pairs(samples):
        step = mean_of(sign * (b - a) for a, b in zip(samples[early], samples[late]))
        yield f"{early:g} to {late:g} s", step


def wider(samples):
    for early, late in pairs(samples):
        growth = variance_of(samples[late]).minus(variance_of(samples[early]))
        yield f"{early:g} to {late:g} s", growth


def velocity(samples):
    """Over the longest time [m/s]."""
    time = max(samples)
    return mean_of(value / time for value in samples[time])


def spreads(samples):
    return verdicts.counted("it spreads from each time to the next", wider(samples)).about("it spreads")


def deviation(values):
    """The samples' standard deviation, with the error that its square has."""
    variance = variance_of(values)
    return type(variance)(math.sqrt(variance.value), variance.error / (2.0 * math.sqrt(variance.value)), variance.count)


def moves(samples, way, check):
    return (check(f"⟨V_x⟩ is to the {way}", velocity(samples)),
            verdicts.counted(f"its mean moves to the {way} from each time to the next",
                             further(samples, 1.0 if way == "right" else -1.0)), spreads(samples))


def claims(numbers):
    return [verdicts.Claim("1", "Fig. 3", "the displacement distribution drifts to the right and spreads with time",
                           moves(numbers["fig3"], "right", verdicts.right)),
            verdicts.Claim("3", "Fig. 4", "θ = 0.209 reverses that current",
                           moves(numbers["fig4"], "left", verdicts.left))]


STUDY = Study("displacements", "Figs. 3 and 4: displacements of single disks",
              tuple(f"paper_{name}" for name in FIGURES), evaluate,
              tuple(Picture(name, f"Displacements at θ = {theta:g}; each disk a run of its own, bars: standard errors "
                            "of the counts", lambda axes, numbers, name=name: draw(axes, numbers[name]),
                            (f"paper_{name}",), (6.4, 3.8))
                    for name, theta in FIGURES.items()), claims,
              tables=lambda numbers: {name: csv_lines(("time_s",), ("mean_displacement_m", "standard_deviation_m"), {
                  time: (mean_of(values), deviation(values)) for time, values in samples.items()})
                                      for name, samples in numbers.items()})
