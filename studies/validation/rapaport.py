"""Large and small disks of one material in a layer on a level base (Rapaport 2001)."""
from ratchet_sieve import plots
from study import D, E, F, V_MIN, Picture, Study, axis, csv_lines, kind_curves, ways
import verdicts

KINDS = ("small", "large")


def draw(numbers):
    """The search's means: map from (e, f, d) to the mean velocities of small and large disks [m/s]."""
    means = numbers["means"]
    restitutions, frequencies, densities = (axis(means, index) for index in range(3))
    figure, row = plots.panels(1, len(restitutions), (8.6, 3.9), sharey=True, squeeze=False)
    for axes, e in zip(row[0], restitutions):
        for k, f in enumerate(frequencies):
            kind_curves(axes, {d: means[e, f, d] for d in densities}, [f"{kind}, {f:g} Hz" for kind in KINDS], k)
        plots.signed(axes)
        axes.set_xscale("log", base=2)
        axes.set_xticks(densities, [f"{d:g}" for d in densities])
        axes.set(title=f"e = {e:g}", xlabel="density $d$")
    row[0][0].set_ylabel(r"$\langle V_x \rangle$ [mm/s]")
    row[0][-1].legend(loc="center left", bbox_to_anchor=(1.0, 0.5))
    return figure


def claims(numbers):
    """@param numbers fresh: map from the rebound floor to both species' mean velocities at one setting [m/s]"""
    checks = (verdicts.Check(f"large and small go opposite ways (e = 0.6, 30 Hz, d = 1) at v_min = {floor:g} m/s",
                             f"small {verdicts.speed(small)}, large {verdicts.speed(large)}",
                             verdicts.opposite(small, large), part=f"v_min = {floor:g} m/s")
              for floor, (small, large) in numbers["fresh"].items())
    return [verdicts.Claim("6", "Rapaport 2001, abstract", "in a vertically vibrated layer on a sawtooth large and "
                           "small particles are horizontally driven in opposite directions", tuple(checks))]


def text(numbers):
    means = numbers["means"]
    found = sum(bool(verdicts.opposite(*pair)) for pair in means.values())
    return (f"In the search they surely go opposite ways at {found} of {len(means)} settings (e, f, d). The checks "
            "are at the setting that came nearest to it. The floor of the search is above 0.6 √(g r) of the small "
            "disks, too.")


STUDY = Study("rapaport", "Large and small disks in a layer (Rapaport 2001)",
              ("validation_rapaport", "validation_rapaport_fresh"),
              lambda rows: {"means": ways(rows["validation_rapaport"], E, F, D),
                            "fresh": ways(rows["validation_rapaport_fresh"], V_MIN)},
              (Picture("rapaport", "Mean velocities of small (radius 0.5 mm) and large (1 mm) disks in a layer over "
                       "its thickness, on steep teeth; bars: standard errors over the seeds", draw,
                       ("validation_rapaport",)),),
              claims, text,
              tables=lambda numbers: {"rapaport": csv_lines(
                  ("e", "f_hz", "d"), ("small_m_per_s", "large_m_per_s"), numbers["means"])})
