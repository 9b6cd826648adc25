import pathlib
import tempfile
import unittest

import yaml

from ratchet_sieve.optimise.search_file import BadSearch, read_search

GOOD = {"title": "t", "scene": "scene.yaml", "set": {}, "search": {"base.teeth": {"from": 5, "to": 30},
                                                                   "base.frequency": {"from": 10.0, "to": 40.0}},
        "machines": {"short": {"vary": ["base.teeth"], "trials": 4},
                     "any": {"vary": ["base.teeth", "base.frequency"], "trials": 8, "start": {"base.frequency": 23.0}}},
        "least_processed": 0.8, "throughput": 10.0, "seeds": {"first": 1, "count": 2},
        "held_out": {"first": 3, "count": 2}}


class SearchFile(unittest.TestCase):
    def read(self, **changes):
        with tempfile.TemporaryDirectory() as directory:
            path = pathlib.Path(directory) / "search.yaml"
            path.write_text(yaml.safe_dump({**GOOD, **changes}, sort_keys=False), encoding="utf-8")
            (path.parent / "scene.yaml").touch()
            return read_search(path)

    def refused(self, why, **changes):
        with self.assertRaisesRegex(BadSearch, why):
            self.read(**changes)

    def test_is_read(self):
        search = self.read()
        self.assertTrue(search.ranges["base.teeth"].is_whole)
        self.assertFalse(search.ranges["base.frequency"].is_whole)
        self.assertEqual([kind.name for kind in search.kinds], ["short", "any"])
        self.assertEqual((search.goal, search.label), ("quality", "Q"))
        search = self.read(goal="purity.left.mass.A")
        self.assertEqual((search.goal, search.label), ("purity.left.mass.A", "purity.left.mass.A"))

    def test_bad_ones_are_refused_by_key(self):
        self.refused("search.base.teeth: .*LOW below HIGH", search={"base.teeth": {"from": 5, "to": 5}})
        self.refused("machines.short: base.theeth has no range in search; there are base.teeth",
                     machines={"short": {"vary": ["base.theeth"], "trials": 4}})
        self.refused("machines.any.start: has no base.frequency",
                     machines={"short": {"vary": ["base.teeth"], "trials": 4},
                               "any": {"vary": ["base.frequency"], "trials": 4}})
        self.refused("machines.short.trials: 0", machines={"short": {"vary": ["base.teeth"], "trials": 0}})
        self.refused("held_out: 2: must not overlap seeds", held_out={"first": 2, "count": 5})
        self.refused("look at typo", typo=1)
        self.refused("scene: none.yaml: must be a scene's file", scene="none.yaml")
        self.refused("search: .*: must be a map", search=[])
        self.refused("machines: None: must be a map", machines=None)
        self.refused("least_processed: 1.5: must be a number from 0 to 1", least_processed=1.5)
        self.refused("goal: 3: must be the name of a number of the results", goal=3)
        self.refused("throughput: much: must be a number", throughput="much")

    def test_searches_of_the_package_are_good(self):
        directory = pathlib.Path(__file__).resolve().parent.parent.parent / "config/searches"
        paths = sorted(directory.glob("*.yaml"))
        self.assertGreater(len(paths), 3)
        for path in paths:
            self.assertTrue(pathlib.Path(read_search(path).scene).is_file())


if __name__ == "__main__":
    unittest.main()
