#!/usr/bin/python3
"""Measures the engine of the live page, in Node, against the native one on one core. Prints a Markdown table."""
import json
import pathlib
import statistics
import subprocess
import tempfile
import time

import ratchet_sieve as rs
from ratchet_sieve import origin
from ratchet_sieve.texts import table
from report import ROOT, arguments_of, publish

# Title, file of config/, overrides, simulated time [s].
SCENES = (("Fig. 8, 524 disks", "paper_fig8", {}, 10.0),
          ("Fig. 9 on 40 teeth, 266 disks", "demo", {}, 10.0),
          ("a layer of 2,014 disks", "paper_fig8", {"base.teeth": 77}, 3.0),
          ("4000 single disks", "paper_fig3", {}, 10.0))


def natively(scene, duration):
    """@return events and processor time of the simulation"""
    simulation = rs.Simulation(scene)
    before = time.process_time()
    simulation.advance_to(duration)
    return simulation.events, time.process_time() - before


def in_node(page, name, duration):
    finished = subprocess.run(["node", ROOT / "benchmark/web_engine.mjs", page, name, str(duration)],
                              check=True, stdout=subprocess.PIPE)
    answer = json.loads(finished.stdout)
    return answer["events"], answer["seconds"]


def measure(rounds):
    """@return of each scene the times of the native engine and of that in Node, in turns"""
    times = []
    with tempfile.TemporaryDirectory() as folder:
        page = pathlib.Path(folder) / "live.html"
        for _, name, overrides, duration in SCENES:
            scene = rs.Scene.load(ROOT / f"config/{name}.yaml", overrides)
            rs.live(scene).write(page)
            pairs = []
            for _ in range(rounds):
                (events, native), (events_of_page, of_page) = natively(scene, duration), in_node(page, name, duration)
                assert events == events_of_page
                pairs.append((native, of_page))
            times.append((duration, pairs))
    return times


def main():
    arguments = arguments_of(__doc__, "web", rounds=7)
    about = origin.describe_physics()
    lines = []
    for (title, *_), (duration, pairs) in zip(SCENES, measure(arguments.rounds)):
        ratios = sorted(native / of_page for native, of_page in pairs)
        reached = duration / statistics.median(of_page for _, of_page in pairs)
        lines.append([title, f"{statistics.median(ratios):.2f} ({ratios[0]:.2f} to {ratios[-1]:.2f})",
                      f"{reached:.1f}"])
    publish(arguments, "web", [
        f"{origin.text(about)}; medians of {arguments.rounds} rounds in turns, all of them in brackets.", "",
        table(["scene", "speed over native", "simulated over processor time"], lines)])


if __name__ == "__main__":
    main()
