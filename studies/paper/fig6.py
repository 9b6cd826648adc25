"""Claim 13: single disks of several radii on a level base. Larger disks feel the ratchet less, as Fig. 6 says."""
from ratchet_sieve import plots
from study import F, Picture, Study, axis, csv_lines, named_curves, over
import verdicts

R = "species.0.radius"
SMALL, LARGE = 0.001, 0.004  # m, as in Fig. 7


def draw(means):
    """@param means map from (f, r) to the ratio of contacts and the mean velocity [m/s]"""
    figure, both = plots.panels(1, 2, (8.6, 3.6))
    frequencies, radii = axis(means, 0), axis(means, 1)
    names = ("short to long contacts", r"$\langle V_x \rangle$ [mm/s]")
    for what, (axes, name) in enumerate(zip(both, names)):
        curves = {f"{f:g} Hz": [(plots.MM * r, means[f, r][what]) for r in radii] for f in frequencies}
        ends = named_curves(axes, curves, plots.ramp(len(frequencies)), plots.MM if what else 1.0)
        axes.set(xlabel="$r$ [mm]", ylabel=name)
        plots.end_labels(axes, ends)
    return figure


def difference(means, what, sign):
    """Of large disks and small ones at each f."""
    for f in axis(means, 0):
        yield f"{f:g} Hz", means[f, LARGE][what].minus(means[f, SMALL][what]).scaled(sign)


def claims(means):
    slower, steeper = difference(means, 1, -1.0), difference(means, 0, 1.0)
    text_of_claim = "large disks hit the steep slope of the next tooth and go back, so the ratchet moves them less"
    return [verdicts.Claim("13", "Fig. 6", text_of_claim, (
        verdicts.counted("on the level base disks of 4 mm are slower than disks of 1 mm, at every f", slower).about(
            "slower"),
        verdicts.counted("their share of contacts with the short, steep slopes is higher, at every f", steeper).about(
            "more contacts with steep slopes")))]


TEXT = ("The second check is indirect: it counts contacts, of which a disk at rest in a valley makes many, and not the "
        "disks that return at the next tooth.")


STUDY = Study("fig6", "Fig. 6: single disks over their radius", ("paper_fig6",),
              lambda rows: over(rows["paper_fig6"], ("short_to_long", "mean_vx.A"), F, R),
              (Picture("fig6", "Contacts with short over those with long slopes, and mean velocity, of single disks "
                       "over their radius at θ = 0; bars: standard errors over the seeds", draw),), claims,
              lambda means: TEXT,
              tables=lambda means: {"fig6": csv_lines(("f_hz", "r_m"), ("short_to_long", "mean_vx_m_per_s"), means)})
