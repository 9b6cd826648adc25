"""Fig. 9: the quality Q and the processed ratio P over the inclination, for densities and lengths of the base."""
from reproduce import drawing, verdicts
from reproduce.best import best_of
from reproduce.document import table
from reproduce.lines import line_through
from reproduce.rows import Rows
from reproduce.study import Picture, Study, Sweep

THETA = "base.inclination"
TEETH = "base.teeth"
DENSITY = "density"
LIMIT = "paper_fig9_limit"
LONG = ("paper_fig9_long", "paper_fig9_dense", LIMIT)
SWEEPS = (Sweep("paper_fig9", {THETA: (0.18, 0.22)}), *(Sweep(name, is_quick=False) for name in LONG))


def evaluate(rows):
    over_theta = Rows(row for name, own in rows.items() if name != LIMIT for row in own)
    numbers = {"Q": {}, "P": {}, "left": {}, "best": {}, "limit": limits(over_theta, rows[LIMIT])}
    for place, group in over_theta.by(TEETH, DENSITY).items():
        by_theta = sorted(group.by(THETA).items())
        for what, field in (("Q", "quality"), ("P", "processed"), ("left", left_in_all)):
            numbers[what][place] = [(theta, own.mean(field)) for theta, own in by_theta]
        numbers["best"][place] = best_of(group, THETA, "quality")
    return numbers


def left_in_all(row):
    return row["processed"] * (row["count.A"] + row["count.B"])


def limits(shorter, longest):
    """Of the two longest bases, where they have the same density and inclination: Q and how many disks left.
    @return map from (d, θ) to a map from the number of teeth to (Q, disks that left)"""
    found = {}
    for place, group in sorted(longest.by(DENSITY, THETA).items()):
        other = shorter.where({DENSITY: place[0], THETA: place[1]})
        runs = other.where({TEETH: max(other.values(TEETH))}) + group
        found[place] = {teeth: (own.mean("quality"), own.mean(left_in_all))
                        for teeth, own in sorted(Rows(runs).by(TEETH).items())}
    return found


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


def over_length(numbers, density):
    """Q at the best θ over one through the number of teeth."""
    return [(1.0 / teeth, best.mean) for (teeth, d), best in sorted(numbers["best"].items()) if d == density]


def draw_lengths(numbers):
    figure, axes = drawing.panels(1, 1, (6.4, 3.8))
    densities = axis(numbers, 1)
    for density, colour in zip(densities, drawing.ramp(len(densities))):
        points = over_length(numbers, density)
        drawing.curve(axes, points, color=colour, linestyle="none", markersize=4, label=f"$d$ = {density:g}")
        line = line_through(points)
        if line:
            ends = (0.0, max(x for x, _ in points))
            axes.plot(ends, [line.at(x) for x in ends], color=colour, linewidth=0.9, linestyle="--")
    lengths = axis(numbers, 0)
    axes.set_xticks([0.0] + [1.0 / teeth for teeth in lengths], ["∞"] + [f"{teeth:g}" for teeth in lengths])
    axes.set_xlim(left=0.0)
    axes.set_xlabel("teeth, on a scale of 1 / teeth")
    axes.set_ylabel(r"$Q$ at the best $\theta$")
    axes.legend()
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


def lines_table(numbers):
    lines = []
    for density in axis(numbers, 1):
        line = line_through(over_length(numbers, density))
        if line:
            lines.append([f"{density:g}", shown(line.intercept), shown(line.slope.scaled(-1.0)),
                          f"{line.chi_squared:.1f} / {line.freedom}"])
    return table(["d", "Q of an endless base", "c", "χ² / degrees of freedom"], lines) if lines else ""


def limit_table(limit):
    lengths = sorted({teeth for found in limit.values() for teeth in found})
    header = ["d", "θ [rad]"] + [f"{what}, {teeth:g} teeth" for what in ("Q", "left") for teeth in lengths]
    lines = [[f"{density:g}", f"{theta:g}"] + [shown(found[teeth][0]) for teeth in lengths]
             + [shown(found[teeth][1]) for teeth in lengths] for (density, theta), found in limit.items()]
    return table(header, lines)


def curve_table(numbers, what, teeth):
    densities = densities_on(numbers, teeth)
    curves = {density: dict(numbers[what][teeth, density]) for density in densities}
    thetas = sorted({theta for curve in curves.values() for theta in curve})
    lines = [[f"{theta:g}"] + [shown(curves[density].get(theta)) for density in densities] for theta in thetas]
    return f"{what} on {teeth:g} teeth:\n\n" + table(["θ [rad]"] + [f"d = {density:g}" for density in densities], lines)


def text(numbers):
    parts = ["The best θ is chosen, for each seed, by the other seeds.", best_table(numbers)]
    lines = lines_table(numbers)
    if lines:
        parts += ["A straight line through Q at its best θ over one through the length, Q = Q(∞) − c / teeth:", lines]
    if numbers["limit"]:
        parts += ["Twice as long a base: Q, and how many disks left within the 100 s. Where both are the same, the "
                  "ends no longer feel each other, Q has reached its limit, and P falls as one over the length.",
                  limit_table(numbers["limit"])]
    parts += [curve_table(numbers, what, teeth) for teeth in axis(numbers, 0) for what in ("Q", "P")]
    return "\n\n".join(parts)


PICTURES = (
    Picture("fig9", "Q and P after 100 s over the inclination, for four densities and several lengths of the base; "
            "bars: standard errors over the seeds", draw),
    Picture("fig9_length", "Q at the best inclination over one through the length of the base, and straight lines; "
            "bars: standard errors over the seeds, the best inclination of each chosen by the others", draw_lengths))
STUDY = Study("fig9", "Fig. 9: quality and processed ratio", SWEEPS, evaluate, PICTURES, claims, text)
