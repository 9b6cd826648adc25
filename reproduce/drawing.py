"""How all pictures look, and how they are saved: as PNG and as SVG, the same bytes of the same numbers."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "scripts"))
from plot_analysis import COLOURS, GREY, STYLE, matplotlib, plt  # noqa: E402

MM = 1e3  # per m
RAMP = "viridis"  # of curves that are ordered by a number

__all__ = ["COLOURS", "GREY", "MM", "curve", "panels", "plt", "ramp", "save", "save_all", "signed"]


def ramp(count):
    """So many colours in the order of a scale, of which the palest is left out."""
    colours = matplotlib.colormaps[RAMP]
    return [colours(0.9 * k / max(1, count - 1)) for k in range(count)]


def panels(rows, columns, size, **options):
    return plt.subplots(rows, columns, figsize=size, layout="constrained", **options)


def curve(axes, points, scale=1.0, **options):
    """Means over x with their standard errors. @param points pairs of x and Mean; those without a Mean are left out"""
    known = [(x, mean) for x, mean in points if mean is not None]
    options = {"marker": "o", "markersize": 2.5, "elinewidth": 0.9, "capsize": 2, **options}
    return axes.errorbar([x for x, _ in known], [scale * mean.value for _, mean in known],
                         yerr=[scale * (mean.error or 0.0) for _, mean in known], **options)


def signed(axes):
    """A line at nought."""
    axes.axhline(0.0, color=GREY, linewidth=0.8, zorder=1)


def save(draw, path):
    """Draws a figure and saves it. @param draw makes the figure, @param path of the PNG; the SVG stands beside it"""
    path.parent.mkdir(parents=True, exist_ok=True)
    with plt.rc_context({**STYLE, "svg.hashsalt": "ratchet_sieve"}):
        figure = draw()
        figure.savefig(path)
        figure.savefig(path.with_suffix(".svg"), metadata={"Date": None})
        plt.close(figure)
    return path


def save_all(outcome, directory, document):
    """@return paths of the PNGs"""
    return [save(lambda draw=picture.draw: draw(outcome.numbers), directory / f"{document}_{picture.name}.png")
            for picture in outcome.study.pictures]
