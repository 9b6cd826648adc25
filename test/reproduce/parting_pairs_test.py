"""One machine that stands in several maps counts once."""
import unittest

from ratchet_sieve.reproduce.paper import parting_pairs
from ratchet_sieve.reproduce.paper.parting_pairs import Pair
from ratchet_sieve.stats import Mean

PARTED = (Mean(0.01, 0.0001, 8), Mean(-0.01, 0.0001, 8))
LEFT = (Mean(-0.01, 0.0001, 8), Mean(-0.01, 0.0001, 8))
OVER_D = Pair("one", "density", "d", "base.frequency", "f")
OVER_A = Pair("two", "base.frequency", "f", "base.asymmetry", "a")
STEEP = Pair("three", "density", "d", "base.frequency", "f", (("base.asymmetry", 0.1),))


def both_angles(x, y, first, second):
    return {(0.105, x, y): first, (0.157, x, y): second}


class Machines(unittest.TestCase):
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
