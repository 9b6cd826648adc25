"""Fig. 8's claim over pairs of parameters: whether A goes to the right and B to the left at both of its angles."""
import dataclasses

from reproduce import drawing, maps, verdicts
from reproduce.document import table
from reproduce.paper import parting
from reproduce.study import Picture, Study, Sweep


@dataclasses.dataclass(frozen=True)
class Pair:
    sweep: str
    x: str        # swept key, and as it is written beside the axis
    x_name: str
    y: str
    y_name: str
    stated: tuple  # the paper's values, and the scenes' of what it leaves open; of x and y


PAIRS = (Pair("parting_density_frequency", "density", "d", "base.frequency", "f [Hz]", (3.93, 23)),
         Pair("parting_asymmetry_density", "density", "d", "base.asymmetry", "a", (3.93, 0.3)),
         Pair("parting_asymmetry_frequency", "base.frequency", "f [Hz]", "base.asymmetry", "a", (23, 0.3)),
         Pair("parting_steep_frequency", "density", "d (a = 0.1)", "base.frequency", "f [Hz]", (None, None)),
         Pair("parting_amplitude_frequency", "base.frequency", "f [Hz]", "base.amplitude", "A [m]", (23, 0.002)),
         Pair("parting_speed_frequency", "base.frequency", "f [Hz]", "contact.min_rebound_speed", "v_min [m/s]",
              (23, 0.05)),
         Pair("parting_friction_restitution", "species.0.friction", "μ", "species.0.restitution", "e", (0.1, 0.6)))


def evaluate(rows):
    """@return of each pair: map from (θ, x, y) to both kinds' mean velocities [m/s]"""
    return {pair: {place: parting.ways(cell)
                   for place, cell in rows[pair.sweep].by(parting.THETA, pair.x, pair.y).items()}
            for pair in PAIRS if rows[pair.sweep]}


def axis(means, index):
    return sorted({place[index] for place in means})


def draw(numbers):
    """Two pairs beside each other, each at both angles; the legend where a pair would be."""
    rows = len(numbers) // 2 + 1
    figure, grid = drawing.panels(rows, 2 * len(parting.ANGLES), (10.5, 2.4 * rows), squeeze=False)
    cells = iter(grid.reshape(2 * rows, len(parting.ANGLES)))
    for pair, means in numbers.items():
        draw_pair(next(cells), pair, means)
    for empty in cells:
        for axes in empty:
            axes.axis("off")
        maps.lone_legend(empty[0], parting.COLOURS)
    return figure


def draw_pair(row, pair, means):
    xs, ys = axis(means, 1), axis(means, 2)
    for axes, theta in zip(row, parting.ANGLES):
        maps.class_map(axes, xs, ys, lambda x, y, t=theta: parting.class_of(means[t, x, y]), parting.COLOURS)
        axes.set_title(rf"$\theta$ = {theta:g}")
        axes.set_xlabel(pair.x_name)
        if pair.stated[0] in xs and pair.stated[1] in ys:
            axes.plot(xs.index(pair.stated[0]) + 0.5, ys.index(pair.stated[1]) + 0.5, "ko", markersize=4)
    row[0].set_ylabel(pair.y_name)


def parted_at(means, theta):
    """@return places (x, y) where the kinds surely part as the paper's do"""
    return {(x, y) for (angle, x, y), pair in means.items()
            if angle == theta and parting.class_of(pair) == parting.PARTED}


def places(pair, cells):
    x_name, y_name = (name.split()[0] for name in (pair.x_name, pair.y_name))
    return "; ".join(f"{x_name} = {x:g}, {y_name} = {y:g}" for x, y in sorted(cells)) or "none"


def at_both(numbers):
    """Those places, of all pairs, where they part at both angles."""
    first, second = parting.ANGLES
    return {pair: parted_at(means, first) & parted_at(means, second) for pair, means in numbers.items()}


def claims(numbers):
    tried = sum(len(means) // len(parting.ANGLES) for means in numbers.values())
    found = sum(len(cells) for cells in at_both(numbers).values())
    checks = [verdicts.Check(f"at θ = {theta:g} somewhere", f"at {count} of {tried} places",
                             count > 0 if tried else None)
              for theta in parting.ANGLES
              for count in [sum(len(parted_at(means, theta)) for means in numbers.values())]]
    checks.append(verdicts.Check("at both, somewhere", f"at {found} of {tried} places", found > 0 if tried else None))
    return [verdicts.Claim("6b", "Fig. 8", "A right and B left at 0.105 and 0.157, were two parameters other than "
                           "printed", tuple(checks))]


def at_printed(numbers, theta):
    """Where they part at an angle and the printed density, in words."""
    found = []
    for pair, means in numbers.items():
        cells = {(x, y) for x, y in parted_at(means, theta) if pair.x != parting.D or x == parting.PRINTED}
        if cells:
            found.append(places(pair, cells))
    return " or ".join(found) or "nowhere"


def conclusion(numbers):
    if not numbers or any(at_both(numbers).values()):
        return ""
    return ("\n\n**What follows.** What shifts the window takes both of its ends along: nothing that was tried, a "
            "density or any of these pairs, puts both angles into it. So the paper's 0.105 and 0.157 are not two angles "
            "of one machine of this model, with a slip in one or two of these parameters. Either they come from runs that "
            "differ in more than θ, or from a model that differs in more than what the paper leaves open.")


def text(numbers):
    lines = []
    for pair, means in numbers.items():
        first, second = (parted_at(means, theta) for theta in parting.ANGLES)
        lines.append([f"{pair.x_name} and {pair.y_name}", len(means) // len(parting.ANGLES), len(first), len(second),
                      places(pair, first & second)])
    told = "; ".join(f"at {theta:g} rad: {at_printed(numbers, theta)}" for theta in parting.ANGLES)
    return ("Places of each map where A goes to the right and B to the left, both with 95 %:\n\n"
            + table(["over", "places", *(f"at {theta:g}" for theta in parting.ANGLES), "at both"], lines)
            + f"\n\nOf these with d = {parting.PRINTED:g}, {told}.{conclusion(numbers)}")


STUDY = Study("parting_pairs", "Whether any two parameters bring out Fig. 8's claim",
              tuple(Sweep(pair.sweep, is_quick=False) for pair in PAIRS), evaluate,
              (Picture("parting_pairs", "Which way both kinds of Fig. 8's mixture go at the two angles of the claim, "
                       "over pairs of parameters, all others as printed; the dot: as printed", draw),), claims, text)
