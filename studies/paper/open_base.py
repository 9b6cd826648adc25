"""Addition A3: why Q on an open base is best near θ = 0.1, where the kinds of Fig. 8 do not part at d = 3.93."""
from ratchet_sieve import plots
from ratchet_sieve.tables import joined
from ratchet_sieve.texts import table
from paper.parting import ANGLES, D, PRINTED
from study import Picture, Study, Sweep, means
import verdicts

THETA = "base.inclination"
TEETH = "base.teeth"
WINDOW = ("settle", "duration")
WHOLE = (0.0, 60.0)  # s: the window of Q
CLAIMED = ANGLES[0]  # where the paper has A go right and B left [rad]
EMPTY = 0.95         # of the disks that have left: a base that counts as empty
FEW = 0.1            # density below which too few disks are left to draw
SWEEPS = (Sweep("paper_open", {THETA: (CLAIMED,)}), Sweep("paper_open_long", is_quick=False))


def left_on(row):
    """The density at the end of a window: disks of 2 mm and of 4 mm diameter, half of each at the start."""
    first, last = (row[f"count.{kind}"] - row[f"left.{kind}"] - row[f"right.{kind}"] for kind in "AB")
    return PRINTED * (first + 2.0 * last) / (row["count.A"] + 2.0 * row["count.B"])


def evaluate(rows):
    """@return of each window, length and θ: drifts [m/s] and the density at the window's end"""
    every = joined(*(rows[sweep.name] for sweep in SWEEPS))
    drifts = {}
    for place, cell in sorted(every.by(*WINDOW, TEETH, THETA).items()):
        drifts[place] = {"A": cell.mean("mean_vx.A"), "B": cell.mean("mean_vx.B"), "d": cell.mean(left_on),
                         "Q": cell.mean("quality"), "P": cell.mean("processed")}
    periodic = rows["parting_window"].where({THETA: CLAIMED})
    return {"drifts": drifts,
            "periodic": {kind: means(periodic, f"mean_vx.{kind}", D).items() for kind in "AB"}}


def lengths(numbers):
    return sorted({place[2] for place in numbers["drifts"]})


def windows(numbers):
    return sorted({place[:2] for place in numbers["drifts"]} - {WHOLE})


def draw(numbers):
    """Left: Q over θ. Right: the drifts at one θ over the density, of the windows and of periodic bases."""
    figure, (left, right) = plots.panels(1, 2, (9.6, 3.8))
    for teeth, colour in zip(lengths(numbers), plots.ramp(len(lengths(numbers)))):
        points = [(place[3], cell["Q"]) for place, cell in numbers["drifts"].items() if place[:3] == (*WHOLE, teeth)]
        plots.curve(left, points, color=colour, label=f"{teeth:g} teeth")
    for kind, colour in zip("AB", plots.COLOURS):
        periodic = numbers["periodic"][kind]
        plots.curve(right, periodic, plots.MM, color=colour, label=f"{kind}, periodic base")
        cells = [cell for place, cell in numbers["drifts"].items() if place[3] == CLAIMED and place[:2] != WHOLE]
        cells = [cell for cell in cells if cell["d"].value > FEW]
        plots.curve(right, [(cell["d"].value, cell[kind]) for cell in cells], plots.MM, color=colour,
                    linestyle="none", marker="s", markersize=4, markerfacecolor="white", label=f"{kind}, open base")
    plots.signed(right)
    left.set(xlabel=r"$\theta$ [rad]", ylabel="$Q$ after 60 s")
    left.legend()
    right.set_xlabel("density $d$, on the open base at the window's end")
    right.set_ylabel(rf"$\langle V_x \rangle$ [mm/s] at $\theta$ = {CLAIMED:g}")
    right.legend()
    return figure


def window_name(window):
    return f"{window[0]:g} to {window[1]:g} s"


def early(numbers, teeth):
    """The drifts at the claimed θ in the first window of a length, while the base is full."""
    return numbers["drifts"][(*windows(numbers)[0], teeth, CLAIMED)]


def parts_late(numbers):
    """A check for each length that empties that the kinds part at the claimed θ over the whole run."""
    for teeth in lengths(numbers):
        cell = numbers["drifts"][(*WHOLE, teeth, CLAIMED)]
        if cell["P"].value < EMPTY:
            continue
        says = (f"{teeth:g} teeth, θ = {CLAIMED:g}, over all 60 s (d falls from {PRINTED:g} to "
                f"{cell['d'].value:.2f}): A to the right, B to the left")
        yield verdicts.both(verdicts.right(says, cell["A"]),
                            verdicts.left(says, cell["B"]))


