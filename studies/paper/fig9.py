"""Fig. 9: the quality Q and the processed ratio P over the inclination, for densities and lengths of the base."""
from ratchet_sieve import plots
from ratchet_sieve.tables import Rows, departed, joined
from ratchet_sieve.texts import table
from curves import best_of
from study import D, TEETH, THETA, Picture, Study, csv_lines, family, means, told
import verdicts

SWEEPS = ("paper_fig9", "paper_fig9_long", "paper_fig9_peak_thin", "paper_fig9_peak_short", "paper_fig9_peak_dense",
          "paper_fig9_dense")
EMPTY = 0.99  # of all disks: so many have left a base that counts as emptied
FAR = 0.02  # rad from the best θ to both ends of a curve: one that shows whether there is a maximum


def evaluate(rows):
    """@return of Q, P and what left: map from (teeth, d) to a curve over θ; and of Q what is best"""
    numbers = {"Q": {}, "P": {}, "left": {}, "best": {}}
    # Some cases are in two sweeps.
    every = Rows(joined(*(rows[name] for name in SWEEPS)).frame.drop_duplicates("run_hash", keep="last"))
    for place, group in every.by(TEETH, D).items():
        for what, field in (("Q", "quality"), ("P", "processed"), ("left", departed)):
            numbers[what][place] = list(means(group, field, THETA).items())
        numbers["best"][place] = best_of(group, THETA, "quality")
    return numbers


def axis(numbers, index):
    return sorted({place[index] for place in numbers["Q"]})


def densities_on(numbers, teeth):
    return sorted(density for length, density in numbers["Q"] if length == teeth)


def draw(numbers):
    lengths, densities = axis(numbers, 0), axis(numbers, 1)
    figure, all_axes = plots.panels(2, len(lengths), (3.2 * len(lengths) + 0.8, 5.2), sharex=True, sharey="row",
                                    squeeze=False)
    for column, teeth in enumerate(lengths):
        for row, what in enumerate(("Q", "P")):
            axes = all_axes[row][column]
            family(axes, {f"$d$ = {density:g}": numbers[what].get((teeth, density), ()) for density in densities})
            axes.set_ylim(0.0, 1.05)
        all_axes[0][column].set_title(f"{teeth:g} teeth")
        all_axes[1][column].set_xlabel(r"$\theta$ [rad]")
    all_axes[0][0].set_ylabel("quality $Q$")
    all_axes[1][0].set_ylabel("processed ratio $P$")
    all_axes[0][-1].legend(loc="center left", bbox_to_anchor=(1.0, 0.5))
    return figure


def peaked(numbers):
    """Q at the best θ less that at the least and at the greatest θ, of curves that reach far enough."""
    for (teeth, density), best in numbers["best"].items():
        curve = numbers["Q"][teeth, density]
        if min(best.at - curve[0][0], curve[-1][0] - best.at) < FAR - 1e-9:
            continue
        for theta, mean in (curve[0], curve[-1]):
            if mean is not None:
                yield f"L = {teeth:g}, d = {density:g}, θ = {theta:g}", best.mean.minus(mean)


def compared_lengths(numbers):
    """Those with several densities."""
    return [teeth for teeth in axis(numbers, 0) if len(densities_on(numbers, teeth)) > 1]


def ends_of(numbers, teeth):
    """What is best at the lowest and at the highest density."""
    densities = densities_on(numbers, teeth)
    return [numbers["best"][teeth, density] for density in (densities[0], densities[-1])]


def order(numbers, teeth):
    """A check of the lowest density against the highest, each at its own best θ."""
    low, *_, high = densities_on(numbers, teeth)
    first, second = ends_of(numbers, teeth)
    return verdicts.above(f"{teeth:g} teeth: best Q at d = {low:g} less that at d = {high:g} is above 0",
                          first.mean.minus(second.mean)).about(f"low d on {teeth:g} teeth")


def emptied(numbers):
    """The bases that nearly all disks left at the best θ: Q of others is that of the fastest disks alone."""
    return [place for place, best in numbers["best"].items() if dict(numbers["P"][place])[best.at].value >= EMPTY]


