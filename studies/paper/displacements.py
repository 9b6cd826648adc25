"""Figs. 3 and 4: distributions of the displacement of single disks at several times. Each run has one disk."""
import math

from ratchet_sieve import plots
from ratchet_sieve.stats import density_of, mean_of, variance_of
from ratchet_sieve.texts import table
from study import Picture, Study, Sweep
import verdicts

TIME = "duration"
BIN = 0.04  # m: two teeth; narrower bins would show the valleys in which disks rest
NEEDED = {TIME: (2.0, 10.0)}


def displacement(row):
    """A run counts from its start: settle is 0."""
    return row["mean_vx.A"] * row["simulated_time"]


def evaluator(sweep):
    def evaluate(rows):
        """@return map from time to the displacements, one of each disk [m]"""
        return {time: group.samples(displacement) for time, group in sorted(rows[sweep].by(TIME).items())}
    return evaluate


def draw(samples):
    figure, axes = plots.panels(1, 1, (6.4, 3.8))
    for (time, values), colour in zip(samples.items(), plots.ramp(len(samples))):
        plots.distribution(axes, *density_of(values, BIN), color=colour, label=f"{time:g} s")
    axes.axvline(0.0, color=plots.GREY, linewidth=0.8, zorder=1)
    axes.set(xlabel="displacement [m]", ylabel="density [1/m]")
    axes.set_ylim(bottom=0.0)
    axes.legend(title="after")
    return figure


def pairs(samples):
    times = list(samples)
    return zip(times, times[1:])


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
    return verdicts.counted("it spreads from each time to the next", wider(samples))


def deviation(values):
    """The samples' standard deviation, with the error that its square has."""
    variance = variance_of(values)
    return type(variance)(math.sqrt(variance.value), variance.error / (2.0 * math.sqrt(variance.value)), variance.count)


def text(samples):
    return table(["time", "disks", "mean displacement [mm]", "standard deviation [mm]", "mean over time [mm/s]"],
                 [[f"{time:g} s", len(values), mean_of(values).text(plots.MM), deviation(values).text(plots.MM),
                   mean_of(value / time for value in values).text(plots.MM)] for time, values in samples.items()])


def study(name, title, claims):
    sweep = f"paper_{name}"
    caption = (f"{title.split(':')[0]}: where single disks are after some times; each disk a run of its own, bars: "
               "standard errors of the counts")
    return Study(name, title, (Sweep(sweep, NEEDED),), evaluator(sweep), (Picture(name, caption, draw),), claims, text)


def claims_of_fig3(samples):
    return [verdicts.Claim("1", "Fig. 3", "the displacement distribution drifts to the right and spreads with time", (
        verdicts.right("⟨V_x⟩ > 0", velocity(samples)),
        verdicts.counted("its mean moves to the right from each time to the next", further(samples, 1.0)),
        spreads(samples)))]


def claims_of_fig4(samples):
    return [verdicts.Claim("3", "Fig. 4", "θ = 0.209 turns that current to the left", (
        verdicts.left("⟨V_x⟩ < 0", velocity(samples)),
        verdicts.counted("its mean moves to the left from each time to the next", further(samples, -1.0)),
        spreads(samples)))]


FIG3 = study("fig3", "Fig. 3: displacements at θ = 0", claims_of_fig3)
FIG4 = study("fig4", "Fig. 4: displacements at θ = 0.209", claims_of_fig4)
