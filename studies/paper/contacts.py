"""Claim 2: contacts with short over those with long slopes, over the rebound floor v_min."""
import dataclasses
import math

from ratchet_sieve import plots
from study import Picture, Study, csv_lines, over
import verdicts

V_MIN = "contact.min_rebound_speed"
SCENES = 0.05        # v_min of the scenes [m/s]
PRINTED = 0.53
ROUNDING = 0.015     # "about 0.53": nearer to it than to 0.5 or 0.56
LENGTHS = math.hypot(0.3 * 20.0, 6.0) / math.hypot(0.7 * 20.0, 6.0)  # of the slopes, short over long


def draw(axes, means):
    plots.curve(axes, [(v, ratio) for v, (ratio, _) in means.items()], color=plots.COLOURS[0])
    axes.axhspan(PRINTED - ROUNDING, PRINTED + ROUNDING, color=plots.COLOURS[4], alpha=0.3, label="about 0.53")
    axes.axhline(LENGTHS, color=plots.GREY, linewidth=0.8, linestyle="--", label=f"slopes' lengths, {LENGTHS:.3f}")
    axes.set(xscale="log", xlabel=r"$v_\mathrm{min}$ [m/s]", ylabel="short to long contacts")
    axes.legend(loc="lower right")


def condition(means):
    """In which range of v_min the claim holds, in words."""
    found = [v for v, (ratio, _) in means.items() if verdicts.is_within(ratio, PRINTED - ROUNDING, PRINTED + ROUNDING)]
    if not found:
        return "at no v_min that was tried"
    ratios = [ratio.value for ratio, _ in means.values()]
    return (f"for v_min from {found[0]:g} to {found[-1]:g} m/s ({min(ratios):.2f} to {max(ratios):.2f} from "
            f"{min(means):g} to {max(means):g} m/s; the paper gives no v_min)")


def claims(means):
    check = verdicts.within(f"between {PRINTED - ROUNDING:g} and {PRINTED + ROUNDING:g} at v_min = {SCENES:g} m/s, as "
                            "in the scenes", means[SCENES][0], PRINTED - ROUNDING, PRINTED + ROUNDING)
    return [verdicts.Claim("2", "3.1.1", "contacts of short to long slopes are about 0.53 in Fig. 3",
                           (dataclasses.replace(check, is_searched=True),), condition(means))]


STUDY = Study("contacts", "Short and long slopes, over the rebound floor",
              ("paper_fig3_contacts",),
              lambda rows: over(rows["paper_fig3_contacts"], ("short_to_long", "mean_vx.A"), V_MIN),
              (Picture("contacts", "Contacts with short over those with long slopes, of Fig. 3's disks, over v_min; "
                       "bars: standard errors over the seeds", draw, size=(6.4, 3.6)),), claims,
              figures=lambda means: {"contacts.short_to_long": means[SCENES][0].text()},
              tables=lambda means: {"contacts": csv_lines(
                  ("v_min_m_per_s",), ("short_to_long", "mean_vx_m_per_s"), means)})
