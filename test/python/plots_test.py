"""The drawing functions, by what they draw."""
import math
import pathlib
import tempfile
import unittest

from matplotlib.text import Text

from ratchet_sieve import plots
from ratchet_sieve.base import length, outline
from ratchet_sieve.plots.curves import STEPS
from ratchet_sieve.plots.machine import surface
from ratchet_sieve.plots.maps import colour_steps
from ratchet_sieve.plots.means import plain_label
from ratchet_sieve.plots.sweep_page import cases_of, pages_of
from ratchet_sieve.tables import Rows

SAWTOOTH = {"teeth": 3, "tooth_width": 0.02, "tooth_height": 0.006, "asymmetry": 0.25}
PROFILE = {"teeth": 2, "profile": [[0, 0], [0.01, -0.004], [0.03, 0]]}
DISKS = {"x": [0.01, 0.03], "y": [0.02, 0.04], "radius": [0.001, 0.002], "species": ["A", "B"],
         "angle": [0.0, math.pi / 2.0]}


def axes_of():
    return plots.panels(1, 1, (4, 3), None)[1]


def box_of(collection):
    return collection.get_paths()[0].get_extents().extents


class Colours(unittest.TestCase):
    def test_a_map_has_ten_steps_at_most(self):
        for values in ([0.013, 0.987], [-0.3, 0.1], [5.0, 5.0], [0.0, 0.0], [-2.0, -1.0], [1e-9, 1e9]):
            self.assertLessEqual(len(colour_steps(values)['norm'].boundaries) - 1, STEPS, values)

    def test_a_map_diverges_around_nought_where_values_have_both_signs(self):
        steps = colour_steps([-0.3, 0.1])
        low, high = steps['cmap'](0.0), steps['cmap'](1.0)
        self.assertTrue(low[2] > low[0] and high[0] > high[2])
        self.assertAlmostEqual(sum(steps['norm'].boundaries), 0.0)

    def test_a_map_is_brightest_where_values_are_largest(self):
        for values, largest in ([0.1, 0.3], 1.0), ([-0.3, -0.1], 0.0):
            colours = colour_steps(values)['cmap']
            self.assertGreater(sum(colours(largest)[:3]), sum(colours(1.0 - largest)[:3]) + 1.0)

    def test_curves_of_numbers_have_colours_in_their_order(self):
        colours = plots.key_colours([float(k) for k in range(STEPS)])
        self.assertEqual(len(set(colours)), STEPS)
        brightness = [sum(colour[:3]) for colour in colours]
        self.assertEqual(brightness, sorted(brightness))

    def test_curves_diverge_where_the_key_has_a_sign(self):
        low, _, high = plots.key_colours([-0.3, 0.0, 0.3])
        self.assertGreater(low[2], low[0])
        self.assertGreater(high[0], high[2])

    def test_labels_at_the_ends_lie_apart(self):
        axes = axes_of()
        ends = [(0.5 + 0.001 * k, f'{k}', 'black') for k in range(6)]
        for end, _, _ in ends:
            axes.plot([0.0, 1.0], [0.0, end])
        plots.end_labels(axes, ends, 'key')
        axes.figure.draw_without_rendering()
        boxes = sorted((Text.get_window_extent(text) for text in axes.texts), key=lambda box: box.y0)
        for one, other in zip(boxes, boxes[1:]):
            self.assertLessEqual(one.y1, other.y0 + 1.0)

    def test_curves_of_texts_are_told_apart(self):
        self.assertEqual(plots.key_colours(['open', 'walled']), plots.COLOURS[:2])


