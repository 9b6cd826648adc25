"""Additions A2a and A2b: Fig. 8's claim over pairs of parameters. Does A go right and B left at both of its angles?

A search: what it finds is tried by fresh seeds in parting_teeth.py."""
import dataclasses

from ratchet_sieve import plots
from paper import parting
from study import THETA, WAYS, Picture, Study, axis, csv_lines, ways

# As printed, and as in the scenes where the paper leaves a value open.
PRINTED = {"density": 3.93, "base.asymmetry": 0.3, "base.frequency": 23.0, "base.amplitude": 0.002,
           "contact.min_rebound_speed": 0.05, "species.0.friction": 0.1, "species.0.restitution": 0.6,
           "species.0.tangential_restitution": 0.4, "species.0.inertia_factor": 0.5, "base.tooth_width": 0.02,
           "base.tooth_height": 0.006}


@dataclasses.dataclass(frozen=True)
class Pair:
    sweep: str
    x: str        # swept key, and as it is written beside the axis
    x_name: str
    y: str
    y_name: str
    fixed: tuple = ()  # (key, value) that the whole sweep has other than printed


F = ("base.frequency", "f [Hz]")
PAIRS = (Pair("parting_density_frequency", "density", "d", *F),
         Pair("parting_asymmetry_density", "density", "d", "base.asymmetry", "a"),
         Pair("parting_asymmetry_frequency", *F, "base.asymmetry", "a"),
         Pair("parting_steep_frequency", "density", "d (a = 0.1)", *F, (("base.asymmetry", 0.1),)),
         Pair("parting_amplitude_frequency", *F, "base.amplitude", "A [mm]"),
         Pair("parting_speed_frequency", *F, "contact.min_rebound_speed", "v_min [m/s]"),
         Pair("parting_friction_restitution", "species.0.friction", "μ", "species.0.restitution", "e"),
         Pair("parting_inertia_tangential", "species.0.tangential_restitution", "β", "species.0.inertia_factor", "α"),
         Pair("parting_width_height", "base.tooth_width", "w [mm]", "base.tooth_height", "h [mm]"))


def draw_map(numbers):
    """The pair over which the species go opposite ways at both angles, at some setting."""
    figure, row = plots.panels(1, len(parting.ANGLES), (7.6, 2.6), squeeze=False)
    draw_pair(row[0], PAIRS[-1], numbers[PAIRS[-1]])
    plots.class_legend(row[0][-1], parting.COLOURS)
    return figure


def draw(numbers):
    """Two pairs beside each other, each at both angles; the legend where a pair would be."""
    rows = len(numbers) // 2 + 1
    figure, grid = plots.panels(rows, 2 * len(parting.ANGLES), (10.5, 2.4 * rows), squeeze=False)
    cells = iter(grid.reshape(2 * rows, len(parting.ANGLES)))
    for pair, means in numbers.items():
        draw_pair(next(cells), pair, means)
    for empty in cells:
        for axes in empty:
            axes.axis("off")
        legend = plots.class_legend(empty[0], parting.COLOURS)
        legend.set_bbox_to_anchor((0.0, 0.5))
        legend.set_in_layout(False)
    return figure


def as_named(values, name):
    """@return map from the values as they stand beside an axis of this name to those of the key"""
    return {(plots.MM if name.endswith("[mm]") else 1.0) * value: value for value in values}


def draw_pair(row, pair, means):
    xs, ys = axis(means, 1), axis(means, 2)
    named = as_named(xs, pair.x_name), as_named(ys, pair.y_name)
    stated = [{**PRINTED, **dict(pair.fixed)}[key] for key in (pair.x, pair.y)]
    for axes, theta in zip(row, parting.ANGLES):
        plots.class_map(axes, *map(list, named),
                        lambda x, y, t=theta: parting.class_of(means[t, named[0][x], named[1][y]]), parting.COLOURS)
        axes.set(title=rf"$\theta$ = {theta:g}", xlabel=pair.x_name)
        if stated[0] in xs and stated[1] in ys and not pair.fixed:
            axes.plot(xs.index(stated[0]) + 0.5, ys.index(stated[1]) + 0.5, "ko", markersize=4)
    row[0].set_ylabel(pair.y_name)


def parted_at(means, theta):
    """@return places (x, y) where the species go opposite ways as the paper's do"""
    return {(x, y) for (angle, x, y), pair in means.items()
            if angle == theta and parting.class_of(pair) == parting.PARTED}


def settings(pair, cells):
    """In words."""
    def told(name, value):
        symbol, _, unit = name.partition(" ")
        return f"{symbol} = {next(iter(as_named([value], name))):g} {unit.strip('[]')}".strip()
    return "; ".join(f"{told(pair.x_name, x)}, {told(pair.y_name, y)}" for x, y in sorted(cells))


def found_at_both(numbers):
    """The settings at which A goes right and B left at both angles, in words."""
    for pair, means in numbers.items():
        if both := set.intersection(*(parted_at(means, theta) for theta in parting.ANGLES)):
            yield settings(pair, both)


def text(numbers):
    found = "; ".join(found_at_both(numbers))
    classes = [parting.class_of(pair) for means in numbers.values() for pair in means.values()]
    return (f"{len(numbers)} pairs of parameters were varied: {len(classes) // len(parting.ANGLES)} settings at two "
            f"angles each. At both angles A is seen to go right and B left {f'only at {found}' if found else 'nowhere'}. "
            f"At {classes.count(parting.UNTOLD)} of {len(classes)} a direction is undecided, mostly because runs were "
            "few and short: seven pairs ran on 10 teeth for 10 to 20 s with three seeds. Each direction is at 95 %, not "
            "corrected for the number of settings; A2a and A2b are by fresh seeds. Three parameters at once were not "
            "varied.")


def lines(numbers):
    """A table for a CSV file: of each pair, setting and angle both species' mean velocities."""
    cells = {(pair.sweep, pair.x, pair.y, x, y, theta): found for pair, means in numbers.items()
             for (theta, x, y), found in means.items()}
    return csv_lines(("sweep", "x_key", "y_key", "x", "y", "theta_rad"), WAYS, cells)


STUDY = Study("parting_pairs", "Two parameters other than printed (A2a, A2b)",
              tuple(pair.sweep for pair in PAIRS), lambda rows: {  # of each both species' velocities, by (θ, x, y)
                  pair: ways(rows[pair.sweep], THETA, pair.x, pair.y) for pair in PAIRS if rows[pair.sweep]},
              (Picture("parting_map", "Which way both species of Fig. 8's mixture go at the two angles of claim 6, "
                       "over width and height of the teeth, all else as printed; the dot: as printed", draw_map,
                       (PAIRS[-1].sweep,)),
               Picture("parting_pairs", "The maps of all pairs; the dot: as printed", draw)),
              lambda numbers: [], text,
              tables=lambda numbers: {"parting_pairs": lines(numbers)})
