#!/usr/bin/python3
"""studies/precision: errors, bounds and verdicts, and the tables on disk."""
import pathlib
import tempfile
import unittest

from ratchet_sieve.stats import Mean
from precision import points, tables

STUDENT_9 = 2.2621571628  # 95 %, 9 degrees of freedom


def fig8(**means):
    """The points of Fig. 8: each with drift A as given by its setting's name, such as exact=Mean(...)."""
    own = points.planned(["fig8"])
    for point in own:
        if tables.setting(point) in means:
            point.means["drift A"] = means[tables.setting(point)]
    return own


class Errors(unittest.TestCase):
    def test_have_the_errors_of_point_and_reference(self):
        error = tables.relative(Mean(1.1, 0.03, 10), Mean(1.0, 0.04, 10))
        self.assertAlmostEqual(error.value, 0.1)
        self.assertAlmostEqual(error.error, (0.03 ** 2 + (1.1 * 0.04) ** 2) ** 0.5)

    def test_of_a_negative_reference_have_the_sign_of_the_difference(self):
        self.assertAlmostEqual(tables.relative(Mean(-0.9, 0.01, 10), Mean(-1.0, 0.01, 10)).value, 0.1)

    def test_are_none_for_one_seed(self):
        self.assertIsNone(tables.relative(Mean(1.0, None, 1), Mean(1.0, 0.1, 10)))

    def test_a_bound_contains_its_error(self):
        error = tables.relative(Mean(1.003, 0.01, 10), Mean(1.0, 0.0, 2))
        self.assertAlmostEqual(tables.bound(error), 0.003 + STUDENT_9 * 0.01)
        self.assertEqual(tables.bound_text(tables.bound(error)), "2.6")

    def test_bounds_are_rounded_up(self):
        self.assertEqual([tables.bound_text(x) for x in (0.0301, 0.112, 0.00561, 0.0, 0.0999)],
                         ["3.1", "12", "0.57", "0.01", "10"])

    def test_the_models_reference_is_a_run_at_the_least_floor(self):
        own = fig8(exact=Mean(2.0, 0.1, 10), floor_0_001=Mean(1.0, 0.1, 10))
        self.assertEqual(tables.least_floor(own, "drift A"), Mean(1.0, 0.1, 10))
        self.assertIsNone(tables.least_floor(fig8(exact=Mean(2.0, 0.1, 10)), "drift A"))


class Verdicts(unittest.TestCase):
    def test_hold_with_the_error_within_the_bound_alone(self):
        for value, error, expected in ((0.01, 0.01, "holds"), (0.04, 0.01, "not decided"),
                                       (-0.06, 0.01, "not decided"), (-0.08, 0.01, "fails the original bound")):
            self.assertEqual(tables.verdict(Mean(value, error, 10), 0.05), expected)


class Tables(unittest.TestCase):
    def test_are_read_as_they_were_written(self):
        own = fig8(exact=Mean(2.0, 0.1, 10), steps_1ms=Mean(2.1, 0.1, 10))
        own[0].cost, own[0].counts = 0.5, {"overlap": 1e-3}
        origin = points.Origin("2026-11-23", "a machine", "2")
        with tempfile.TemporaryDirectory() as directory:
            path = pathlib.Path(directory)
            points.save(path, own, origin, True)
            points.save(path, [], origin, True)  # keeps what it does not measure
            read = points.planned(["fig8"])
            results, costs = points.load(path, read)
        self.assertEqual(read, own)
        self.assertEqual((results[-1].physics, costs), ("2", [origin]))


class Quoted(unittest.TestCase):
    def test_what_is_not_known_over_the_floor_is_no_figure(self):
        own = fig8(exact=Mean(2.0, 0.1, 10))
        text = tables.floors({"fig8": own}, {})
        self.assertIn("drift A", text)
        self.assertNotIn("1.0", text)

    def test_settings_have_names_of_their_own(self):
        names = [tables.setting(point) for point in points.planned(["fig8"])]
        self.assertEqual(len(set(names)), len(names))
        self.assertLessEqual({"exact", "steps_0_25ms", "floor_0_0125", "steps_1ms_floor_0_025", "no_spin"}, set(names))
        self.assertIn(points.REFERENCE_FLOOR, points.FLOORS)


if __name__ == "__main__":
    unittest.main()
