"""How all pictures look, and how they are saved: the same bytes of the same numbers."""
import contextlib
import math

from matplotlib import style
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure

from ratchet_sieve.tables import writing

MM = 1e3  # per m
UJ = 1e6  # per J

# Okabe and Ito's colours, which colour-blind readers can distinguish.
COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9"]
GREY = "#555555"
DPI = 100  # of a figure in a notebook

STYLE = {
    "figure.dpi": 150,
    "font.size": 9,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "grid.color": "#E6E6E6",
    "axes.axisbelow": True,
    "axes.titlesize": 9,
    "axes.titleweight": "bold",
    "legend.frameon": False,
    "legend.fontsize": 8,
    "lines.linewidth": 1.4,
    "svg.hashsalt": "ratchet_sieve",
}


def coloured(items):
    """Pairs of a colour and an item. From the seventh on the colours come again, each time half as strong."""
    for k, item in enumerate(items):
        repeats, place = divmod(k, len(COLOURS))
        paler = tuple(1.0 - (1.0 - part) / 2.0**repeats for part in to_rgb(COLOURS[place]))
        yield paler if repeats else COLOURS[place], item


def styled():
    """A context in which figures are made and saved: matplotlib's defaults and STYLE, whatever the user's own are."""
    return style.context(["default", STYLE])


class StyledFigure(Figure):
    """Drawn in that context as well, for texts at the ticks are made only then."""

    def draw(self, renderer):
        with styled():
            super().draw(renderer)


def panels(rows, columns, size, layout="constrained", dpi=None, **options):
    """@param size of the figure [inches]. @return the figure, and its axes"""
    figure = StyledFigure(figsize=size, layout=layout, dpi=dpi)
    return figure, figure.subplots(rows, columns, **options)


@contextlib.contextmanager
def drawing(axes, size):
    """A context in which these axes are drawn into. None: those of a figure of its own, which a notebook shows, in the
    package's style. @param size of that figure [inches]"""
    if axes is not None:
        yield axes
        return
    from matplotlib import pyplot  # takes long, and the programs do without

    pyplot.draw_if_interactive()  # loads the backend before the context, whose end would undo its settings
    with styled():
        yield pyplot.subplots(figsize=size, dpi=DPI, layout="constrained", FigureClass=StyledFigure)[1]


def save(figure, path, **options):
    """@param path of the PNG; an SVG stands beside it where `svg` is true. @param options of Figure.savefig
    @return paths"""
    path.parent.mkdir(parents=True, exist_ok=True)
    paths = [path, path.with_suffix(".svg")] if options.pop("svg", True) else [path]
    for each in paths:
        with writing(each) as part:
            figure.savefig(part, format=each.suffix[1:], metadata={"Date": None} if each.suffix == ".svg" else None,
                           **options)
    return paths


def any_defined(values):
    return any(not math.isnan(value) for value in values)


def describe(axes, title, y, x=None):
    """A title at the left, and what the axes show."""
    axes.set_title(title, loc="left")
    axes.set_ylabel(y)
    if x is not None:
        axes.set_xlabel(x)


def say_undefined(axes, text):
    axes.text(0.5, 0.5, text, transform=axes.transAxes, ha="center", va="center", color=GREY)


def beside(axes, otherwise=None, **options):
    """A legend to the right of the axes; if nothing was recorded, the text `otherwise` in them."""
    if axes.get_legend_handles_labels()[0]:
        axes.legend(loc="upper left", bbox_to_anchor=(1.01, 1.02), borderaxespad=0.0, **options)
    elif otherwise:
        say_undefined(axes, otherwise)


def legend_above(axes):
    axes.legend(loc="lower left", bbox_to_anchor=(0.0, 1.0), ncol=4, frameon=False, borderaxespad=0.2)
