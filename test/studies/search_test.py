import pathlib
import tempfile
import unittest

import yaml

from ratchet_sieve.stats import Mean
from ratchet_sieve.tables import Rows
from machines.search import (MOST_ON_FRONT, BadSearch, Measured, Seeds, best_at, changed, front, measured, read_search,
                             read_yaml, require_goal, thinned)


GOOD = {"title": "t", "scene": "scene.yaml", "set": {}, "search": {"base.teeth": {"from": 5, "to": 30},
                                                                   "base.frequency": {"from": 10.0, "to": 40.0}},
        "machines": {"short": {"vary": ["base.teeth"], "trials": 4},
                     "any": {"vary": ["base.teeth", "base.frequency"], "trials": 8, "start": {"base.frequency": 23.0}}},
        "least_processed": 0.8, "throughput": 10.0, "seeds": {"first": 1, "count": 2},
        "held_out": {"first": 3, "count": 2}}


def point(quality, throughput):
    return {"base.teeth": 10}, Measured(Mean(quality, 0.01, 2), Mean(throughput, 1.0, 2), Mean(0.9, 0.01, 2))


class Front(unittest.TestCase):
    def test_has_what_nothing_beats_in_both(self):
        points = [point(0.5, 100.0), point(0.9, 10.0), point(0.4, 90.0), point(0.8, 20.0), point(0.5, 50.0)]
        self.assertEqual([(m.goal.value, m.throughput.value) for _, m in front(points)],
                         [(0.9, 10.0), (0.8, 20.0), (0.5, 100.0)])

    def test_keeps_two_that_are_alike(self):
        self.assertEqual(len(front([point(0.5, 10.0), point(0.5, 10.0)])), 2)

    def test_is_thinned_to_its_ends_and_some_between(self):
        points = [point(1.0 - 0.01 * k, float(k)) for k in range(50)]
        some = thinned(points)
        self.assertEqual(len(some), MOST_ON_FRONT)
        self.assertEqual((some[0], some[-1]), (points[0], points[-1]))
        self.assertEqual(thinned(points[:3]), points[:3])

    def test_the_best_has_enough_throughput(self):
        points = [point(0.9, 10.0), point(0.7, 40.0), point(0.8, 30.0)]
        self.assertEqual(best_at(points, 30.0), points[2])
        self.assertIsNone(best_at(points, 50.0))


class Throughput(unittest.TestCase):
    def test_is_over_time_and_length(self):
        rows = Rows([{"quality": 0.1, "processed": 0.5, "left.A": 20.0, "right.A": 10.0, "left.B": 5.0, "right.B": 15.0,
                      "simulated_time": 20.0}])
        sawtooth = {"base": {"teeth": 40, "tooth_width": 0.02}}
        profile = {"base": {"teeth": 40, "profile": [[0, 0], [0.01, 0.01], [0.03, 0]]}}
        for scene, values, length in ((sawtooth, {}, 0.8), (sawtooth, {"base.teeth": 10}, 0.2), (profile, {}, 1.2),
                                      (profile, {"base.profile.2.0": 0.05}, 2.0)):
            found = measured(rows, changed(scene, values)["base"], Seeds(1, 1), "quality")
            self.assertAlmostEqual(found.throughput.value, 50.0 / (20.0 * length))


class Goal(unittest.TestCase):
    rows = Rows([{"quality": quality, "processed": 0.5, "purity.left.mass.A": purity, "left.A": 50.0,
                  "simulated_time": 10.0, "warning_text": "w"} for quality, purity in ((0.2, 0.9), (None, 0.8))])
    base = {"teeth": 10, "tooth_width": 0.1}

    def of(self, goal):
        return measured(self.rows, self.base, Seeds(1, 2), goal)

    def test_is_any_number_of_the_results(self):
        self.assertAlmostEqual(self.of("purity.left.mass.A").goal.value, 0.85)
        self.assertAlmostEqual(self.of("purity.left.mass.A").throughput.value, 5.0)
        self.assertIsNone(self.of("quality"))

    def test_of_another_name_is_refused(self):
        require_goal("quality", self.rows, "s.yaml")
        with self.assertRaisesRegex(BadSearch, "^s.yaml: goal: purity.left.A: must be a number of the results of "
                                               "sieve_sweep, did you mean purity.left.mass.A\\?$"):
            require_goal("purity.left.A", self.rows, "s.yaml")
        for name in ("warning_text", "nonsense"):
            with self.assertRaisesRegex(BadSearch, f"goal: {name}: .*such as quality or purity.left.mass.A$"):
                require_goal(name, self.rows, "s.yaml")


class Changed(unittest.TestCase):
    def test_follows_maps_lists_and_what_is_not_there(self):
        scene = {"base": {"teeth": 3}, "species": [{"mass": 1.0}]}
        self.assertEqual(changed(scene, {"base.teeth": 5, "species.0.mass": 2.0, "feed.rate": 7.0}),
                         {"base": {"teeth": 5}, "species": [{"mass": 2.0}], "feed": {"rate": 7.0}})

    def test_a_profile_replaces_the_sawtooth(self):
        scene = {"base": {"teeth": 3, "tooth_width": 0.02, "tooth_height": 0.006, "asymmetry": 0.3}}
        self.assertEqual(changed(scene, {"base.profile": [[0, 0], [0.02, 0]]}),
                         {"base": {"teeth": 3, "profile": [[0, 0], [0.02, 0]]}})


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
        self.assertEqual(search.ranges, {"base.teeth": (5, 30), "base.frequency": (10.0, 40.0)})
        self.assertEqual([kind.name for kind in search.kinds], ["short", "any"])
        self.assertEqual((search.goal, search.label), ("quality", "Q"))
        search = self.read(goal="purity.left.mass.A")
        self.assertEqual((search.goal, search.label), ("purity.left.mass.A", "purity.left.mass.A"))

    def test_bad_ones_are_refused_by_key(self):
        self.refused("search: .*LOW below HIGH", search={"base.teeth": {"from": 5, "to": 5}})
        self.refused("machines.short: base.theeth has no range in search; there are base.teeth",
                     machines={"short": {"vary": ["base.theeth"], "trials": 4}})
        self.refused("machines.any.start: has no base.frequency",
                     machines={"short": {"vary": ["base.teeth"], "trials": 4},
                               "any": {"vary": ["base.frequency"], "trials": 4}})
        self.refused("machines: .*a whole number above 0", machines={"short": {"vary": ["base.teeth"], "trials": 0}})
        self.refused("held_out: 2: must not overlap seeds", held_out={"first": 2, "count": 5})
        self.refused("look at typo", typo=1)
        self.refused("goal: 3: must be the name of a number of the results", goal=3)

    def test_a_file_that_is_cut_off_is_named(self):
        with tempfile.TemporaryDirectory() as directory:
            path = pathlib.Path(directory) / "scene.yaml"
            path.write_text("base: {teeth: [", encoding="utf-8")
            with self.assertRaisesRegex(BadSearch, f"^{path}: [^\\n]*$"):
                read_yaml(path)

    def test_searches_of_the_package_are_good(self):
        directory = pathlib.Path(__file__).resolve().parent.parent.parent / "config/searches"
        paths = sorted(directory.glob("*.yaml"))
        self.assertGreater(len(paths), 3)
        for path in paths:
            self.assertTrue(pathlib.Path(read_search(path).scene).is_file())


if __name__ == "__main__":
    unittest.main()
