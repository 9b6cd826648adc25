#!/usr/bin/python3
"""Searches for the inclination at which a running, fed sieve separates best, and holds it.

Usage: rosrun ratchet_sieve seek.py [_PARAMETER:=VALUE]... [ROS ARGUMENT...]

Publishes every trial on ~trials (ratchet_sieve/SeekTrial). What it does and its limits: docs/seeking.md.

Parameters (all times are simulated):
  ~sieve                   name of the sieve's node (default: sieve)
  ~goal                    what is maximised: quality; purity:SPECIES:BIN, its share of the bin;
                           recovery:SPECIES:BIN, the bin's share of what leaves of the species; flow:SPECIES:BIN,
                           throughput (all that leaves) [1/s]. BIN: left or right; with :mass at the end by mass
                           [kg/s] (default: quality)
  ~inclination/start       first inclination [rad] (default: the present one)
  ~inclination/min, max    range of the search [rad] (default: the limits of the sieve)
  ~inclination/step        of the scan, at most [rad] (default: 0.1)
  ~inclination/resolution  smallest step [rad] (default: 0.02)
  ~dwell                   wait after the inclination is reached, before counting [s] (default: 4)
  ~window                  least time of counting [s] (default: 4)
  ~least_disks             of each species that are counted, for which the window is extended (default: 100)
  ~longest_window          longest time of counting [s] (default: 60)
  ~confidence              difference at which one inclination is better than another [standard errors]; at a
                           smaller one the trial is repeated (default: 1.5)
  ~most_trials             trials at one inclination before it is decided anyway (default: 3)
  ~drop                    decrease at the best inclination that restarts the search; of flow and throughput
                           relative to the best (default: 0.15)

Exit status: 0 if it is stopped; 2 for a bad parameter.

An example of a node that controls a sieve, to be copied: Trial knows when to count, Search what to try next, and
Node connects them to ROS.
"""
import math
import sys
import threading
import time

import numpy as np
import rospy
import yaml
from std_msgs.msg import Float64

from ratchet_sieve.goals import LEFT, ON_BASE, RIGHT, Goal
from ratchet_sieve.msg import BaseState, BinCounts, SceneDescription, SeekTrial, SieveStatistics

# name: (default, least, most)
PARAMETERS = {'inclination/step': (0.1, 1e-3, 1.0), 'inclination/resolution': (0.02, 1e-4, 1.0),
              'dwell': (4.0, 0.0, 1e6), 'window': (4.0, 0.0, 1e6), 'least_disks': (100, 1, 1e9),
              'longest_window': (60.0, 0.0, 1e6), 'confidence': (1.5, 0.0, 10.0), 'most_trials': (3, 1, 1000),
              'drop': (0.15, 0.0, 1.0)}

REACHED = 1e-6  # the base is at its setpoint [rad, Hz, m]
DROPS = 2  # worse windows in a row that restart the search; a single one may be chance
SEPARATES = 3.0  # standard errors above 0: of eleven trials of noise one exceeds them in 3 % of all searches
REPEAT_AFTER = 0.5  # a setpoint that the sieve does not show is sent again [s of wall time]
SILENT_AFTER = 10.0  # [s of wall time]


def left_between(first, last):
    """What left between two messages of the bins: per species the columns of ratchet_sieve.goals."""
    table, before = (np.array([bins.left, bins.right, bins.on_base, bins.left_mass, bins.right_mass], dtype=float).T
                     for bins in (last, first))
    before[:, ON_BASE] = 0.0
    return table - before


def measure(goal, bins, duration):
    """@return value, standard error, whether it is defined"""
    return tuple(column.item() for column in goal.measured(bins[np.newaxis], np.array([duration])))


