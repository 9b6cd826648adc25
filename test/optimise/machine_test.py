import pathlib
import tempfile
import unittest

from ratchet_sieve.optimise.machine import Machine, Measured, front, measured, put, read_scene, require_goal
from ratchet_sieve.optimise.outcome import MOST_ON_FRONT, best_at, thinned
from ratchet_sieve.optimise.search_file import BadSearch, Seeds
from ratchet_sieve.tables import Rows
from ratchet_sieve.stats import Mean


def point(quality, throughput):
    return Machine("any", {"base.teeth": 10}), Measured(Mean(quality, 0.01, 2), Mean(0.9, 0.01, 2),
                                                        Mean(throughput, 1.0, 2))


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


class Scene(unittest.TestCase):
    def test_that_is_cut_off_is_named(self):
        with tempfile.TemporaryDirectory() as directory:
            path = pathlib.Path(directory) / "scene.yaml"
            path.write_text("base: {teeth: [", encoding="utf-8")
            with self.assertRaisesRegex(BadSearch, f"^{path}: [^\\n]*$"):
                read_scene(path)


class Throughput(unittest.TestCase):
    def test_is_over_time_and_length(self):
        rows = Rows([{"quality": 0.1, "processed": 0.5, "left.A": 20.0, "right.A": 10.0, "left.B": 5.0, "right.B": 15.0,
                      "simulated_time": 20.0}])
        sawtooth = {"base": {"teeth": 40, "tooth_width": 0.02}}
        profile = {"base": {"teeth": 40, "profile": [[0, 0], [0.01, 0.01], [0.03, 0]]}}
        for scene, values, length in ((sawtooth, {}, 0.8), (sawtooth, {"base.teeth": 10}, 0.2), (profile, {}, 1.2),
                                      (profile, {"base.profile.2.0": 0.05}, 2.0)):
            found = measured(rows, scene, Machine("any", values), Seeds(1, 1), "quality")
            self.assertAlmostEqual(found.throughput.value, 50.0 / (20.0 * length))


class Goal(unittest.TestCase):
    rows = Rows([{"quality": quality, "processed": 0.5, "purity.left.mass.A": purity, "left.A": 50.0,
                  "simulated_time": 10.0, "warning_text": "w"} for quality, purity in ((0.2, 0.9), (None, 0.8))])
    scene = {"base": {"teeth": 10, "tooth_width": 0.1}}

    def of(self, goal):
        return measured(self.rows, self.scene, Machine("any", {}), Seeds(1, 2), goal)

    def test_is_any_number_of_the_results(self):
        self.assertAlmostEqual(self.of("purity.left.mass.A").goal.value, 0.85)
        self.assertAlmostEqual(self.of("purity.left.mass.A").throughput.value, 5.0)
        self.assertFalse(self.of("quality").is_whole())

    def test_of_another_name_is_refused(self):
        require_goal("quality", self.rows, "s.yaml")
        with self.assertRaisesRegex(BadSearch, "^s.yaml: goal: purity.left.A: must be a number of the results of "
                                               "sieve_sweep, did you mean purity.left.mass.A\\?$"):
            require_goal("purity.left.A", self.rows, "s.yaml")
        for name in ("warning_text", "nonsense"):
            with self.assertRaisesRegex(BadSearch, f"goal: {name}: .*such as quality or purity.left.mass.A$"):
                require_goal(name, self.rows, "s.yaml")


class Put(unittest.TestCase):
    def test_follows_maps_lists_and_what_is_not_there(self):
        scene = {"base": {"teeth": 3}, "species": [{"mass": 1.0}]}
        for key, value in {"base.teeth": 5, "species.0.mass": 2.0, "feed.rate": 7.0}.items():
            put(scene, key, value)
        self.assertEqual(scene, {"base": {"teeth": 5}, "species": [{"mass": 2.0}], "feed": {"rate": 7.0}})

    def test_of_a_profile_replaces_the_sawtooth(self):
        scene = {"base": {"teeth": 3, "tooth_width": 0.02, "tooth_height": 0.006, "asymmetry": 0.3}}
        put(scene, "base.profile", [[0, 0], [0.02, 0]])
        self.assertEqual(scene, {"base": {"teeth": 3, "profile": [[0, 0], [0.02, 0]]}})


if __name__ == "__main__":
    unittest.main()
