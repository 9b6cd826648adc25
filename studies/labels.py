"""Labels beside points that cover neither points, nor lines, nor each other."""
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.patheffects import withStroke

OFFSETS = [(5, 5), (5, -5), (-5, 5), (-5, -5), (0, 9), (0, -9), (9, 0), (-9, 0), (8, 13), (8, -13), (-8, 13), (-8, -13),
           (0, 19), (0, -19), (20, 5), (-20, 5)]  # from the point [points of 1/72 inch]
MARKER = 5.0  # half the width of a point [pixels]
LINE = 1.5    # of a line
STEPS = 12    # points that a line's piece is taken as


def overlap(one, other):
    """Area [pixels^2]."""
    width = min(one[2], other[2]) - max(one[0], other[0])
    height = min(one[3], other[3]) - max(one[1], other[1])
    return max(0.0, width) * max(0.0, height)


def annotate(axes, point, offset, text, colour):
    horizontal = "left" if offset[0] > 0 else "right" if offset[0] < 0 else "center"
    vertical = "bottom" if offset[1] > 0 else "top" if offset[1] < 0 else "center"
    return axes.annotate(text, point, textcoords="offset points", xytext=offset, ha=horizontal, va=vertical, fontsize=7,
                         color=colour, path_effects=[withStroke(linewidth=2, foreground="white")])


def boxes(pixels, half):
    return [(x - half, y - half, x + half, y + half) for x, y in pixels]


def along(pixels):
    """Points along a line."""
    return [one + (other - one) * k / STEPS for one, other in zip(pixels, pixels[1:]) for k in range(1, STEPS)]


def place(axes, labelled, points, lines):
    """Writes each label where it covers least; the figure's layout has to be final.
    @param labelled triples (point, text, colour), @param lines arrays of points"""
    renderer = FigureCanvasAgg(axes.figure).get_renderer()
    taken = boxes(map(axes.transData.transform, points), MARKER)
    for line in lines:
        taken += boxes(along(axes.transData.transform(line)), LINE)
    frame = axes.get_window_extent(renderer)
    for point, text, colour in labelled:
        best = None
        for offset in OFFSETS:
            label = annotate(axes, point, offset, text, colour)
            box = label.get_window_extent(renderer).extents
            outside = (box[2] - box[0]) * (box[3] - box[1]) - overlap(box, frame.extents)
            covered = outside + sum(overlap(box, other) for other in taken)
            label.remove()
            if best is None or covered < best[0]:
                best = covered, offset, box
            if covered == 0.0:
                break
        annotate(axes, point, best[1], text, colour)
        taken.append(tuple(best[2]))
