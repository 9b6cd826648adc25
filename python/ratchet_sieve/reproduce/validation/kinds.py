"""Two kinds in one mixture over the inclination, on a ratchet: where they differ, and where they go opposite ways."""
import dataclasses

from ratchet_sieve import plots
from ratchet_sieve.reproduce import verdicts
from ratchet_sieve.reproduce.study import axis

THETA = "base.inclination"


@dataclasses.dataclass(frozen=True)
class Ratchet:
    """A sweep of a mixture: panels over two keys, curves over a third, all over the inclination."""
    suffix: str   # of the sweep's and the picture's name
    about: str    # of its teeth
    columns: str  # key of the panels' columns
    column: str   # and how a value of it is written
    curves: str
    curve: str
    scale: float = 1.0  # of both values in that writing


ROWS, ROW_NAME = "density", "d"


def velocities(rows, ratchet):
    """@return map from (row, column, curve, θ) to both kinds' mean velocities and B's less A's, seed by seed [m/s]"""
    return {place: (cell.mean("mean_vx.A"), cell.mean("mean_vx.B"),
                    cell.mean(lambda row: row["mean_vx.B"] - row["mean_vx.A"]))
            for place, cell in rows.by(ROWS, ratchet.columns, ratchet.curves, THETA).items()}


def draw(means, ratchet, kinds):
    rows, columns, curves = (axis(means, index) for index in range(3))
    figure, grid = plots.panels(len(rows), len(columns), (8.6, 0.6 + 2.7 * len(rows)), sharex=True, squeeze=False)
    for line, row in zip(grid, rows):
        for axes, column in zip(line, columns):
            for curve, colour in zip(curves, plots.COLOURS):
                for kind, style in enumerate(("-", "--")):
                    points = [(theta, means[row, column, curve, theta][kind]) for theta in axis(means, 3)]
                    plots.curve(axes, points, plots.MM, color=colour, linestyle=style,
                                label=f"{kinds[kind]}, {ratchet.curve.format(ratchet.scale * curve)}")
            plots.signed(axes)
            axes.set_title(f"{ROW_NAME} = {row:g}, {ratchet.column.format(ratchet.scale * column)}")
    for axes in grid[-1]:
        axes.set_xlabel(r"$\theta$ [rad]")
        axes.locator_params(axis="x", nbins=5)
    for line in grid:
        line[0].set_ylabel(r"$\langle V_x \rangle$ [mm/s]")
    grid[0][-1].legend(loc="center left", bbox_to_anchor=(1.0, 0.5))
    return figure


def named(place, ratchet):
    row, column, curve, theta = place
    values = (ratchet.column.format(ratchet.scale * column), ratchet.curve.format(ratchet.scale * curve))
    return f"{ROW_NAME} = {row:g}, {', '.join(values)}, θ = {theta:g}".replace("-", "−")


def shown(mean):
    return verdicts.shown(mean, plots.MM, "mm/s")


def differing(means, ratchet):
    """Where the search has kinds of different velocities, and where they differ most, in words."""
    sure = {place: pair[2] for place, pair in means.items() if pair[2].surely_above(0.0) is not None}
    if not sure:
        return f"On {ratchet.about} the kinds drift at different speeds at none of {len(means)} places."
    most = max(sure, key=lambda place: abs(sure[place].value))
    return (f"On {ratchet.about} the kinds drift at different speeds at {len(sure)} of {len(means)} places, most at "
            f"{named(most, ratchet)}: B less A {shown(sure[most])}.")


def opposed_at(means):
    """@return places where one kind surely goes to the right and the other to the left, with both"""
    ways = {place: (pair[0].surely_above(0.0), pair[1].surely_above(0.0)) for place, pair in means.items()}
    return {place: means[place] for place, (a, b) in sorted(ways.items()) if None not in (a, b) and a != b}


def opposed(means_of):
    """On how many places of each ratchet the search has kinds that go opposite ways, in words."""
    counts = [f"{len(opposed_at(means))} of {len(means)} places on {ratchet.about}"
              for ratchet, means in means_of.items()]
    return f"They go opposite ways at {' and at '.join(counts)}."
