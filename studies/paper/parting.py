"""Which way both species of Fig. 8's mixture go, and where they part as the paper's do. Addition A1: the window of
inclinations in which they do, over the density."""
from ratchet_sieve import plots
from curves import TURNS, turns_of
from study import D, THETA, Picture, Study, csv_lines, told, ways
import verdicts

PRINTED = 3.93           # the paper's density
ANGLES = (0.105, 0.157)  # where the paper has A go to the right and B to the left [rad]
NEEDED = ANGLES[1] - ANGLES[0]  # the least width of a window that has both angles in it

PARTED = "A right, B left"
RIGHT = "both right"
LEFT = "both left"
OTHER = "A left, B right"
UNTOLD = "undecided"
LITTLE = 1.0 / 3.0  # of the difference at θ = 0
COLOURS = {PARTED: plots.COLOURS[2], RIGHT: plots.COLOURS[5], LEFT: plots.COLOURS[4], OTHER: plots.COLOURS[3],
           UNTOLD: "#EEEEEE"}
CLASSES = {(True, False): PARTED, (True, True): RIGHT, (False, False): LEFT, (False, True): OTHER}


def class_of(pair):
    """@param pair of ways(); None in either is undecided"""
    return CLASSES.get(tuple(mean and mean.surely_above(0.0) for mean in pair), UNTOLD)


def parted(says, pair):
    """A check that A goes to the right and B to the left."""
    a, b = pair
    return verdicts.both(verdicts.right(says, a), verdicts.left(says, b))


def draw_ways(panels):
    """@param panels map from a title to both species' mean velocities over θ"""
    figure, row = plots.panels(1, len(panels), (8.6, 3.4), sharey=True, squeeze=False)
    for axes, (title, means) in zip(row[0], panels.items()):
        for k, (kind, colour) in enumerate(zip("AB", plots.COLOURS)):
            plots.curve(axes, [(theta, pair[k]) for theta, pair in means.items()], plots.MM, color=colour, label=kind)
        plots.signed(axes)
        axes.set(title=title, xlabel=r"$\theta$ [rad]")
    row[0][0].set_ylabel(r"$\langle V_x \rangle$ [mm/s]")
    row[0][0].legend()
    return figure


def differ_little(says, level, tilted):
    """A check that the species differ by less than a part of what they differ by on the level base.
    @param level B's mean velocity less A's there"""
    size = tilted.scaled(-1.0 if tilted.value < 0.0 else 1.0)
    return verdicts.Check(says, f"{verdicts.speed(size)} against {level.text(plots.MM)}",
                          size.minus(level.scaled(LITTLE)).surely_below(0.0))


def evaluate(rows):
    """@return of each density the angles at which A and B turn to the left, of each angle of the claim the densities"""
    rows = rows["parting_window"]
    return {"turns": {d: turns_of(group, THETA) for d, group in sorted(rows.by(D).items())},
            "limits": {theta: turns_of(rows.where({THETA: theta}), D) for theta in ANGLES},
            "ways": ways(rows, D, THETA)}


def draw_turns(axes, turns, names):
    """The inclinations at which both species turn, and the window between them.
    @param turns pairs of x and turns_of(). @param names of both species' curves"""
    for (kind, name), colour in zip(names.items(), plots.COLOURS):
        plots.curve(axes, [(x, turn[kind]) for x, turn in turns], color=colour, label=name)
    known = [(x, turn["B"].value, turn["A"].value) for x, turn in turns if turn["A"] and turn["B"]]
    if known:
        axes.fill_between(*zip(*known), color=plots.COLOURS[2], alpha=0.3, label="A right, B left here")
    axes.set_ylabel(r"$\theta$ [rad]")


def draw(axes, part):
    draw_turns(axes, part["turns"].items(), {"A": "A reverses (1 mm, 10 g)", "B": "B reverses (2 mm, 1 g)"})
    axes.plot([PRINTED] * len(ANGLES), ANGLES, "kx", markersize=7, label="opposite ways in the paper",
              clip_on=False, zorder=5)
    for theta in ANGLES:
        axes.axhline(theta, color=plots.GREY, linewidth=0.8, linestyle="--", zorder=1)
    axes.set_xlabel("density $d$")
    axes.set_ylim(bottom=0.0)
    axes.legend(loc="lower left")


def is_parted(part, d, theta):
    """None: undecided."""
    return parted("", part["ways"][d, theta]).passes


def listed(densities):
    return f"d = {', '.join(f'{d:g}' for d in densities)}" if densities else "no d"


def at_one(part):
    """A check that one density does for both angles."""
    turns = part["turns"]
    outcomes = {d: verdicts.all_of(is_parted(part, d, theta) for theta in ANGLES) for d in turns}
    found, unsure = ([d for d, outcome in outcomes.items() if outcome is wanted] for wanted in (True, None))
    alone = "; ".join(f"at {theta:g} alone at {listed([d for d in turns if is_parted(part, d, theta)])}"
                      for theta in ANGLES)
    widths = {d: turn["window"] for d, turn in turns.items() if turn["window"]}
    widest = max(widths, key=lambda d: widths[d].value)
    said = (f"at {listed(found)} of {len(turns)}{f', undecided at {listed(unsure)}' if unsure else ''} ({alone}; the "
            f"widest interval, at d = {widest:g}, begins at {turns[widest]['B'].text()} and is {widths[widest].text()} "
            f"rad wide; both angles need {NEEDED:.3g})")
    return verdicts.Check("A right and B left at both angles, at one density", said,
                          True if found else None if unsure else False)


def claims(part):
    return [verdicts.Claim("A1", "Fig. 8", "claim 6's A right and B left at 0.105 and at 0.157 come out at another "
                           "density", (at_one(part),))]


def turn_lines(name, turns):
    """@param turns pairs of x and turns_of(). @param name of x"""
    return csv_lines((name,), TURNS.values(), {x: [turn[kind] for kind in TURNS] for x, turn in turns})


def text(part):
    """Below which density A goes to the right at the first angle of the claim, and above which B to the left."""
    limits = part["limits"][ANGLES[0]]
    return f"At θ = {ANGLES[0]:g} the species go opposite ways from d = {told(limits['B'])} to {told(limits['A'])}."


WINDOW = Study("parting_window", "The inclinations at which the species of Fig. 8's mixture reverse, over the density",
              ("parting_window",), evaluate,
              (Picture("parting_window", "The inclinations at which A and B reverse, over the density; bars: "
                       "jackknife errors over the seeds", draw, size=(6.4, 4.2)),),
              claims, text, tables=lambda part: {"parting_window": turn_lines("d", part["turns"].items())})
