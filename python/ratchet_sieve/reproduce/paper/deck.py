"""Addition A8: whether a base that is shaken along its own normal parts Fig. 8's mixture at the paper's angles."""
from ratchet_sieve import plots
from ratchet_sieve.reproduce import verdicts
from ratchet_sieve.reproduce.paper import parting
from ratchet_sieve.reproduce.paper.parting import ANGLES, THETA
from ratchet_sieve.reproduce.study import Picture, Study, Sweep
from ratchet_sieve.texts import table

FRAME = "base.drive_frame"
NAMES = {"world": "vertically, as in the paper", "base": "along its own normal"}


def evaluate(rows):
    """@return of each drive's axes: map from θ to both kinds' mean velocities [m/s]"""
    return {frame: {theta: parting.ways(cell) for theta, cell in sorted(group.by(THETA).items())}
            for frame, group in rows["paper_deck"].by(FRAME).items()}


def draw(numbers):
    figure, row = plots.panels(1, len(NAMES), (8.6, 3.4), sharey=True, squeeze=False)
    for axes, (frame, name) in zip(row[0], NAMES.items()):
        for k, (kind, colour) in enumerate(zip("AB", plots.COLOURS)):
            points = [(theta, pair[k]) for theta, pair in numbers[frame].items()]
            plots.curve(axes, points, plots.MM, color=colour, label=kind)
        plots.signed(axes)
        axes.set_title("shaken " + name)
        axes.set_xlabel(r"$\theta$ [rad]")
    row[0][0].set_ylabel(r"$\langle V_x \rangle$ [mm/s]")
    row[0][0].legend()
    return figure


def claims(numbers):
    checks = tuple(parting.parted(f"θ = {theta:g}: A to the right, B to the left", numbers["base"][theta])
                   for theta in ANGLES)
    return [verdicts.Claim("A8", "Fig. 8", "claim 6's A right and B left at 0.105 and at 0.157 come out on a base that "
                           "is shaken along its own normal", checks)]


def text(numbers):
    thetas = numbers["world"]
    lines = [[f"{theta:g}", *(mean.text(plots.MM) for frame in NAMES for mean in numbers[frame][theta])]
             for theta in thetas]
    heads = [f"{kind}, {name} [mm/s]" for name in NAMES.values() for kind in "AB"]
    return "\n\n".join((
        "The paper says that its base is shaken vertically. A vibrator bolted to the deck shakes it along its normal "
        "(`base.drive_frame: base`), which at an inclination θ also pushes towards the lower end.",
        table(["θ [rad]", *heads], lines)))


STUDY = Study("deck", "Fig. 8's mixture on a base that is shaken along its own normal",
              (Sweep("paper_deck", {THETA: ANGLES}),), evaluate,
              (Picture("deck", "Mean velocities of Fig. 8's mixture over the inclination, d = 3.93, for both axes of "
                       "the drive; bars: standard errors over the seeds", draw),), claims, text)
