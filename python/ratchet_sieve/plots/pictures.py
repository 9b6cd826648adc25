"""Pictures of a Run."""
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from ratchet_sieve.plots.machine import machine
from ratchet_sieve.plots.style import DPI, drawing, legend_above, panels, styled
from ratchet_sieve.values import Values

SIZE = (8.0, 3.2)  # of a machine's picture [inch]


def instant(run, frame):
    """Disks and base at a frame; of a run without frames, at its end."""
    if len(run.frames):
        return run.frames.disks[frame], run.frames.base[frame]
    return run.simulation.disks, run.simulation.base


def draw(run, frame, axes):
    disks, base = instant(run, frame)
    names = run.scene.species
    columns = {name: disks[name] for name in ("x", "y", "radius", "angle")}
    columns["species"] = [names[kind] for kind in disks["species"]]
    machine(axes, run.scene.values["base"], columns, float(base["inclination"]),
            (float(base["horizontal_displacement"]), float(base["displacement"])), names)
    legend_above(axes)


def machine_of(run, frame, axes=None):
    with drawing(axes, SIZE) as axes:
        draw(run, frame, axes)
    return axes


def animation_of(run, speed):
    from matplotlib.animation import FuncAnimation  # takes long, and the programs do without

    # No figure of pyplot's: a window of it, closed, is still drawn to at the end of the program.
    with styled():
        figure, axes = panels(1, 1, SIZE, dpi=DPI)
        FigureCanvasAgg(figure)
        draw(run, 0, axes)
    left, right = axes.get_xlim()
    low, high = axes.get_ylim()

    def show(frame):
        with styled():
            axes.clear()
            draw(run, frame, axes)
        axes.set(xlim=(left, right), ylim=(low, high), title=f"{run.frames.time[frame]:.3f} s")

    period = 1000.0 * float(run.frames.time[-1] - run.frames.time[0]) / max(len(run.frames) - 1, 1)
    return FuncAnimation(figure, show, frames=len(run.frames), interval=period / speed)


def pixels_of(simulation):
    """The machine at its time: an array (height, width, 3) of uint8."""
    figure = Figure(figsize=(8.0, 4.0), dpi=100)
    canvas = FigureCanvasAgg(figure)
    axes = figure.subplots()
    draw(Values(frames=(), simulation=simulation, scene=simulation.scene), -1, axes)
    axes.set_title(f"{simulation.time:.3f} s")
    canvas.draw()
    return np.asarray(canvas.buffer_rgba())[..., :3].copy()
