"""Directions of two species and of one, and the resulting windows of separation, from hand-made numbers."""
import unittest

from ratchet_sieve.stats import Mean
from paper import open_base, parting
from validation import bae, rapaport


def sure(value):
    return Mean(value, 0.001, 8)


class Parting(unittest.TestCase):
    def test_class_follows_both_signs(self):
        self.assertEqual(parting.class_of((sure(0.1), sure(-0.1))), parting.PARTED)
        self.assertEqual(parting.class_of((sure(0.1), sure(0.1))), parting.RIGHT)
        self.assertEqual(parting.class_of((sure(-0.1), sure(-0.1))), parting.LEFT)
        self.assertEqual(parting.class_of((sure(-0.1), sure(0.1))), parting.OTHER)

    def test_an_unsure_sign_is_undecided(self):
        self.assertEqual(parting.class_of((sure(0.0005), sure(-0.1))), parting.UNTOLD)
        self.assertEqual(parting.class_of((None, sure(-0.1))), parting.UNTOLD)


class Fresh(unittest.TestCase):
    def test_each_floor_has_a_verdict(self):
        fresh = {0.05: (sure(-0.1), sure(0.1)), 0.01: (sure(0.0005), sure(0.1))}
        self.assertEqual(rapaport.claims({"fresh": fresh})[0].verdict(),
                         "holds: v_min = 0.05 m/s; undecided: v_min = 0.01 m/s")


class OpenBase(unittest.TestCase):
    def test_the_density_that_is_left_counts_diameters(self):
        row = {"count.A": 10, "left.A": 2, "right.A": 3, "count.B": 10, "left.B": 10, "right.B": 0}
        self.assertAlmostEqual(open_base.left_on(row), 3.93 * 5 / 30)


class Currents(unittest.TestCase):
    def test_regimes(self):
        self.assertEqual(bae.regime(sure(0.1), 0.05), bae.NORMAL)
        self.assertEqual(bae.regime(sure(-0.1), 0.05), bae.REVERSED)
        self.assertEqual(bae.regime(sure(0.01), 0.05), bae.NONE)
        self.assertEqual(bae.regime(sure(0.05), 0.05), bae.UNTOLD)
        self.assertEqual(bae.regime(None, 0.05), bae.UNTOLD)

    def test_what_is_nowhere_fails_only_if_every_place_is_told(self):
        told = {"x": sure(0.1)}
        self.assertIs(bae.exists("reversed", told, 0.05, bae.REVERSED).passes, False)
        self.assertIsNone(bae.exists("reversed", {**told, "y": sure(0.05)}, 0.05, bae.REVERSED).passes)
        self.assertTrue(bae.exists("normal", told, 0.05, bae.NORMAL).passes)


if __name__ == "__main__":
    unittest.main()
