"""Error over speed-up, a panel for each of four scenes: of the method (steps), and of what the model leaves out."""
from matplotlib.ticker import LogLocator, NullFormatter

from ratchet_sieve import plots
import labels
from precision import tables
from precision.points import MODEL, SCENES_FLOOR, find

METHOD_PANELS = {"gas": ("K_rot / K_trans",), "fig8": ("drift A", "drift B", "K_B"), "dense": ("drift B", "K_B"),
                 "violent": ("drift B", "K_B")}
MODEL_PANELS = {"fig3": "short / long", "fig8": "drift A", "fig9": "Q", "dense": "drift A"}
LIMITS = (0.2, 1000.0)  # of the error [%]

# The recommended points: scene -> family, label.
EVENTS = ("exact", "exact")
USE_METHOD = {"gas": EVENTS, "fig8": ("steps", "1 ms"), "dense": EVENTS, "violent": EVENTS}
USE_MODEL = {"fig8": ("floor, in steps of 1 ms", "0.025 m/s"), "fig9": EVENTS,
             "dense": ("rebound floor", "0.0125 m/s")}

LOOKS = {"drift A": (0, "o"), "drift B": (1, "s"), "K_B": (2, "^"), "K_rot / K_trans": (3, "D"),
         "rebound floor": (0, "s"), "contact duration": (1, "^"), "restitution by speed": (2, "v"),
         "floor, in steps of 1 ms": (3, "o"), "no spin": (4, "P"), "no pairs": (5, "X")}


def look(name):
    colour, marker = LOOKS[name]
    return plots.COLOURS[colour], marker


def draw_point(axes, speed, error, name):
    """Filled, with its interval, where an error is seen; else open, at its bound, with an arrow below.
    @return where it was drawn"""
    colour, marker = look(name)
    bound = tables.PERCENT * tables.bound(error)
    if not tables.is_seen(error):
        size = max(bound, LIMITS[0])
        axes.annotate("", (speed, size / 1.9), (speed, size),
                      arrowprops={"arrowstyle": "->", "color": colour, "lw": 0.8})
        axes.plot(speed, size, marker, color=colour, markersize=4.5, markerfacecolor="white", zorder=3)
        return speed, size
    size = tables.PERCENT * abs(error.value)
    axes.plot([speed, speed], [max(LIMITS[0], 2.0 * size - bound), bound], color=colour, linewidth=0.9)
    axes.plot(speed, size, marker, color=colour, markersize=4.5, zorder=3)
    return speed, size


def draw_series(axes, points, chosen, name, quantity, reference):
    """@param chosen the points of one line. @return triples (place, label, point)"""
    exact, drawn = find(points, "exact"), []
    for point in chosen:
        speed = tables.speed_up(point, exact)
        error = tables.relative(point.means.get(quantity), reference(points, quantity))
        if speed is not None and error is not None:
            drawn.append((draw_point(axes, speed, error, name), point.label, point))
    axes.plot([place[0] for place, _, _ in drawn], [place[1] for place, _, _ in drawn], color=look(name)[0],
              linewidth=0.8, zorder=2, label="_")
    return drawn


def finish(axes, points, drawn, used):
    """Scales, the exact engine, and the recommended point."""
    axes.set_xscale("log", base=2)
    axes.set(yscale="log", ylim=LIMITS)
    speeds = [place[0] for place, _, _ in drawn] + [1.0]
    axes.set_xlim(min(speeds) / 1.5, max(speeds) * 1.6)
    axes.xaxis.set_major_locator(LogLocator(base=2.0))
    axes.xaxis.set_major_formatter("{x:g}")
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.yaxis.set_major_formatter("{x:g}")
    axes.tick_params(which="minor", length=0)
    axes.axvline(1.0, color=plots.GREY, linewidth=0.8, linestyle=":")
    axes.set_title(f"{points[0].scene.title} ({tables.seeds([point for _, _, point in drawn])})", loc="left")
    found = [place for place, _, point in drawn if used == (point.family, point.label)]
    if used == EVENTS and not found:  # they are the reference
        found = [(1.0, LIMITS[0] * 1.15)]
    for place in found:
        axes.plot(*place, "*", color="#E6B800", markersize=15, markeredgecolor="black", markeredgewidth=0.7, zorder=2.5,
                  clip_on=False)


def write_labels(axes, drawn, labelled):
    chosen = [(place, text, look(name)[0]) for name, place, text in labelled]
    lines = [line.get_xydata() for line in axes.lines if len(line.get_xydata()) > 2]
    labels.place(axes, chosen, [place for place, _, _ in drawn], lines)


def legend(figure, axes, names):
    for name in names:
        colour, marker = look(name)
        axes.plot([], [], marker + "-", color=colour, markersize=4.5, label=name)
    axes.plot([], [], "o", color=plots.GREY, markerfacecolor="white", markersize=4.5,
              label="not told from 0: at most so much (95 %)")
    axes.plot([], [], "*", color="#E6B800", markeredgecolor="black", markersize=11, label="recommended")
    axes.plot([], [], ":", color=plots.GREY, label="events, as the scene stands")
    handles, texts = axes.get_legend_handles_labels()
    figure.legend(handles, texts, ncol=4, loc="lower center")


def panels():
    figure, grid = plots.panels(2, 2, (10.0, 8.2), None)
    figure.subplots_adjust(left=0.08, right=0.98, top=0.95, bottom=0.15, hspace=0.28, wspace=0.18)
    for axes in grid[:, 0]:
        axes.set_ylabel("error, %")
    for axes in grid[1]:
        axes.set_xlabel("times faster than events")
    return figure, list(grid.flat)


def draw_method(groups):
    """Steps against the known value or the exact engine."""
    figure, grid = panels()
    for axes, (scene, names) in zip(grid, METHOD_PANELS.items()):
        points = groups.get(scene, [])
        series = {name: draw_series(axes, points, tables.measured(points, "steps"), name, name, tables.exact_value)
                  for name in names} if points else {}
        drawn = [one for own in series.values() for one in own]
        if not drawn:
            continue
        finish(axes, points, drawn, USE_METHOD.get(scene))
        # One label for each step, at the point that is highest.
        highest = {}
        for name, own in series.items():
            for place, text, _ in own:
                if text not in highest or place[1] > highest[text][1][1]:
                    highest[text] = (name, place, text)
        write_labels(axes, drawn, highest.values())
    legend(figure, grid[0], dict.fromkeys(name for names in METHOD_PANELS.values() for name in names))
    return figure


def draw_model(groups):
    """What the model leaves out against the least floor; labelled are the ends of each family."""
    figure, grid = panels()
    for axes, (scene, quantity) in zip(grid, MODEL_PANELS.items()):
        points, drawn, labelled = groups.get(scene, []), [], []
        for family in MODEL:
            own = tables.with_floors(points) if family == "rebound floor" else tables.measured(points, family)
            found = draw_series(axes, points, own, family, quantity, tables.least_floor)
            drawn += found
            used = USE_MODEL.get(scene)
            labelled += [(family, place, text if point.family != "exact" else f"{SCENES_FLOOR:g} m/s")
                         for place, text, point in found
                         if point in (found[0][2], found[-1][2]) or used == (family, text) or point.family == "exact"]
        if not drawn:
            continue
        finish(axes, points, drawn, USE_MODEL.get(scene))
        axes.set_title(axes.get_title(loc="left") + f": {quantity}", loc="left")
        write_labels(axes, drawn, labelled)
    legend(figure, grid[0], MODEL)
    return figure
