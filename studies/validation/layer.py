"""A layer of one species: its current over its thickness, and over the frequency (Derényi, Tegzes, Vicsek 1998)."""
from ratchet_sieve import plots
from ratchet_sieve.stats import jackknife
from curves import curve_of
from study import D, E, F, V_MIN, Picture, Study, axis, csv_lines, family, means, named_curves
import verdicts

LEAST = 0.0005  # m/s that count as a current
SUDDEN = 0.5    # of the greatest current within one step of the frequency: an onset that is sudden


def evaluate(rows):
    onset, fresh = rows["validation_layer_onset"], rows["validation_layer_fresh"]
    rows = rows["validation_layer"]
    return {"means": means(rows, "mean_vx.A", E, F, D),
            "fresh": {floor: means(part, "mean_vx.A", D) for floor, part in sorted(fresh.by(V_MIN).items())},
            "onset": means(onset, "mean_vx.A", E, F, D),
            "steps": {place: jackknife(lambda seeds, cell=cell: largest_step(cell, seeds), cell.values("seed"))
                      for place, cell in sorted(onset.by(E, D).items())}}


def draw(numbers):
    velocities = numbers["means"]
    restitutions, frequencies, densities = (axis(velocities, index) for index in range(3))
    figure, row = plots.panels(1, len(restitutions), (8.6, 3.9), sharey=True, squeeze=False)
    labels = []
    for axes, e in zip(row[0], restitutions):
        curves = {f"{f:g} Hz": [(d, velocities[e, f, d]) for d in densities] for f in frequencies}
        labels.append((axes, named_curves(axes, curves, plots.ramp(len(frequencies)), plots.MM)))
        plots.signed(axes)
        axes.set_xscale("log", base=2)
        axes.set_xticks(densities, [f"{d:g}" for d in densities])
        axes.set(title=f"e = {e:g}", xlabel="density $d$, about the number of layers")
    row[0][0].set_ylabel(r"$\langle V_x \rangle$ [mm/s]")
    for axes, ends in labels:
        plots.end_labels(axes, ends)
    return figure


def draw_onset(axes, numbers):
    velocities = numbers["onset"]
    for e, style in zip(axis(velocities, 0), ("-", "--")):
        family(axes, {f"e = {e:g}, d = {d:g}": [(f, velocities[e, f, d]) for f in axis(velocities, 1)]
                      for d in axis(velocities, 2)}, plots.MM, linestyle=style)
    plots.signed(axes)
    axes.set(xlabel="$f$ [Hz]", ylabel=r"$\langle V_x \rangle$ [mm/s]")
    if velocities:
        axes.legend()


def turns_afresh(floor, fresh):
    """A check by fresh seeds that the current of a thin layer and of a thicker one have opposite signs."""
    says = f"the current reverses as the layer is made thicker (e = 0.85, 22 Hz) at v_min = {floor:g} m/s"
    told = ", ".join(f"{verdicts.speed(mean)} at d = {d:g}" for d, mean in fresh.items())
    return verdicts.Check(says, told, verdicts.opposite(*fresh.values()), part="it reverses")


def largest_step(rows, seeds):
    """@return the greatest change of the velocity from one frequency to the next, over its greatest size"""
    speeds = [speed for _, speed in curve_of(rows, F, "mean_vx.A", seeds)]
    return max(abs(late - early) for early, late in zip(speeds, speeds[1:])) / max(map(abs, speeds))


def sets_in(steps):
    """A check that no single step of the frequency makes the most of the current."""
    says = f"it sets in gradually: of the greatest current no step of 1 Hz makes {100 * SUDDEN:g} %"
    if not steps:
        return verdicts.Check(says, "—", None, part="it sets in gradually")
    told = "; ".join(f"e = {e:g}, d = {d:g}: {share.text(100.0)} %" for (e, d), share in steps.items())
    return verdicts.Check(says, told, verdicts.all_of(share.surely_below(SUDDEN) for share in steps.values()),
                          part="it sets in gradually")


def claims(numbers):
    return [verdicts.Claim("3", "Derényi 1998, abstract", "increasing the layer's thickness reverses its current, "
                           "under certain conditions; transport sets in gradually with the frequency",
                           (*(turns_afresh(floor, fresh) for floor, fresh in numbers["fresh"].items()),
                            sets_in(numbers["steps"])))]


TEXT = "The rebound floor of the search, 0.05 m/s, is above 0.6 √(g r) of these disks: `sieve_run` warns of that."


STUDY = Study("layer", "A layer over its thickness (Derényi and others 1998)",
              ("validation_layer", "validation_layer_fresh", "validation_layer_onset"), evaluate,
              (Picture("layer", "Mean velocity of a layer of one species over its thickness, on steep teeth (w = 6 mm, "
                       "h = 5 mm, a = 0.3); bars: standard errors over the seeds", draw, ("validation_layer",)),
               Picture("layer_onset", "Mean velocity of a thin and of a thick layer over the frequency, on the same "
                       "teeth; bars: standard errors over the seeds", draw_onset, ("validation_layer_onset",),
                       (6.4, 3.8))), claims, lambda numbers: TEXT,
              tables=lambda numbers: {name: csv_lines(("e", "f_hz", "d"), ("mean_vx_m_per_s",), numbers[key])
                                      for name, key in (("layer", "means"), ("layer_onset", "onset"))})
