#!/usr/bin/python3
"""The colours of a sweep's curves and maps, and the labels at the ends of its curves."""
import pathlib
import sys
import unittest

from matplotlib.text import Text

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / 'scripts'))
from plot_tables import plt  # noqa: E402
from sweep_colours import COLOUR_STEPS, DIVERGING, SEQUENTIAL, colour_steps, curve_colours, label_ends  # noqa: E402


class SweepColours(unittest.TestCase):
    def test_a_map_has_ten_steps_at_most(self):
        for values in ([0.013, 0.987], [-0.3, 0.1], [5.0, 5.0], [0.0, 0.0], [-2.0, -1.0], [1e-9, 1e9]):
            self.assertLessEqual(len(colour_steps(values)['norm'].boundaries) - 1, COLOUR_STEPS, values)

    def test_a_map_diverges_around_nought_where_values_have_both_signs(self):
        steps = colour_steps([-0.3, 0.1])
        self.assertEqual(steps['cmap'], DIVERGING)
        self.assertAlmostEqual(sum(steps['norm'].boundaries), 0.0)
        self.assertEqual(colour_steps([0.1, 0.3])['cmap'], SEQUENTIAL)

    def test_curves_of_numbers_have_colours_in_their_order(self):
        colours = curve_colours([float(k) for k in range(COLOUR_STEPS)])
        self.assertEqual(len(set(colours)), COLOUR_STEPS)
        brightness = [sum(colour[:3]) for colour in colours]
        self.assertEqual(brightness, sorted(brightness))

    def test_curves_diverge_where_the_key_has_a_sign(self):
        low, _, high = curve_colours([-0.3, 0.0, 0.3])
        self.assertGreater(low[2], low[0])
        self.assertGreater(high[0], high[2])

    def test_labels_at_the_ends_lie_apart(self):
        figure, axes = plt.subplots()
        ends = [((1.0, 0.5 + 0.001 * k), f'{k}', 'black') for k in range(6)]
        for end, _, _ in ends:
            axes.plot([0.0, 1.0], [0.0, end[1]])
        label_ends(axes, ends, 'key')
        figure.canvas.draw()
        # Without the lines to the curves.
        boxes = sorted((Text.get_window_extent(text) for text in axes.texts), key=lambda box: box.y0)
        for one, other in zip(boxes, boxes[1:]):
            self.assertLessEqual(one.y1, other.y0 + 1.0)
        plt.close(figure)


if __name__ == '__main__':
    unittest.main()
