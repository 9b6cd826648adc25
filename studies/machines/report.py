"""A search as lines of a table, a picture, a scene of the best machine, a section of a document, and quotable figures.

A line of the table is a machine. Its part is `tried` (by the search's seeds, all allowed machines), `front` (by fresh
seeds) or `best` (the chosen machine, by fresh seeds)."""
import dataclasses

import yaml

from ratchet_sieve import plots
from ratchet_sieve.stats import Mean
from ratchet_sieve.tables import read_csv, write_csv
from ratchet_sieve.texts import counted, table
from machines.search import BadSearch, Found, Measured, front

HEADER = ("# {title}: the best machine that\n"
          "# scripts/optimise {search} found; docs/machines.md has its results. Every key is explained in paper_fig8.yaml."
          "\n")
FIXED = ["search", "kind", "part",
         *(f"{name}{ending}" for name in ("quality", "throughput", "processed") for ending in ("", "_error")), "seeds",
         "measured", "machine", "version"]


def columns_of(search):
    """The columns of Measured."""
    return (search.goal, "throughput", "processed")


def lines(search, found, origin):
    """@param origin the last three of FIXED"""
    for one in found:
        for part, pairs in (("tried", one.tried), ("front", one.front), ("best", [one.best] if one.best else [])):
            for machine, measured in pairs:
                line = {"search": search.path.stem, "kind": one.kind.name, "part": part, **origin, **machine}
                for column, (value, error, count, _) in zip(columns_of(search), dataclasses.astuple(measured)):
                    line.update({column: f"{value:.6g}", f"{column}_error": "" if error is None else f"{error:.6g}",
                                 "seeds": count})
                yield line


def write_table(path, all_lines):
    write_csv(path, FIXED + sorted({key for line in all_lines for key in line} - set(FIXED)), all_lines)


def pair(line, search):
    """A machine and its Measured."""
    machine = {key: (int if isinstance(low, int) and isinstance(high, int) else float)(line[key])
               for key, (low, high) in search.ranges.items() if line.get(key)}
    return machine, Measured(*(Mean(float(line[name]), float(error) if (error := line[f"{name}_error"]) else None,
                                    int(line["seeds"])) for name in columns_of(search)))


def read_table(path, search):
    """@return a Found for each kind, and the last line"""
    own = [line for line in read_csv(path).to_dict("records")
           if line["search"] == search.path.stem and line.get(search.goal)]
    if not own:
        raise BadSearch(f"{path}: has no line of {search.path.stem} with {search.goal}")
    found = []
    for kind in search.kinds:
        tried, again, best = ([pair(line, search) for line in own if (line["kind"], line["part"]) == (kind.name, part)]
                              for part in ("tried", "front", "best"))
        found.append(Found(kind, tried, again, best[0] if best else None))
    return found, own[-1]


def draw_kind(axes, one, colour):
    """The machines that were tried, those that were measured anew, and the front of the latter."""
    axes.plot([m.throughput.value for _, m in one.tried], [m.goal.value for _, m in one.tried], ".",
              color=colour, alpha=0.25, markersize=3)
    for _, m in one.front:
        axes.errorbar(m.throughput.value, m.goal.value, xerr=m.throughput.error or 0.0, yerr=m.goal.error or 0.0,
                      color=colour, marker="o", markersize=4, markerfacecolor="white", elinewidth=0.9, capsize=2)
    best = front(one.front)
    axes.plot([m.throughput.value for _, m in best], [m.goal.value for _, m in best], "o-", color=colour,
              markersize=4, linewidth=1.2, zorder=3, label=one.kind.name)
    if one.best:
        axes.plot(one.best[1].throughput.value, one.best[1].goal.value, "*", color=colour, markersize=13,
                  markeredgecolor="white", zorder=4)


