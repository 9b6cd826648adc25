"""Two species of one size and mass that differ in restitution alone, or in friction alone (Farkas et al. 2002).

The parameters were searched for. The checks are of runs with fresh seeds at places that the search had found."""
import dataclasses

from ratchet_sieve import plots
from ratchet_sieve.tables import Rows
from ratchet_sieve.texts import shown
from study import THETA, WAYS, Picture, Study, axis, csv_lines, kind_curves, over
import verdicts


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
USEFUL = 0.5  # Q from which a mixture counts as segregated: half way from mixed to pure
RATCHETS = (Ratchet("", "teeth of 20 mm", "base.asymmetry", "a = {:g}", "base.frequency", "f = {:g} Hz"),
            Ratchet("_steep", "small steep teeth of 5 mm", "base.tooth_height", "h = {:g} mm", "base.amplitude",
                          "amplitude {:g} mm", plots.MM))


def velocities(rows, ratchet):
    """@return map from (row, column, curve, θ) to both species' mean velocities and B's less A's, seed by seed [m/s]"""
    return {place: (cell.mean("mean_vx.A"), cell.mean("mean_vx.B"),
                    cell.mean(lambda row: row["mean_vx.B"] - row["mean_vx.A"]))
            for place, cell in rows.by(ROWS, ratchet.columns, ratchet.curves, THETA).items()}


def draw_kinds(means, ratchet, kinds):
    rows, columns, curves = (axis(means, index) for index in range(3))
    figure, grid = plots.panels(len(rows), len(columns), (8.6, 0.6 + 2.7 * len(rows)), sharex=True, squeeze=False)
    for line, row in zip(grid, rows):
        for axes, column in zip(line, columns):
            for k, curve in enumerate(curves):
                kind_curves(axes, {theta: means[row, column, curve, theta] for theta in axis(means, 3)},
                            [f"{kind}, {ratchet.curve.format(ratchet.scale * curve)}" for kind in kinds], k)
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


def evaluate(name, rows):
    return {"means": {ratchet: velocities(rows[name + ratchet.suffix], ratchet) for ratchet in RATCHETS},
            "quality": over(rows[f"{name}_open"], ("quality", "processed"), THETA),
            "fresh": confirmed(rows[f"{name}_fresh"])}


def confirmed(rows):
    """@return of the three places of the fresh seeds: B's drift less A's on the teeth of Fig. 3, both drifts on steep
    teeth, Q on the open base; each with the place in words"""
    open_, periodic = rows.where({"boundary": "open"}), Rows(rows.frame[rows.frame["boundary"] != "open"])
    parts = periodic.by("base.tooth_width")
    fig3, steep = parts[max(parts)], parts[min(parts)]
    return {"differing": fig3.mean(lambda row: row["mean_vx.B"] - row["mean_vx.A"]), "differing_at": place_of(fig3, 0),
            "opposed": (steep.mean("mean_vx.A"), steep.mean("mean_vx.B")), "opposed_at": place_of(steep, 1),
            "quality": open_.mean("quality"), "quality_at": f"θ = {shown(open_[0][THETA])}"}


def place_of(rows, index):
    ratchet, row = RATCHETS[index], rows[0]
    return named((row[ROWS], row[ratchet.columns], row[ratchet.curves], row[THETA]), ratchet)


def draw_quality(axes, numbers):
    for index, (name, colour) in enumerate(zip("QP", ("black", plots.COLOURS[2]))):
        points = [(theta, pair[index]) for theta, pair in numbers["quality"].items()]
        plots.curve(axes, points, color=colour, label=name)
    axes.set_ylim(0.0, 1.05)
    axes.set(xlabel=r"$\theta$ [rad]", ylabel="$Q$ and $P$")
    axes.legend()


def differs(fresh):
    """That the species drift at different speeds, whichever is faster."""
    mean = fresh["differing"]
    way = mean.surely_above(0.0)
    return verdicts.Check(f"on {RATCHETS[0].about} the species drift at different speeds ({fresh['differing_at']})",
                          f"B less A {verdicts.speed(mean)}", None if way is None else True, part="different speeds")


def opposite(fresh):
    a, b = fresh["opposed"]
    return verdicts.Check(f"on {RATCHETS[1].about} they go opposite ways ({fresh['opposed_at']})",
                          f"A {verdicts.speed(a)}, B {verdicts.speed(b)}", verdicts.opposite(a, b),
                          part="opposite ways")


def claims(number, word, fresh):
    return [verdicts.Claim(number, "Farkas 2002, abstract", "two species of the same size that differ only in their "
                           f"{word} coefficient can be segregated by an appropriately chosen ratchet",
                           (differs(fresh), opposite(fresh),
                            verdicts.above(f"on an open base Q > {USEFUL:g} ({fresh['quality_at']})", fresh["quality"],
                                           USEFUL).about("Q on an open base")))]


def text(numbers):
    """Where the species go opposite ways in the search."""
    found = [f"{sum(bool(verdicts.opposite(a, b)) for a, b, _ in means.values())} of {len(means)} settings on {ratchet.about}"
             for ratchet, means in numbers["means"].items()]
    return f"In the search they go opposite ways at {' and '.join(found)}."


def picture(name, word, names, ratchet):
    return Picture(f"{name}{ratchet.suffix}", f"Mean velocities of two species that differ in {word} alone, over the "
                   f"inclination, on {ratchet.about}; bars: standard errors over the seeds",
                   lambda numbers: draw_kinds(numbers["means"][ratchet], ratchet, names),
                   (f"validation_{name}{ratchet.suffix}",))


def study(number, word, names, scene):
    """@param names of both species. @param scene of the open base, in words"""
    name, sweep = f"farkas_{word}", f"validation_farkas_{word}"
    quality = Picture(f"{name}_quality", f"Q and P on an open base ({scene}); bars: "
                      "standard errors over the seeds", draw_quality, (f"{sweep}_open",), (6.0, 3.6))
    return Study(name, f"One size, another {word} (Farkas and others 2002)",
                 (*(sweep + ratchet.suffix for ratchet in RATCHETS), f"{sweep}_open", f"{sweep}_fresh"),
                 lambda rows: evaluate(sweep, rows),
                 (*(picture(name, word, names, ratchet) for ratchet in RATCHETS[::-1]), quality),
                 lambda numbers: claims(number, word, numbers["fresh"]), text, tables=lambda numbers: {
                     # Of both ratchets; the keys' names differ, and stand in the first column.
                     name: csv_lines(("teeth", "d", "column", "curve", "theta_rad"), (*WAYS, "b_less_a_m_per_s"), {
                         (ratchet.about, *map(float, place)): found for ratchet, means in numbers["means"].items()
                         for place, found in means.items()}),
                     f"{name}_quality": csv_lines(("theta_rad",), ("q", "p"), numbers["quality"])})


RESTITUTION = study("1", "restitution", ("A: e = 0.4", "B: e = 0.8"),
                    "1 m of teeth of 5 mm, h = 4 mm, A = 1.4 mm, d = 0.1 at the start, 200 s")
FRICTION = study("2", "friction", ("A: μ = 0", "B: μ = 0.6"),
                 "1 m of teeth of 5 mm, h = 3.2 mm, A = 1.4 mm, d = 0.1 at the start, 300 s")
