"""Fig. 8: the mean velocity of both kinds of a mixture, over the frequency and the inclination."""
from ratchet_sieve import plots
from ratchet_sieve.tables import joined
from ratchet_sieve.texts import table
from curves import turns_of
from paper import parting
from paper.fig7 import (F, THETA, at_one_frequency, draw_kinds, more_moved, velocities,
                                                velocity_lines)
from paper.parting import ANGLES
from study import Picture, Study, Sweep, axis, told
import verdicts

SHOWN = 23.0  # Hz, as in Fig. 3
KINDS = {"A": "A: 1 mm, 10 g", "B": "B: 2 mm, 1 g"}
CLAIM = ("at θ = 0 both go right and B is faster; at 0.052 they differ little; at 0.105 and 0.157 A goes right and B "
         "left")
TURNED = 0.209       # rad, at which Fig. 4's current goes to the left
NEAR = (-0.01, 0.09)  # inclinations of the inset [rad]


def evaluate(rows):
    printed = rows["paper_fig8"]
    every = joined(printed, rows["paper_fig8_window"])
    return {"means": velocities(printed), "all": velocities(every),
            "turns": {f: turns_of(group, THETA) for f, group in every.by(F).items()}}


def draw_frequencies(numbers):
    return draw_kinds(numbers["means"], KINDS)


def draw_inclinations(numbers):
    figure, axes = plots.panels(1, 1, (6.8, 4.0))
    inset = axes.inset_axes([0.6, 0.63, 0.39, 0.36])
    for kind, colour in zip(KINDS, plots.COLOURS):
        points = [(theta, numbers["all"][kind][theta, SHOWN]) for theta in axis(numbers["all"][kind], 0)
                  if (theta, SHOWN) in numbers["all"][kind]]
        near = [point for point in points if NEAR[0] <= point[0] <= NEAR[1]]
        plots.curve(axes, points, plots.MM, color=colour, label=KINDS[kind])
        plots.curve(inset, near, plots.MM, color=colour)
    for k, theta in enumerate(ANGLES):
        axes.axvline(theta, color=plots.GREY, linewidth=0.8, linestyle="--",
                     label=None if k else "A right, B left in the paper")
    for own in (axes, inset):
        shade_window(own, numbers["turns"][SHOWN])
        plots.signed(own)
    inset.set_xlim(NEAR)
    inset.tick_params(labelsize=7)
    axes.set(xlabel=r"$\theta$ [rad]", ylabel=r"$\langle V_x \rangle$ [mm/s]")
    axes.legend(loc="lower left")
    return figure


def shade_window(axes, turns):
    if turns["A"] and turns["B"]:
        axes.axvspan(turns["B"].value, turns["A"].value, color=plots.COLOURS[2], alpha=0.3,
                     label="A right, B left here")


def draw_turns(numbers):
    figure, axes = plots.panels(1, 1, (6.4, 3.8))
    turns = sorted(numbers["turns"].items())
    for kind, colour in zip(KINDS, plots.COLOURS):
        plots.curve(axes, [(f, turn[kind]) for f, turn in turns], color=colour, label=f"{KINDS[kind]} turns")
    both = [(f, turn["B"].value, turn["A"].value) for f, turn in turns if turn["A"] and turn["B"]]
    if both:
        axes.fill_between(*zip(*both), color=plots.COLOURS[2], alpha=0.3, label="A right, B left here")
    for k, theta in enumerate(ANGLES):
        axes.axhline(theta, color=plots.GREY, linewidth=0.8, linestyle="--",
                     label=None if k else "A right, B left in the paper")
    axes.set_ylim(bottom=0.0)
    axes.set(xlabel="$f$ [Hz]", ylabel=r"$\theta$ [rad]")
    axes.legend(loc="lower right")
    return figure


def parted(numbers, theta):
    means, turns = numbers["means"], numbers["turns"][SHOWN]
    a, b = (means[kind][theta, SHOWN] for kind in KINDS)
    says = f"θ = {theta:g}: A to the right, B to the left"
    check = parting.parted(says, (a, b))
    seen = [f"{f:g}" for f in axis(means["A"], 1)
            if means["A"][theta, f].surely_above(0.0) and means["B"][theta, f].surely_below(0.0)]
    came_out = (f"{check.came_out} at {SHOWN:g} Hz, where they part between θ = {told(turns['B'])} and "
                f"{told(turns['A'])} (at this θ they part at {', '.join(seen) or 'no'} Hz)")
    return verdicts.Check(says, came_out, check.passes)


def claims(numbers):
    means = numbers["means"]
    level = {kind: means[kind][0.0, SHOWN] for kind in KINDS}
    right, faster = "θ = 0: both to the right", level["B"].minus(level["A"])
    return [verdicts.Claim("6", "Fig. 8", CLAIM, (
                verdicts.both(*(verdicts.right(right, level[kind]) for kind in KINDS)),
                verdicts.right("θ = 0: B is faster", faster),
                parting.differ_little("θ = 0.052: they differ by less than a third of that at 0",
                                      *(means["B"][theta, SHOWN].minus(means["A"][theta, SHOWN])
                                        for theta in (0.0, 0.052))),
                *(parted(numbers, theta) for theta in ANGLES)), "at the printed parameters (see A2, A3 and A7)"),
            verdicts.Claim("10", "3.2.1", "in the mixture θ acts more on B than on A", (
                verdicts.counted("B loses more than A from the least θ to the greatest, at every f", more_moved(means)),
                ))]


def text(numbers):
    turned = [[f"{f:g} Hz", *(told(turn[part]) for part in ("B", "A", "window"))]
              for f, turn in sorted(numbers["turns"].items())]
    return ("Where each kind turns to the left, by a parabola through the means nearest to it, and how far A's angle "
            "lies above B's; errors by leaving out one seed after the other:\n\n"
            + table(["f", "B turns, θ [rad]", "A turns, θ [rad]", "width of the window [rad]"], turned)
            + "\n\n" + at_one_frequency(numbers["means"]))


def figures(numbers):
    """Fig. 8's drifts at 23 Hz on the level base, and its window."""
    turns = numbers["turns"][SHOWN]
    return {**{f"fig8.drift.{kind.lower()}.theta_0": numbers["means"][kind][0.0, SHOWN].text(plots.MM) for kind in KINDS},
            "fig8.window.from": told(turns["B"]), "fig8.window.to": told(turns["A"])}


CAPTION = "of a mixture of A (1 mm, 10 g) and B (2 mm, 1 g), d = 3.93; bars: standard errors over the seeds"
STUDY = Study("fig8", "Fig. 8: both kinds of a mixture",
              (Sweep("paper_fig8", {F: (SHOWN,), THETA: (0.0, 0.052, *ANGLES, TURNED)}),
               Sweep("paper_fig8_window", is_quick=False)), evaluate,
              (Picture("fig8", f"Mean velocities over the frequency, for eleven inclinations, {CAPTION}",
                       draw_frequencies),
               Picture("fig8_inclination", f"Mean velocities over the inclination at {SHOWN:g} Hz, near zero enlarged, "
                       f"{CAPTION}", draw_inclinations),
               Picture("fig8_turn", f"The inclinations at which the kinds turn, {CAPTION}", draw_turns)), claims, text,
              figures, lambda numbers: {"fig8": velocity_lines(numbers["means"])})
