"""Maps over two keys: of a signed mean, and of which of some classes it falls into."""
from matplotlib.colors import BoundaryNorm, ListedColormap, SymLogNorm
from matplotlib.patches import Patch

SIGNED = "RdBu"  # blue: to the right, red: to the left, by the colour-blind told apart


def label_cells(axes, xs, ys):
    """Cells of one size, whatever the values: they are chosen, not evenly spaced."""
    axes.set_xticks([k + 0.5 for k in range(len(xs))], [f"{x:g}" for x in xs])
    axes.set_yticks([k + 0.5 for k in range(len(ys))], [f"{y:g}" for y in ys])
    axes.grid(False)


def class_map(axes, xs, ys, class_of, colours):
    """@param class_of (x, y) -> the name of its class. @param colours map from name to colour"""
    names = list(colours)
    cells = [[names.index(class_of(x, y)) for x in xs] for y in ys]
    axes.pcolormesh(range(len(xs) + 1), range(len(ys) + 1), cells, cmap=ListedColormap(list(colours.values())),
                    norm=BoundaryNorm([k - 0.5 for k in range(len(names) + 1)], len(names)), edgecolors="white", linewidth=0.5)
    label_cells(axes, xs, ys)


def class_legend(axes, colours):
    """Beside the axes."""
    axes.legend(handles=[Patch(facecolor=colour, edgecolor="#999999", label=name) for name, colour in colours.items()],
                loc="center left", bbox_to_anchor=(1.0, 0.5))


def signed_map(axes, xs, ys, mean_of, scale, linear, largest):
    """Of means, in a scale that is linear around nought and logarithmic beyond; a dot where the sign is not sure.
    @param mean_of (x, y) -> Mean or None. @param linear, largest in the picture's unit"""
    values = [[scale * mean_of(x, y).value if mean_of(x, y) else float("nan") for x in xs] for y in ys]
    mesh = axes.pcolormesh(range(len(xs) + 1), range(len(ys) + 1), values, cmap=SIGNED, edgecolors="white", linewidth=0.5,
                           norm=SymLogNorm(linear, vmin=-largest, vmax=largest, base=10))
    unsure = [(i + 0.5, j + 0.5) for j, y in enumerate(ys) for i, x in enumerate(xs)
              if mean_of(x, y) and mean_of(x, y).surely_above(0.0) is None]
    axes.plot([x for x, _ in unsure], [y for _, y in unsure], "k.", markersize=2)
    label_cells(axes, xs, ys)
    return mesh
