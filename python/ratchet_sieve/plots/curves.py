"""Curves with errors, distributions, and the colours and labels of curves."""
import matplotlib

from ratchet_sieve.plots.style import COLOURS, GREY

STEPS = 10  # of a colour scale
RAMP = "viridis"    # of curves that are ordered by a number
SIGNED = "RdBu_r"   # of numbers with a sign: blue below zero, red above
LAST = 0.75         # of that ramp, which can be seen on white
MIDDLE = "#999999"  # of zero itself
GAP = 1.12          # between labels at the curves' ends, in lines of text


def ramp(count):
    """So many colours in the order of a scale, up to STEPS different ones. The yellow ones are left out."""
    colours = matplotlib.colormaps[RAMP].resampled(round(STEPS / LAST))
    return [colours(round((STEPS - 1) * k / max(1, count - 1))) for k in range(count)]


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


def has_signs(values):
    """Whether some are below 0 and some above."""
    return min(values) < 0.0 < max(values)


def key_colours(values):
    """Of a curve for each value of a key: in the order of numbers, side by side for texts."""
    if len(values) == 1 or any(isinstance(value, str) for value in values):
        return [COLOURS[k % len(COLOURS)] for k in range(len(values))]
    return signed_ramp(values) if has_signs(values) else ramp(len(values))


def curve(axes, points, scale=1.0, **options):
    """Means over x with their standard errors. @param points pairs of x and Mean; those without a Mean are left out"""
    known = [(x, mean) for x, mean in points if mean is not None]
    options = {"marker": "o", "markersize": 2.5, "elinewidth": 0.9, "capsize": 2, **options}
    return axes.errorbar([x for x, _ in known], [scale * mean.value for _, mean in known],
                         yerr=[scale * (mean.error or 0.0) for _, mean in known], **options)


def distribution(axes, edges, densities, errors=None, **options):
    """Of displacements or the like. With errors: a line through the centres of the bins, else steps.
    @param edges of the bins, one more than densities"""
    if errors is None:
        return axes.step(edges, [*densities, 0.0], where="post", **options)
    centres = [0.5 * (low + high) for low, high in zip(edges, edges[1:])]
    return axes.errorbar(centres, densities, yerr=errors, linewidth=1.0, elinewidth=0.7, **options)


def signed(axes):
    """A line at zero."""
    axes.axhline(0.0, color=GREY, linewidth=0.8, zorder=1)


def end_labels(axes, ends, title="", size=7.5):
    """A label at the right of each curve's end, moved up or down where two would touch.
    @param ends (y of the end, text, colour) of each curve. @param title above them"""
    if not ends:
        return
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
