"""The window of inclinations in which Fig. 8's mixture parts, over the density: how far off d would have to be."""
from reproduce import drawing, verdicts
from reproduce.crossings import crossing_of, distance_of
from reproduce.document import table
from reproduce.paper import parting, parting_follows
from reproduce.paper.parting import ANGLES, D, PRINTED, THETA
from reproduce.study import Picture, Study, Sweep

TEETH = {0.3: "parting_window", 0.1: "parting_window_steep"}  # asymmetry: sweep
STATED = 0.3
NEEDED = ANGLES[1] - ANGLES[0]  # the least width of a window that has both angles in it


def turns_of(rows):
    """@return of each density: the angles at which A and B turn to the left, and A's less B's"""
    return {d: {"A": crossing_of(group, THETA, "mean_vx.A"), "B": crossing_of(group, THETA, "mean_vx.B"),
                "window": distance_of(group, THETA, "mean_vx.A", "mean_vx.B")}
            for d, group in sorted(rows.by(D).items())}


def limits_of(rows):
    """@return of each angle of the claim: the densities at which A and B turn to the left"""
    return {theta: {kind: crossing_of(rows.where({THETA: theta}), D, f"mean_vx.{kind}") for kind in "AB"}
            for theta in ANGLES}


def evaluate(rows):
    return {a: {"turns": turns_of(rows[sweep]), "limits": limits_of(rows[sweep]),
                "ways": {place: parting.ways(cell) for place, cell in rows[sweep].by(D, THETA).items()}}
            for a, sweep in TEETH.items() if rows[sweep]}


def draw(numbers):
    figure, row = drawing.panels(1, len(numbers), (8.6, 4.2), sharey=True, squeeze=False)
    row = row[0]
    for axes, (a, part) in zip(row, numbers.items()):
        turns = part["turns"]
        for kind, name, colour in zip("AB", ("A turns (1 mm, 10 g)", "B turns (2 mm, 1 g)"), drawing.COLOURS):
            drawing.curve(axes, [(d, turn[kind]) for d, turn in turns.items()], color=colour, label=name)
        known = [(d, turn["B"].value, turn["A"].value) for d, turn in turns.items() if turn["A"] and turn["B"]]
        axes.fill_between(*zip(*known), color=drawing.COLOURS[2], alpha=0.3, label="A right, B left here")
        axes.plot([PRINTED] * len(ANGLES), ANGLES, "kx", markersize=7, label="so in the paper", clip_on=False, zorder=5)
        for theta in ANGLES:
            axes.axhline(theta, color=drawing.GREY, linewidth=0.8, linestyle="--", zorder=1)
        axes.set_title(f"$a$ = {a:g}" + (", as printed" if a == STATED else ", as in Fig. 9"))
        axes.set_xlabel("density $d$")
    row[0].set_ylabel(r"$\theta$ [rad]")
    row[0].set_ylim(bottom=0.0)
    row[0].legend(loc="lower left")
    return figure


def densities_of(part):
    return sorted(part["turns"])


def is_parted(part, d, theta):
    return parting.class_of(part["ways"][d, theta]) == parting.PARTED


def listed(densities):
    return f"d = {', '.join(f'{d:g}' for d in densities)}" if densities else "no d"


def somewhere(part, theta):
    """A check that the kinds part at an angle, at one of the densities."""
    found = [d for d in densities_of(part) if is_parted(part, d, theta)]
    return verdicts.Check(f"θ = {theta:g}, at some density", f"at {listed(found)}", bool(found))


def at_one(part):
    """A check that one density does for both angles."""
    found = [d for d in densities_of(part) if all(is_parted(part, d, theta) for theta in ANGLES)]
    widths = {d: turn["window"] for d, turn in part["turns"].items() if turn["window"]}
    widest = max(widths, key=lambda d: widths[d].value)
    return verdicts.Check("at both angles, at one density", f"at {listed(found)} (the widest window: "
                          f"{widths[widest].text()} rad at d = {widest:g}; both angles need {NEEDED:.3g})", bool(found))


def claims(numbers):
    part = numbers[STATED]
    printed = (parting.parted(f"θ = {theta:g}, d = {PRINTED:g}, as printed", part["ways"][PRINTED, theta])
               for theta in ANGLES)
    return [verdicts.Claim("6a", "Fig. 8", "A right and B left at 0.105 and 0.157: at the printed density, or at "
                           "another", (*printed, *(somewhere(part, theta) for theta in ANGLES), at_one(part)))]


def shown(mean):
    return "—" if mean is None else mean.text()


def off(mean):
    return "—" if mean is None else f"{PRINTED / mean.value:.2f}"


def text(numbers):
    lines = [[f"{a:g}", f"{d:g}", *(shown(turn[kind]) for kind in ("B", "A", "window"))]
             for a, part in numbers.items() for d, turn in part["turns"].items()]
    limits = [[f"{a:g}", f"{theta:g}", shown(found["B"]), shown(found["A"]), off(found["A"])]
              for a, part in numbers.items() for theta, found in part["limits"].items()]
    return "\n\n".join((
        "The angles at which each kind turns to the left (—: none up to the largest θ), by a parabola through the "
        "means nearest to it; errors by leaving out one seed after the other:",
        table(["a", "d", "B turns, θ [rad]", "A turns, θ [rad]", "width [rad]"], lines),
        "The other way round: at an angle of the claim, B goes to the left above one density, and A to the right "
        "below another (—: at all that were measured). The last column says by which factor "
        f"{PRINTED:g} is above the latter:",
        table(["a", "θ [rad]", "B left above d", "A right below d", f"{PRINTED:g} over that"], limits),
        parting_follows.text(numbers)))


STUDY = Study("parting_window", "The window in which Fig. 8's mixture parts, over the density",
              (Sweep("parting_window", {THETA: (0.0, 0.052, *ANGLES)}),
               Sweep("parting_window_steep", is_quick=False)), evaluate,
              (Picture("parting_window", "The inclinations at which A and B turn to the left, over the density, for "
                       "the teeth of Fig. 8 as printed and for those of Fig. 9; bars: jackknife errors over the seeds",
                       draw),),
              claims, text)
