#!/usr/bin/python3
"""Counts how many disks go over the walls of a base that is tilted to and fro, over its width and the rate of the turn.
Prints a table. Exit status 1 where disks go over at a calm turn, of which the node does not warn."""
import sys

import ratchet_sieve as rs
from ratchet_sieve import origin
from ratchet_sieve.texts import table
from report import ROOT, arguments_of, publish

WIDTHS = (0.2, 1, 8)                 # [m]
RATES = (0.3, 1, 2, 3, 5)            # [rad/s]
RUNS = [(swing, seed) for swing in (0.5, 1.2) for seed in range(1, 5)]  # of each cell; swings in rad
DURATION, LOOK = 10.0, 0.02          # [s]
CALM = 0.15 * 9.81                   # ω² W above which the node warns [m/s²]


def over(width, rate, swing, seed):
    """The number of disks, of 20, that go over the walls of one run."""
    scene = rs.Scene.load(ROOT / "config/paper_fig8.yaml", {
        "boundary": "walled", "base.teeth": round(width / 0.02), "density": None, "seed": seed,
        "species.0.count": 10, "species.1.count": 10})
    simulation, target = rs.Simulation(scene), swing
    simulation.set_slew_rates(inclination=rate)
    simulation.command(inclination=target)
    for k in range(1, round(DURATION / LOOK) + 1):
        simulation.advance_to(k * LOOK)
        if simulation.base.inclination == target:
            target = -target
            simulation.command(inclination=target)
    return sum(bins.left + bins.right for bins in simulation.bins.values())


def main():
    arguments = arguments_of(__doc__, "walls")
    lost = {(width, rate): sum(over(width, rate, *run) for run in RUNS) for width in WIDTHS for rate in RATES}
    warned = {(width, rate) for width, rate in lost if rate ** 2 * width > CALM}
    lines = [[width, *(f"{lost[width, rate]}" + " ⚠" * ((width, rate) in warned) for rate in RATES)]
             for width in WIDTHS]
    publish(arguments, "walls", [f"{origin.text()}.", "", table(["W [m] \\ ω [rad/s]", *RATES], lines)])
    if any(lost[cell] for cell in lost.keys() - warned):
        sys.exit("disks go over the walls at a calm turn")


if __name__ == "__main__":
    main()
