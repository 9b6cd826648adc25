"""What follows from the window in which Fig. 8's mixture parts, in words that its numbers choose."""
from ratchet_sieve.reproduce.paper.parting import ANGLES, PRINTED

RADII = 0.5 * PRINTED  # by this measure, of a layer whose sum of radii over W is the printed d


def is_inside(part, theta, d):
    """Whether A goes to the right and B to the left at this angle and density."""
    return is_beyond(part, theta, d, "A") is False and is_beyond(part, theta, d, "B") is True


def is_beyond(part, theta, d, kind):
    """Whether a kind goes to the left at this angle and density; where it does not turn over d, as at the nearest d."""
    turn = part["limits"][theta][kind]
    if turn is not None:
        return d > turn.value
    nearest = min((place[0] for place in part["ways"]), key=lambda other: abs(other - d))
    return part["ways"][nearest, theta]["AB".index(kind)].value < 0.0


def angles(part, d):
    """At which of the claim's angles they part, in words."""
    found = [f"{theta:g}" for theta in ANGLES if is_inside(part, theta, d)]
    return f"at {' and at '.join(found)} rad" if found else "at neither angle"


def at_printed(part):
    turn = part["turns"][PRINTED]
    beyond, half = ANGLES[0] - turn["A"].value, turn["A"].half_width()
    return (f"At d = {PRINTED:g} the window reaches from {turn['B'].text()} to {turn['A'].text()} rad. The smaller "
            f"angle of the claim lies {beyond - half:.3f} to {beyond + half:.3f} rad above it (interval of 95 % by "
            f"Student's t, {turn['A'].degrees():g} degrees of freedom).")


def too_narrow(part):
    widths = {d: turn["window"] for d, turn in part["turns"].items() if turn["window"]}
    needed = ANGLES[1] - ANGLES[0]
    wide = [d for d in widths if widths[d].value > needed]
    if not wide:
        return f"The window is nowhere as wide as the {needed:.3g} rad that both angles need."
    lower = part["turns"][max(wide)]["B"]
    return (f"The window is as wide as the {needed:.3g} rad that both angles need at d = "
            f"{', '.join(f'{d:g}' for d in wide)} alone, and begins there at {lower.text()} rad at the least, "
            f"{'above' if lower.value > ANGLES[0] else 'below'} {ANGLES[0]:g}.")


def off_by(part):
    told = []
    for theta in ANGLES:
        a, b = (part["limits"][theta][kind] for kind in "AB")
        if a is None:
            continue
        least = f"and above {b.text()} " if b else ""
        told.append(f"below {a.text()} {least}for {theta:g}, {PRINTED / a.value:.1f} times less than printed")
    return f"d would have to be {'; '.join(told)}." if told else "No density does."


def text(part):
    return ("**What follows.** " + " ".join((at_printed(part), off_by(part), too_narrow(part)))
            + f" Were d a sum of radii (d = {RADII:g} by this measure), they would part {angles(part, RADII)}.")
