"""How all pictures look, and how they are saved: as PNG and as SVG, the same bytes of the same numbers."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "scripts"))
from plot_tables import COLOURS, GREY, STYLE, matplotlib, plt, writing  # noqa: E402

MM = 1e3  # per m
STEPS = 10  # of a colour scale
RAMP = "viridis"    # of curves that are ordered by a number
SIGNED = "RdBu_r"   # of numbers with a sign: blue below zero, red above
MIDDLE = "#999999"  # of zero itself
GAP = 1.12          # between labels at the curves' ends, in lines of text

__all__ = ["COLOURS", "GREY", "MM", "curve", "end_labels", "panels", "plt", "ramp", "save", "save_all", "signed",
           "signed_ramp"]


def ramp(count):
    """So many colours in the order of a scale, of which the palest is left out. Up to STEPS differ."""
    colours = matplotlib.colormaps[RAMP].resampled(STEPS)
    return [colours(round(0.9 * (STEPS - 1) * k / max(1, count - 1))) for k in range(count)]


def signed_ramp(values):
    """A colour of each value on a scale that diverges from zero, with STEPS colours. The pale ones are left out."""
    colours = matplotlib.colormaps[SIGNED].resampled(2 * STEPS)
    largest = max(abs(value) for value in values) or 1.0
    side = STEPS // 2
    found = []
    for value in values:
        step = max(1, round(side * abs(value) / largest))
        away = round((STEPS - 1) * (0.35 + 0.65 * step / side))
        found.append(MIDDLE if value == 0.0 else colours(STEPS + away if value > 0.0 else STEPS - 1 - away))
    return found


def panels(rows, columns, size, **options):
    return plt.subplots(rows, columns, figsize=size, layout="constrained", **options)


def curve(axes, points, scale=1.0, **options):
    """Means over x with their standard errors. @param points pairs of x and Mean; those without a Mean are left out"""
    known = [(x, mean) for x, mean in points if mean is not None]
    options = {"marker": "o", "markersize": 2.5, "elinewidth": 0.9, "capsize": 2, **options}
    return axes.errorbar([x for x, _ in known], [scale * mean.value for _, mean in known],
                         yerr=[scale * (mean.error or 0.0) for _, mean in known], **options)


def signed(axes):
    """A line at zero."""
    axes.axhline(0.0, color=GREY, linewidth=0.8, zorder=1)


def end_labels(axes, ends, title="", size=7.5):
    """A label at the right of each curve's end, moved up or down where two would touch.
    @param ends (y of the end, text, colour) of each curve. @param title above them"""
    figure = axes.figure
    figure.draw_without_rendering()
    low, high = axes.get_ylim()
    line = GAP * size / 72.0 * (high - low) / (axes.get_window_extent().height / figure.dpi)
    ends = sorted(ends)
    heights = [y for y, _, _ in ends]
    for _ in range(200):  # neighbours push each other apart
        for k in range(len(heights) - 1):
            overlap = line - (heights[k + 1] - heights[k])
            if overlap > 0.0:
                heights[k] -= 0.5 * overlap
                heights[k + 1] += 0.5 * overlap
    for height, (_, text, colour) in zip(heights, ends):
        axes.annotate(text, (1.0, height), xycoords=("axes fraction", "data"), xytext=(4, 0),
                      textcoords="offset points", color=colour, fontsize=size, va="center", annotation_clip=False)
    if title:
        axes.annotate(title, (1.0, heights[-1] + 1.3 * line), xycoords=("axes fraction", "data"), xytext=(4, 0),
                      textcoords="offset points", color=GREY, fontsize=size, va="center", annotation_clip=False)


def save(draw, path, note=""):
    """Draws a figure and saves it. @param draw makes the figure, @param path of the PNG; the SVG stands beside it
    @param note below the figure"""
    path.parent.mkdir(parents=True, exist_ok=True)
    with plt.rc_context({**STYLE, "svg.hashsalt": "ratchet_sieve"}):
        figure = draw()
        if note:
            figure.supxlabel(note, x=0.995, ha="right", fontsize=7.5, color=GREY)
        with writing(path):
            figure.savefig(path)
            figure.savefig(path.with_suffix(".svg"), metadata={"Date": None})
        plt.close(figure)
    return path


def save_all(outcome, directory, document):
    """@return paths of the PNGs"""
    return [save(lambda draw=picture.draw: draw(outcome.numbers), directory / f"{document}_{picture.name}.png",
                 outcome.samples(picture)) for picture in outcome.study.pictures]