class Trial:
    """What leaves a sieve at one inclination. It goes by the times in the messages alone."""

    def __init__(self, options, inclination):
        self.options, self.inclination = options, inclination
        self.last = None
        self.interrupt()

    def interrupt(self):
        """The sieve was reset: begins again."""
        self.base_time = -math.inf
        self.standing_since = self.first = None  # time since when the base is there; the bins as the window began
        self.temperatures = []

    def begin(self, inclination):
        """At the inclination of the trial before, the window goes on where that one ended."""
        self.first = self.last
        self.temperatures = []
        if inclination != self.inclination:
            self.standing_since = self.first = None
        self.inclination = inclination

    def take_base(self, base):
        if base.time < self.base_time:
            self.interrupt()
        self.base_time = base.time
        if any(abs(one - other) > REACHED for one, other in (
                (base.inclination, self.inclination), (base.commanded_inclination, self.inclination),
                (base.frequency, base.commanded_frequency), (base.amplitude, base.commanded_amplitude))):
            self.standing_since = self.first = None
        elif self.standing_since is None:
            self.standing_since = base.time

    def take_statistics(self, statistics):
        if self.first:
            self.temperatures.append([species.granular_temperature for species in statistics.species])

    def take_bins(self, bins):
        """@return what left and in how many seconds, once the window is over"""
        if self.standing_since is None or bins.time < self.standing_since + self.options['dwell']:
            return None
        self.first = self.first or bins
        left, duration = left_between(self.first, bins), bins.time - self.first.time
        if duration < 0.0 or (left < 0.0).any():
            self.interrupt()
            return None
        counted = left[:, LEFT] + left[:, RIGHT]
        if duration < self.options['window'] or not counted.any() or (
                counted.min() < self.options['least_disks'] and duration < self.options['longest_window']):
            return None
        self.last = bins
        return left, duration


class Search:
    """Decides which inclination to try next, from what left at those tried so far: scans the range in steps, goes on
    around the best one with smaller steps, and holds the best. Counts at the same inclination are added."""

    def __init__(self, options, goal, low, high, start):
        self.options, self.goal, self.low, self.high = options, goal, low, high
        self.begin(min(max(start, low), high))

    def begin(self, start):
        """A new search, which knows nothing."""
        self.start = self.next = self.best = start
        self.phase, self.drops = 'scan', 0
        self.step = self.options['inclination/step']
        self.tried = {}  # inclination: what left, in how many seconds, in how many trials
        self.scan = [round(inclination, 9) for side in (
            (*np.arange(start + self.step, self.high - REACHED, self.step), self.high),
            (*np.arange(start - self.step, self.low + REACHED, -self.step), self.low))
            for inclination in side if abs(inclination - start) > REACHED]

    def take(self, left, duration):
        """Takes what left in a trial at `next`. @return whether the search began anew, since it is worse than before"""
        self.drops = self.drops + 1 if self.phase == 'hold' and self.is_worse(left, duration) else 0
        anew = self.drops == DROPS
        if anew:
            self.begin(self.next)
        if self.next in self.tried:
            before, seconds, trials = self.tried[self.next]
            before[:, ON_BASE] = 0.0
            self.tried[self.next] = (before + left, seconds + duration, trials + 1)
        else:
            self.tried[self.next] = (left, duration, 1)
        if self.phase in ('scan', 'refine'):
            self.choose()
        return anew

    def choose(self):
        """Sets the phase, the best inclination and the next one."""
        before, self.best = self.best, max(self.tried, key=self.at_least)
        if self.scan:
            self.next = self.scan.pop(0)
            return
        width = self.options['inclination/step']
        if self.phase == 'scan' or abs(self.best - before) > width:
            self.step = width / 2.0
        self.phase = 'refine'
        self.next = self.rival(width)
        if self.next is None and self.goal.measure == 'quality' and not self.separates():
            self.next = self.again([self.best])
            if self.next is None:
                self.phase, self.next, self.best = 'nothing', self.start, self.start
            return
        while self.next is None and self.step >= self.options['inclination/resolution']:
            self.next = self.beside()
            if self.next is None:
                self.step /= 2.0
        if self.next is None:
            self.phase, self.next = 'hold', self.best

    def rival(self, width):
        """@return to be tried again, if another maximum may be as high as the best one"""
        return self.again(one for one in self.tried if abs(one - self.best) > width + REACHED)

    def beside(self):
        """@return to be tried at this step, on both sides of the best; None: the best is the best"""
        sides = [round(min(max(self.best + sign * self.step, self.low), self.high), 9) for sign in (1.0, -1.0)]
        untried = [one for one in sides if one not in self.tried]
        if untried or self.step / 2.0 >= self.options['inclination/resolution']:
            return untried[0] if untried else None
        return self.again(one for one in sides if one != self.best)

    def again(self, inclinations):
        """@return the first that is neither better nor worse than the best, or the best if that was tried less often"""
        value, error, _ = self.measured(self.best)
        for one in inclinations:
            other, other_error, defined = self.measured(one)
            lesser = min(one, self.best, key=lambda inclination: self.tried[inclination][2])
            if (defined and abs(other - value) <= self.options['confidence'] * math.hypot(error, other_error)
                    and self.tried[lesser][2] < self.options['most_trials']):
                return lesser
        return None

    def measured(self, inclination):
        return measure(self.goal, *self.tried[inclination][:2])

    def at_least(self, inclination):
        """The goal's value, with confidence: a few disks are no reason to call an inclination the best."""
        value, error, defined = self.measured(inclination)
        return value - self.options['confidence'] * error if defined else -math.inf

    def separates(self):
        value, error, defined = self.measured(self.best)
        return defined and value > SEPARATES * error

    def is_worse(self, left, duration):
        now, before = measure(self.goal, left, duration), self.measured(self.best)
        drop = self.options['drop'] * (1.0 if self.goal.is_share else before[0])
        return now[0] < before[0] - max(drop, self.options['confidence'] * math.hypot(now[1], before[1]))