def wider(numbers):
    """A check that the same disks are segregated better on a wider base."""
    best = numbers["best"]
    short = max(place for place in best if place[0] == axis(numbers, 0)[0])
    longest = max(teeth for teeth, _ in emptied(numbers))
    wide = min((place for place in emptied(numbers) if place[0] == longest),  # with most nearly as many disks
               key=lambda place: abs(place[0] * place[1] - short[0] * short[1]))
    return verdicts.above(f"Q at the best θ of {wide[0]:g} teeth, d = {wide[1]:g}, less that of {short[0]:g} teeth, "
                          f"d = {short[1]:g}, is above 0 (P > {EMPTY:g} for both)",
                          best[wide].mean.minus(best[short].mean))


def claims(numbers):
    return [verdicts.Claim("8", "Fig. 9", "Q over θ has a maximum at some θ, and is higher for low d", (
                verdicts.counted(f"Q is higher at its best θ than at the ends, for all curves that reach {FAR:g} rad "
                                 "beyond it", peaked(numbers)).about("a maximum"),
                *(order(numbers, teeth) for teeth in compared_lengths(numbers)))),
            verdicts.Claim("9", "3.2.2", "many disks are segregated better where the system is wider, and d lower for "
                           "it", (wider(numbers),))]


def apart(numbers):
    """How much the length alone and the density alone raise the best Q, in words."""
    best, lengths = numbers["best"], compared_lengths(numbers)
    short, long = lengths[0], max(teeth for teeth, _ in emptied(numbers))
    low, *_, high = densities_on(numbers, short)
    gains = [best[long, high].mean.minus(best[short, high].mean), best[short, low].mean.minus(best[short, high].mean)]
    return (f"At d = {high:g} the length alone raises the best Q by {gains[0].text()} from {short:g} to {long:g} "
            f"teeth. The density alone, from {high:g} to {low:g} on {short:g} teeth, raises it by {gains[1].text()}.")


def best_table(numbers):
    """What the machine does at its best inclination, at the least and at the highest density."""
    lines = []
    for (teeth, density), best in sorted(numbers["best"].items()):
        there = {what: dict(numbers[what][teeth, density])[best.at].value for what in ("P", "left")}
        if density in (densities_on(numbers, teeth)[0], densities_on(numbers, teeth)[-1]):
            lines.append([f"{teeth:g}", f"{density:g}", f"{best.at:g}", told(best.mean), best.mean.count,
                          f"{there['P']:.2f}", f"{there['left']:.0f}"])
    return table(["teeth", "d", "best θ [rad]", "best Q", "n", "P at that θ", "disks out"], lines)


def tables(numbers):
    return {"fig9": csv_lines(("teeth", "d", "theta_rad"), ("q", "p"), {
                (*place, theta): (quality, dict(numbers["P"][place])[theta])
                for place, curve in sorted(numbers["Q"].items()) for theta, quality in curve}),
            "fig9_best": csv_lines(("teeth", "d", "best_theta_rad"), ("q", "p", "out"), {
                (*place, best.at): (best.mean, *(dict(numbers[what][place])[best.at] for what in ("P", "left")))
                for place, best in sorted(numbers["best"].items())})}


def text(numbers):
    return "\n\n".join((
        "The paper gives neither the length of its base nor its densities. It plots P: at some θ not all of its disks "
        "had left after 100 s. Here that is so on 300 teeth: Q there is of the disks that left first. For the best "
        "Q one half of the seeds chooses θ and the other half gives Q, both ways, n in all; θ and P are those of all "
        "seeds.",
        best_table(numbers), apart(numbers)))


STUDY = Study("fig9", "Fig. 9: quality and processed ratio", SWEEPS, evaluate,
              (Picture("fig9", "Q and P after 100 s over the inclination, for several densities and lengths of the "
                       "base; bars: standard errors over the seeds", draw),), claims, text,
              tables=tables)
