"""Two kinds of one size and mass that differ in restitution alone, or in friction alone (Farkas et al. 2002).

The parameters were searched for. The checks are of runs with fresh seeds at places that the search had found."""
from ratchet_sieve import plots
from ratchet_sieve.reproduce import verdicts
from ratchet_sieve.reproduce.best import best_of
from ratchet_sieve.reproduce.study import Picture, Study, Sweep
from ratchet_sieve.reproduce.validation import kinds
from ratchet_sieve.tables import Rows
from ratchet_sieve.texts import shown, table

THETA = kinds.THETA
USEFUL = 0.5  # Q from which a mixture counts as segregated: half way from mixed to pure
RATCHETS = (kinds.Ratchet("", "the teeth of Fig. 3", "base.asymmetry", "a = {:g}", "base.frequency", "f = {:g} Hz"),
            kinds.Ratchet("_steep", "small steep teeth", "base.tooth_height", "h = {:g} mm", "base.amplitude",
                          "amplitude {:g} mm", plots.MM))


def evaluator(name):
    def evaluate(rows):
        open_rows = rows[f"{name}_open"]
        return {"means": {ratchet: kinds.velocities(rows[name + ratchet.suffix], ratchet) for ratchet in RATCHETS},
                "quality": {theta: (cell.mean("quality"), cell.mean("processed"))
                            for theta, cell in sorted(open_rows.by(THETA).items())},
                "best": best_of(open_rows, THETA, "quality"), "fresh": confirmed(rows[f"{name}_fresh"])}
    return evaluate


def confirmed(rows):
    """@return of the three places of the fresh seeds: B's drift less A's on the teeth of Fig. 3, both drifts on steep
    teeth, Q on the open base; each with the place in words; and the seeds"""
    open_, periodic = rows.where({"boundary": "open"}), Rows(rows.frame[rows.frame["boundary"] != "open"])
    parts = periodic.by("base.tooth_width")
    fig3, steep = parts[max(parts)], parts[min(parts)]
    return {"differing": fig3.mean(lambda row: row["mean_vx.B"] - row["mean_vx.A"]), "differing_at": place_of(fig3, 0),
            "opposed": (steep.mean("mean_vx.A"), steep.mean("mean_vx.B")), "opposed_at": place_of(steep, 1),
            "quality": open_.mean("quality"), "quality_at": f"θ = {shown(open_[0][THETA])}",
            "seeds": rows.values("seed")}


def place_of(rows, index):
    ratchet, row = RATCHETS[index], rows[0]
    return kinds.named((row[kinds.ROWS], row[ratchet.columns], row[ratchet.curves], row[THETA]), ratchet)


def draw_quality(numbers):
    figure, axes = plots.panels(1, 1, (6.0, 3.6))
    for index, (name, colour) in enumerate(zip("QP", plots.COLOURS)):
        points = [(theta, pair[index]) for theta, pair in numbers["quality"].items()]
        plots.curve(axes, points, color=colour, label=name)
    axes.set_ylim(0.0, 1.05)
    axes.set_xlabel(r"$\theta$ [rad]")
    axes.set_ylabel("$Q$ and $P$")
    axes.legend()
    return figure


def differs(fresh):
    """That the kinds drift at different speeds, whichever is faster."""
    mean = fresh["differing"]
    way = mean.surely_above(0.0)
    return verdicts.Check(f"on {RATCHETS[0].about} the kinds drift at different speeds ({fresh['differing_at']})",
                          f"B less A {kinds.shown(mean)}", None if way is None else True)


def opposite(fresh):
    a, b = fresh["opposed"]
    ways = [mean.surely_above(0.0) for mean in (a, b)]
    return verdicts.Check(f"on {RATCHETS[1].about} they go opposite ways ({fresh['opposed_at']})",
                          f"A {kinds.shown(a)}, B {kinds.shown(b)}", None if None in ways else ways[0] != ways[1])


def segregates(fresh):
    return verdicts.above(f"on an open base Q > {USEFUL:g} ({fresh['quality_at']})", fresh["quality"], USEFUL)


def claimer(number, word):
    def claims(numbers):
        fresh = numbers["fresh"]
        return [verdicts.Claim(number, "Farkas 2002, abstract", "two kinds of the same size that differ only in their "
                               f"{word} coefficient can be segregated by an appropriately chosen ratchet",
                               (differs(fresh), opposite(fresh), segregates(fresh)))]
    return claims


def figures_of(word):
    """Q on the open base by the fresh seeds: those of the search are a check of it."""
    return lambda numbers: {f"farkas_{word}.q": numbers["fresh"]["quality"].text(),
                            f"farkas_{word}.theta": numbers["fresh"]["quality_at"].split(" = ")[1]}


def opposed_table(means, ratchet):
    lines = [[kinds.named(place, ratchet), *(mean.text(plots.MM) for mean in pair)]
             for place, pair in kinds.opposed_at(means).items()]
    if not lines:
        return f"On {ratchet.about} the kinds go opposite ways nowhere."
    return (f"Where the kinds go opposite ways on {ratchet.about}, velocities in mm/s:\n\n"
            + table(["where", "A", "B", "B less A"], lines))


def text(numbers):
    quality = [[shown(theta), *("—" if mean is None else mean.text() for mean in pair)]
               for theta, pair in numbers["quality"].items()]
    found = [*(kinds.differing(means, ratchet) for ratchet, means in numbers["means"].items()),
             kinds.opposed(numbers["means"])]
    return "\n\n".join(["What the search found: " + " ".join(found),
                        *(opposed_table(means, ratchet) for ratchet, means in numbers["means"].items()),
                        "On the open base, in the search; the fresh seeds' Q above is the one to quote:",
                        table(["θ [rad]", "Q", "P"], quality)])


def picture(name, word, names, ratchet):
    return Picture(f"{name}{ratchet.suffix}", f"Mean velocities of two kinds that differ in {word} alone, over the "
                   f"inclination, on {ratchet.about}; bars: standard errors over the seeds",
                   lambda numbers: kinds.draw(numbers["means"][ratchet], ratchet, names),
                   (f"validation_{name}{ratchet.suffix}",))


def study(number, word, names, scene):
    """@param names of both kinds. @param scene of the open base, in words"""
    name, sweep = f"farkas_{word}", f"validation_farkas_{word}"
    quality = Picture(f"{name}_quality", f"Quality and processed share of the mixture on an open base ({scene}); bars: "
                      "standard errors over the seeds", draw_quality, (f"{sweep}_open",))
    return Study(name, f"One size, another {word} (Farkas and others 2002)",
                 (*(Sweep(sweep + ratchet.suffix) for ratchet in RATCHETS), Sweep(f"{sweep}_open"),
                  Sweep(f"{sweep}_fresh")), evaluator(sweep),
                 (*(picture(name, word, names, ratchet) for ratchet in RATCHETS), quality), claimer(number, word), text,
                 figures_of(word))
