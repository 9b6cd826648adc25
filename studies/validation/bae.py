"""One grain: no, normal and reversed current over the strength of the shaking and the roughness (Bae et al. 2004)."""
import math

from ratchet_sieve import plots
from study import E, V_MIN, Picture, Study, axis, csv_lines, named_curves
import verdicts

HEIGHT = "base.tooth_height"
AMPLITUDE = "base.amplitude"
WIDTH = 0.005    # of the teeth [m]
FREQUENCY = 23.0  # Hz
GRAVITY = 9.81
LEAST = 0.0005   # m/s that count as a current: a tooth in ten seconds
SLICE = 0.6      # the restitution whose curves are drawn
CUT, STRONG, ROUGH = 0.8, 8.0, 1.0  # h/w, Γ and h/w along which the fresh places lie
NORMAL = "normal"      # to where the gentler slopes face: to the right, as a < 0.5
REVERSED = "reversed"
NONE = "none"
UNTOLD = "undecided"
COLOURS = {NORMAL: plots.COLOURS[5], NONE: "#D9D9D9", REVERSED: plots.COLOURS[4], UNTOLD: "#FFFFFF"}  # right, left


def regime(mean, least):
    """@param least speed that counts as a current [m/s]"""
    if mean is None:
        return UNTOLD
    if mean.surely_above(least):
        return NORMAL
    if mean.surely_below(-least):
        return REVERSED
    return NONE if verdicts.is_within(mean, -least, least) else UNTOLD


def exists(says, means, least, wanted):
    """A check that a regime is at one of these places; it fails only where each surely has another.
    @param means map from the place's name to its Mean, by fresh seeds"""
    found = {place: mean for place, mean in means.items() if regime(mean, least) == wanted}
    if not found:
        open_ = any(regime(mean, least) == UNTOLD for mean in means.values())
        return verdicts.Check(says, f"at none of {len(means)}", None if open_ else False)
    place = max(found, key=lambda name: abs(found[name].value))
    return verdicts.Check(says, f"at {len(found)} of {len(means)}, most at {place}: {verdicts.speed(found[place])}",
                          True)


def strength(amplitude):
    """Γ, the base's greatest acceleration over gravity."""
    return round(amplitude * (2.0 * math.pi * FREQUENCY) ** 2 / GRAVITY, 2)


FLOOR = 0.01  # of the map and of the checks [m/s]


def velocities(rows):
    """@return of each restitution: map from (Γ, h / w) to the mean velocity [m/s]"""
    return {e: {(strength(amplitude), round(height / WIDTH, 9)): cell.mean("mean_vx.A")
                for (height, amplitude), cell in group.by(HEIGHT, AMPLITUDE).items()}
            for e, group in sorted(rows.by(E).items())}


def draw_regimes(numbers):
    numbers = numbers["map"]
    figure, row = plots.panels(1, len(numbers), (3.4 * len(numbers), 3.9), sharey=True)
    for axes, (e, means) in zip(row, numbers.items()):
        plots.class_map(axes, axis(means, 0), axis(means, 1),
                       lambda x, y, means=means: regime(means[x, y], LEAST), COLOURS)
        axes.set(title=f"e = {e:g}", xlabel=r"$\Gamma = A (2 \pi f)^2 / g$")
        axes.tick_params(axis="x", rotation=60)
    row[0].set_ylabel("roughness $h / w$")
    plots.class_legend(row[-1], COLOURS)
    return figure


def draw_curves(axes, numbers):
    means = numbers["map"][SLICE]
    heights, strengths = axis(means, 1), axis(means, 0)
    curves = {f"{height:g}": [(gamma, means[gamma, height]) for gamma in strengths] for height in heights}
    ends = named_curves(axes, curves, plots.ramp(len(heights)), plots.MM)
    plots.signed(axes)
    axes.set(xlabel=r"$\Gamma = A (2 \pi f)^2 / g$", ylabel=r"$\langle V_x \rangle$ [mm/s]")
    plots.end_labels(axes, ends, "$h / w$")