class Curves(unittest.TestCase):
    def test_a_distribution_has_the_area_of_its_bins(self):
        line, = plots.distribution(axes_of(), [0.0, 1.0, 3.0], [0.4, 0.3])
        self.assertEqual([list(row) for row in line.get_xydata()], [[0.0, 0.4], [1.0, 0.3], [3.0, 0.0]])
        points = plots.distribution(axes_of(), [0.0, 1.0, 3.0], [0.4, 0.3], [0.1, 0.1]).lines[0]
        self.assertEqual([list(row) for row in points.get_xydata()], [[0.5, 0.4], [2.0, 0.3]])

    def test_a_trajectory_goes_on_at_the_other_end_of_a_periodic_base(self):
        track = ([0.018, 0.019, 0.001, 0.002], [0.0] * 4)
        axes = axes_of()
        plots.trajectories(axes, [track], period=0.02)
        plots.trajectories(axes, [track])
        periodic, open_ = (list(line.get_xdata()) for line in axes.lines)
        self.assertEqual(open_, [18.0, 19.0, 1.0, 2.0])
        self.assertTrue(math.isnan(periodic.pop(2)))
        self.assertEqual(periodic, open_)


class Machine(unittest.TestCase):
    def test_a_tooth_has_its_corners(self):
        self.assertEqual(outline(SAWTOOTH), [(0.0, 0.0), (0.005, 0.006), (0.02, 0.0)])
        self.assertEqual(surface(PROFILE), [(0, 0), (0.01, -0.004), (0.03, 0), (0.04, -0.004), (0.06, 0)])
        self.assertEqual((length(SAWTOOTH), length(PROFILE)), (0.06, 0.06))

    def test_is_drawn_to_scale(self):
        axes = axes_of()
        plots.machine(axes, SAWTOOTH, DISKS)
        self.assertEqual(axes.get_legend_handles_labels()[1], ["A", "B"])
        for kind, expected in zip(axes.collections[0::2], ((9.0, 19.0, 11.0, 21.0), (28.0, 38.0, 32.0, 42.0))):
            self.assertAlmostEqual(math.dist(box_of(kind), expected), 0.0, places=3)
        self.assertEqual(axes.get_aspect(), 1.0)

    def test_is_tilted_about_its_first_foot_and_moves(self):
        axes = axes_of()
        plots.machine(axes, SAWTOOTH, DISKS, inclination=math.pi / 2.0, displacement=(0.0, 0.001))
        corners = axes.patches[0].get_xy()
        for found, expected in zip(corners, ((0.0, 1.0), (-6.0, 6.0), (0.0, 21.0))):
            self.assertAlmostEqual(math.dist(found, expected), 0.0)

    def test_the_dot_turns_with_its_disk(self):
        axes = axes_of()
        plots.machine(axes, SAWTOOTH, DISKS)
        dots = [box_of(collection) for collection in axes.collections[1::2]]
        for (left, low, right, high), expected in zip(dots, ((10.55, 20.0), (30.0, 41.1))):
            self.assertAlmostEqual(math.dist((0.5 * (left + right), 0.5 * (low + high)), expected), 0.0, places=3)


class SweepReports(unittest.TestCase):
    def test_labels_have_no_mathtext_but_that_of_names(self):
        self.assertEqual(plain_label('base.inclination'), ('\u03b8', 'rad'))
        self.assertEqual(plain_label('throughput'), ('throughput', 'disks/s'))
        self.assertEqual(plain_label('mean_vx.$A [x]'), ('\u27e8V_x\u27e9 of $A [x]', 'm/s'))
        self.assertEqual(plain_label('purity.left.mass.A [x]'), ('purity.left.mass.A [x]', ''))

    def test_runs_that_differ_in_the_seed_alone_are_together(self):
        arguments = ['--set gravity=8 --seed 18446744073709551615', '--set gravity=8 --seed 2',
                     "--set 'species.0.name=--seed 3'", None]
        rows = Rows([{'arguments': text, 'run_hash': f'{k}'} for k, text in enumerate(arguments)])
        with tempfile.TemporaryDirectory() as name:
            kept = pathlib.Path(name) / 'kept #1'
            kept.mkdir()
            (kept / '1.html').touch()
            cases = cases_of(rows, pages_of(kept, pathlib.Path(name) / 'report'))
        self.assertEqual(cases, [
            {'arguments': '--set gravity=8', 'seeds': ['18446744073709551615', '2'],
             'pages': [None, '../kept%20%231/1.html']},
            {'arguments': "--set 'species.0.name=--seed 3'", 'seeds': [None], 'pages': [None]},
            {'arguments': '', 'seeds': [None], 'pages': [None]}])
