"""Claim 14: the restitution changes the mean velocity of single disks, as section 3.1.2 remarks."""
from ratchet_sieve import plots
from study import E, Picture, Study, csv_lines, means
import verdicts

PRINTED = 0.6


def draw(axes, velocities):
    plots.curve(axes, velocities.items(), plots.MM, color="black")
    axes.set(xlabel="restitution $e$", ylabel=r"$\langle V_x \rangle$ [mm/s]")
    axes.set_ylim(bottom=0.0)


def claims(velocities):
    others = [mean.minus(velocities[PRINTED]) for e, mean in velocities.items() if e != PRINTED]
    differing = sum(sign is not None for sign in verdicts.signs(others))
    low, high = (choose(velocities, key=lambda e: velocities[e].value) for choose in (min, max))
    told = (f"at {differing} of {len(others)}, from {verdicts.speed(velocities[low])} at {low:g} to "
            f"{verdicts.speed(velocities[high])} at {high:g}")
    return [verdicts.Claim("14", "3.1.2", "the restitution changes the net current of single disks", (
        verdicts.Check(f"at another e it differs from that at e = {PRINTED:g}", told, True if differing else None),))]


STUDY = Study("restitution", "Single disks over their restitution", ("paper_restitution",),
              lambda rows: means(rows["paper_restitution"], "mean_vx.A", E),
              (Picture("restitution", "Mean velocity of single disks over their restitution, otherwise as in "
                       "Fig. 3; bars: standard errors over the seeds", draw, size=(6.4, 3.6)),), claims,
              tables=lambda velocities: {"restitution": csv_lines(("e",), ("mean_vx_m_per_s",), velocities)})
