#!/usr/bin/python3
"""The engine of a live page, in Node and in browsers, against the native one: byte for byte, for every scene of config/.

What is run natively is the program that the page gives to be copied.

Usage: live_states_test.py OUT  (PAGE_TEST_MODULES: modules of the browsers' tests)
"""
import base64
import contextlib
import io
import json
import os
import pathlib
import subprocess
import sys
import unittest
import warnings

import numpy as np

import ratchet_sieve as rs
from ratchet_sieve.places import SHARE

HERE = pathlib.Path(__file__).resolve().parent
OUT = pathlib.Path(sys.argv.pop(1))
DISK = ("id", "species", "x", "y", "angle", "vx", "vy", "spin", "displacement", "radius")


def scenes():
    """Every scene of config/ that is one, with `settle` short enough for means."""
    for path in sorted((SHARE / "config").glob("*.yaml")):
        with contextlib.suppress(rs.SceneError):
            yield rs.Scene.load(path, {"settle": 0.5})


class StatesTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        warnings.simplefilter("ignore")
        OUT.mkdir(parents=True, exist_ok=True)
        cls.count = len(chosen := list(scenes()))
        rs.live(*chosen).write(OUT / "live.html")
        cls.native = {}

    def natively(self, program):
        """The state after a program: disks as rows, base, bins."""
        if program not in self.native:
            names = {}
            with contextlib.redirect_stdout(io.StringIO()):
                exec(program, names)  # pylint: disable=exec-used
            simulation = names["simulation"]
            disks = np.stack([simulation.disks[name].astype(float) for name in DISK], axis=1)
            self.native[program] = disks.tobytes(), simulation.base, simulation.bins, simulation.events
        return self.native[program]

    def compare(self, host):
        out = OUT / f"{host}.json"
        subprocess.run(["node", HERE / "live_states.js", OUT / "live.html", out], check=True,
                       env={**os.environ, "PAGE_TEST_BROWSER": host})
        states = json.loads(out.read_text(encoding="utf-8"))
        self.assertEqual(len(states), self.count)
        for state in states:
            with self.subTest(scene=state["name"]):
                disks, base, bins, events = self.natively(state["program"])
                self.assertEqual(base64.b64decode(state["disks"]), disks)
                readings = state["readings"]
                self.assertEqual(readings["events"], events)
                self.assertEqual(readings["base"], base)
                for of_page, of_native in zip(readings["species"], bins.values(), strict=True):
                    self.assertEqual({name: of_page[name] for name in of_native}, of_native)

    def test_node(self):
        self.compare("node")

    def test_chromium(self):
        self.compare("chromium")

    def test_firefox(self):
        self.compare("firefox")


if __name__ == "__main__":
    unittest.main()
