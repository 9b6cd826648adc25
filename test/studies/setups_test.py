import unittest

import setups


class Setups(unittest.TestCase):
    def test_values_are_those_of_the_scene_the_set_the_grid_and_the_cases(self):
        self.assertEqual(setups.values_of("validation_layer", "base.tooth_height"), [0.005])       # the scene
        self.assertEqual(setups.values_of("validation_layer_fresh", "base.frequency"), [22])       # set
        self.assertEqual(setups.values_of("validation_layer_onset", "base.frequency"), [10, 20])   # a range
        self.assertEqual(setups.values_of("validation_layer", "base.teeth"), [16, 20, 40, 60, 80])  # cases
        self.assertEqual(setups.values_of("validation_bae", "density"), [])                        # none

    def test_species_that_differ_are_told_apart(self):
        keys = ("species.0.friction", "species.1.friction")
        self.assertEqual(setups.told("validation_farkas_friction", keys, 1), "0; 0.6")
        self.assertEqual(setups.told("validation_farkas_restitution", keys, 1), "0.1")
