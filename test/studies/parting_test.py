"""Directions of two species and of one, and the resulting windows of separation, from hand-made numbers."""
import unittest

from ratchet_sieve.stats import Mean
from paper import open_base, parting, parting_pairs
from paper.parting_pairs import Pair
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


class Follows(unittest.TestCase):
    def setUp(self):
        nothing = {(1.0, theta): (sure(0.1), sure(-0.1)) for theta in parting.ANGLES}
        self.part = {"limits": {0.105: {"A": sure(2.2), "B": sure(1.2)}, 0.157: {"A": sure(0.9), "B": None}},
                     "ways": nothing}

    def test_density_between_both_turns_is_inside(self):
        self.assertTrue(parting.is_inside(self.part, 0.105, 2.0))
        self.assertFalse(parting.is_inside(self.part, 0.105, 1.0))
        self.assertFalse(parting.is_inside(self.part, 0.105, 3.0))

    def test_a_kind_that_does_not_turn_goes_as_it_was_measured(self):
        self.assertTrue(parting.is_inside(self.part, 0.157, 0.5))
        self.assertFalse(parting.is_inside(self.part, 0.157, 2.0))

    def test_angles_are_named(self):
        self.assertEqual(parting.angles(self.part, 2.0), "at 0.105 rad")
        self.assertEqual(parting.angles(self.part, 3.0), "at neither angle")


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


PARTED = (Mean(0.01, 0.0001, 8), Mean(-0.01, 0.0001, 8))
LEFT = (Mean(-0.01, 0.0001, 8), Mean(-0.01, 0.0001, 8))
OVER_D = Pair("one", "density", "d", "base.frequency", "f")
OVER_A = Pair("two", "base.frequency", "f", "base.asymmetry", "a")
STEEP = Pair("three", "density", "d", "base.frequency", "f", (("base.asymmetry", 0.1),))


def both_angles(x, y, first, second):
    return {(0.105, x, y): first, (0.157, x, y): second}


class Machines(unittest.TestCase):
    """One machine that stands in several maps counts once."""

    def test_the_printed_machine_is_one_in_all_maps(self):
        numbers = {OVER_D: both_angles(3.93, 23.0, LEFT, LEFT), OVER_A: both_angles(23.0, 0.3, LEFT, LEFT)}
        self.assertEqual(len(parting_pairs.machines(numbers)), 1)

    def test_what_a_whole_map_has_other_than_printed_counts(self):
        numbers = {STEEP: both_angles(3.93, 23.0, LEFT, LEFT), OVER_A: both_angles(23.0, 0.1, LEFT, LEFT)}
        self.assertEqual(len(parting_pairs.machines(numbers)), 1)
        numbers = {STEEP: both_angles(3.93, 23.0, LEFT, LEFT), OVER_A: both_angles(23.0, 0.3, LEFT, LEFT)}
        self.assertEqual(len(parting_pairs.machines(numbers)), 2)

    def test_both_angles_need_one_machine(self):
        numbers = {OVER_D: {**both_angles(1.0, 23.0, PARTED, LEFT), **both_angles(0.5, 23.0, LEFT, PARTED)}}
        self.assertIn("at 0.105 on 1, at 0.157 on 1, and at both on 0", parting_pairs.found(numbers))
        self.assertIn("none of these pairs", parting_pairs.conclusion(numbers))
        numbers[OVER_D].update(both_angles(2.0, 23.0, PARTED, PARTED))
        self.assertIn("at both on 1", parting_pairs.found(numbers))
        self.assertIn("d = 2, f = 23", parting_pairs.conclusion(numbers))
