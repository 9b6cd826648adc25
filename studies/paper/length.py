"""Addition A4: how the best Q rises with the length of the base, and whether a line in 1 / length says where to."""
from ratchet_sieve import plots
from ratchet_sieve.stats import LEVEL
from curves import line_through
from paper import fig9
from paper.fig9 import axis
from study import Picture, Study, numbers_of
import verdicts

NEAR = 0.01  # of Q(∞) from 1


def evaluate(rows):
    curves = fig9.evaluate(rows)
    points = {}
    for (teeth, density), best in sorted(curves["best"].items()):
        points.setdefault(density, []).append((1.0 / teeth, best.mean))
    lines = {density: line_through(own) for density, own in points.items()}
    return {**curves, "points": points, "lines": {density: line for density, line in lines.items() if line}}


def draw(axes, numbers):
    densities = axis(numbers, 1)
    for density, colour in zip(densities, plots.ramp(len(densities))):
        points, line = numbers["points"][density], numbers["lines"].get(density)
        plots.curve(axes, points, color=colour, linestyle="none", markersize=4, label=f"$d$ = {density:g}")
        if line:
            ends = (0.0, max(x for x, _ in points))
            axes.plot(ends, [line.at(x) for x in ends], color=colour, linewidth=0.9, linestyle="--")
    lengths = axis(numbers, 0)
    axes.set_xticks([0.0] + [1.0 / teeth for teeth in lengths], ["∞"] + [f"{teeth:g}" for teeth in lengths])
    axes.set_xlim(left=0.0)
    axes.set(xlabel="teeth, on a scale of 1 / teeth", ylabel=r"$Q$ at the best $\theta$ after 100 s")
    axes.legend()


def rising(numbers):
    """Of each density: Q at the best θ of each length less that of the next shorter one."""
    for density in axis(numbers, 1):
        lengths = sorted(teeth for teeth, d in numbers["best"] if d == density)
        for short, long in zip(lengths, lengths[1:]):
            gain = numbers["best"][long, density].mean.minus(numbers["best"][short, density].mean)
            yield f"d = {density:g}, {short:g} to {long:g} teeth", gain


def tends_to_one(density, line):
    """A check that a line in 1 / teeth ends near 1; undecided where it does not fit."""
    near = verdicts.within("", line.intercept, 1.0 - NEAR, 1.0 + NEAR)
    fits = line.probability() >= LEVEL
    told = f"Q(∞) = {line.intercept.text()}, p = {line.probability():.2g}{'' if fits else ', no line'}"
    return verdicts.Check(f"d = {density:g}: a line in 1 / teeth has |Q(∞) − 1| < {NEAR:g}", told,
                          near.passes if fits else None, part=f"to 1 at d = {density:g}")


def claims(numbers):
    return [verdicts.Claim("A4", "Fig. 9", "Q at the best θ rises with the length of the base, and tends to 1", (
        verdicts.counted("after 100 s Q at the best θ rises from each length to the next", rising(numbers)).about(
            "it rises"),
        *(tends_to_one(density, line) for density, line in numbers["lines"].items())))]


def tables(numbers):
    return {"length": (["d", "q_infinite", "q_infinite_error", "c", "c_error", "chi_squared", "freedom", "p"], [
        [f"{density:g}", *numbers_of(line.intercept), *numbers_of(line.slope.scaled(-1.0)), f"{line.chi_squared:.2g}",
         line.freedom, f"{line.probability():.2g}"] for density, line in numbers["lines"].items()])}


TEXT = ("Disks that start near the wrong end leave there, and their share falls as the base grows. Three lengths are "
        "few for a limit, and on 300 teeth not all disks are out after 100 s. The line is Q = Q(∞) − c / teeth.")


STUDY = Study("length", "The length of the base", fig9.SWEEPS, evaluate,
              (Picture("length", "Q at the best inclination over one through the length of the base, and straight "
                       "lines; bars: standard errors over the seeds", draw, size=(6.4, 3.8)),), claims,
              lambda numbers: TEXT, tables=tables)
