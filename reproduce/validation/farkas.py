"""Two kinds of one size and mass that differ in restitution alone, or in friction alone (Farkas et al. 2002)."""
from reproduce import drawing, verdicts
from reproduce.best import best_of
from reproduce.document import table
from reproduce.study import Picture, Study, Sweep

D = "density"
ASYMMETRY = "base.asymmetry"
F = "base.frequency"
THETA = "base.inclination"
USEFUL = 0.5  # Q from which a mixture counts as segregated: half way from mixed to pure


def velocities(rows):
    """@return map from (d, a, f, θ) to both kinds' mean velocities and B's less A's, of each seed [m/s]"""
    return {place: (cell.mean("mean_vx.A"), cell.mean("mean_vx.B"),
                    cell.mean(lambda row: row["mean_vx.B"] - row["mean_vx.A"]))
            for place, cell in rows.by(D, ASYMMETRY, F, THETA).items()}


def evaluator(name):
    def evaluate(rows):
        open_rows = rows[f"validation_farkas_{name}_open"]
        return {"means": velocities(rows[f"validation_farkas_{name}"]),
                "quality": {theta: (cell.mean("quality"), cell.mean("processed"))
                            for theta, cell in open_rows.by(THETA).items()},
                "best": best_of(open_rows, THETA, "quality")}
    return evaluate


def axis(means, index):
    return sorted({place[index] for place in means})


def drawer(kinds):
    def draw(numbers):
        means = numbers["means"]
        densities, asymmetries, frequencies = (axis(means, index) for index in range(3))
        figure, grid = drawing.panels(len(densities), len(asymmetries), (8.6, 6.0), sharex=True, sharey=True,
                                      squeeze=False)
        for row, d in zip(grid, densities):
            for axes, a in zip(row, asymmetries):
                for f, colour in zip(frequencies, drawing.COLOURS):
                    for kind, style in enumerate(("-", "--")):
                        points = [(theta, means[d, a, f, theta][kind]) for theta in axis(means, 3)]
                        drawing.curve(axes, points, drawing.MM, color=colour, linestyle=style,
                                      label=f"{kinds[kind]}, {f:g} Hz")
                drawing.signed(axes)
                axes.set_title(f"$a$ = {a:g}, $d$ = {d:g}")
        for axes in grid[-1]:
            axes.set_xlabel(r"$\theta$ [rad]")
        for row in grid:
            row[0].set_ylabel(r"$\langle V_x \rangle$ [mm/s]")
        grid[0][-1].legend(loc="center left", bbox_to_anchor=(1.0, 0.5))
        return figure
    return draw


def draw_quality(numbers):
    figure, axes = drawing.panels(1, 1, (6.0, 3.6))
    for index, (name, colour) in enumerate(zip("QP", drawing.COLOURS)):
        points = [(theta, pair[index]) for theta, pair in sorted(numbers["quality"].items())]
        drawing.curve(axes, points, color=colour, label=name)
    axes.set_ylim(0.0, 1.05)
    axes.set_xlabel(r"$\theta$ [rad]")
    axes.set_ylabel("$Q$ and $P$ after 100 s")
    axes.legend()
    return figure


def named(place):
    return "d = {:g}, a = {:g}, f = {:g} Hz, θ = {:g}".format(*place)


def differing(means):
    """A check that the kinds have different velocities: everywhere, or else where most."""
    sure = {place: pair[2] for place, pair in means.items() if pair[2].surely_above(0.0) is not None}
    says = "the kinds drift at different speeds"
    if not sure:
        return verdicts.Check(says, f"at none of {len(means)} places", None)
    most = max(sure, key=lambda place: abs(sure[place].value))
    return verdicts.Check(says, f"at {len(sure)} of {len(means)} places, most at {named(most)}: B less A "
                          + verdicts.shown(sure[most], drawing.MM, "mm/s"), True)


def opposed_at(means):
    """@return places where one kind surely goes to the right and the other to the left, with both"""
    ways = {place: (pair[0].surely_above(0.0), pair[1].surely_above(0.0)) for place, pair in means.items()}
    return {place: means[place] for place, pair in ways.items() if None not in pair and pair[0] != pair[1]}


def opposed(means):
    found = opposed_at(means)
    says = "somewhere they go opposite ways"
    if not found:
        return verdicts.Check(says, f"at none of {len(means)} places", False)
    most = max(found, key=lambda place: min(abs(mean.value) for mean in found[place][:2]))
    a, b, _ = found[most]
    return verdicts.Check(says, f"at {len(found)} of {len(means)} places, as at {named(most)}: A "
                          f"{verdicts.shown(a, drawing.MM, 'mm/s')}, B {verdicts.shown(b, drawing.MM, 'mm/s')}", True)


def segregates(numbers):
    best = numbers["best"]
    where = f", best at θ = {best.at:g}" if best else ""
    return verdicts.above(f"on an open base Q > {USEFUL:g}{where}", best.mean if best else None, USEFUL)


def claimer(number, name):
    def claims(numbers):
        return [verdicts.Claim(number, "Farkas 2002, abstract", "two kinds of the same size that differ only in their "
                               f"{name} coefficient can be segregated by an appropriately chosen ratchet",
                               (differing(numbers["means"]), opposed(numbers["means"]), segregates(numbers)))]
    return claims


def text(numbers):
    means = numbers["means"]
    lines = [[f"{value:g}" for value in place] + [mean.text(drawing.MM) for mean in pair] for place, pair in
             sorted(opposed_at(means).items())]
    quality = [[f"{theta:g}", *("—" if mean is None else mean.text() for mean in pair)]
               for theta, pair in sorted(numbers["quality"].items())]
    return ("Where the kinds go opposite ways, velocities in mm/s:\n\n"
            + table(["d", "a", "f [Hz]", "θ [rad]", "A", "B", "B less A"], lines)
            + "\n\nOn the open base:\n\n" + table(["θ [rad]", "Q", "P"], quality))


def study(number, name, word, kinds, scene):
    sweep = f"validation_farkas_{name}"
    return Study(f"farkas_{name}", f"One size, another {word} (Farkas and others 2002)",
                 (Sweep(sweep), Sweep(f"{sweep}_open")), evaluator(name),
                 (Picture(f"farkas_{name}", f"Mean velocities of two kinds that differ in {word} alone, over the "
                          "inclination; bars: standard errors over the seeds", drawer(kinds)),
                  Picture(f"farkas_{name}_quality", "Quality and processed share of that mixture on an open base "
                          f"({scene}); bars: standard errors over the seeds", draw_quality)), claimer(number, word), text)
