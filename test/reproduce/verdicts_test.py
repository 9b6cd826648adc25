import unittest

from reproduce import verdicts
from reproduce.samples import Mean
from reproduce.verdicts import Check, Claim

SURE, UNSURE = Mean(1.0, 0.01, 8), Mean(0.01, 0.01, 8)


def verdict(*outcomes):
    return Claim("1", "here", "so it is", tuple(Check("", "", outcome) for outcome in outcomes)).verdict()


class Verdicts(unittest.TestCase):
    def test_a_verdict_follows_from_the_checks(self):
        self.assertEqual(verdict(True, True), "holds")
        self.assertEqual(verdict(True, False), "holds in part")
        self.assertEqual(verdict(True, None), "holds in part")
        self.assertEqual(verdict(False, None), "does not hold")
        self.assertEqual(verdict(None, None), "not told")
        self.assertEqual(verdict(), "not told")

    def test_a_check_follows_from_the_numbers(self):
        self.assertIs(verdicts.above("", SURE).passes, True)
        self.assertIs(verdicts.below("", SURE).passes, False)
        self.assertIsNone(verdicts.above("", UNSURE).passes)
        self.assertIsNone(verdicts.above("", None).passes)
        self.assertIs(verdicts.within("", SURE, 0.9, 1.1).passes, True)
        self.assertIs(verdicts.within("", SURE, 1.1, 1.2).passes, False)
        self.assertIsNone(verdicts.within("", SURE, 0.99, 1.1).passes)

    def test_many_comparisons_say_which_is_the_other_way(self):
        check = verdicts.counted("all", [("first", True), ("second", False), ("third", None)])
        self.assertIs(check.passes, False)
        self.assertEqual(check.text(), "all: 1 of 3 are sure, 1 are surely the other way (second): **no**")
        self.assertIsNone(verdicts.counted("none", []).passes)
