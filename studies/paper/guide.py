"""Claims 11 and 12: what single disks, which do not collide with each other, say of the mixtures of Figs. 8 and 9."""
from ratchet_sieve import plots
from ratchet_sieve.tables import joined
from curves import best_of, crossing_of
from paper import fig9
from paper.fig7 import velocities
from paper.fig8 import TURNED
from study import F, TEETH, THETA, Picture, Study, csv_lines, means
import verdicts

SHOWN = 23.0     # Hz
ENOUGH = 0.9     # of the best Q: what a guide to the inclination should reach
SINGLE, ALONE, WINDOW = "paper_single", "paper_fig9_alone", "paper_fig8_window"


def evaluate(rows):
    mixtures = fig9.evaluate(rows)
    single = rows[SINGLE]
    alone = {teeth: {"best": best_of(group, THETA, "quality"), "Q": means(group, "quality", THETA).items()}
             for teeth, group in sorted(rows[ALONE].by(TEETH).items())
             if teeth in fig9.compared_lengths(mixtures)}
    turns = {name: {kind: crossing_of(group.where({F: SHOWN}), THETA, f"mean_vx.{kind}") for kind in "AB"}
             for name, group in (("single", single), ("mixture", joined(rows["paper_fig8"], rows[WINDOW])))}
    return {"single": velocities(single), "mixture": velocities(rows["paper_fig8"]), "turns": turns,
            "alone": alone, "Q": mixtures["Q"], "best": mixtures["best"]}


def densest(numbers, teeth):
    return max(density for length, density in numbers["Q"] if length == teeth)


def draw(numbers):
    lengths = list(numbers["alone"])
    figure, row = plots.panels(1, len(lengths), (3.2 * len(lengths), 3.4), sharey=True, squeeze=False)
    for axes, teeth in zip(row[0], lengths):
        density = densest(numbers, teeth)
        plots.curve(axes, numbers["alone"][teeth]["Q"], color=plots.COLOURS[0], label="single disks")
        plots.curve(axes, numbers["Q"][teeth, density], color=plots.COLOURS[1], label=f"mixture, $d$ = {density:g}")
        axes.set(title=f"{teeth:g} teeth", xlabel=r"$\theta$ [rad]")
        axes.set_ylim(0.0, 1.05)
    row[0][0].set_ylabel("$Q$")
    row[0][0].legend(loc="upper left")
    return figure


def lowered(numbers):
    """Of each length: the best Q of single disks less that of the densest mixture; and that the loss is the density's,
    since that of the thinnest mixture is smaller."""
    for teeth, alone in numbers["alone"].items():
        density = densest(numbers, teeth)
        mixture = numbers["best"][teeth, density]
        gain = alone["best"].mean.minus(mixture.mean)
        yield verdicts.above(f"{teeth:g} teeth: best Q of single disks ({alone['best'].mean.text()}) above that at "
                             f"d = {density:g} ({mixture.mean.text()})", gain).about(f"{teeth:g} teeth")
    for teeth in numbers["alone"]:
        low, *_, high = fig9.densities_on(numbers, teeth)
        first, second = fig9.ends_of(numbers, teeth)
        yield verdicts.above(f"{teeth:g} teeth, control: best Q is lower at d = {high:g} than at d = {low:g}",
                             first.mean.minus(second.mean)).about(f"control on {teeth:g} teeth")


def same_way(numbers):
    """At each θ and f of Fig. 8, where the way of the single disks is sure: the mixture's drift along it."""
    for kind, means in numbers["single"].items():
        for (theta, f), mean in means.items():
            other = numbers["mixture"][kind].get((theta, f))
            way = mean.surely_above(0.0)
            if way is not None and other is not None:
                yield (kind, theta, f), other.scaled(1.0 if way else -1.0)


def directions(numbers):
    comparisons = list(same_way(numbers))
    outcomes = verdicts.signs(mean for _, mean in comparisons)
    against = {theta for ((_, theta, _), _), way in zip(comparisons, outcomes) if way is False}
    said = (f"{outcomes.count(True)} of {len(outcomes)} do, {outcomes.count(False)} go significantly the other way"
            + (f" (at θ = {', '.join(f'{theta:g}' for theta in sorted(against))})" if against else ""))
    return verdicts.Check("each species of Fig. 8's mixture goes where its single disks go, at every θ and f", said,
                          verdicts.all_of(outcomes), part="the directions at every θ and f")


def remain(numbers):
    """That the currents are still there in the mixture."""
    means = numbers["mixture"]
    checks = [verdicts.both(*(compare("", means[kind][theta, SHOWN], 0.0, plots.MM, "mm/s") for kind in "AB"))
              for compare, theta in ((verdicts.above, 0.0), (verdicts.below, TURNED))]
    return verdicts.Check(f"the currents of Figs. 3 and 4 remain in the mixture: to the right at θ = 0, to the left at "
                          f"{TURNED:g}", "; ".join(check.came_out for check in checks),
                          verdicts.all_of(check.passes for check in checks), part="the currents of Figs. 3 and 4")


def window(numbers):
    single, mixture = numbers["turns"]["single"], numbers["turns"]["mixture"]
    says, part = "the intervals of θ in which the species go opposite ways overlap", "the interval of opposite ways"
    if None in (mixture["A"], single["B"]):
        return verdicts.Check(says, "—", None, part=part)
    check = verdicts.above(says, mixture["A"].minus(single["B"]), 0.0, 1.0, "rad")
    told = (f"{mixture['B'].text()} to {mixture['A'].text()} in the mixture, {single['B'].text()} to "
            f"{single['A'].text()} for single disks, the distance {check.came_out}")
    return verdicts.Check(says, told, check.passes, part=part)


def guided(numbers):
    """That the best θ of single disks is good enough for Fig. 9's mixtures, on the base with the widest curves."""
    teeth = min(numbers["alone"])
    theta = numbers["alone"][teeth]["best"].at
    for density in (min(fig9.densities_on(numbers, teeth)), densest(numbers, teeth)):
        best = numbers["best"][teeth, density].mean
        there = dict(numbers["Q"][teeth, density]).get(theta)
        says = (f"{teeth:g} teeth, d = {density:g}: Q at single disks' best θ, {theta:g}, above {ENOUGH:g} of the best "
                "Q, which halves of the seeds choose")
        check = verdicts.Check(says, "—", None) if there is None else verdicts.Check(
            says, f"{there.text()} against {best.text()}", there.minus(best.scaled(ENOUGH)).surely_above(0.0))
        yield check.about(f"the best θ at d = {density:g}")


def claims(numbers):
    return [verdicts.Claim("11", "3.2.2", "at high density collisions between disks lower Q", tuple(lowered(numbers))),
            verdicts.Claim("12", "3.1.2, 4", "single disks are a guide to the parameters of mixtures", (
                remain(numbers), directions(numbers), window(numbers), *guided(numbers)))]


STUDY = Study("guide", "Single disks as a guide to mixtures",
              ("paper_fig8", WINDOW, SINGLE, ALONE, *fig9.SWEEPS), evaluate,
              (Picture("guide", "Q over the inclination, of single disks and of the mixture of Fig. 9; bars: standard "
                       "errors over the seeds", draw, (ALONE, *fig9.SWEEPS)),), claims,
              tables=lambda numbers: {"guide": csv_lines(("teeth", "best_theta_rad"), ("q_of_single_disks",), {
                  (teeth, alone["best"].at): alone["best"].mean for teeth, alone in numbers["alone"].items()})})
