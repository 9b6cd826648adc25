"""Large and small disks of one material in a layer on a level base (Rapaport 2001)."""
from ratchet_sieve import plots
from study import D, E, F, Picture, Study, axis, csv_lines, kind_curves, ways
import verdicts

KINDS = ("small", "large")


def draw(means):
    """@param means map from (e, f, d) to the mean velocities of small and large disks [m/s]"""
    restitutions, frequencies, densities = (axis(means, index) for index in range(3))
    figure, row = plots.panels(1, len(restitutions), (8.6, 3.9), sharey=True, squeeze=False)
    for axes, e in zip(row[0], restitutions):
        for f, colour in zip(frequencies, plots.ramp(len(frequencies))):
            kind_curves(axes, {d: means[e, f, d] for d in densities}, [f"{kind}, {f:g} Hz" for kind in KINDS], colour)
        plots.signed(axes)
        axes.set_xscale("log", base=2)
        axes.set_xticks(densities, [f"{d:g}" for d in densities])
        axes.set(title=f"e = {e:g}", xlabel="density $d$")
    row[0][0].set_ylabel(r"$\langle V_x \rangle$ [mm/s]")
    row[0][-1].legend(loc="center left", bbox_to_anchor=(1.0, 0.5))
    return figure


def claims(means):
    found = [place for place, pair in means.items() if verdicts.opposite(*pair)]
    says = "large and small go opposite ways"
    check = verdicts.Check(says, f"at none of {len(means)} (e, f, d), which does not exclude other parameters", None)
    if found:
        most = max(found, key=lambda place: min(abs(mean.value) for mean in means[place]))
        small, large = (verdicts.speed(mean) for mean in means[most])
        e, f, d = most
        check = verdicts.Check(says, f"at {len(found)} of {len(means)} (e, f, d), as at e = {e:g}, {f:g} Hz, "
                               f"d = {d:g}: small {small}, large {large}", True, is_searched=True)
    return [verdicts.Claim("6", "Rapaport 2001, abstract", "in a vertically vibrated layer on a sawtooth large and "
                           "small particles are horizontally driven in opposite directions", (check,))]


STUDY = Study("rapaport", "Large and small disks in a layer (Rapaport 2001)", ("validation_rapaport",),
              lambda rows: ways(rows["validation_rapaport"], E, F, D),
              (Picture("rapaport", "Mean velocities of small (0.5 mm) and large (1 mm) disks in a layer over its "
                       "thickness, on steep teeth; bars: standard errors over the seeds", draw),), claims,
              tables=lambda means: {"rapaport": csv_lines(
                  ("e", "f_hz", "d"), ("small_m_per_s", "large_m_per_s"), means)})
