"""Addition A3: what the species of Fig. 8 do at θ = 0.105 on an open base, which empties."""
from ratchet_sieve import plots
from ratchet_sieve.tables import joined
from paper.parting import ANGLES, PRINTED, parted
from study import D, TEETH, THETA, WAYS, Picture, Study, csv_lines, family, means
import verdicts

WINDOW = ("settle", "duration")
WHOLE = (0.0, 60.0)  # s: the window of Q
CLAIMED = ANGLES[0]  # where the paper has A go right and B left [rad]
FEW = 0.1            # density below which too few disks are left to draw
SWEEPS = ("paper_open", "paper_open_long")


def left_on(row):
    """The density at the end of a window: disks of 2 mm and of 4 mm diameter, half of each at the start."""
    first, last = (row[f"count.{kind}"] - row[f"left.{kind}"] - row[f"right.{kind}"] for kind in "AB")
    return PRINTED * (first + 2.0 * last) / (row["count.A"] + 2.0 * row["count.B"])


def mean_on(row):
    """The mean density over a window."""
    first, last = (row[f"height_profile.disks.{kind}"] for kind in "AB")
    return PRINTED * (first + 2.0 * last) / (row["count.A"] + 2.0 * row["count.B"])


def evaluate(rows):
    """@return of each window, length and θ: drifts [m/s] and the density, its mean and at the window's end"""
    every = joined(*(rows[name] for name in SWEEPS))
    drifts = {}
    for place, cell in sorted(every.by(*WINDOW, TEETH, THETA).items()):
        drifts[place] = {"A": cell.mean("mean_vx.A"), "B": cell.mean("mean_vx.B"), "d": cell.mean(left_on),
                         "mean_d": cell.mean(mean_on),
                         "Q": cell.mean("quality"), "P": cell.mean("processed")}
    periodic = rows["parting_window"].where({THETA: CLAIMED})
    return {"drifts": drifts,
            "periodic": {kind: means(periodic, f"mean_vx.{kind}", D).items() for kind in "AB"}}


def lengths(numbers):
    return sorted({place[2] for place in numbers["drifts"]})


def draw(numbers):
    """Left: Q over θ. Right: the drifts at one θ over the density, of the windows and of periodic bases."""
    figure, (left, right) = plots.panels(1, 2, (9.6, 3.8))
    family(left, {f"{teeth:g} teeth": [(place[3], cell["Q"]) for place, cell in numbers["drifts"].items()
                                       if place[:3] == (*WHOLE, teeth)] for teeth in lengths(numbers)})
    for kind, colour in zip("AB", plots.COLOURS):
        periodic = numbers["periodic"][kind]
        plots.curve(right, periodic, plots.MM, color=colour, label=f"{kind}, periodic base")
        cells = [cell for place, cell in numbers["drifts"].items() if place[3] == CLAIMED and place[:2] != WHOLE]
        cells = [cell for cell in cells if cell["mean_d"].value > FEW]
        plots.curve(right, [(cell["mean_d"].value, cell[kind]) for cell in cells], plots.MM, color=colour,
                    linestyle="none", marker="s", markersize=4, markerfacecolor="white", label=f"{kind}, open base")
    plots.signed(right)
    left.set(xlabel=r"$\theta$ [rad]", ylabel="$Q$ after 60 s")
    left.legend()
    right.set_xlabel("density $d$, on the open base its mean over an interval of time")
    right.set_ylabel(rf"$\langle V_x \rangle$ [mm/s] at $\theta$ = {CLAIMED:g}")
    right.legend()
    return figure


def parts_late(numbers):
    """A check for each length that the species go opposite ways at the claimed θ over the whole run."""
    for teeth in lengths(numbers):
        cell = numbers["drifts"][(*WHOLE, teeth, CLAIMED)]
        says = (f"{teeth:g} teeth, θ = {CLAIMED:g}, over all 60 s (d falls from {PRINTED:g} to "
                f"{cell['d'].value:.2f}): A to the right, B to the left")
        yield parted(says, (cell["A"], cell["B"])).about(f"{teeth:g} teeth")


def both_left_early(numbers):
    teeth, (begin, end) = lengths(numbers)[-1], min({place[:2] for place in numbers["drifts"]} - {WHOLE})
    cell = numbers["drifts"][begin, end, teeth, CLAIMED]
    says = (f"{teeth:g} teeth, θ = {CLAIMED:g}, while the base is full ({begin:g} to {end:g} s, d = "
            f"{cell['d'].value:.2f} at its end): both to the left, as on the periodic base")
    return verdicts.both(*(verdicts.left(says, cell[kind]) for kind in "AB")).about("both left while full")


def claims(numbers):
    return [verdicts.Claim("A3", "3.2.1, Fig. 8", f"on an open base A goes right and B left at θ = {CLAIMED:g} in the "
                           "mean over a whole run, in which it empties",
                           (both_left_early(numbers), *parts_late(numbers)))]


TEXT = ("The bases start at d = 3.93. A drift on an open base is the displacement of all disks over the time that they "
        "spent on it. As the base empties it passes through the densities at which the species go opposite ways (A1). "
        "But at equal mean density both drift further to the left than on a periodic base, which is what the paper "
        "names for Fig. 8: in no interval of the run are they seen to go opposite ways at those densities.")


STUDY = Study("open_base", "Fig. 8's mixture on an open base, which empties",
              (*SWEEPS, "parting_window"), evaluate,
              (Picture("open_base", "Q of Fig. 8's mixture on open bases over the inclination, and drifts at θ = 0.105 "
                       "over the mean density; bars: standard errors over the seeds", draw),), claims,
              lambda numbers: TEXT,
              tables=lambda numbers: {"open_base": csv_lines(
                  ("settle_s", "duration_s", "teeth", "theta_rad"), ("d_at_end", "mean_d", *WAYS, "q", "p"), {
                      place: [cell[name] for name in ("d", "mean_d", "A", "B", "Q", "P")]
                      for place, cell in numbers["drifts"].items()})})
