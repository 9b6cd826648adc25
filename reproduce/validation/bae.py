"""One grain: no, normal and reversed current over the strength of the shaking and the roughness (Bae et al. 2004)."""
import math

from reproduce import drawing, maps, verdicts
from reproduce.document import table
from reproduce.study import Picture, Study, Sweep
from reproduce.validation import currents

E = "species.0.restitution"
HEIGHT = "base.tooth_height"
AMPLITUDE = "base.amplitude"
WIDTH = 0.005    # of the teeth [m]
FREQUENCY = 23.0  # Hz
GRAVITY = 9.81
LEAST = 0.0005   # m/s that count as a current: a tooth in ten seconds
SLICE = 0.6      # the restitution whose curves are drawn


def strength(amplitude):
    """Γ, the base's greatest acceleration over gravity."""
    return round(amplitude * (2.0 * math.pi * FREQUENCY) ** 2 / GRAVITY, 2)


def evaluate(rows):
    """@return of each restitution: map from (Γ, h / w) to the mean velocity [m/s]"""
    rows = rows["validation_bae"]
    return {e: {(strength(amplitude), height / WIDTH): cell.mean("mean_vx.A")
                for (height, amplitude), cell in group.by(HEIGHT, AMPLITUDE).items()}
            for e, group in sorted(rows.by(E).items())}


def axis(means, index):
    return sorted({place[index] for place in means})


def draw_regimes(numbers):
    figure, row = drawing.panels(1, len(numbers), (3.4 * len(numbers), 3.9), sharey=True)
    for axes, (e, means) in zip(row, numbers.items()):
        maps.class_map(axes, axis(means, 0), axis(means, 1),
                       lambda x, y, means=means: currents.regime(means[x, y], LEAST), currents.COLOURS)
        axes.set_title(f"e = {e:g}")
        axes.set_xlabel(r"$\Gamma = A (2 \pi f)^2 / g$")
        axes.tick_params(axis="x", rotation=60)
    row[0].set_ylabel("roughness $h / w$")
    maps.class_legend(row[-1], currents.COLOURS)
    return figure


def draw_curves(numbers):
    means = numbers[SLICE]
    figure, axes = drawing.panels(1, 1, (6.4, 4.0))
    heights = axis(means, 1)
    for height, colour in zip(heights, drawing.ramp(len(heights))):
        drawing.curve(axes, [(gamma, means[gamma, height]) for gamma in axis(means, 0)], drawing.MM, color=colour,
                      label=f"$h / w$ = {height:g}")
    drawing.signed(axes)
    axes.set_xlabel(r"$\Gamma = A (2 \pi f)^2 / g$")
    axes.set_ylabel(r"$\langle V_x \rangle$ [mm/s]")
    axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5))
    return figure


def places(numbers):
    return {f"e = {e:g}, Γ = {x:g}, h/w = {y:g}": mean
            for e, means in numbers.items() for (x, y), mean in means.items()}


def regimes_of(means):
    return {currents.regime(mean, LEAST) for mean in means.values()} - {currents.UNTOLD}


def depends(numbers, index, name):
    """That at fixed other values more than one regime is seen along an axis, somewhere."""
    several = 0
    lines = 0
    for means in numbers.values():
        for other in axis(means, 1 - index):
            lines += 1
            cut = {place: mean for place, mean in means.items() if place[1 - index] == other}
            several += len(regimes_of(cut)) > 1
    return verdicts.Check(f"the regime changes with {name}, all else the same", f"in {several} of {lines} cuts",
                          several > 0)


def depends_on_restitution(numbers):
    common = set.intersection(*(set(means) for means in numbers.values()))
    several = sum(len(regimes_of({e: means[place] for e, means in numbers.items()})) > 1 for place in common)
    return verdicts.Check("the regime changes with e, all else the same", f"at {several} of {len(common)} places",
                          several > 0)


def claims(numbers):
    known = places(numbers)
    return [verdicts.Claim("4", "Bae 2004, abstract", "one grain has regimes of no, of normal and of reversed "
                           "current, by the strength of the shaking, the roughness of the teeth and the restitution", (
                               currents.exists("no current", known, LEAST, currents.NONE),
                               currents.exists("normal current", known, LEAST, currents.NORMAL),
                               currents.exists("reversed current", known, LEAST, currents.REVERSED),
                               depends(numbers, 0, "the strength"), depends(numbers, 1, "the roughness"),
                               depends_on_restitution(numbers)))]


def extent(means, wanted):
    cells = [place for place, mean in means.items() if currents.regime(mean, LEAST) == wanted]
    if not cells:
        return "nowhere"
    return (f"{len(cells)}: Γ {min(x for x, _ in cells):g} to {max(x for x, _ in cells):g}, "
            f"h/w {min(y for _, y in cells):g} to {max(y for _, y in cells):g}")


def text(numbers):
    wanted = (currents.NONE, currents.NORMAL, currents.REVERSED, currents.UNTOLD)
    lines = [[f"{e:g}", len(means), *(extent(means, name) for name in wanted)] for e, means in numbers.items()]
    means = numbers[SLICE]
    strengths = axis(means, 0)
    speeds = [[f"{y:g}"] + [currents.speed_text(means[x, y]) for x in strengths] for y in axis(means, 1)]
    return ("Where each regime lies: places of the map, and between which values they lie:\n\n"
            + table(["e", "places", *wanted], lines)
            + f"\n\n⟨V_x⟩ in mm/s at e = {SLICE:g}:\n\n"
            + table(["h/w \\ Γ"] + [f"{x:g}" for x in strengths], speeds))


STUDY = Study("bae", "One grain: no, normal and reversed current (Bae and others 2004)",
              (Sweep("validation_bae"),), evaluate,
              (Picture("bae_regimes", "Which way single grains go, over the strength of the shaking and the roughness "
                       f"of the teeth, a = 0.3; a current is more than {LEAST * drawing.MM:g} mm/s with 95 %",
                       draw_regimes),
               Picture("bae_current", "Mean velocity of single grains over the strength of the shaking, "
                       f"e = {SLICE:g}, a = 0.3; bars: standard errors over the seeds", draw_curves)), claims, text)
