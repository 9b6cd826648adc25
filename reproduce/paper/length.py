"""How Q depends on the length of the base, and its limits: of an endless base, within 100 s and with time enough."""
from reproduce import drawing
from reproduce.best import best_of
from reproduce.document import table
from reproduce.lines import line_through
from reproduce.paper import fig9
from reproduce.paper.fig9 import DENSITY, TEETH, THETA, axis, left_in_all, shown
from reproduce.rows import Rows
from reproduce.study import Picture, Study, Sweep

PATIENT = "paper_fig9_patient"
DOUBLE = "paper_fig9_limit"
NEARLY_ALL = 0.98  # of the disks: with so many out, time plays no part


def doubled(shorter, longest):
    """Of the two longest bases, where they have the same density and inclination: Q and how many disks left.
    @return map from (d, θ) to a map from the number of teeth to (Q, disks that left)"""
    found = {}
    for place, group in sorted(longest.by(DENSITY, THETA).items()):
        other = shorter.where({DENSITY: place[0], THETA: place[1]})
        runs = other.where({TEETH: max(other.values(TEETH))}) + group
        found[place] = {teeth: (own.mean("quality"), own.mean(left_in_all))
                        for teeth, own in sorted(Rows(runs).by(TEETH).items())}
    return found


def with_time_enough(curves, patient):
    """Q at the best θ where nearly all disks are out: after 100 s, or else of the patient runs.
    @return of each density: pairs of one over the number of teeth and Q"""
    points = {}
    for (teeth, density), best in sorted(curves["best"].items()):
        if dict(curves["P"][teeth, density])[best.at].value < NEARLY_ALL:
            best = best_of(patient.where({TEETH: teeth, DENSITY: density}), THETA, "quality")
        if best:
            points.setdefault(density, []).append((1.0 / teeth, best.mean))
    return points


def evaluate(rows):
    curves = fig9.evaluate(rows)
    points = with_time_enough(curves, rows[PATIENT])
    return {**curves, "points": points, "lines": {density: line_through(own) for density, own in points.items()},
            "doubled": doubled(fig9.over_inclinations(rows), rows[DOUBLE]),
            "out": [group.mean("processed").value for group in rows[PATIENT].by(DENSITY, THETA).values()]}


def draw(numbers):
    figure, axes = drawing.panels(1, 1, (6.4, 3.8))
    densities = axis(numbers, 1)
    for density, colour in zip(densities, drawing.ramp(len(densities))):
        points, line = numbers["points"].get(density, []), numbers["lines"].get(density)
        early = [(1.0 / teeth, best.mean) for (teeth, d), best in numbers["best"].items() if d == density]
        late = [point for point in early if point not in points]
        drawing.curve(axes, points, color=colour, linestyle="none", markersize=4, label=f"$d$ = {density:g}")
        drawing.curve(axes, late, color=colour, linestyle="none", markersize=4, markerfacecolor="white")
        if line:
            ends = (0.0, max(x for x, _ in points))
            axes.plot(ends, [line.at(x) for x in ends], color=colour, linewidth=0.9, linestyle="--")
    lengths = axis(numbers, 0)
    axes.plot([], [], "o", color=drawing.GREY, markersize=4, markerfacecolor="white", label="after 100 s, not all out")
    axes.set_xticks([0.0] + [1.0 / teeth for teeth in lengths], ["∞"] + [f"{teeth:g}" for teeth in lengths])
    axes.set_xlim(left=0.0)
    axes.set_xlabel("teeth, on a scale of 1 / teeth")
    axes.set_ylabel(r"$Q$ at the best $\theta$")
    axes.legend()
    return figure


def lines_table(numbers):
    lines = [[f"{density:g}", shown(line.intercept), shown(line.slope.scaled(-1.0)), f"{line.chi_squared:.1f}"]
             for density, line in numbers["lines"].items() if line]
    return table(["d", "Q(∞)", "c", "χ², of one degree of freedom"], lines)


def doubled_table(doubled_means):
    lengths = sorted({teeth for found in doubled_means.values() for teeth in found})
    header = ["d", "θ [rad]"] + [f"{what}, {teeth:g} teeth" for what in ("Q", "left") for teeth in lengths]
    lines = [[f"{density:g}", f"{theta:g}"] + [shown(found[teeth][0]) for teeth in lengths]
             + [shown(found[teeth][1]) for teeth in lengths] for (density, theta), found in doubled_means.items()]
    return table(header, lines)


def text(numbers):
    parts = []
    if any(numbers["lines"].values()):
        out = numbers["out"]
        parts += [f"With time enough: 100 s where nearly all disks are out by then (P above {NEARLY_ALL:g}), else 500 "
                  f"s, with P from {min(out):.3f} to {max(out):.3f}. A straight line through Q at its best θ, "
                  "Q = Q(∞) − c / teeth:", lines_table(numbers)]
    if numbers["doubled"]:
        parts += ["Within 100 s: Q, and how many disks left, on 300 teeth and on twice as many. Where both are the "
                  "same, the ends no longer feel each other: Q has reached its limit, and P falls as one over the "
                  "length.",
                  doubled_table(numbers["doubled"])]
    return "\n\n".join(parts)


STUDY = Study("length", "The length of the base, and the limit of Q",
              (*fig9.SWEEPS, Sweep(PATIENT, is_quick=False), Sweep(DOUBLE, is_quick=False)), evaluate,
              (Picture("length", "Q at the best inclination over one through the length of the base, and straight "
                       "lines through those with time enough; bars: standard errors over the seeds, the best "
                       "inclination of each chosen by the others", draw),), lambda numbers: [], text)
