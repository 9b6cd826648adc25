"""The law of a second controller, without ROS: it holds a purity by what a counter and a scale at the right end say."""
from collections import deque

AGREE = 2.0  # what was counted and what was weighed differ by less than this factor
LEAST = 0.1  # kg in a window, from which on they are compared


class Holder:
    """A PI controller of the share of the first species in what leaves on the right within `window` [s].

    Gain and integral time by the rules of S. Skogestad, J. Process Control 13, 291 (2003). Where counter and scale
    contradict each other, or one falls silent, it goes to the level base and stays there: `fault` says why."""

    def __init__(self, purity, masses, gain=0.4, integral_time=6.0, window=10.0, limit=0.2):
        """@param masses of a disk of each species [kg] @param gain [rad] @param limit of the inclination [rad]"""
        self.purity, self.masses, self.gain, self.integral_time = purity, masses, gain, integral_time
        self.window, self.limit = window, limit
        self.begin()

    def begin(self):
        self.inclination = self.integral = self.time = 0.0
        self.fault, self.past, self.said = None, deque(), {}

    def take(self, sensor, time, value):
        """@param sensor count or scale @param time of the measurement [s] @param value numbers of disks, or kg
        @return the inclination [rad]; None: the other sensor's reading of this time is still to come"""
        if time < self.time:  # the sieve was reset
            self.begin()
        self.said[sensor] = time, value
        (counted_at, counts), (weighed_at, mass) = (self.said.get(name, (0.0, None)) for name in ('count', 'scale'))
        if abs(counted_at - weighed_at) > self.window:
            self.fault = 'a sensor is silent'
        elif counted_at != weighed_at or counts is None or mass is None:
            return None
        else:
            self.decide(time, counts, mass)
        self.time = time
        return 0.0 if self.fault else self.inclination

    def decide(self, time, counts, mass):
        self.past.append((time, counts, mass))
        while time - self.past[0][0] > self.window:
            self.past.popleft()
        start, counts_then, mass_then = self.past[0]
        left = [now - then for now, then in zip(counts, counts_then)]
        counted, weighed = sum(n * m for n, m in zip(left, self.masses)), mass - mass_then
        # Not "outside": NaN, too, is a fault.
        if not (max(counted, weighed) < LEAST or weighed / AGREE < counted < weighed * AGREE):
            self.fault = f'{counted:.2f} kg counted, {weighed:.2f} kg weighed since {start:.1f} s'
        if self.fault or time - start < self.window or not any(left):
            return
        error = self.purity - left[0] / sum(left)
        self.integral += self.gain / self.integral_time * error * (time - self.time)
        self.integral = min(max(self.integral, 0.0), self.limit)
        self.inclination = min(max(self.integral + self.gain * error, 0.0), self.limit)