class Node:
    """Takes the sieve's topics, commands its inclination and publishes the trials."""

    def __init__(self):
        self.sieve = rospy.resolve_name(rospy.get_param('~sieve', 'sieve'))
        self.options = {name: number(name, *rest) for name, rest in PARAMETERS.items()}
        limits = [rospy.get_param(f'{self.sieve}/limits/inclination/{end}', usual) for end, usual in
                  (('min', -0.5), ('max', 0.5))]
        low = number('inclination/min', limits[0], *limits)
        self.limits = low, number('inclination/max', limits[1], low, limits[1])
        self.start = number('inclination/start', None, *self.limits)
        self.scene = self.goal = self.quality = self.drive = self.search = self.trial = self.error = None
        self.count, self.sent_at, self.heard_at = 0, -math.inf, time.monotonic()
        self.lock = threading.Lock()  # each topic has a thread
        self.trials = rospy.Publisher('~trials', SeekTrial, queue_size=100, latch=True)
        self.setpoint = rospy.Publisher(f'{self.sieve}/inclination_setpoint', Float64, queue_size=10)
        for topic, kind, take in (('scene', SceneDescription, self.take_scene), ('base', BaseState, self.take_base),
                                  ('bins', BinCounts, self.take_bins),
                                  ('statistics', SieveStatistics, self.take_statistics)):
            # The newest is all that is needed: bins are counted since the start.
            rospy.Subscriber(f'{self.sieve}/{topic}', kind, self.one_by_one, take, queue_size=1, tcp_nodelay=True)

    def one_by_one(self, message, take):
        with self.lock:
            self.heard_at = time.monotonic()
            take(message)

    def take_scene(self, message):
        scene = yaml.safe_load(message.yaml)
        for key in ('inclination', 'frequency', 'amplitude', 'phase'):  # as they are at present
            del scene['base'][key]
        if scene == self.scene:
            return
        names = [str(species['name']) for species in scene['species']]
        if scene['boundary'] != 'open' or len(names) < 2 or not scene['feed']['rate']:
            rospy.logwarn('%s: to be searched, it needs an open base, two species and a feed', self.sieve)
        try:
            self.goal, self.quality = Goal(rospy.get_param('~goal', 'quality'), names), Goal('quality', names)
        except ValueError as error:
            self.error = f'parameter {rospy.resolve_name("~goal")}: {error}'
            rospy.signal_shutdown(self.error)
        if self.search:
            self.search.goal = self.goal
            self.begin_anew('scene')
        self.scene = scene

    def take_base(self, base):
        if not self.goal:
            return
        if not self.search:
            start = base.commanded_inclination if self.start is None else self.start
            self.search = Search(self.options, self.goal, *self.limits, start)
            self.trial = Trial(self.options, self.search.next)
            rospy.loginfo('%s: searching from %g to %g rad, by %s', self.sieve, *self.limits, self.goal.text)
        drive = base.commanded_frequency, base.commanded_amplitude
        if self.drive not in (None, drive):
            self.begin_anew('drive')
        self.drive = drive
        was_reset = base.time < self.trial.base_time
        self.trial.take_base(base)
        if abs(base.commanded_inclination - self.search.next) > REACHED and (
                was_reset or time.monotonic() > self.sent_at + REPEAT_AFTER):
            self.command()

    def begin_anew(self, what):
        rospy.logwarn('the %s of %s has changed: the search restarts at %.4f rad', what, self.sieve, self.search.next)
        self.search.begin(self.search.next)
        self.trial.interrupt()

    def command(self):
        self.setpoint.publish(self.search.next)
        self.sent_at = time.monotonic()

    def take_statistics(self, statistics):
        if self.trial:
            self.trial.take_statistics(statistics)

    def take_bins(self, bins):
        result = self.trial and self.trial.take_bins(bins)
        if not result:
            return
        search, inclination, phase = self.search, self.search.next, self.search.phase
        if search.take(*result):
            rospy.logwarn('%s separates worse than before: the search restarts at %.4f rad', self.sieve, inclination)
        self.publish(inclination, phase, bins, *result)
        if search.phase == 'nothing' != phase:
            rospy.logwarn('nothing separates here: no trial from %g to %g rad is distinguishable from 0; holding %.4f '
                          'rad', *self.limits, search.next)
        self.trial.begin(search.next)
        if search.next != inclination:
            self.command()

    def publish(self, inclination, phase, bins, left, duration):
        self.count += 1
        search, best = self.search, self.search.tried[self.search.best][:2]
        fallen = left[:, (LEFT, RIGHT)].astype(int)
        counted = fallen[fallen.sum(axis=1) > 0]
        trial = SeekTrial(
            header=bins.header, time=bins.time, begin=bins.time - duration, trial=self.count, phase=phase,
            inclination=inclination, goal=self.goal.text, species=bins.species, left=fallen[:, 0].tolist(),
            right=fallen[:, 1].tolist(), on_base=bins.on_base,
            balance=((counted[:, 1] - counted[:, 0]) / counted.sum(axis=1)).mean(), best_inclination=search.best,
            next_phase=search.phase, next_inclination=search.next)
        if self.trial.temperatures:
            trial.granular_temperature = np.mean(self.trial.temperatures, axis=0).tolist()
        for name, goal, of in (('value', self.goal, (left, duration)), ('quality', self.quality, (left, duration)),
                               ('best_value', self.goal, best), ('best_quality', self.quality, best)):
            for field, number_of in zip((name, f'{name}_error', f'{name}_defined'), measure(goal, *of)):
                setattr(trial, field, number_of)
        self.trials.publish(trial)
        fell = ', '.join(f'{name} {a} left {b} right' for name, (a, b) in zip(bins.species, fallen))
        rospy.loginfo(f'trial {trial.trial}, {phase}: {inclination:.4f} rad, {trial.begin:.1f} to {trial.time:.1f} s: '
                      f'{trial.goal} {trial.value:.3g} +- {trial.value_error:.2g} ({fell}); best '
                      f'{trial.best_inclination:.4f} rad, {trial.best_value:.3g} +- {trial.best_value_error:.2g}; next '
                      f'{trial.next_phase} {trial.next_inclination:.4f} rad')


def number(name, default, least, most):
    """A private parameter. Raises ValueError."""
    value = rospy.get_param(f'~{name}', default)
    if value is not default and not (isinstance(value, (int, float)) and least <= value <= most):
        raise ValueError(f'parameter {rospy.resolve_name("~" + name)}: {value}: must be a number from {least:g} to '
                         f'{most:g}')
    return value


def main():
    if '--help' in sys.argv:
        print(__doc__)
        return 0
    rospy.init_node('seek')
    done = threading.Event()
    rospy.on_shutdown(done.set)
    try:
        node = Node()
        while not done.wait(SILENT_AFTER):
            if time.monotonic() > node.heard_at + SILENT_AFTER:
                rospy.logwarn('no message from %s for %g s: it is paused or not running', node.sieve, SILENT_AFTER)
        if node.error:
            raise ValueError(node.error)
    except ValueError as error:
        print(f'seek.py: {error}', file=sys.stderr)
        return 2
    return 0


if __name__ == '__main__':
    sys.exit(main())
