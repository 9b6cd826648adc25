import unittest

import verdicts
from ratchet_sieve.stats import Mean
from verdicts import Check, Claim

SURE, UNSURE = Mean(1.0, 0.01, 8), Mean(0.01, 0.01, 8)
ONCE = Mean(1.0, 0.3, 8)  # p = 0.013: sure alone, not among five


def verdict(*outcomes, **options):
    return Claim("1", "here", "so it is", tuple(Check(f"check {k}", "", outcome, **options)
                                                for k, outcome in enumerate(outcomes))).verdict()


class Verdicts(unittest.TestCase):
    def test_a_verdict_follows_from_the_checks(self):
        self.assertEqual(verdict(True, True), "holds")
        self.assertEqual(verdict(False, False), "does not hold")
        self.assertEqual(verdict(None, None), "undecided")
        self.assertEqual(verdict(), "undecided")

    def test_where_checks_differ_the_verdict_says_which(self):
        self.assertEqual(verdict(None, True, False, True),
                         "holds: check 1, check 3; does not hold: check 2; undecided: check 0")
        self.assertEqual(verdict(True, None, part="on 40 teeth"), "holds: on 40 teeth; undecided: on 40 teeth")

    def test_what_was_searched_for_is_possible_at_most(self):
        self.assertEqual(verdict(True, is_searched=True), "possible")
        self.assertEqual(verdict(None, is_searched=True), "undecided")

    def test_a_check_follows_from_the_numbers(self):
        self.assertIs(verdicts.above("", SURE).passes, True)
        self.assertIs(verdicts.below("", SURE).passes, False)
        self.assertIsNone(verdicts.above("", UNSURE).passes)
        self.assertIsNone(verdicts.above("", None).passes)
        self.assertIs(verdicts.within("", SURE, 0.9, 1.1).passes, True)
        self.assertIs(verdicts.within("", SURE, 1.1, 1.2).passes, False)
        self.assertIsNone(verdicts.within("", SURE, 0.99, 1.1).passes)

    def test_many_comparisons_say_which_is_the_other_way(self):
        check = verdicts.counted("all", [("first", SURE), ("second", SURE.scaled(-1.0)), ("third", UNSURE)])
        self.assertIs(check.passes, False)
        self.assertEqual(check.text(), "all: 1 of 3, 1 significantly the other way (second): **does not hold**")
        self.assertIsNone(verdicts.counted("none", []).passes)

    def test_many_comparisons_are_corrected_for_their_number(self):
        self.assertIs(verdicts.counted("one", [("alone", ONCE)]).passes, True)
        self.assertIsNone(verdicts.counted("five", [(str(k), ONCE) for k in range(5)]).passes)