def changes(says, means):
    """A check that more than one regime is among these places. @param means map from the place's name to its Mean"""
    regimes = {place: regime(mean, LEAST) for place, mean in means.items()}
    told = "; ".join(f"{name} at {place}" for place, name in regimes.items())
    known = set(regimes.values()) - {UNTOLD}
    passes = True if len(known) > 1 else None if UNTOLD in regimes.values() else False
    return verdicts.Check(says, told, passes)


# Those fresh places that differ in one key alone from the last place of the strength's cut.
CUTS = {"strength": lambda e, x, y: e == SLICE and y == CUT, "roughness": lambda e, x, y: e == SLICE and x == STRONG,
        "e": lambda e, x, y: (x, y) == (STRONG, ROUGH) and e != SLICE}


def places(numbers, is_chosen=lambda e, x, y: True):
    """@return map from a place in words to its mean velocity"""
    return {f"e = {e:g}, Γ = {x:g}, h/w = {y:g}": mean for e, means in numbers.items()
            for (x, y), mean in sorted(means.items()) if is_chosen(e, x, y)}


def claims(numbers):
    fresh = numbers["fresh"][FLOOR]
    known = places(fresh)
    return [verdicts.Claim("4", "Bae 2004, abstract", "one grain has regimes of no, of normal and of reversed "
                           "current, by the strength of the shaking, the roughness of the teeth and the restitution", (
                               *(exists(f"{'no' if wanted == NONE else wanted} current (of {LEAST * plots.MM:g} mm/s)", known,
                                        LEAST, wanted)
                                 for wanted in (NONE, NORMAL, REVERSED)),
                               *(changes(f"the regime changes with {'' if name == 'e' else 'the '}{name}, all else "
                                         "the same", places(fresh, cut)) for name, cut in CUTS.items())))]


def text(numbers):
    """What another floor changes, in words."""
    known = places(numbers["fresh"][FLOOR])
    changed = [f"{regime(means[place], LEAST)} in place of {regime(mean, LEAST)} at {place}, v_min = {floor:g} m/s "
               f"({verdicts.speed(means[place])})" for floor, fresh in numbers["fresh"].items() if floor != FLOOR
               for means in (places(fresh),) for place, mean in known.items()
               if regime(means[place], LEAST) != regime(mean, LEAST)]
    others = " and ".join(f"{floor:g}" for floor in numbers["fresh"] if floor != FLOOR)
    return (f"The checks are at v_min = {FLOOR:g} m/s. At {others} m/s the regimes are the same, except for: "
            f"{'; '.join(changed) or 'none'}.")


def lines_of(floors):
    """@param floors map from the rebound floor [m/s] to what velocities() gives"""
    return csv_lines(("floor_m_per_s", "e", "gamma", "h_over_w"), ("mean_vx_m_per_s",), {
        (floor, e, *place): mean for floor, numbers in floors.items() for e, means in numbers.items()
        for place, mean in means.items()})


STUDY = Study("bae", "One grain: no, normal and reversed current (Bae and others 2004)",
              ("validation_bae", "validation_bae_fresh"),  # of a search, and of fresh seeds at places that it had found
              lambda rows: {"map": velocities(rows["validation_bae"]), "fresh": {
                  floor: velocities(part) for floor, part in sorted(rows["validation_bae_fresh"].by(V_MIN).items())}},
              (Picture("bae_regimes", "Which way single grains go, over the strength of the shaking and the roughness "
                       f"of the teeth, a = 0.3; a current is more than {LEAST * plots.MM:g} mm/s with 95 %",
                       draw_regimes, ("validation_bae",)),
               Picture("bae_current", "Mean velocity of single grains over the strength of the shaking, "
                       f"e = {SLICE:g}, a = 0.3; bars: standard errors over the seeds", draw_curves,
                       ("validation_bae",), (6.4, 4.0))),
              claims, text, tables=lambda numbers: {"bae": lines_of({FLOOR: numbers["map"]}),
                                                    "bae_fresh": lines_of(numbers["fresh"])})
