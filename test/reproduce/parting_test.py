"""Directions of two species and of one, and the resulting windows of separation, from hand-made numbers."""
import unittest

from ratchet_sieve.reproduce.paper import open_base, parting, parting_follows
from ratchet_sieve.stats import Mean
from ratchet_sieve.reproduce.validation import currents, rapaport


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


class Follows(unittest.TestCase):
    def setUp(self):
        nothing = {(1.0, theta): (sure(0.1), sure(-0.1)) for theta in parting.ANGLES}
        self.part = {"limits": {0.105: {"A": sure(2.2), "B": sure(1.2)}, 0.157: {"A": sure(0.9), "B": None}},
                     "ways": nothing}

    def test_density_between_both_turns_is_inside(self):
        self.assertTrue(parting_follows.is_inside(self.part, 0.105, 2.0))
        self.assertFalse(parting_follows.is_inside(self.part, 0.105, 1.0))
        self.assertFalse(parting_follows.is_inside(self.part, 0.105, 3.0))

    def test_a_kind_that_does_not_turn_goes_as_it_was_measured(self):
        self.assertTrue(parting_follows.is_inside(self.part, 0.157, 0.5))
        self.assertFalse(parting_follows.is_inside(self.part, 0.157, 2.0))

    def test_angles_are_named(self):
        self.assertEqual(parting_follows.angles(self.part, 2.0), "at 0.105 rad")
        self.assertEqual(parting_follows.angles(self.part, 3.0), "at neither angle")


class Searches(unittest.TestCase):
    def test_what_a_search_has_nowhere_is_undecided(self):
        self.assertEqual(rapaport.claims({(0.6, 15.0, 1.0): (sure(0.1), sure(0.1))})[0].verdict(), "undecided")

    def test_what_a_search_has_somewhere_is_possible(self):
        self.assertEqual(rapaport.claims({(0.6, 15.0, 1.0): (sure(-0.1), sure(0.1))})[0].verdict(), "possible")


class OpenBase(unittest.TestCase):
    def test_the_density_that_is_left_counts_diameters(self):
        row = {"count.A": 10, "left.A": 2, "right.A": 3, "count.B": 10, "left.B": 10, "right.B": 0}
        self.assertAlmostEqual(open_base.left_on(row), 3.93 * 5 / 30)


class Currents(unittest.TestCase):
    def test_regimes(self):
        self.assertEqual(currents.regime(sure(0.1), 0.05), currents.NORMAL)
        self.assertEqual(currents.regime(sure(-0.1), 0.05), currents.REVERSED)
        self.assertEqual(currents.regime(sure(0.01), 0.05), currents.NONE)
        self.assertEqual(currents.regime(sure(0.05), 0.05), currents.UNTOLD)
        self.assertEqual(currents.regime(None, 0.05), currents.UNTOLD)

    def test_what_is_nowhere_fails_only_if_every_place_is_told(self):
        told = {"x": sure(0.1)}
        self.assertIs(currents.exists("reversed", told, 0.05, currents.REVERSED).passes, False)
        self.assertIsNone(currents.exists("reversed", {**told, "y": sure(0.05)}, 0.05, currents.REVERSED).passes)
        self.assertTrue(currents.exists("normal", told, 0.05, currents.NORMAL).passes)


if __name__ == "__main__":
    unittest.main()
