import math
import random
import statistics
import unittest

from ratchet_sieve.stats import Mean
from ratchet_sieve.tables import Rows
from curves import best_of, crossing_of, line_through, turns_of, zero_crossing


def rows_of(curve, noise, seeds=6, draws_of=3):
    draws = random.Random(draws_of)
    return Rows({"x": 0.1 * k, "seed": float(seed), "y": curve(0.1 * k) + draws.gauss(0.0, noise)}
                for k in range(8) for seed in range(1, seeds + 1))


class Curves(unittest.TestCase):
    def test_a_parabola_is_crossed_where_it_is(self):
        points = [(x, 2.0 - x * x) for x in (0.0, 1.0, 1.5, 3.0)]
        self.assertAlmostEqual(zero_crossing(points), math.sqrt(2.0))

    def test_no_change_of_sign_is_no_crossing(self):
        self.assertIsNone(zero_crossing([(0.0, 1.0), (1.0, 2.0), (2.0, 0.5)]))

    def test_a_crossing_is_within_its_error(self):
        found = crossing_of(rows_of(lambda x: 1.0 - 3.0 * x, 0.02), "x", "y")
        self.assertLess(abs(found.value - 1.0 / 3.0), 4.0 * found.error)
        self.assertLess(found.error, 0.01)

    def test_two_lines_part_as_they_do(self):
        frame = rows_of(lambda x: 0.5 - x, 1e-4).frame
        rows = Rows(frame.rename(columns={"y": "mean_vx.A"}).assign(**{"mean_vx.B": 0.2 - frame["x"]}))
        turns = turns_of(rows, "x")
        for name, value in (("A", 0.5), ("B", 0.2), ("window", 0.3)):
            self.assertAlmostEqual(turns[name].value, value, delta=0.001)

    def test_the_best_of_noise_is_not_above_it(self):
        sets = [rows_of(lambda x: 0.0, 1.0, 6, draws_of) for draws_of in range(60)]
        halves = [best_of(rows, "x", "y").mean.value for rows in sets]
        naive = [max(cell.mean("y").value for cell in rows.by("x").values()) for rows in sets]
        self.assertLess(abs(statistics.fmean(halves)), 0.1)
        self.assertGreater(statistics.fmean(naive), 0.4)  # selection by the same samples

    def test_each_half_of_the_seeds_chooses_for_the_other(self):
        rows = Rows({"x": x, "seed": float(seed), "y": y} for x, ys in ((1.0, (5.0, 0.0)), (2.0, (0.0, 3.0)))
                    for seed, y in zip((1, 2), ys))
        self.assertEqual(best_of(rows, "x", "y").mean.value, 0.0)  # seed 1 chooses x = 1, where seed 2 has 0; and so on

    def test_a_place_that_few_seeds_ran_is_not_chosen(self):
        rows = rows_of(lambda x: x, 0.01, 6)
        few = Rows(rows.frame[(rows.frame["x"] < 0.65) | (rows.frame["seed"] < 3.0)])
        best = best_of(few, "x", "y")
        self.assertAlmostEqual(best.at, 0.6)
        self.assertEqual(best.mean.count, 6)

    def test_the_error_of_a_crossing_contains_its_interpolation(self):
        rows = Rows({"x": x, "seed": float(seed), "y": math.exp(-x) - 0.5} for x in (0.0, 0.5, 1.0, 2.0)
                    for seed in range(1, 5))
        found = crossing_of(rows, "x", "y")
        self.assertGreater(found.error, abs(found.value - math.log(2.0)))

    def test_the_best_is_found(self):
        best = best_of(rows_of(lambda x: 1.0 - (x - 0.4) ** 2, 0.002), "x", "y")
        self.assertAlmostEqual(best.at, 0.4)
        self.assertAlmostEqual(best.mean.value, 1.0, delta=0.01)

    def test_a_line_goes_through_its_points(self):
        line = line_through([(x, Mean(2.0 - 3.0 * x, 0.1 + x, 4)) for x in (0.0, 1.0, 2.0, 5.0)])
        self.assertAlmostEqual(line.intercept.value, 2.0)
        self.assertAlmostEqual(line.slope.value, -3.0)
        self.assertAlmostEqual(line.chi_squared, 0.0)
        self.assertIsNone(line_through([(0.0, Mean(1.0, 0.1, 4)), (1.0, Mean(1.0, 0.1, 4))]))

    def test_the_error_of_a_lines_height_is_that_of_its_mean(self):
        line = line_through([(x, Mean(1.0, 0.2, 4)) for x in (-1.0, -1.0, 1.0, 1.0)])
        self.assertAlmostEqual(line.intercept.error, 0.1)
