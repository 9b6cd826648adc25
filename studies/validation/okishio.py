"""One ball over the asymmetry of the teeth (Okishio, Ito, Kitahata 2022)."""
from ratchet_sieve import plots
from study import A, E, Picture, Study, axis, csv_lines, family, means
import verdicts

SYMMETRIC = 0.5


def draw(axes, velocities):
    """@param velocities of each (a, e) [m/s]"""
    family(axes, {f"e = {e:g}": [(a, velocities[a, e]) for a in axis(velocities, 0)] for e in axis(velocities, 1)},
           plots.MM)
    plots.signed(axes)
    axes.axvline(SYMMETRIC, color=plots.GREY, linewidth=0.8, zorder=1)
    axes.set(xlabel="asymmetry $a$", ylabel=r"$\langle V_x \rangle$ [mm/s]")
    axes.legend()


def gentler(velocities):
    """To where the gentler slopes face: to the right for a < 1/2."""
    for (a, e), mean in sorted(velocities.items(), key=lambda item: item[0][::-1]):
        if a != SYMMETRIC:
            yield f"e = {e:g}, a = {a:g}", mean.scaled(1.0 if a < SYMMETRIC else -1.0)


def claims(velocities):
    return [verdicts.Claim("5", "Okishio 2022, abstract", "one ball is transported to where the gentler slopes face", (
        verdicts.counted("at every asymmetry and restitution", gentler(velocities)),))]


STUDY = Study("okishio", "One ball over the asymmetry (Okishio and others 2022)",
              ("validation_okishio",), lambda rows: means(rows["validation_okishio"], "mean_vx.A", A, E),
              (Picture("okishio", "Mean velocity of single balls over the asymmetry of the teeth; bars: standard "
                       "errors over the seeds", draw, size=(6.4, 4.0)),), claims,
              tables=lambda velocities: {"okishio": csv_lines(("a", "e"), ("mean_vx_m_per_s",), velocities)})
