import math
import random
import statistics
import unittest

from reproduce import student
from reproduce.best import best_of, vertex
from reproduce.crossings import apart_between, crossing_of, distance_of, zero_crossing
from reproduce.lines import chi_squared_tail, line_through
from reproduce.rows import Rows
from reproduce.samples import Mean, jackknife, mean_of, variance_of


class Means(unittest.TestCase):
    def test_mean_and_standard_error(self):
        mean = mean_of([1.0, 2.0, 3.0, 4.0])
        self.assertEqual(mean.value, 2.5)
        self.assertAlmostEqual(mean.error, math.sqrt(5.0 / 3.0 / 4.0))
        self.assertEqual(mean.count, 4)

    def test_what_is_not_defined_is_none(self):
        self.assertIsNone(mean_of([]))
        self.assertIsNone(mean_of([1.0]).error)
        self.assertIsNone(mean_of([1.0]).surely_above(0.0))
        self.assertEqual(mean_of([1.0]).text(), "1.000 ± —")

    def test_errors_are_shown_with_one_digit_or_two_after_a_one(self):
        self.assertEqual(Mean(-0.01234, 0.0004, 8).text(1e3), "−12.3 ± 0.4")
        self.assertEqual(Mean(0.01234, 0.00014, 8).text(1e3), "12.34 ± 0.14")
        self.assertEqual(Mean(-0.00001, 0.0004, 8).text(1e3), "0.0 ± 0.4")

    def test_sure_is_an_interval_of_95_percent(self):
        for freedom, printed in ((1, 12.706), (3, 3.182), (30, 2.042), (120, 1.980)):  # from the printed table
            self.assertAlmostEqual(student.quantile(freedom), printed, places=3)
        self.assertAlmostEqual(student.quantile(5, 0.001), 6.869, places=3)
        self.assertIs(Mean(4.4, 1.0, 3).surely_above(0.0), True)
        self.assertIsNone(Mean(4.2, 1.0, 3).surely_above(0.0))
        self.assertIs(Mean(-4.4, 1.0, 3).surely_above(0.0), False)
        self.assertIs(Mean(-4.4, 1.0, 3).surely_below(0.0), True)

    def test_intervals_hold_the_truth_as_often_as_they_say(self):
        draws = random.Random(1)
        means = [mean_of(draws.gauss(0.0, 1.0) for _ in range(4)) for _ in range(4000)]
        outside = sum(mean.surely_above(0.0) is not None for mean in means)
        self.assertAlmostEqual(outside / 4000, 0.05, delta=0.015)

    def test_a_difference_has_the_freedom_of_welch(self):
        even = Mean(1.0, 0.1, 5).minus(Mean(0.0, 0.1, 5))
        self.assertAlmostEqual(even.degrees(), 8.0)  # of two equal ones, their combined error
        self.assertAlmostEqual(even.error, math.hypot(0.1, 0.1))
        self.assertAlmostEqual(Mean(1.0, 0.1, 5).minus(Mean(0.0, 1e-9, 3)).degrees(), 4.0)  # one is exact
        self.assertIs(even.surely_above(0.0), True)

    def test_the_jackknife_of_a_mean_is_its_standard_error(self):
        samples = [0.3, 1.4, 2.1, 0.2, 0.9]
        found, known = jackknife(statistics.fmean, samples), mean_of(samples)
        self.assertAlmostEqual(found.value, known.value)
        self.assertAlmostEqual(found.error, known.error)

    def test_the_variance_of_normal_samples_has_the_error_of_print(self):
        draws = random.Random(2)
        variance = variance_of([draws.gauss(0.0, 2.0) for _ in range(20000)])
        self.assertAlmostEqual(variance.value, 4.0, delta=3.0 * variance.error)
        self.assertAlmostEqual(variance.error, 4.0 * math.sqrt(2.0 / 20000.0), delta=0.003)  # sigma^2 sqrt(2 / n)


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
        rows = Rows({**row, "z": 0.2 - row["x"]} for row in rows_of(lambda x: 0.5 - x, 1e-4))
        distance, apart = distance_of(rows, "x", "y", "z"), apart_between(rows, "x", "y", "z")
        self.assertAlmostEqual(distance.value, 0.3, delta=0.001)
        self.assertAlmostEqual(apart.value, 0.3, delta=0.001)

    def test_the_best_of_noise_is_not_above_it(self):
        sets = [rows_of(lambda x: 0.0, 1.0, 6, draws_of) for draws_of in range(200)]
        halves = [best_of(rows, "x", "y").mean.value for rows in sets]
        naive = [max(cell.mean("y").value for cell in rows.by("x").values()) for rows in sets]
        self.assertLess(abs(statistics.fmean(halves)), 0.1)
        self.assertGreater(statistics.fmean(naive), 0.4)  # selection by the same samples

    def test_each_half_of_the_seeds_chooses_for_the_other(self):
        rows = Rows({"x": x, "seed": float(seed), "y": y} for x, ys in ((1.0, (5.0, 0.0)), (2.0, (0.0, 3.0)))
                    for seed, y in zip((1, 2), ys))
        self.assertEqual(best_of(rows, "x", "y").mean.value, 0.0)  # seed 1 chooses x = 1, where seed 2 has 0; and so on

    def test_the_best_is_found(self):
        best = best_of(rows_of(lambda x: 1.0 - (x - 0.4) ** 2, 0.002), "x", "y")
        self.assertAlmostEqual(best.at, 0.4)
        self.assertAlmostEqual(best.mean.value, 1.0, delta=0.01)
        self.assertAlmostEqual(best.peak.value, 1.0, delta=0.01)

    def test_a_peak_between_the_places_is_found(self):
        self.assertAlmostEqual(vertex([(x, 2.0 - (x - 1.3) ** 2) for x in (0.0, 1.0, 2.5)]), 2.0)
        self.assertIsNone(vertex([(0.0, 1.0), (1.0, 0.0), (2.0, 1.0)]))
        self.assertIsNone(vertex([(0.0, 0.0), (1.0, 1.0), (2.0, 1.9)]))  # rises on beyond them

    def test_chi_squared_has_the_tail_of_print(self):
        for x, freedom in ((3.841, 1), (5.991, 2), (7.815, 3), (9.488, 4)):
            self.assertAlmostEqual(chi_squared_tail(x, freedom), 0.05, places=4)

    def test_a_line_goes_through_its_points(self):
        line = line_through([(x, Mean(2.0 - 3.0 * x, 0.1 + x, 4)) for x in (0.0, 1.0, 2.0, 5.0)])
        self.assertAlmostEqual(line.intercept.value, 2.0)
        self.assertAlmostEqual(line.slope.value, -3.0)
        self.assertAlmostEqual(line.chi_squared, 0.0)
        self.assertIsNone(line_through([(0.0, Mean(1.0, 0.1, 4)), (1.0, Mean(1.0, 0.1, 4))]))

    def test_the_error_of_a_lines_height_is_that_of_its_mean(self):
        line = line_through([(x, Mean(1.0, 0.2, 4)) for x in (-1.0, -1.0, 1.0, 1.0)])
        self.assertAlmostEqual(line.intercept.error, 0.1)
