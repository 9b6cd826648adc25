#!/usr/bin/python3
"""Holds a purity by the PI controller of examples/my_feeder, tuned in two ways, over the delay of its sensors, with
exact sensors and drives and with those of a real machine. Writes data/control.csv, a picture and the conditions into
your_package.md."""
import argparse
import itertools
import pathlib
import sys
import warnings
from collections import deque

import numpy
import pandas

import ratchet_sieve as rs
from ratchet_sieve import documents, origin, plots
from ratchet_sieve.places import WORK
from ratchet_sieve.texts import wrapped

FEEDER = WORK / "examples/my_feeder"
sys.path.insert(0, str(FEEDER / "src"))
from my_feeder.holder import Holder  # noqa: E402

MARK = "control"
PURITY, MASSES = 0.62, (0.010, 0.001)
# By the rules that hold.py goes by, for the shortest window that its sensors leave: on exact ones without delay the
# purity follows within 1 s, 2 s after the inclination, by 0.7 per radian.
TUNINGS = {"as hold.py": {}, "quick": {"gain": 0.3, "integral_time": 1.0, "window": 2.0}}
SLICES = 20  # sieves side by side on one drive, whose sensors are summed: a sieve's own few disks are mostly noise
STEP, EPISODE = 0.5, 80.0  # s
LATE = 50.0  # s: from then on its mean is where it settles
BAND = 0.3   # of this mean
# Of each plant its sensors, without their delay, and the dead time of the drive [s].
PLANTS = {
    "exact": ({}, {}, 0.0),
    "as in hold.launch":
        ({"dead_time": 0.002, "miss": 0.05, "confusion": 0.02},
         {"noise": 0.01, "resolution": 0.005, "time_constant": 0.3, "drop_height": 0.1}, 2.0)}
DELAYS = (0.0, 1.0, 2.0, 3.5, 5.0)  # s


def controlled(tuning, plant, delay, count):
    """@return the inclination that is asked for, (steps, machines)"""
    counter, scale, dead_time = PLANTS[plant]
    common = {"rate": 1.0 / STEP, "delay": delay}
    sieves = rs.env.SieveVectorEnv(
        FEEDER / "config/feeder.yaml", count * SLICES, step=STEP, episode=EPISODE, observations=("sensors",),
        limits={"inclination": (0.0, 0.5)}, sensors={"count": {**counter, **common}, "scale": {**scale, **common}})
    holders = [Holder(PURITY, MASSES, **TUNINGS[tuning]) for _ in range(count)]
    place = {name: k for k, name in enumerate(sieves.observation_names)}
    read, _ = sieves.reset(seed=1)
    asked, under_way = [], deque([numpy.zeros(count)] * round(dead_time / STEP))
    for k in range(round(EPISODE / STEP)):
        for holder, of_one in zip(holders, read.reshape(count, SLICES, -1).sum(axis=1)):
            holder.take("scale", k * STEP, of_one[place["right/scale"]])
            holder.take("count", k * STEP, [of_one[place["right/count.A"]], of_one[place["right/count.B"]]])
            assert not holder.fault, holder.fault
        asked.append([holder.inclination for holder in holders])
        under_way.append(numpy.array(asked[-1]))
        read, *_ = sieves.step(numpy.repeat(under_way.popleft(), SLICES)[:, numpy.newaxis])
    return numpy.array(asked)


def overshoot_and_settling(asked):
    """Of one machine: relative to where it settles; and [s], EPISODE where it does not."""
    times = numpy.arange(len(asked)) * STEP
    end = asked[times >= LATE].mean()
    return asked.max() / end - 1.0, times[abs(asked - end) > BAND * end].max() + STEP


def measured(count):
    """A row for each tuning, plant and delay: means over machines and their standard errors."""
    for tuning, plant, delay in itertools.product(TUNINGS, PLANTS, DELAYS):
        found = numpy.array([overshoot_and_settling(of_one) for of_one in controlled(tuning, plant, delay, count).T])
        row = [tuning, plant, delay, *found.mean(axis=0), *found.std(axis=0, ddof=1) / count ** 0.5, count]
        print(*row, flush=True)
        yield row


def draw(table):
    with plots.styled():
        figure, axes = plots.panels(1, 2, (8.6, 3.4))
        for (tuning, plant), rows in table.groupby(["tuning", "plant"], sort=False):
            for place, name, scale in zip(axes.flat, ("overshoot", "settling"), (100.0, 1.0)):
                place.errorbar(rows.delay, scale * rows[name], scale * rows[f"{name}_error"], marker="o", capsize=2,
                               color=plots.COLOURS[[*TUNINGS].index(tuning)], label=f"{tuning}, {plant}",
                               linestyle="-" if plant == "exact" else "--")
        for place, label in zip(axes.flat, ("overshoot [%]", f"time to settle within {100.0 * BAND:g} % [s]")):
            place.set_xlabel("delay of the sensors [s]")
            place.set_ylabel(label)
            place.set_ylim(bottom=0.0)
        figure.legend(*axes.flat[0].get_legend_handles_labels(), loc="upper center", ncol=2, bbox_to_anchor=(0.5, 0.0))
        return figure


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--machines", type=int, default=3, help="of each point (default: 3)")
    parser.add_argument("--out", type=pathlib.Path, default=WORK / "docs", metavar="DIR",
                        help="directory with your_package.md (default: docs)")
    options = parser.parse_args()
    page = options.out / "your_package.md"
    documents.require_place(parser, page, MARK)
    warnings.simplefilter("ignore", rs.SieveWarning)
    table = pandas.DataFrame(measured(options.machines), columns=[
        "tuning", "plant", "delay", "overshoot", "settling", "overshoot_error", "settling_error", "machines"])
    table.to_csv(options.out / "data/control.csv", index=False, float_format="%.4g")
    plots.save(draw(table), options.out / "images/control.png", svg=False, bbox_inches="tight")
    about = wrapped(f"[control.csv](data/control.csv): means of {options.machines} machines of {SLICES} slices "
                    f"each, over {EPISODE:g} s: what takes as long does not settle. {origin.text()}.")
    picture = "![Overshoot and time to settle over the delay; bars: standard errors over the machines](images/control.png)"
    documents.put(page, MARK, f"{picture}\n\n{about}")


if __name__ == "__main__":
    main()
