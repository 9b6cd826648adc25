"""Fig. 9: the quality Q and the processed ratio P over the inclination, for densities and lengths of the base."""
from reproduce import drawing, verdicts
from reproduce.best import best_of
from reproduce.document import table
from reproduce.rows import Rows
from reproduce.study import Picture, Study, Sweep

THETA = "base.inclination"
TEETH = "base.teeth"
DENSITY = "density"
SWEEPS = (Sweep("paper_fig9", {THETA: (0.18, 0.22)}), Sweep("paper_fig9_long", is_quick=False),
          Sweep("paper_fig9_dense", is_quick=False))


def over_inclinations(rows):
    """All runs of this figure's sweeps, which have no case in common."""
    return Rows(row for sweep in SWEEPS for row in rows[sweep.name])


def evaluate(rows):
    """@return of Q, P and what left: map from (teeth, d) to a curve over θ; and of Q what is best"""
    numbers = {"Q": {}, "P": {}, "left": {}, "best": {}}
    for place, group in over_inclinations(rows).by(TEETH, DENSITY).items():
        by_theta = sorted(group.by(THETA).items())
        for what, field in (("Q", "quality"), ("P", "processed"), ("left", left_in_all)):
            numbers[what][place] = [(theta, own.mean(field)) for theta, own in by_theta]
        numbers["best"][place] = best_of(group, THETA, "quality")
    return numbers


def left_in_all(row):
    return row["processed"] * (row["count.A"] + row["count.B"])


def axis(numbers, index):
    return sorted({place[index] for place in numbers["Q"]})


def densities_on(numbers, teeth):
    return sorted(density for length, density in numbers["Q"] if length == teeth)


def draw(numbers):
    lengths, densities = axis(numbers, 0), axis(numbers, 1)
    figure, all_axes = drawing.panels(2, len(lengths), (3.2 * len(lengths) + 0.8, 5.2), sharex=True, sharey="row",
                                      squeeze=False)
    for column, teeth in enumerate(lengths):
        for row, what in enumerate(("Q", "P")):
            axes = all_axes[row][column]
            for density, colour in zip(densities, drawing.ramp(len(densities))):
                drawing.curve(axes, numbers[what].get((teeth, density), ()), color=colour, label=f"$d$ = {density:g}")
            axes.set_ylim(0.0, 1.05)
        all_axes[0][column].set_title(f"{teeth:g} teeth")
        all_axes[1][column].set_xlabel(r"$\theta$ [rad]")
    all_axes[0][0].set_ylabel("quality $Q$")
    all_axes[1][0].set_ylabel("processed ratio $P$")
    all_axes[0][-1].legend(loc="center left", bbox_to_anchor=(1.0, 0.5))
    return figure


def peaked(numbers):
    """Q at the best θ against that at the least and at the greatest θ."""
    for (teeth, density), best in numbers["best"].items():
        curve = numbers["Q"][teeth, density]
        for theta, mean in (curve[0], curve[-1]):
            if mean is not None:
                yield f"L = {teeth:g}, d = {density:g}, θ = {theta:g}", best.mean.minus(mean).surely_above(0.0)


def order(numbers, teeth):
    """Of the lowest density against the highest: each at its own best θ, and both at that of the lowest."""
    low, *_, high = densities_on(numbers, teeth)
    first, second = numbers["best"][teeth, low], numbers["best"][teeth, high]
    yield verdicts.above(f"{teeth:g} teeth: Q at d = {low:g} less that at d = {high:g} is above 0, each at its best θ",
                         first.mean.minus(second.mean))
    there = dict(numbers["Q"][teeth, high]).get(first.at)
    yield verdicts.above(f"{teeth:g} teeth: the same, both at θ = {first.at:g}, the best of d = {low:g}",
                         there and dict(numbers["Q"][teeth, low])[first.at].minus(there))


def claims(numbers):
    checks = [verdicts.counted("Q at its best θ is higher than at the least and at the greatest θ", peaked(numbers))]
    checks += [check for teeth in axis(numbers, 0) for check in order(numbers, teeth)]
    return [verdicts.Claim("8", "Fig. 9", "Q over θ has a maximum at some θ, and is higher for low d", tuple(checks))]


def shown(mean):
    return "—" if mean is None else mean.text()


def best_line(numbers, place):
    """What the machine does at its best inclination."""
    best = numbers["best"][place]
    at_best = {what: dict(numbers[what][place])[best.at] for what in ("P", "left")}
    ratios = [mean.value for _, mean in numbers["P"][place]]
    return [f"{place[0]:g}", f"{place[1]:g}", f"{best.at:g}", shown(best.mean), best.mean.count, shown(at_best["P"]),
            f"{min(ratios):.2f} to {max(ratios):.2f}", shown(at_best["left"])]


def best_table(numbers):
    return table(["teeth", "d", "best θ [rad]", "Q there", "n", "P there", "P over all θ", "disks that left there"],
                 [best_line(numbers, place) for place in sorted(numbers["best"])])


def curve_table(numbers, what, teeth):
    densities = densities_on(numbers, teeth)
    curves = {density: dict(numbers[what][teeth, density]) for density in densities}
    thetas = sorted({theta for curve in curves.values() for theta in curve})
    lines = [[f"{theta:g}"] + [shown(curves[density].get(theta)) for density in densities] for theta in thetas]
    return f"{what} on {teeth:g} teeth:\n\n" + table(["θ [rad]"] + [f"d = {density:g}" for density in densities], lines)


def text(numbers):
    parts = ["The best θ is chosen, for each seed, by the other seeds.", best_table(numbers)]
    parts += [curve_table(numbers, what, teeth) for teeth in axis(numbers, 0) for what in ("Q", "P")]
    return "\n\n".join(parts)


STUDY = Study("fig9", "Fig. 9: quality and processed ratio", SWEEPS, evaluate,
              (Picture("fig9", "Q and P after 100 s over the inclination, for four densities and several lengths of "
                       "the base; bars: standard errors over the seeds", draw),), claims, text)
