"""Pictures: a machine at an instant, trajectories, distributions, curves with errors, maps over two keys. All are drawn
into matplotlib's axes, and need no screen."""
from ratchet_sieve.plots.curves import curve, distribution, end_labels, key_colours, ramp, signed, signed_ramp
from ratchet_sieve.plots.machine import machine, trajectories
from ratchet_sieve.plots.maps import class_legend, class_map, mark_cells, value_map
from ratchet_sieve.plots.results import bins, displacements, sweep_curves, sweep_map, tracks
from ratchet_sieve.plots.style import COLOURS, GREY, MM, beside, drawing, panels, save, say_undefined, styled

__all__ = ["COLOURS", "GREY", "MM", "beside", "bins", "class_legend", "class_map", "curve", "displacements",
           "distribution", "drawing", "end_labels", "key_colours", "machine", "mark_cells", "panels", "ramp", "save",
           "say_undefined", "signed", "signed_ramp", "styled", "sweep_curves", "sweep_map", "tracks", "trajectories",
           "value_map"]
