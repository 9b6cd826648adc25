"""A search as a picture, a scene of the best machine, and a section of a document."""
import copy

import yaml

from optimise.machine import read_scene
from reproduce import drawing
from reproduce.document import table

HEADER = "# {title}: the best machine that\n# scripts/optimise {search} found; `docs/machines.md` has what it does. Every key is explained in paper_fig8.yaml.\n"


def draw(search, found):
    figure, all_axes = drawing.panels(1, 1, (6.4, 4.2), squeeze=False)
    axes = all_axes[0][0]
    for one, colour in zip(found, drawing.COLOURS):
        axes.plot([m.throughput.value for _, m in one.tried], [m.quality.value for _, m in one.tried], ".",
                  color=colour, alpha=0.25, markersize=3)
        front = sorted(one.front, key=lambda pair: pair[1].throughput.value)
        axes.errorbar([m.throughput.value for _, m in front], [m.quality.value for _, m in front],
                      xerr=[m.throughput.error or 0.0 for _, m in front],
                      yerr=[m.quality.error or 0.0 for _, m in front], color=colour, marker="o", markersize=4,
                      linewidth=1.0, capsize=2, label=one.kind.name)
        if one.best:
            axes.plot(one.best[1].throughput.value, one.best[1].quality.value, "*", color=colour, markersize=13,
                      markeredgecolor="white")
    axes.axvline(search.throughput, color=drawing.GREY, linewidth=0.8, linestyle=":")
    axes.set_xlabel("throughput [disks / (s m)]")
    axes.set_ylabel("quality $Q$")
    axes.set_ylim(0.0, 1.02)
    axes.set_xlim(left=0.0)
    axes.set_title(search.title, fontsize=10)
    axes.legend(loc="best")
    return figure


def put(scene, path, value):
    """Sets a key by its dotted path, as `--set` of sieve_run."""
    *parents, last = path.split(".")
    place = scene
    for name in parents:
        place = place[int(name)] if isinstance(place, list) else place.setdefault(name, {})
    place[int(last) if isinstance(place, list) else last] = value


def scene_of(search, machine):
    """The machine as a scene of its own."""
    scene = copy.deepcopy(read_scene(search.scene))
    for key, value in {**search.settings, **machine.values}.items():
        put(scene, key, value)
    return HEADER.format(title=search.title, search=search.path.name) + yaml.safe_dump(scene, sort_keys=False,
                                                                                       default_flow_style=None)


def shown(value):
    return f"{value:.4g}".replace("-", "−") if isinstance(value, float) else str(value)


def machine_table(search, found):
    keys = list(search.ranges)
    lines = []
    for one in found:
        if one.best is None:
            lines.append([one.kind.name, "—", "—", "—", *["—" for _ in keys]])
            continue
        machine, measured = one.best
        lines.append([one.kind.name, measured.quality.text(), measured.throughput.text(), measured.processed.text(),
                      *[shown(machine.values[key]) if key in machine.values else "" for key in keys]])
    return table(["machine", "Q", "disks / (s m)", "P", *[f"`{key}`" for key in keys]], lines)


def gain(found):
    """Of each kind against the first."""
    first, *others = found
    for other in others:
        if first.best and other.best:
            difference = other.best[1].quality.minus(first.best[1].quality)
            times = other.best[1].throughput.value / first.best[1].throughput.value
            yield (f"With {other.kind.name} Q is higher by {difference.text()} than with {first.kind.name}, at "
                   f"{times:.2g} times the throughput")


def film(search, found, pictures):
    """That of the best machine of the last kind, where there is one: scripts/make_animation.py makes it from the scene."""
    name = f"machine_{search.path.stem}_rviz.gif"
    if found[-1].best and (pictures / name).is_file():
        yield f"![In RViz: the best machine of the last kind, five seconds of it](images/{name})"


def section(search, found, picture, pictures):
    """@param picture the name of its file in the directory `pictures`"""
    tried = "; ".join(f"{one.kind.name}: {one.kind.trials} machines tried, {len(one.tried)} allowed" for one in found)
    return "\n\n".join([
        f"## {search.title}",
        f"[{search.path.name}](../config/searches/{search.path.name}). {tried}. Found by seeds {search.seeds.first} to "
        f"{search.seeds.first + search.seeds.count - 1}; all below by {search.held_out.count} others, "
        f"{search.held_out.first} to {search.held_out.first + search.held_out.count - 1}. The best are those of the "
        f"highest Q, by the first seeds, with P ≥ {search.least_processed:g} and {search.throughput:g} disks / (s m).",
        f"![Quality over throughput: {search.title}](images/{picture})",
        f"*Dots: machines that were tried (n = {search.seeds.count}). Circles: the front of each kind, measured anew "
        f"(n = {search.held_out.count}; bars: standard errors); stars: the best.*",
        machine_table(search, found),
        "\n".join(f"- {line}." for line in gain(found)),
        *film(search, found, pictures),
    ])
