"""Fig. 8: the mean velocity of both species of a mixture, over the frequency and the inclination."""
from ratchet_sieve import plots
from ratchet_sieve.stats import quantile
from ratchet_sieve.tables import joined
from ratchet_sieve.texts import table
from curves import TURNS, turns_of
from paper import parting
from paper.fig7 import draw_kinds, more_moved, velocities, velocity_lines
from paper.parting import ANGLES
from study import F, THETA, Picture, Study, axis, told
import verdicts

SHOWN = 23.0  # Hz, as in Fig. 3
KINDS = {"A": "A: 1 mm, 10 g", "B": "B: 2 mm, 1 g"}
TURNED = 0.209       # rad, at which Fig. 4's current goes to the left
WIDE, NEAR = (-0.3, 0.3), (-0.01, 0.17)  # inclinations of both panels [rad]


def evaluate(rows):
    printed = rows["paper_fig8"]
    every = joined(printed, rows["paper_fig8_window"])
    return {"means": velocities(printed), "all": velocities(every), "seeds": len(every.values("seed")),
            "turns": {f: turns_of(group, THETA) for f, group in every.by(F).items()}}


def draw_inclinations(numbers):
    """All inclinations beside those near zero, where the species reverse."""
    figure, panels = plots.panels(1, 2, (9.6, 3.9))
    for kind, colour in zip(KINDS, plots.COLOURS):
        points = [(theta, numbers["all"][kind][theta, SHOWN]) for theta in axis(numbers["all"][kind], 0)
                  if (theta, SHOWN) in numbers["all"][kind]]
        for axes, (low, high) in zip(panels, (WIDE, NEAR)):
            plots.curve(axes, [point for point in points if low <= point[0] <= high], plots.MM, color=colour,
                        label=KINDS[kind])
    turns = numbers["turns"][SHOWN]
    for axes, title in zip(panels, ("all inclinations", "near the reversals")):
        for k, theta in enumerate(ANGLES):
            axes.axvline(theta, color=plots.GREY, linewidth=0.8, linestyle="--",
                         label=None if k else "A right, B left in the paper")
        if turns["A"] and turns["B"]:
            axes.axvspan(turns["B"].value, turns["A"].value, color=plots.COLOURS[2], alpha=0.3, linewidth=0.0,
                         label="A right, B left here")
        plots.signed(axes)
        axes.set(xlabel=r"$\theta$ [rad]", title=title)
    panels[0].set_ylabel(r"$\langle V_x \rangle$ [mm/s]")
    panels[0].legend(loc="lower left")
    return figure


def draw_turns(axes, numbers):
    parting.draw_turns(axes, sorted(numbers["turns"].items()), {kind: f"{KINDS[kind]} reverses" for kind in KINDS})
    for k, theta in enumerate(ANGLES):
        axes.axhline(theta, color=plots.GREY, linewidth=0.8, linestyle="--",
                     label=None if k else "A right, B left in the paper")
    axes.set_ylim(bottom=0.0)
    axes.set_xlabel("$f$ [Hz]")
    axes.legend(loc="lower right")


def parted(numbers, theta):
    means = numbers["means"]
    a, b = (means[kind][theta, SHOWN] for kind in KINDS)
    says = f"θ = {theta:g}: A to the right, B to the left"
    check = parting.parted(says, (a, b))
    seen = [f"{f:g}" for f in axis(means["A"], 1)
            if f != SHOWN and means["A"][theta, f].surely_above(0.0) and means["B"][theta, f].surely_below(0.0)]
    came_out = f"{check.came_out} at {SHOWN:g} Hz; at other frequencies so at {', '.join(seen) or 'none'}"
    return verdicts.Check(says, came_out, check.passes)


def claims(numbers):
    means = numbers["means"]
    level = {kind: means[kind][0.0, SHOWN] for kind in KINDS}
    right, faster = "θ = 0: both to the right", level["B"].minus(level["A"])
    return [verdicts.Claim("6a", "Fig. 8", "at θ = 0 both go right and B is faster", (
                verdicts.both(*(verdicts.right(right, level[kind]) for kind in KINDS)).about("to the right"),
                verdicts.right("θ = 0: B is faster", faster).about("B faster"))),
            verdicts.Claim("6b", "Fig. 8", "at θ = 0.052 they differ little", (
                parting.differ_little("θ = 0.052: they differ by less than a third of that at 0",
                                      *(means["B"][theta, SHOWN].minus(means["A"][theta, SHOWN])
                                        for theta in (0.0, 0.052))),)),
            *(verdicts.Claim(number, "Fig. 8", f"at θ = {theta:g} A goes right and B left", (parted(numbers, theta),),
                             f"at the printed parameters; see {see}")
              for number, theta, see in zip(("6c", "6d"), ANGLES, ("A1, A2b and A3", "A1 and A2b"))),
            verdicts.Claim("10", "3.2.1", "in the mixture θ acts more on B than on A", (
                verdicts.counted("B loses more than A from the least θ to the greatest, at every f", more_moved(means)),
                ))]


def text(numbers):
    """The headline: where the species go opposite ways."""
    turns = sorted(numbers["turns"].items())
    lines = [[f"{f:g} Hz", *(told(turn[part]) for part in TURNS)] for f, turn in turns
             if f in (turns[0][0], SHOWN, turns[-1][0])]
    return ("A goes to the right and B to the left between two angles: that at which B reverses and that at which A "
            "does. Each is the zero of a parabola through the three means nearest to it; its error is that of leaving "
            "out one seed and the distance to the zero of a straight line. The seeds are few: an interval of 95 % is "
            f"{quantile(numbers['seeds'] - 1):.1f} times as wide on either side.\n\n"
            + table(["f", "B reverses, θ [rad]", "A reverses, θ [rad]", "interval [rad]"], lines))


def figures(numbers):
    """Fig. 8's drifts at 23 Hz on the level base, and its window."""
    turns = numbers["turns"][SHOWN]
    return {**{f"fig8.drift.{kind.lower()}.theta_0": numbers["means"][kind][0.0, SHOWN].text(plots.MM)
               for kind in KINDS},
            "fig8.window.from": told(turns["B"]), "fig8.window.to": told(turns["A"])}


CAPTION = "d = 3.93; bars: standard errors over the seeds"
STUDY = Study("fig8", "Fig. 8: both species of a mixture",
              ("paper_fig8", "paper_fig8_window"), evaluate,
              (Picture("fig8_inclination", "Mean velocities of both species over the inclination at "
                       f"{SHOWN:g} Hz, {CAPTION}", draw_inclinations),
               Picture("fig8", f"Mean velocities over the frequency at eleven inclinations, {CAPTION}",
                       lambda numbers: draw_kinds(numbers["means"], KINDS)),
               Picture("fig8_turn", f"The inclinations at which the species reverse, over the frequency, {CAPTION}",
                       draw_turns, size=(6.4, 3.8))), claims, text,
              figures, lambda numbers: {"fig8": velocity_lines(numbers["means"]), "fig8_turn": parting.turn_lines(
                  "f_hz", sorted(numbers["turns"].items()))})
