import unittest

from peers import runs, table


def run_of(program, *blocks):
    return [{"program": program, "drift_blocks": list(blocks)}]


class Peers(unittest.TestCase):
    def test_one_definition_of_the_same_drift_holds_for_every_row(self):
        alike = runs.drift(run_of(runs.OURS, (0.010, 0.040), (0.010, 0.040)))
        for a, b, near in ((0.0104, 0.0390, "yes"), (0.0106, 0.040, "no"), (0.010, 0.043, "no"), (-0.010, 0.040, "no")):
            self.assertEqual(table.is_near(run_of("box2d", (a, b), (a, b)), alike), near)
        self.assertEqual(table.is_near(run_of(runs.OURS, (0.01, 0.04), (0.01, 0.04)), alike), "—")
