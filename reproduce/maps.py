"""Maps over two keys that show the class of each place."""
from matplotlib.colors import BoundaryNorm, ListedColormap
from matplotlib.patches import Patch


def label_cells(axes, xs, ys):
    """Cells of one size, since the values are not evenly spaced."""
    axes.set_xticks([k + 0.5 for k in range(len(xs))], [f"{x:g}" for x in xs])
    axes.set_yticks([k + 0.5 for k in range(len(ys))], [f"{y:g}" for y in ys])
    axes.grid(False)


def class_map(axes, xs, ys, class_of, colours):
    """@param class_of (x, y) -> the name of its class. @param colours map from name to colour"""
    names = list(colours)
    cells = [[names.index(class_of(x, y)) for x in xs] for y in ys]
    edges = [k - 0.5 for k in range(len(names) + 1)]
    axes.pcolormesh(range(len(xs) + 1), range(len(ys) + 1), cells, cmap=ListedColormap(list(colours.values())),
                    norm=BoundaryNorm(edges, len(names)), edgecolors="white", linewidth=0.5)
    label_cells(axes, xs, ys)


def class_legend(axes, colours):
    """Beside the axes."""
    return axes.legend(handles=[Patch(facecolor=colour, edgecolor="#999999", label=name)
                                for name, colour in colours.items()], loc="center left", bbox_to_anchor=(1.0, 0.5))


def lone_legend(axes, colours):
    """In place of the axes."""
    axes.axis("off")
    legend = class_legend(axes, colours)
    legend.set_bbox_to_anchor((0.0, 0.5))
    legend.set_in_layout(False)
