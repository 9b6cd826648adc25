"""Addition A1: the window of inclinations in which Fig. 8's mixture parts, over the density."""
from ratchet_sieve import plots
from ratchet_sieve.reproduce import verdicts
from ratchet_sieve.reproduce.crossings import crossing_of, distance_of
from ratchet_sieve.reproduce.paper import parting, parting_follows
from ratchet_sieve.reproduce.paper.parting import ANGLES, D, PRINTED, THETA
from ratchet_sieve.reproduce.study import Picture, Study, Sweep
from ratchet_sieve.texts import table

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
    rows = rows["parting_window"]
    return {"turns": turns_of(rows), "limits": limits_of(rows),
            "ways": {place: parting.ways(cell) for place, cell in rows.by(D, THETA).items()}}


def draw(part):
    figure, axes = plots.panels(1, 1, (6.4, 4.2))
    turns = part["turns"]
    for kind, name, colour in zip("AB", ("A turns (1 mm, 10 g)", "B turns (2 mm, 1 g)"), plots.COLOURS):
        plots.curve(axes, [(d, turn[kind]) for d, turn in turns.items()], color=colour, label=name)
    known = [(d, turn["B"].value, turn["A"].value) for d, turn in turns.items() if turn["A"] and turn["B"]]
    axes.fill_between(*zip(*known), color=plots.COLOURS[2], alpha=0.3, label="A right, B left here")
    axes.plot([PRINTED] * len(ANGLES), ANGLES, "kx", markersize=7, label="so in the paper", clip_on=False, zorder=5)
    for theta in ANGLES:
        axes.axhline(theta, color=plots.GREY, linewidth=0.8, linestyle="--", zorder=1)
    axes.set_xlabel("density $d$")
    axes.set_ylabel(r"$\theta$ [rad]")
    axes.set_ylim(bottom=0.0)
    axes.legend(loc="lower left")
    return figure


def densities_of(part):
    return sorted(part["turns"])


def is_parted(part, d, theta):
    return parting.class_of(part["ways"][d, theta]) == parting.PARTED


def listed(densities):
    return f"d = {', '.join(f'{d:g}' for d in densities)}" if densities else "no d"


def at_one(part):
    """A check that one density does for both angles."""
    found = [d for d in densities_of(part) if all(is_parted(part, d, theta) for theta in ANGLES)]
    alone = "; ".join(f"at {theta:g} alone at {listed([d for d in densities_of(part) if is_parted(part, d, theta)])}"
                      for theta in ANGLES)
    widths = {d: turn["window"] for d, turn in part["turns"].items() if turn["window"]}
    widest = max(widths, key=lambda d: widths[d].value)
    told = (f"at {listed(found)} ({alone}; the widest window: {widths[widest].text()} rad at d = {widest:g}, and both "
            f"angles need {NEEDED:.3g})")
    return verdicts.Check("A right and B left at both angles, at one density", told, bool(found))


def claims(part):
    return [verdicts.Claim("A1", "Fig. 8", "claim 6's A right and B left at 0.105 and at 0.157 come out at another "
                           "density", (at_one(part),))]


def shown(mean):
    return "—" if mean is None else mean.text()


def off(mean):
    return "—" if mean is None else f"{PRINTED / mean.value:.2f}"


def text(part):
    lines = [[f"{d:g}", *(shown(turn[kind]) for kind in ("B", "A", "window"))] for d, turn in part["turns"].items()]
    limits = [[f"{theta:g}", shown(found["B"]), shown(found["A"]), off(found["A"])]
              for theta, found in part["limits"].items()]
    return "\n\n".join((
        "The angles at which each kind turns to the left (—: none up to the largest θ), by a parabola through the "
        "means nearest to it; errors by leaving out one seed after the other. Claim 6 quotes the window at "
        f"d = {PRINTED:g} from [Fig. 8](#fig-8-both-kinds-of-a-mixture); the one here, from other runs, is a check:",
        table(["d", "B turns, θ [rad]", "A turns, θ [rad]", "width [rad]"], lines),
        "The other way round: at an angle of the claim, B goes to the left above one density, and A to the right "
        "below another (—: at all that were measured). The last column says by which factor "
        f"{PRINTED:g} is above the latter:",
        table(["θ [rad]", "B left above d", "A right below d", f"{PRINTED:g} over that"], limits),
        parting_follows.text(part)))


STUDY = Study("parting_window", "The window in which Fig. 8's mixture parts, over the density",
              (Sweep("parting_window", {THETA: (0.052, *ANGLES)}),), evaluate,
              (Picture("parting_window", "The inclinations at which A and B turn to the left, over the density; bars: "
                       "jackknife errors over the seeds", draw),),
              claims, text)
