"""Addition A7: how much of what Fig. 9's quality lacks of 1 comes from disks that start near the wrong end."""
import dataclasses

from ratchet_sieve import plots
from ratchet_sieve.tables import Rows, joined
from curves import best_of
from study import THETA, Picture, Study, csv_lines, family, means
import verdicts

FROM, TO = "pour.from", "pour.to"
SHARE = 1.0 / 3.0  # of the loss on the whole base: at most this is left with a chute


def name(place):
    return f"{place[0]:g} to {place[1]:g} m"


def best_place(groups):
    """The best pair of place and θ: one half of the seeds chooses it, the other gives Q, both ways."""
    pairs = sorted((place, theta) for place, group in groups.items() for theta in group.values(THETA))
    frame = joined(*groups.values()).frame
    rows = Rows(frame.assign(pair=[float(pairs.index(((a, b), theta))) for a, b, theta in
                                   zip(frame[FROM], frame[TO], frame[THETA])]))
    best = best_of(rows, "pair", "quality")
    return pairs[int(best.at)], best.mean


def evaluate(rows):
    """@return of each place of the pour: Q over θ, and the best Q; and the best of all places but the whole base"""
    groups = dict(sorted(rows["paper_fig9_chute"].by(FROM, TO).items()))
    whole = max(groups, key=lambda place: place[1] - place[0])
    return {"whole": whole,
            "Q": {place: means(group, "quality", THETA).items() for place, group in groups.items()},
            "best": {place: best_of(group, THETA, "quality") for place, group in groups.items()},
            "chosen": best_place({place: group for place, group in groups.items() if place != whole})}


def draw(axes, numbers):
    plots.curve(axes, numbers["Q"][numbers["whole"]], color=plots.GREY, label="the whole base")
    family(axes, {name(place): curve for place, curve in numbers["Q"].items() if place != numbers["whole"]})
    axes.set(xlabel=r"$\theta$ [rad]", ylabel="quality $Q$ after 100 s")
    axes.legend(title="poured onto")


def loss(mean):
    """1 − Q."""
    return dataclasses.replace(mean, value=1.0 - mean.value)


def claims(numbers):
    (place, theta), mean = numbers["chosen"]
    whole = numbers["best"][numbers["whole"]].mean
    says = (f"poured onto {name(place)}, at θ = {theta:g}: 1 − Q ({loss(mean).text()}) less a third of that of the "
            f"whole base at its best θ ({loss(whole).text()}) is below 0")
    return [verdicts.Claim("A7", "Fig. 9", "most of 1 − Q comes from where the disks start: poured onto a fifth of the "
                           "base, at the best position, 1 − Q is less than a third of that",
                           (verdicts.below(says, loss(mean).minus(loss(whole).scaled(SHARE))),))]


TEXT = ("100 teeth, 2 m, d = 1 on the whole base; on a fifth of it (`pour.from`, `pour.to`) the heap is five times as "
        "deep.")


STUDY = Study("chute", "Fig. 9's mixture poured by a chute", ("paper_fig9_chute",), evaluate,
              (Picture("chute", "Quality Q over the inclination for several intervals of the pour, 100 teeth, d = 1; "
                       "bars: standard errors over the seeds", draw, size=(6.4, 3.8)),), claims, lambda numbers: TEXT,
              tables=lambda numbers: {"chute": csv_lines(("from_m", "to_m", "best_theta_rad"), ("q",), {
                  (*place, best.at): best.mean for place, best in numbers["best"].items()})})
