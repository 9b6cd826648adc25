"""Two kinds of one size and mass that differ in restitution alone, or in friction alone (Farkas et al. 2002)."""
from reproduce import drawing, verdicts
from reproduce.best import best_of
from reproduce.document import table
from reproduce.study import Picture, Study, Sweep
from reproduce.validation import kinds

THETA = kinds.THETA
USEFUL = 0.5  # Q from which a mixture counts as segregated: half way from mixed to pure
RATCHETS = (kinds.Ratchet("", "the teeth of Fig. 3", "base.asymmetry", "a = {:g}", "base.frequency", "f = {:g} Hz"),
            kinds.Ratchet("_steep", "small steep teeth", "base.tooth_height", "h = {:g} mm", "base.amplitude",
                          "amplitude {:g} mm", drawing.MM))


def evaluator(name):
    def evaluate(rows):
        open_rows = rows[f"{name}_open"]
        return {"means": {ratchet: kinds.velocities(rows[name + ratchet.suffix], ratchet) for ratchet in RATCHETS},
                "quality": {theta: (cell.mean("quality"), cell.mean("processed"))
                            for theta, cell in sorted(open_rows.by(THETA).items())},
                "best": best_of(open_rows, THETA, "quality")}
    return evaluate


def draw_quality(numbers):
    figure, axes = drawing.panels(1, 1, (6.0, 3.6))
    for index, (name, colour) in enumerate(zip("QP", drawing.COLOURS)):
        points = [(theta, pair[index]) for theta, pair in numbers["quality"].items()]
        drawing.curve(axes, points, color=colour, label=name)
    axes.set_ylim(0.0, 1.05)
    axes.set_xlabel(r"$\theta$ [rad]")
    axes.set_ylabel("$Q$ and $P$")
    axes.legend()
    return figure


def segregates(numbers):
    best = numbers["best"]
    where = f", best at θ = {best.at:g}".replace("-", "−") if best else ""
    return verdicts.above(f"on an open base Q > {USEFUL:g}{where}", best.mean if best else None, USEFUL)


def claimer(number, word):
    def claims(numbers):
        means_of = numbers["means"]
        differing = (kinds.differing(means, ratchet) for ratchet, means in means_of.items())
        return [verdicts.Claim(number, "Farkas 2002, abstract", "two kinds of the same size that differ only in their "
                               f"{word} coefficient can be segregated by an appropriately chosen ratchet",
                               (*differing, kinds.opposed(means_of), segregates(numbers)))]
    return claims


def opposed_table(means, ratchet):
    lines = [[kinds.named(place, ratchet), *(mean.text(drawing.MM) for mean in pair)]
             for place, pair in kinds.opposed_at(means).items()]
    if not lines:
        return f"On {ratchet.about} the kinds go opposite ways nowhere."
    return (f"Where the kinds go opposite ways on {ratchet.about}, velocities in mm/s:\n\n"
            + table(["where", "A", "B", "B less A"], lines))


def text(numbers):
    quality = [[f"{theta:g}".replace("-", "−"), *("—" if mean is None else mean.text() for mean in pair)]
               for theta, pair in numbers["quality"].items()]
    return "\n\n".join([*(opposed_table(means, ratchet) for ratchet, means in numbers["means"].items()),
                        "On the open base:", table(["θ [rad]", "Q", "P"], quality)])


def picture(name, word, names, ratchet):
    return Picture(f"{name}{ratchet.suffix}", f"Mean velocities of two kinds that differ in {word} alone, over the "
                   f"inclination, on {ratchet.about}; bars: standard errors over the seeds",
                   lambda numbers: kinds.draw(numbers["means"][ratchet], ratchet, names))


def study(number, word, names, scene):
    """@param names of both kinds. @param scene of the open base, in words"""
    name, sweep = f"farkas_{word}", f"validation_farkas_{word}"
    quality = Picture(f"{name}_quality", f"Quality and processed share of the mixture on an open base ({scene}); bars: "
                      "standard errors over the seeds", draw_quality)
    return Study(name, f"One size, another {word} (Farkas and others 2002)",
                 (*(Sweep(sweep + ratchet.suffix) for ratchet in RATCHETS), Sweep(f"{sweep}_open")), evaluator(sweep),
                 (*(picture(name, word, names, ratchet) for ratchet in RATCHETS), quality), claimer(number, word), text)
