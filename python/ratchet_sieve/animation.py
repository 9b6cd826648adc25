"""Films RViz on a virtual screen while a sieve tilts and its two kinds of disks part: the pictures of the documents.

Writes OUT.gif, and OUT.png, the whole window at --still. The sieve is stepped from frame to frame, so that a scene
gives the same film on a slow machine. Run it where `rosrun ratchet_sieve` works.
"""

import argparse
import contextlib
import subprocess
import tempfile
from pathlib import Path

import numpy
import rospy
from std_msgs.msg import Float64

from ratchet_sieve.processes import master, wait_for
from ratchet_sieve.srv import StepSimulation
from ratchet_sieve.tables import writing
from ratchet_sieve.virtual_screen import VirtualScreen

# How fast the base follows what is commanded [rad/s].
SLEW_RATE = 0.5

# The part of RViz's window, of 1280 by 800 pixels, that shows the scene: rows, columns.
VIEW = (slice(62, 700), slice(16, 1264))

# The fewest colours with smooth text and disks.
COLOURS = 48


def arguments():
    parser = argparse.ArgumentParser(prog='ratchet_sieve.animation', description=__doc__.splitlines()[0])
    parser.add_argument('scene', type=Path)
    parser.add_argument('out', type=Path)
    parser.add_argument('--teeth', type=int, help="of the base, instead of the scene's")
    parser.add_argument('--inclination', type=float, default=0.19, help='commanded at the beginning [rad]')
    parser.add_argument('--from', type=float, default=0.0, dest='begin', help='when the film begins [s]')
    parser.add_argument('--duration', type=float, default=8.0, help='simulated [s]')
    parser.add_argument('--rate', type=float, default=12.5, help='frames per simulated second')
    parser.add_argument('--still', type=float, default=4.0, help='when OUT.png is taken, of the film [s]')
    parser.add_argument('--width', type=int, default=760, help='of OUT.gif [pixels]')
    return parser.parse_args()


@contextlib.contextmanager
def paused_sieve(screen, options):
    """A sieve at its beginning, in RViz on the screen."""
    changes = f'{{base.teeth: {options.teeth}}}' if options.teeth else '{}'
    launch = screen.start(['roslaunch', 'ratchet_sieve', 'sieve.launch', f'scene:={options.scene.resolve()}',
                           f'set:={changes}',
                           f'params:={{limits: {{inclination: {{slew_rate: {SLEW_RATE}}}}}}}',
                           'paused:=true', 'rviz:=true', 'exit_at_end:=false'],
                          stdout=subprocess.DEVNULL)
    rospy.init_node('film', disable_signals=True)
    try:
        yield
    finally:
        rospy.signal_shutdown('done')
        screen.end(launch)


class Film:
    """The pictures of RViz, one after the other."""

    def __init__(self, screen):
        self.screen = screen
        self.last = None

    def next(self):
        """The next picture, once it differs from the last one and no longer changes."""
        grabbed = [None, self.screen.pixels()]

        def still():
            grabbed[:] = grabbed[1], self.screen.pixels()
            before, now = (pixels[VIEW] for pixels in grabbed)
            return numpy.array_equal(before, now) and (
                self.last is None or not numpy.array_equal(now, self.last[VIEW]))
        wait_for(still, 'RViz shows the next picture')
        self.last = grabbed[1]
        return self.last


def shows_disks(screen):
    """Whether there are coloured pixels in the middle of the window."""
    middle = screen.pixels()[300:500].astype(int)
    return (middle.max(axis=2) - middle.min(axis=2) > 60).sum() > 100


def write(pixels, path, *operations):
    """Writes a picture as PNG. @param operations of convert(1)"""
    height, width, _ = pixels.shape
    with writing(path) as part:
        subprocess.run(['convert', '-size', f'{width}x{height}', '-depth', '8', 'rgb:-', *operations, f'png:{part}'],
                       input=pixels.tobytes(), check=True)


def take(options, frames):
    """Steps through the run; writes the still, and every frame into a directory."""
    with master(frames), VirtualScreen() as screen, paused_sieve(screen, options):
        setpoint = rospy.Publisher('/sieve/inclination_setpoint', Float64, queue_size=1, latch=True)
        step = rospy.ServiceProxy('/sieve/step', StepSimulation)
        step.wait_for_service()
        wait_for(lambda: setpoint.get_num_connections() > 0, 'the sieve takes setpoints')
        if options.begin > 0.0:
            step(options.begin)
        wait_for(lambda: shows_disks(screen), 'RViz shows the disks')
        setpoint.publish(options.inclination)
        film = Film(screen)
        for k in range(round(options.duration * options.rate)):
            write(film.next()[VIEW], frames / f'{k:05}.png', '-resize', f'{options.width}x', '+repage')
            if k == round(options.still * options.rate):
                write(film.last, options.out.with_suffix('.png'))
            step(1.0 / options.rate)


def main():
    options = arguments()
    with tempfile.TemporaryDirectory() as scratch:
        frames = Path(scratch)
        take(options, frames)
        with writing(options.out.with_suffix('.gif')) as part:
            subprocess.run(['convert', '-delay', str(round(100.0 / options.rate)), '-loop', '0',
                            *map(str, sorted(frames.glob('*.png'))), '+dither', '-colors', str(COLOURS),
                            '-fuzz', '1%', '-layers', 'optimize-transparency', '+fuzz', '-layers', 'optimize',
                            f'gif:{part}'], check=True)


if __name__ == '__main__':
    main()
