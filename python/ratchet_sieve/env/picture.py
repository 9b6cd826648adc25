"""Pictures of a sieve as arrays of pixels."""
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from ..plots import pictures
from ..simulation import Simulation
from ..values import Values

SIZE = (8.0, 4.0)  # [inch]
RESOLUTION = 100  # [1/inch]


def pixels(simulation: Simulation) -> np.ndarray:
    """The machine at its time: an array (height, width, 3) of uint8."""
    figure = Figure(figsize=SIZE, dpi=RESOLUTION)
    canvas = FigureCanvasAgg(figure)
    axes = figure.subplots()
    pictures.draw(Values(frames=(), simulation=simulation, scene=simulation.scene), -1, axes)
    axes.set_title(f"{simulation.time:.3f} s")
    canvas.draw()
    return np.asarray(canvas.buffer_rgba())[..., :3].copy()
