"""Fig. 9: the quality Q and the processed ratio P over the inclination, for densities and lengths of the base."""
import dataclasses

from ratchet_sieve import plots
from ratchet_sieve.tables import Rows, departed, joined
from ratchet_sieve.texts import table
from curves import best_of
from study import Picture, Study, Sweep, means, told
import verdicts

THETA = "base.inclination"
TEETH = "base.teeth"
DENSITY = "density"
SWEEPS = (Sweep("paper_fig9", {THETA: (0.18, 0.22)}), Sweep("paper_fig9_long", is_quick=False),
          Sweep("paper_fig9_peak_thin", is_quick=False), Sweep("paper_fig9_peak_short", is_quick=False),
          Sweep("paper_fig9_peak_dense", is_quick=False), Sweep("paper_fig9_dense", is_quick=False))
FAR = 0.02  # rad from the best θ to both ends of a curve: one that shows whether there is a maximum


def over_inclinations(rows):
    """All runs of this figure's sweeps, each once: some cases are in two sweeps."""
    return Rows(joined(*(rows[sweep.name] for sweep in SWEEPS)).frame.drop_duplicates("run_hash", keep="last"))


def evaluate(rows):
    """@return of Q, P and what left: map from (teeth, d) to a curve over θ; and of Q what is best"""
    numbers = {"Q": {}, "P": {}, "left": {}, "best": {}}
    for place, group in over_inclinations(rows).by(TEETH, DENSITY).items():
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
            for density, colour in zip(densities, plots.ramp(len(densities))):
                plots.curve(axes, numbers[what].get((teeth, density), ()), color=colour, label=f"$d$ = {density:g}")
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
    """Those with several densities: --quick leaves some out."""
    return [teeth for teeth in axis(numbers, 0) if len(densities_on(numbers, teeth)) > 1]


def ends_of(numbers, teeth):
    """What is best at the lowest and at the highest density."""
    densities = densities_on(numbers, teeth)
    return [numbers["best"][teeth, density] for density in (densities[0], densities[-1])]


def order(numbers, teeth):
    """A check of the lowest density against the highest, each at its own best θ."""
    low, *_, high = densities_on(numbers, teeth)
    first, second = ends_of(numbers, teeth)
    check = verdicts.above(f"{teeth:g} teeth: Q at d = {low:g} less Q at d = {high:g} is above 0, each at its best θ",
                           first.mean.minus(second.mean))
    fitted = f"; by parabolas {first.peak.minus(second.peak).text()}" if first.peak and second.peak else ""
    return dataclasses.replace(check, came_out=check.came_out + fitted)


def of_as_many(places, short):
    """On the longest base, the density at which it has most nearly as many disks as a short one."""
    longest = max(teeth for teeth, _ in places)
    return min((place for place in places if place[0] == longest),
               key=lambda place: abs(place[0] * place[1] - short[0] * short[1]))


def wider(numbers):
    """A check that the same disks are segregated better on a wider base."""
    best = numbers["best"]
    short = max(place for place in best if place[0] == axis(numbers, 0)[0])
    wide = of_as_many(best, short)
    return verdicts.above(f"Q at the best θ of {wide[0]:g} teeth, d = {wide[1]:g}, less that of {short[0]:g} teeth, "
                          f"d = {short[1]:g}, is above 0", best[wide].mean.minus(best[short].mean))


def claims(numbers):
    return [verdicts.Claim("8", "Fig. 9", "Q over θ has a maximum at some θ, and is higher for low d", (
                verdicts.counted(f"Q at its best θ is higher than at the least and at the greatest θ, of all curves "
                                 f"that reach {FAR:g} rad beyond it", peaked(numbers)),
                *(order(numbers, teeth) for teeth in compared_lengths(numbers)))),
            verdicts.Claim("9", "3.2.2", "many disks are segregated better where the system is wider, and d lower for "
                           "it", (wider(numbers),))]


def apart(numbers):
    """How much of claim 9's gain the length brings, and how much the density."""
    best = numbers["best"]
    lengths = compared_lengths(numbers)
    if len(lengths) < 2:
        return {}, ""
    short, long = lengths[0], lengths[-1]
    low, high = densities_on(numbers, short)[0], densities_on(numbers, short)[-1]
    gains = {"length": best[long, high].mean.minus(best[short, high].mean),
             "density_short": best[short, low].mean.minus(best[short, high].mean),
             "density_long": best[long, low].mean.minus(best[long, high].mean)}
    told = (f"**Length and density apart.** At d = {high:g} the length alone raises the best Q from "
            f"{best[short, high].mean.text()} ({short:g} teeth) to {best[long, high].mean.text()} ({long:g} teeth), by "
            f"{gains['length'].text()}. The density alone, from {high:g} to {low:g}, raises it by "
            f"{gains['density_short'].text()} on {short:g} teeth and by {gains['density_long'].text()} on {long:g} "
            "teeth. So nearly all of the gain of claim 9 is the length's.")
    return gains, told


def best_line(numbers, place):
    """What the machine does at its best inclination."""
    best = numbers["best"][place]
    at_best = {what: dict(numbers[what][place])[best.at] for what in ("P", "left")}
    ratios = [mean.value for _, mean in numbers["P"][place]]
    return [f"{place[0]:g}", f"{place[1]:g}", f"{best.at:g}", told(best.mean), best.mean.count, told(best.peak),
            told(at_best["P"]), f"{min(ratios):.2f} to {max(ratios):.2f}", f"{at_best['left'].value:.0f}"]


def best_table(numbers):
    return table(["teeth", "d", "best θ [rad]", "Q there", "n", "Q by parabola", "P there", "P over all θ", "out"],
                 [best_line(numbers, place) for place in sorted(numbers["best"])])


def curve_lines(numbers):
    """For a CSV file."""
    lines = []
    for (teeth, density), curve in sorted(numbers["Q"].items()):
        processed = dict(numbers["P"][teeth, density])
        for theta, quality in curve:
            ratio = processed[theta]
            lines.append([f"{teeth:g}", f"{density:g}", f"{theta:g}", f"{quality.value:.6g}", f"{quality.error:.2g}",
                          f"{ratio.value:.6g}", f"{ratio.error:.2g}", quality.count])
    return ["teeth", "d", "theta_rad", "q", "q_standard_error", "p", "p_standard_error", "n"], lines


def text(numbers):
    return "\n\n".join((
        "The best θ is chosen by one half of the seeds, and Q is that of the other half; both ways, and all are "
        "averaged. So the choice does not raise Q. The table has the best θ of all seeds. The parabola goes through "
        "the means at this θ and at its two neighbours; its error is a jackknife's. \"Out\" is the number of disks "
        "that left within 100 s.",
        best_table(numbers), apart(numbers)[1]))


STUDY = Study("fig9", "Fig. 9: quality and processed ratio", SWEEPS, evaluate,
              (Picture("fig9", "Q and P after 100 s over the inclination, for several densities and lengths of the "
                       "base; bars: standard errors over the seeds", draw),), claims, text,
              tables=lambda numbers: {"fig9": curve_lines(numbers)})
