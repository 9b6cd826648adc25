"""The law of the controller, without ROS: it climbs to the inclination at which |s| of what leaves is largest."""


class Climber:
    """Goes on by `step` [rad] while |s| grows, and turns round when it falls.

    It waits `dwell` [s] after each step before it counts, so that the base arrives and earlier disks leave."""

    def __init__(self, step, dwell, limit=0.4):
        self.step, self.dwell, self.limit = step, dwell, limit
        self.begin()

    def begin(self):
        self.inclination = self.time = self.last = 0.0
        self.direction, self.count_from = 1, self.dwell

    def take(self, bins):
        """@param bins ratchet_sieve/BinCounts @return the inclination [rad]"""
        if bins.time < self.time:  # the sieve was reset
            self.begin()
        self.time = bins.time
        if bins.window_start >= self.count_from and bins.window_separation_defined:
            if abs(bins.window_separation) < self.last:
                self.direction = -self.direction
            self.last = abs(bins.window_separation)
            self.inclination = min(max(self.inclination + self.direction * self.step, -self.limit), self.limit)
            self.count_from = bins.time + self.dwell
        return self.inclination