def draw(search, found):
    """The goal over throughput, with the limits that the best machine is chosen by."""
    figure, all_axes = plots.panels(1, 1, (6.8, 5.0), squeeze=False)
    axes = all_axes[0][0]
    for one, colour in zip(found, plots.COLOURS):
        draw_kind(axes, one, colour)
    axes.axvline(search.throughput, color=plots.GREY, linewidth=0.8, linestyle=":")
    axes.annotate(f"least throughput of the best: {search.throughput:g}", (search.throughput, 0.99), xytext=(4, 0),
                  textcoords="offset points", xycoords=("data", "axes fraction"), va="top", fontsize=7,
                  color=plots.GREY)
    axes.set_xlabel(f"throughput [disks / (s m)], of machines with $P$ ≥ {search.least_processed:g}")
    axes.set_ylabel("quality $Q$" if search.label == "Q" else search.label)
    values = [m.goal.value for one in found for _, m in (*one.tried, *one.front)] or [1.0]
    axes.set_ylim(1.12 * min(0.0, *values), 1.12 * max(0.0, *values))
    axes.set_xlim(left=0.0)
    axes.set_title(search.title, fontsize=10)
    held_out = search.held_out.count
    for marker, face, text in (("o", plots.GREY, f"measured anew (n = {held_out}): on the front"),
                               ("o", "white", f"measured anew (n = {held_out}): beaten by another"),
                               (".", plots.GREY, f"tried (n = {search.seeds.count})"),
                               ("*", plots.GREY, "chosen as the best by the search's seeds")):
        axes.plot([], [], marker, color=plots.GREY, markerfacecolor=face, label=text)
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.14), ncol=2)
    return figure


def save(search, found, path):
    """@return path"""
    with plots.styled():
        return plots.save(draw(search, found), path, svg=False)[0]


def scene_of(search, machine):
    """The machine as a scene of its own."""
    return (HEADER.format(title=search.title, search=search.path.name)
            + yaml.safe_dump(search.scene_of(machine), sort_keys=False, default_flow_style=None))


def shown(value):
    return f"{value:.4g}".replace("-", "−") if isinstance(value, float) else str(value)


def machine_table(search, found):
    """A column for each kind."""
    chosen = [one.best for one in found]
    lines = [[title, *(getattr(best[1], name).text() if best else "—" for best in chosen)]
             for title, name in ((search.label, "goal"), ("disks / (s m)", "throughput"), ("P", "processed"))]
    lines += [[f"`{key}`", *(shown(best[0][key]) if best and key in best[0] else "" for best in chosen)]
              for key in search.ranges]
    return table(["", *(one.kind.name for one in found)], lines)


def gain(found):
    """Of each kind against the first. @return triples (Found, difference of the goal, ratio of the throughputs)"""
    first, *others = found
    return [(other, other.best[1].goal.minus(first.best[1].goal),
             other.best[1].throughput.value / first.best[1].throughput.value)
            for other in others if first.best and other.best]


def gain_lines(search, found):
    for other, difference, times in gain(found):
        yield (f"- With {other.kind.name} {search.label} is higher by {difference.text()} than with "
               f"{found[0].kind.name}, at {times:.2g} times the throughput.")


def summary(results):
    """The best machine of each search and kind. @param results pairs (search, found)"""
    kinds = list(dict.fromkeys(one.kind.name for _, found in results for one in found))
    lines = []
    for search, found in results:
        cells = {one.kind.name: f"{one.best[1].goal.text()}<br>at {one.best[1].throughput.text()}" for one in found
                 if one.best}
        gains = [difference.text() for other, difference, _ in gain(found) if other is found[-1]]
        lines.append([search.title, *(cells.get(kind, "—") for kind in kinds), *(gains or ["—"])])
    goals = " or ".join(dict.fromkeys(search.label for search, _ in results))
    return table([f"{goals}, at disks / (s m)", *kinds, "gain of the last over the first"], lines)


def section(search, found, picture):
    """@param picture the name of its file"""
    tried = "; ".join(f"{one.kind.name}: {counted(one.kind.trials, 'machine')} tried, {len(one.tried)} allowed"
                      for one in found)
    return "\n\n".join([
        f"## {search.title}",
        machine_table(search, found),
        "\n".join(gain_lines(search, found)),
        f"![{search.label} over throughput: {search.title}](images/{picture})",
        f"Search: [{search.path.name}](../config/searches/{search.path.name}). Machines: {tried}. Seeds of the search: "
        f"{search.seeds.text()}; of all results: {search.held_out.text()}. The best have the highest "
        f"{search.label} in the search, with P ≥ {search.least_processed:g} and at least {search.throughput:g} disks / (s m).",
    ])
