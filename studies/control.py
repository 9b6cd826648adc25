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
# 2.5 times the integral action of hold.py: as it may be found on exact sensors without delay.
TUNINGS = {"as hold.py": {}, "quick": {"gain": 0.5, "integral_time": 3.0}}
STEP, EPISODE = 0.5, 160.0  # s
LATE = 100.0  # s: from then on it is settled
BAND = 0.2    # of the inclination at which it settles
# Of each plant its sensors, without their delay, and the dead time of the drive [s].
PLANTS = {
    "exact": ({}, {}, 0.0),
    "as in hold.launch":
        ({"dead_time": 0.002, "miss": 0.05, "confusion": 0.02},
         {"noise": 0.01, "resolution": 0.005, "time_constant": 0.3, "drop_height": 0.1}, 2.0)}
DELAYS = (0.0, 1.0, 2.0, 3.5, 5.0)  # s


def controlled(tuning, plant, delay, count):
    """@return the inclination that is asked for, (steps, sieves)"""
    counter, scale, dead_time = PLANTS[plant]
    common = {"rate": 1.0 / STEP, "delay": delay}
    sieves = rs.env.SieveVectorEnv(
        FEEDER / "config/feeder.yaml", count, step=STEP, episode=EPISODE, observations=("sensors",),
        limits={"inclination": (0.0, 0.5)}, sensors={"count": {**counter, **common}, "scale": {**scale, **common}})
    holders = [Holder(PURITY, MASSES, **TUNINGS[tuning]) for _ in range(count)]
    place = {name: k for k, name in enumerate(sieves.observation_names)}
    read, _ = sieves.reset(seed=1)
    asked, under_way = [], deque([numpy.zeros(count)] * round(dead_time / STEP))
    for k in range(round(EPISODE / STEP)):
        for holder, of_one in zip(holders, read):
            holder.take("scale", k * STEP, of_one[place["right/scale"]])
            holder.take("count", k * STEP, [of_one[place["right/count.A"]], of_one[place["right/count.B"]]])
            assert not holder.fault, holder.fault
        asked.append([holder.inclination for holder in holders])
        under_way.append(numpy.array(asked[-1]))
        read, *_ = sieves.step(under_way.popleft()[:, numpy.newaxis])
    return numpy.array(asked)


def overshoot_and_settling(asked):
    """Of the mean over sieves, relative to the inclination at which it settles; and [s]."""
    times, mean = numpy.arange(len(asked)) * STEP, asked.mean(axis=1)
    end = mean[times >= LATE].mean()
    outside = times[abs(mean - end) > BAND * end]
    return max(0.0, mean[times < LATE].max() / end - 1.0), outside.max(initial=0.0) + STEP


def measured(count, tunings=TUNINGS):
    """A row for each tuning, plant and delay; errors by a bootstrap over the sieves."""
    for tuning, plant, delay in itertools.product(tunings, PLANTS, DELAYS):
        generator = numpy.random.default_rng(1)
        asked = controlled(tuning, plant, delay, count)
        values = overshoot_and_settling(asked)
        drawn = [overshoot_and_settling(asked[:, generator.integers(count, size=count)]) for _ in range(200)]
        row = [tuning, plant, delay, *values, *numpy.std(drawn, axis=0), count]
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
        for place, label in zip(axes.flat, ("overshoot [%]", "time to settle within 20 % [s]")):
            place.set_xlabel("delay of the sensors [s]")
            place.set_ylabel(label)
            place.set_ylim(bottom=0.0)
        figure.legend(*axes.flat[0].get_legend_handles_labels(), loc="upper center", ncol=2, bbox_to_anchor=(0.5, 0.0))
        return figure


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--sieves", type=int, default=12, help="of each point (default: 12)")
    parser.add_argument("--out", type=pathlib.Path, default=WORK / "docs", metavar="DIR",
                        help="directory with your_package.md (default: docs)")
    options = parser.parse_args()
    page = options.out / "your_package.md"
    documents.require_place(parser, page, MARK)
    warnings.simplefilter("ignore", rs.SieveWarning)
    table = pandas.DataFrame(measured(options.sieves), columns=["tuning", "plant", "delay", "overshoot",
                                                                "settling", "overshoot_error", "settling_error",
                                                                "sieves"])
    table.to_csv(options.out / "data/control.csv", index=False, float_format="%.4g")
    plots.save(draw(table), options.out / "images/control.png", svg=False, bbox_inches="tight")
    about = wrapped(f"[control.csv](data/control.csv): means of {options.sieves} seeds, errors by a bootstrap. "
                    f"{origin.text()}.")
    documents.put(page, MARK, f"![Overshoot and time to settle over the delay](images/control.png)\n\n{about}")


if __name__ == "__main__":
    main()
