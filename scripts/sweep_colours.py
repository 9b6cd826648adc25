"""The colours of plot_sweep.py's curves and maps, and the labels at the ends of curves."""
from matplotlib.colors import BoundaryNorm

from plot_tables import COLOURS, GREY, MaxNLocator, matplotlib

COLOUR_STEPS = 10  # of a map's colours, and the most curves
SEQUENTIAL, DIVERGING = 'viridis', 'RdBu_r'  # the latter where values have both signs
BRIGHTEST = 0.85  # of the sequential map that a curve has
PALE = 0.2  # up to this the diverging map, over its extreme, is too pale for a curve
LABEL_GAP = 0.045  # between labels, over the axes' height


def has_signs(values):
    """Whether some are below 0 and some above."""
    return min(values) < 0.0 < max(values)


def curve_colours(values):
    """Of a curve for each value: steps of a colour map in the order of numbers, colours side by side for texts."""
    if any(isinstance(v, str) for v in values) or values == [None]:
        return [COLOURS[k % len(COLOURS)] for k in range(len(values))]
    if has_signs(values):
        extreme = max(-values[0], values[-1])
        # The middle of the map is white.
        return [matplotlib.colormaps[DIVERGING](0.5 + 0.5 * v / extreme) if abs(v) > PALE * extreme else GREY
                for v in values]
    ramp = matplotlib.colormaps[SEQUENTIAL]
    return [ramp(BRIGHTEST * k / max(1, len(values) - 1)) for k in range(len(values))]


def spread(places, gap):
    """Ascending places, moved apart to `gap` at least, around the same middle but below the axes' top."""
    moved = []
    for place in places:
        moved.append(max(place, moved[-1] + gap) if moved else place)
    shift = min((sum(places) - sum(moved)) / len(places), 1.0 - gap - moved[-1]) if places else 0.0
    return [place + shift for place in moved]


def label_ends(axes, ends, heading):
    """Writes beside the axes what each curve is. @param ends triples (last point, text, colour)"""
    axes.autoscale_view()
    to_axes = axes.transData + axes.transAxes.inverted()
    heights = sorted((to_axes.transform(place)[1], text, colour, place) for place, text, colour in ends)
    for height, (_, text, colour, place) in zip(spread([h[0] for h in heights], LABEL_GAP), heights):
        axes.annotate(text, place, xytext=(1.03, height), textcoords='axes fraction', va='center', fontsize=7.5,
                      color=colour, annotation_clip=False,
                      arrowprops={'arrowstyle': '-', 'color': colour, 'linewidth': 0.5, 'shrinkA': 1, 'shrinkB': 3})
    axes.text(1.03, 1.02, heading, transform=axes.transAxes, fontsize=7.5, va='bottom')


def colour_steps(values):
    """Colour map and norm of ten steps at most at round numbers; diverging around 0 where values have both signs."""
    low, high = min(values), max(values)
    name = SEQUENTIAL
    if has_signs(values):
        name, high = DIVERGING, max(-low, high)
        low = -high
    levels = MaxNLocator(COLOUR_STEPS, steps=[1, 2, 2.5, 5, 10]).tick_values(low, high)
    if len(levels) < 3:
        levels = [low - 0.5, low, low + 0.5]
    return {'cmap': name, 'norm': BoundaryNorm(levels, matplotlib.colormaps[name].N)}
