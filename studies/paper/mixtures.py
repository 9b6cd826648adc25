"""Section 3.2.1: mixtures of species that have the same radius or the same mass, against the mixture of Fig. 8."""
from ratchet_sieve import plots
from curves import TURNS, best_of, turns_of
from study import THETA, Picture, Study, csv_lines, means
import verdicts

KEYS = ("species.0.radius", "species.0.mass", "species.1.radius", "species.1.mass")
REFERENCE = (0.001, 0.01, 0.002, 0.001)  # A and B of Fig. 8: radius [m], mass [kg] of each
NAMES = {
    REFERENCE: "1 mm, 10 g; 2 mm, 1 g",
    (0.001, 0.01, 0.001, 0.001): "same r: 1 mm, 10 g; 1 g",
    (0.002, 0.01, 0.002, 0.001): "same r: 2 mm, 10 g; 1 g",
    (0.001, 0.001, 0.002, 0.001): "same m: 1 g, 1 mm; 2 mm",
    (0.001, 0.01, 0.002, 0.01): "same m: 10 g, 1 mm; 2 mm",
}


def of_mixture(rows, mixture):
    return rows.where(dict(zip(KEYS, mixture)))


def evaluate(rows):
    periodic, separating = rows["paper_mixtures"], rows["paper_mixtures_quality"]
    numbers = {}
    for mixture in NAMES:
        drifts, machine = of_mixture(periodic, mixture), of_mixture(separating, mixture)
        numbers[mixture] = {
            **turns_of(drifts, THETA),
            "apart": means(drifts, lambda frame: frame["mean_vx.A"] - frame["mean_vx.B"], THETA).items(),
            "quality": means(machine, "quality", THETA).items(),
            "best": best_of(machine, THETA, "quality")}
    return numbers


def draw(numbers):
    figure, (left, right) = plots.panels(1, 2, (9.6, 3.6))
    for (mixture, found), colour in zip(numbers.items(), plots.COLOURS):
        plots.curve(left, found["quality"], color=colour, label=NAMES[mixture])
        plots.curve(right, found["apart"], plots.MM, color=colour)
    plots.signed(right)
    left.set_ylabel("$Q$")
    right.set_ylabel(r"$\langle V_x \rangle$ of A less that of B [mm/s]")
    for axes in (left, right):
        axes.set_xlabel(r"$\theta$ [rad]")
    right.legend(*left.get_legend_handles_labels(), loc="center left", bbox_to_anchor=(1.0, 0.5))
    return figure


def others(numbers):
    return {mixture: found for mixture, found in numbers.items() if mixture != REFERENCE}


def worse(numbers):
    best = numbers[REFERENCE]["best"].mean
    for mixture, found in others(numbers).items():
        yield f"{NAMES[mixture]}: {found['best'].mean.text()}", best.minus(found["best"].mean)


def narrower(numbers):
    """A mixture whose kinds do not both turn has no window, and is not counted."""
    window = numbers[REFERENCE]["window"]
    for mixture, found in others(numbers).items():
        if window and found["window"]:
            yield f"{NAMES[mixture]}: {found['window'].text()}", window.minus(found["window"])


def claims(numbers):
    best, window = numbers[REFERENCE]["best"].mean, numbers[REFERENCE]["window"]
    text = "the same r with different m, or the same m with different r, segregates worse than the mixture of Fig. 8"
    return [verdicts.Claim("7", "3.2.1", text, (
                verdicts.counted(f"Q at the best θ is lower than Fig. 8's, {verdicts.shown(best, 1, '')}",
                                 worse(numbers)),)),
            verdicts.Claim("A5", "3.2.1", "on a periodic base of 10 teeth the species of claim 7's mixtures go "
                           "opposite ways in a narrower interval of θ than Fig. 8's", (
                verdicts.counted("the interval is narrower than Fig. 8's, "
                                 f"{verdicts.shown(window, 1, 'rad') if window else '—'}", narrower(numbers)),))]


TEXT = ("Q is that of 20 teeth with open ends after 60 s. The intervals are those of θ in which A goes right and B "
        "left, on 10 teeth.")


STUDY = Study("mixtures", "Section 3.2.1: mixtures that differ in the radius or the mass alone",
              ("paper_mixtures", "paper_mixtures_quality"), evaluate,
              (Picture("mixtures", "Q and how much faster A is than B, of five mixtures, d = 3.93; bars: standard "
                       "errors over the seeds", draw),), claims,
              lambda numbers: TEXT,
              tables=lambda numbers: {"mixtures": csv_lines(("mixture", "best_theta_rad"), ("q", *TURNS.values()), {
                  (NAMES[mixture], found["best"].at): [found["best"].mean, *(found[part] for part in TURNS)]
                  for mixture, found in numbers.items()})})
