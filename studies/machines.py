#!/usr/bin/python3
"""Searches for the machines that part the paper's mixture, and three of kinds that differ in one number alone, best at
much throughput. Writes the table of separate.md, data/machines.csv, a picture, and the best machines as scenes."""
import argparse
import pathlib
import warnings

import pandas

import ratchet_sieve as rs
from ratchet_sieve import documents, origin, plots, stats
from ratchet_sieve.answers.machine import Machine, flow_of
from ratchet_sieve.places import WORK
from ratchet_sieve.plots.answer import draw_front
from ratchet_sieve.texts import counted, plus_minus, table, wrapped

MARK = "machines"
# Of each mixture its name, what differs from Fig. 9, and the throughput that its best machine has at least [disks/s].
ONE_SIZE = {"species.0.radius": 0.001, "species.1.radius": 0.001}
ONE_MASS = {"species.0.mass": 0.001, "species.1.mass": 0.001}
MIXTURES = {
    "fig9": ("A (1 mm, 10 g) and B (5 mm, 1 g), the mixture of Fig. 9", {}, 20.0),
    "friction": ("A (μ = 0.5) and B (μ = 0.02), else the same: 1 mm, 1 g",
                 {**ONE_SIZE, **ONE_MASS, "species.0.friction": 0.5, "species.1.friction": 0.02}, 20.0),
    "mass": ("A (10 g) and B (1 g), else the same: 1 mm", {**ONE_SIZE, "species.0.mass": 0.01, "species.1.mass": 0.001},
             20.0),
    "restitution": ("A (e = 0.9) and B (e = 0.4), else the same: 1 mm, 1 g",
                    {**ONE_SIZE, **ONE_MASS, "species.0.restitution": 0.9, "species.1.restitution": 0.4}, 20.0),
}
PAPER = {"base.inclination": (-0.1, 0.35), "base.teeth": (10, 40), "feed.rate": (10.0, 50.0)}
ANY = {**PAPER, "base.asymmetry": (0.0, 0.5), "base.tooth_height": (0.002, 0.018), "base.frequency": (8.0, 40.0),
       "base.amplitude": (0.0005, 0.006), "base.horizontal_amplitude": (0.0, 0.003),
       "base.horizontal_phase": (-3.14, 3.14)}
KINDS = {"the paper's teeth and drive": (PAPER, 48), "any teeth, driven obliquely as well": (ANY, 120)}
VERTICAL = {"base.horizontal_amplitude": 0.0, "base.horizontal_phase": 0.0}  # of the paper's drive
SEEN = {  # first lines of the scenes: a title, and what one sees
    "fig9": "Two species climb apart: small heavy disks walk up the sawtooth to the right, large light ones come down to "
            "the left.",
    "friction": "Only the friction differs: smooth and rough disks of one size and mass part.",
    "mass": "Only the mass differs: disks of one size, 10 g and 1 g, and the machine still tells them apart.",
    "restitution": "Only the bounce differs: dull and bouncy disks of one size and mass part.",
}
LONG, FRESH = 200.0, (900_000_000, 8)  # of each run that measures a machine anew [s]; their first seed, their number
HEADER = """# {seen}
#
# {title}:
# the best machine that studies/machines.py found, at {throughput:g} disks/s at least; docs/separate.md has its results.
# Every key is explained in paper_fig8.yaml.
"""


def scene_of(name):
    return rs.Scene.load(WORK / "config/paper_fig9.yaml", {"feed.rate": 20.0, "density": 0.0, **MIXTURES[name][1]})


def search(name, results, out):
    """@return a Front for each kind; the freer one begins with the best machines of the other"""
    title, _, throughput = MIXTURES[name]
    scene, fronts, start = scene_of(name), {}, []
    for kind, (over, trials) in KINDS.items():
        fronts[kind] = rs.front(scene, over, trials=trials, start=start, results=results)
        start = [{**VERTICAL, **row} for row in fronts[kind].table[list(over)].to_dict("records")]
        print(name, kind, fronts[kind], flush=True)
    text = HEADER.format(seen=SEEN[name], title=title, throughput=throughput) + fronts[kind].scene(throughput).yaml
    (out / f"machine_{name}.yaml").write_text(text, encoding="utf-8")
    return fronts


def known(name, data):
    """@return what search() returned, from the file that main() wrote then"""
    rows = data[data.mixture == name]
    return {kind: rs.Front(Machine(scene_of(name), over),
                           *(rows[(rows.machines == kind) & (rows.part == part)] for part in ("front", "tried")))
            for kind, (over, _) in KINDS.items()}


def measured(scene):
    """The separation and the throughput of a machine once it has filled, by long runs with fresh seeds."""
    rows = rs.sweep(scene.replace({"duration": LONG, "feed.on_choke": "stop"}), seeds=FRESH, progress=False)
    steady = rows["steady.separation.value"].notna()
    means = [stats.mean_of(of[steady]) for of in (rows["steady.separation.value"], flow_of(rows))]
    return "<br>at ".join(plus_minus(abs(mean.value), mean.half_width()) for mean in means) + \
        ("" if steady.all() else f"<br>in {steady.sum()} of {counted(len(rows), 'run')}")


def bests_of(found):
    """The table: of each mixture the best of each kind of machine."""
    return table(["separation, at disks/s", *KINDS],
                 [[MIXTURES[name][0], *(measured(front.scene(MIXTURES[name][2])) for front in fronts.values())]
                  for name, fronts in found.items()])


def draw(found):
    """Of each mixture the fronts."""
    with plots.styled():
        figure, axes = plots.panels(2, 2, (9.6, 7.6))
        for (name, fronts), place in zip(found.items(), axes.flat):
            for k, (kind, front) in enumerate(fronts.items()):
                draw_front(front, place, color=plots.COLOURS[k], name=kind)
            place.set_title(MIXTURES[name][0], fontsize=9)
            place.get_legend().remove()
        figure.legend(*axes.flat[0].get_legend_handles_labels(), loc="upper center", ncol=2,
                      bbox_to_anchor=(0.5, 0.0))
        return figure


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--results", type=pathlib.Path, default=WORK / "out/machines.db", metavar="FILE",
                        help="where the runs are kept: the same command continues (default: out/machines.db)")
    parser.add_argument("--out", type=pathlib.Path, default=WORK / "docs", metavar="DIR",
                        help="directory with separate.md (default: docs); scenes go to its neighbour config")
    parser.add_argument("--again", action="store_true",
                        help="measure the machines anew that were found before, for the table: minutes")
    options = parser.parse_args()
    page = options.out / "separate.md"
    documents.require_place(parser, page, MARK)
    warnings.simplefilter("ignore", rs.SieveWarning)
    data = options.out / "data/machines.csv"
    if options.again:
        found = {name: known(name, pandas.read_csv(data)) for name in MIXTURES}
    else:
        options.results.parent.mkdir(parents=True, exist_ok=True)
        found = {name: search(name, options.results, options.out.parent / "config") for name in MIXTURES}
        pandas.concat([rows.assign(mixture=name, machines=kind, part=part) for name, fronts in found.items()
                       for kind, front in fronts.items()
                       for part, rows in (("tried", front.tried), ("front", front.table))]).to_csv(
            data, index=False, float_format="%.6g")
        plots.save(draw(found), options.out / "images/machines.png", svg=False, bbox_inches="tight")
    about = wrapped(f"{origin.text()}.")
    documents.put(page, MARK, f"{bests_of(found)}\n\n{about}")


if __name__ == "__main__":
    main()
