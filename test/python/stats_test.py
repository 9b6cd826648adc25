import math
import random
import statistics
import unittest

from ratchet_sieve.stats import Mean, chi_squared_tail, holm, jackknife, mean_of, quantile, signs, two_sided, variance_of, wilson


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
        self.assertIsNone(mean_of([1.0]).half_width())
        self.assertEqual(mean_of([1.0]).text(), "1.000 ± —")

    def test_errors_are_shown_with_one_digit_or_two_after_a_one(self):
        self.assertEqual(Mean(-0.01234, 0.0004, 8).text(1e3), "−12.3 ± 0.4")
        self.assertEqual(Mean(0.01234, 0.00014, 8).text(1e3), "12.34 ± 0.14")
        self.assertEqual(Mean(-0.00001, 0.0004, 8).text(1e3), "0.0 ± 0.4")

    def test_intervals_of_shares(self):
        # Newcombe, Statist. Med. 17, 857 (1998), table I, method 3.
        for part, whole, low, high in ((81, 263, 0.2553, 0.3662), (15, 148, 0.0624, 0.1605), (0, 20, 0.0, 0.1611),
                                       (1, 29, 0.0061, 0.1718)):
            for got, printed in zip(wilson(part, whole), (low, high)):
                self.assertAlmostEqual(got, printed, places=4)
        self.assertEqual(wilson(20, 20)[1], 1.0)
        self.assertAlmostEqual(wilson(20, 20)[0], 1.0 - 0.1611, places=4)

    def test_sure_is_an_interval_of_95_percent(self):
        # Abramowitz and Stegun, Handbook of Mathematical Functions (1964), table 26.10.
        for freedom, printed in ((1, 12.706), (3, 3.182), (30, 2.042), (120, 1.980)):
            self.assertAlmostEqual(quantile(freedom), printed, places=3)
            self.assertAlmostEqual(two_sided(printed, freedom), 0.05, places=4)
        self.assertAlmostEqual(quantile(5, 0.001), 6.869, places=3)
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

    def test_welch_is_that_of_print(self):
        # NIST/SEMATECH e-Handbook of Statistical Methods, 1.3.5.3: miles per gallon of cars, AUTO83B.DAT.
        american = Mean(20.14458, 6.414700 / math.sqrt(249), 249)
        japanese = Mean(30.48101, 6.107710 / math.sqrt(79), 79)
        difference = american.minus(japanese)
        self.assertAlmostEqual(difference.value / difference.error, -12.94627, places=4)
        self.assertAlmostEqual(difference.degrees(), 136.8750, places=3)

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

    def test_holm_of_the_textbook(self):
        self.assertEqual(holm([0.01, 0.04, 0.03, 0.005]), [True, False, False, True])
        self.assertEqual(holm([0.04]), [True])
        self.assertEqual(holm([0.03, 0.03]), [False, False])

    def test_a_mean_without_an_error_has_no_sure_sign(self):
        self.assertEqual(signs([None, Mean(1.0, None, 1), Mean(1.0, 0.01, 8)]), [None, None, True])

    def test_chi_squared_has_the_tail_of_print(self):
        # Abramowitz and Stegun, table 26.8.
        for x, freedom in ((3.841, 1), (5.991, 2), (7.815, 3), (9.488, 4)):
            self.assertAlmostEqual(chi_squared_tail(x, freedom), 0.05, places=4)