def both_left_early(numbers):
    teeth = lengths(numbers)[-1]
    cell = early(numbers, teeth)
    says = (f"{teeth:g} teeth, θ = {CLAIMED:g}, while the base is full ({window_name(windows(numbers)[0])}, d = "
            f"{cell['d'].value:.2f} at its end): both to the left, as on the periodic base")
    return verdicts.both(verdicts.left(says, cell["A"]),
                         verdicts.left(says, cell["B"]))


def claims(numbers):
    return [verdicts.Claim("A3", "3.2.1, Fig. 8", "on an open base Q is best near θ = 0.1 because the base empties: d "
                           "falls to where the kinds part", (both_left_early(numbers), *parts_late(numbers)))]


def drift_table(numbers):
    lines = [[f"{place[2]:g}", f"{place[3]:g}", window_name(place[:2]), f"{cell['d'].value:.2f}",
              cell["A"].text(plots.MM), cell["B"].text(plots.MM), cell["A"].count]
             for place, cell in sorted(numbers["drifts"].items(), key=lambda item: (item[0][2:], item[0][1]))
             if place[3] == CLAIMED]
    return table(["teeth", "θ [rad]", "window", "d at its end", "A [mm/s]", "B [mm/s]", "n"], lines)


def quality_table(numbers):
    thetas = sorted({place[3] for place in numbers["drifts"]})
    lines = []
    for theta in thetas:
        cells = [numbers["drifts"].get((*WHOLE, teeth, theta)) for teeth in lengths(numbers)]
        lines.append([f"{theta:g}", *("—" if cell is None else cell["Q"].text() for cell in cells),
                      *("—" if cell is None else f"{cell['A'].text(plots.MM)}; {cell['B'].text(plots.MM)}"
                        for cell in cells)])
    return table(["θ [rad]", *(f"Q, {teeth:g} teeth" for teeth in lengths(numbers)),
                  *(f"A; B over 60 s [mm/s], {teeth:g} teeth" for teeth in lengths(numbers))], lines)


def text(numbers):
    return "\n\n".join((
        f"Fig. 8's mixture on open bases that start at d = {PRINTED:g}. A drift on an open base is the displacement "
        "of all disks over the time that they spent on the base, within a window of time. A disk counts until it "
        "leaves. Within a window d falls and the share of each kind changes. So these drifts follow those of a "
        "periodic base in their course, not in their values.",
        quality_table(numbers), f"At θ = {CLAIMED:g}, window by window:", drift_table(numbers),
        "**What it means for claim 6.** An open base passes through the densities at which the kinds part (above) as it "
        "empties. So the paper's signs at 0.105 come out on it, as a mean over the whole run. The paper names a "
        "periodic base and d = 3.93 for Fig. 8. There d stays, the signs do not come out, and claim 6 keeps its "
        "verdict. That the paper's drifts at 0.105 were taken on an emptying base would explain them; its text does "
        "not say so.",
        "Claim 7's section has Q on 20 teeth from other runs, as a check."))


def numbers_of(mean):
    """For a CSV file: the mean and its error, empty where the base was empty."""
    return ("", "") if mean is None else (f"{mean.value:.4g}", f"{mean.error or 0.0:.2g}")


def lines_of(numbers):
    """For a CSV file."""
    return (["settle_s", "duration_s", "teeth", "theta_rad", "d_at_end", "a_m_per_s", "a_standard_error", "b_m_per_s",
             "b_standard_error", "q", "p", "n"],
            [[*(f"{value:g}" for value in place), f"{cell['d'].value:.4g}",
              *(number for kind in "AB" for number in numbers_of(cell[kind])), numbers_of(cell["Q"])[0],
              numbers_of(cell["P"])[0], cell["P"].count]
             for place, cell in numbers["drifts"].items()])


STUDY = Study("open_base", "Fig. 8's mixture on an open base, which empties",
              (*SWEEPS, Sweep("parting_window")), evaluate,
              (Picture("open_base", "Q of Fig. 8's mixture on open bases over the inclination, and drifts at θ = 0.105 "
                       "over the density; bars: standard errors over the seeds", draw),), claims, text,
              tables=lambda numbers: {"open_base": lines_of(numbers)})
