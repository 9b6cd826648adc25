"""Which settings to run next: until the best is known, or cannot be told from others by more than is wanted.

A surface is fitted to all runs. The best place is where it is highest. As long as any other place may be better by more
than `within`, at 95 % of all places together, the one which may be so most, over what it costs, or else the best
itself, whichever is known less, is run next (LUCB, Kalyanakrishnan et al., ICML 2012, with a Gaussian process in place
of single arms).
"""
import itertools
import os
import time

import numpy as np
import pandas

from ratchet_sieve.answers.machine import CUT, LEAST_RESIDENCES, LONGEST, RESIDENCES
from ratchet_sieve.answers.places import spread
from ratchet_sieve.answers.surface import Surface
from ratchet_sieve.arguments import integer

Z = 1.96          # normal quantile of 95 %, two-sided
ANYWHERE = 2.5    # the same for all places together, of which about four tell nothing about each other
BATCH = 8         # runs at a time; the same on any number of cores, so that the answer is the same
FIRST = {1: 11, 2: 32}  # places that are run first, of one and two ranges; more ranges: 16 each
GRID = {1: 81, 2: 33}   # candidates along each of one and two ranges
CANDIDATES = 2048       # of more ranges
MOST = 400        # runs of a search
NEIGHBOURS = (0.08, 0.04)  # of a range: so far from the best its neighbours are run before the search ends
COSTLIEST = 200.0  # events that a simulated second may take, over the median of the first runs: a nearly choked base
SHAPE = ("base.teeth", "base.tooth", "base.asymmetry", "base.length", "base.phase")  # does not decide what is thrown
RATES = 20.0      # scale of the logarithm of that: of its surface over the ranges
RATES_VARIANCE = 0.1  # of what one run says of it
OPEN_COST = 20.0  # of a run where the machine has not settled, over Machine.usual_events() of others
LONG_COST = 50.0  # of a run that is longer than the shortest, over the median of the first runs
UNSEEN_COST = 8.0  # the same where no run has been: the machine may fill up there
SEEDS = 1_000_000  # of the scenes between two seeds of the search; the second half of them is for fresh runs
MOST_SEED = 10 ** 12
UNKNOWN_ERRORS = 3.0  # standard deviation of the logarithm of their variance, for a goal of the user's
NEAR = 1e-12      # squared distance of a place from itself
LIFT_OFF = 1.1    # peak acceleration, over gravity, below which a machine that works may fill up after minutes
SINGLE = 1.0      # variance of the separation, times the disks that have left


class Search:
    """@ivar runs a row for each run so far
    @ivar grid places that may be chosen; best the number of the best; value and error of the surface at each; `may`,
    by how much each may be better than the best; `works`, whether the machine does or a longer run may show it; `why`
    not; bound of the value anywhere
    @ivar idle places that are left out: their drive throws no disk up
    @ivar is_cut_short whether the best must be a place where a run has settled, for none will be run to see it
    @ivar deadline of time.monotonic(), at which runs end, or None. @ivar show function of a text about the runs"""

    def __init__(self, machine, within, seed, deadline=None, **options):
        """@param options of Machine.run()"""
        self.machine, self.within, self.deadline, self._options = machine, within, deadline, options
        self.seed = seed_of(seed)
        self.runs = pandas.DataFrame()
        self._places = np.empty((0, len(machine.keys)))
        places = _different(machine, _grid(len(machine.keys)))
        lifts = _lifts(machine, places)
        thrown = (lifts >= 1.0) | (lifts < 1.0).all()
        self.grid, self.idle = places[thrown], places[~thrown]
        # Near lift-off a setting must be better by `within` to be the best.
        self._handicap = within * ((lifts[thrown] < LIFT_OFF) & (machine.kind == "fed"))
        self._surface = None
        self._costs = Surface(len(machine.keys), RATES)
        self.rounds = 0
        self.show = lambda done: None
        self.is_cut_short = False
        self._first = None
        self._closed = {}

    def close(self, why):
        """Leaves the best out: its fresh runs say that it is none."""
        self._closed[self.best] = why

    @property
    def threads(self):
        return self._options.get("threads") or os.cpu_count()

    def first(self):
        """The places that are run first, spread over the ranges; those of any number that come first are so as well."""
        if self._first is None:
            ranges = len(self.machine.keys)
            count = FIRST.get(ranges, 16 * ranges)
            if ranges == 1:
                steps = np.linspace(0, len(self.grid) - 1, count).round().astype(int)
                self._first = np.array(list(dict.fromkeys(steps[k] for k in _halving(count))))
            else:
                places = (self._nearest(place) for place in spread(ranges, 8 * count, self.seed)
                          if not len(self.idle) or _distance(self.grid, place) <= _distance(self.idle, place))
                self._first = np.array(list(dict.fromkeys(itertools.islice(places, count))))
        return self._first

    def part(self, chosen):
        """@param chosen of the grid, a mask @return how much of the ranges that is"""
        return chosen.sum() / (len(self.grid) + len(self.idle))

    def measure(self, chosen, durations):
        """@param chosen numbers of places. @param durations of their runs, in units of the shortest"""
        self.rounds += 1
        durations = np.asarray(durations, dtype=float)
        counts = np.ones(len(chosen), dtype=int)
        if self.machine.kind != "fed":  # more runs in place of longer ones
            counts, durations = np.maximum(durations.round().astype(int), 1), np.ones(len(chosen))
        for k in range(counts.max()):
            picked = counts > k
            self._add(self.grid[chosen[picked]], self.machine.shortest * durations[picked],
                      (self.seed + 100 * self.rounds + k, 1))

    def unsettled(self):
        """@return numbers of the places whose last run was too short to say anything, and how long the next one is to
        be, over the shortest; none where most of the others do say something"""
        seen = self.machine.observed(self.runs)
        last = dict(zip(map(self._nearest, self._places), self._longer(seen)))
        open_ = [k for k, units in last.items() if np.isfinite(units)]
        if 2 * len(open_) <= int(seen["value"].notna().sum()):
            return np.array([], dtype=int), []
        return np.array(open_), [last[k] for k in open_]

    def _longer(self, seen):
        """Machine.longer() of each run."""
        return self.machine.longer(self.runs, seen, OPEN_COST * self.machine.usual_events(seen.head(len(self.first()))))

    def _run(self, places, durations, seeds, *others):
        budget = None if self.deadline is None else max(self.deadline - time.monotonic(), 0.0)
        return self.machine.run(places, durations, seeds, *others, budget=budget,
                                progress=lambda done, failed, count: self.show(f"{done + failed} of {count}"),
                                **self._options)

    def _add(self, places, durations, seeds, observe=()):
        rows = self._run(places, durations, seeds, observe)
        if len(rows):
            both = (np.vstack([self._places, places[rows.index.to_numpy() // seeds[1]]]),
                    pandas.concat([self.runs, rows], ignore_index=True))
            self._places, self.runs = both  # at once: Ctrl-C comes between two lines
        return rows

    def fresh(self, runs, duration):
        """Runs the best place with seeds that no run has had. @return their rows"""
        at = self.grid[self.best]
        known = self.runs["seed"][self.runs["seed"] >= self.seed + SEEDS // 2]
        first = self.seed + SEEDS // 2 if known.empty else int(known.max()) + 1
        observe = ("mass_flow",) if self.machine.kind == "poured" else ()
        return self._add(at[None], [duration], (first, runs), observe)

    def lowered(self, changes, runs, fresh):
        """Runs of the best place with other values of keys, as long as the fresh ones. @return their rows"""
        duration = fresh["duration"].iloc[0] if "duration" in fresh else self.machine.shortest
        return self._run(self.grid[self.best][None], [duration], (self.seed + SEEDS // 2, runs), (), changes)

    def screened(self, unknown, duration):
        """Runs of the best place, one with each row of what is taken as unknown. @return their rows"""
        count = len(unknown.table)
        first = -(-(self.seed + 3 * SEEDS // 4) // count) * count  # a multiple: each row once
        return self._run(self.grid[self.best][None], [duration], (first, count), (), None, unknown)

    def assess(self, best=None):
        """Fits the surface. @param best the place that others are compared with; None: the highest
        @return whether the machine works anywhere"""
        if not len(self.runs):
            return False
        seen = self.machine.observed(self.runs)
        defined = seen["value"].notna().to_numpy()
        longer = self._longer(seen)
        may_work = defined | np.isfinite(longer)
        # Of several runs of a place the last, which is the longest; one that was cut before it says anything last.
        distance = ((self.grid[:, None] - self._places[None, ::-1]) ** 2).sum(axis=-1)
        distance += 0.5 * NEAR * (seen["why"] == CUT).to_numpy()[::-1]
        nearest = len(self._places) - 1 - distance.argmin(axis=1)
        self.works, self.why = may_work[nearest], seen["why"].to_numpy()[nearest]
        for k, reason in self._closed.items():
            self.works[k], self.why[k] = False, reason
        self.last = nearest  # the run that tells of each place
        self._waits = np.where(defined[nearest] | ~self.works, 0.0, longer[nearest])
        self._residence = seen["residence"].to_numpy()[nearest]
        self._rate = self._rates(seen["rate"].to_numpy())
        self._usual = float(seen["rate"].head(len(self.first())).median())
        self.too_costly = self.works & (self._rate > COSTLIEST * self._usual)
        self.works = self.works & ~self.too_costly
        if not self.works.any() or len(np.unique(self._places[defined], axis=0)) < 2:
            return False
        variances = seen["variance"].to_numpy()[defined]
        weights = 1.0 / variances
        # The variance of a run times its disks.
        self._single = SINGLE if self.machine.is_signed else \
            float(np.median(variances * self.machine.rate * self.runs["simulated_time"].to_numpy()[defined]))
        places, group = np.unique(self._places[defined], axis=0, return_inverse=True)
        total = np.bincount(group, weights)
        values = np.bincount(group, weights * seen["value"].to_numpy()[defined]) / total
        if self._surface is None:
            is_share = self.has_errors and self.machine.kind != "closed"
            self._surface = Surface(self.grid.shape[1], 1.0 if is_share else 10.0 * values.std() or 1.0,
                                    **({} if self.has_errors and not self.machine.unknown else
                                       {"error_spread": UNKNOWN_ERRORS}))
        self._known = places, (1.0 if self.has_errors else values.var()) / total
        self._surface.fit(places, values, self._known[1])
        self.value, self._variance, self._half = self._surface.at(self.grid)
        self.error = np.sqrt(self._variance)
        height = np.abs(self.value) if self.machine.is_signed else self.value
        self._is_seen = distance.min(axis=1) < NEAR
        settled = self.works & defined[nearest] & (self._is_seen | (not self.is_cut_short))
        height = np.where(settled if settled.any() else self.works, height - self._handicap, -np.inf)
        self.best = int(height.argmax()) if best is None else best
        self.may = self._may(self._variance, self._half)
        up = np.copysign(1.0, self.value[self.best]) if self.machine.is_signed else 1.0
        # By how much the best may be better than each: by no more than all of it, where that is not below 0.
        whole = abs(self.value[self.best]) + Z * self.error[self.best]
        loss = self.may - 2.0 * up * (self.value - self.value[self.best])
        self.loss = np.clip(loss + self._handicap - self._handicap[self.best], 0.0,
                            whole if self.machine.is_signed or self.machine.share_goal else np.inf)
        self.bound = float((np.abs(self.value) + ANYWHERE * self.error)[self.works].max())
        return True

    @property
    def has_errors(self):
        """Whether each run's error is known, rather than how it falls with the run's length."""
        return self.machine.is_signed or self.machine.share_goal is not None

    def _rates(self, seen):
        """The events that a simulated second takes at each place, one standard error above what a surface expects."""
        places, group = np.unique(self._places, axis=0, return_inverse=True)
        logs = np.bincount(group, np.log(seen)) / np.bincount(group)
        self._costs.fit(places, logs, np.full(len(places), RATES_VARIANCE))
        value, variance, _ = self._costs.at(self.grid)
        return np.exp(value + np.sqrt(variance))

    def _may(self, variance, half):
        """By how much each place may be better than the best, at 95 % of all places together, less its handicap."""
        covariance, k = self._surface.covariance_with(self.grid, half, self.best), self.best
        up = 1.0 if self.value[k] >= 0.0 or not self.machine.is_signed else -1.0
        spread = variance + variance[k]
        may = up * (self.value - self.value[k]) + ANYWHERE * np.sqrt(np.maximum(spread - 2.0 * covariance, 0.0))
        if self.machine.is_signed:  # the kinds may part the other way round
            other = -up * (self.value + self.value[k]) + ANYWHERE * np.sqrt(np.maximum(spread + 2.0 * covariance, 0.0))
            may = np.maximum(may, other)
        return np.where(self.works, may - self._handicap + self._handicap[k], -np.inf)

    def nowhere(self):
        """Whether the value is surely small everywhere."""
        return self.machine.is_signed and self.bound < 0.5 * self.within

    def chosen(self):
        """@return the numbers of the places to run next, and how long; none: the search has ended"""
        units = self._units()
        if self.nowhere() or len(self.runs) >= MOST or self.is_late():
            return np.array([], dtype=int), []
        picks = self._challengers(units)
        if not picks:
            picks = dict.fromkeys(self._neighbours(), 2)
        return np.array(list(picks), dtype=int), [units[k] * count for k, count in picks.items()]

    def _units(self):
        """The duration of a run at each place, over the shortest one."""
        if self.machine.kind != "fed":
            return np.ones(len(self.grid))
        stay = self._residence / self.machine.shortest
        wanted = np.clip(LONG_COST * self._usual / self._rate, LEAST_RESIDENCES * stay, RESIDENCES * stay)
        return np.clip(np.maximum(wanted, self._waits), 1.0, LONGEST)

    def _challengers(self, units):
        """@return map from the number of a place to its runs"""
        cost = self._rate * units
        most = np.maximum(np.where(self._is_seen, LONG_COST, UNSEEN_COST) * self._usual / cost, 1.0)
        picks, variance, half = {}, self._variance, self._half
        may, error = self.may, self.error
        sign_is_known = abs(self.value[self.best]) > ANYWHERE * error[self.best]
        for _ in range(BATCH):
            over = may / self.within - 1.0
            if self.machine.is_signed and not sign_is_known:
                over = np.maximum(over, (np.abs(self.value) + ANYWHERE * error) / (0.5 * self.within) - 1.0)
            over = np.where(self.works & (most >= 1.0), over, 0.0)
            if over.max() <= 0.0:
                break
            k = int(np.where(over > 0.0, (over + 0.2) / cost, 0.0).argmax())
            if error[self.best] > error[k] and most[self.best] >= 1.0:
                k = self.best
            picks[k] = picks.get(k, 0) + 1
            most[k] -= 1.0
            variance, half = self._surface.after(self.grid, variance, half, k, self._error_of(k, units[k]))
            may, error = self._may(variance, half), np.sqrt(variance)
        return picks

    def _error_of(self, k, unit):
        """The variance that a run at a place is expected to have."""
        if self.machine.kind == "fed" and self.has_errors:
            return self._single / (self.machine.rate * self.machine.shortest * unit)
        return float(np.median(self._known[1]))

    def _neighbours(self):
        """Those of the best that no run has come near, the far ones first: else a narrow ridge would be missed."""
        directions = np.vstack([np.eye(self.grid.shape[1]), -np.eye(self.grid.shape[1])])  # along one range each
        for far in NEIGHBOURS:
            beside = dict.fromkeys(self._nearest(place) for place in
                                   np.clip(self.grid[self.best] + far * directions, 0.0, 1.0))
            found = [k for k in beside if self.works[k] and not self._is_known(k, far)]
            if found:
                return found
        return []

    def _is_known(self, k, far):
        """Whether runs within half the distance have told the value at a place."""
        places, variances = self._known
        near = np.abs(places - self.grid[k]).max(axis=1) < 0.5 * far
        return bool((variances[near] < self.within ** 2).any())

    def _nearest(self, place):
        return int(np.abs(self.grid - place).sum(axis=1).argmin())

    def final_duration(self, runs, error, residences):
        """Of so many runs of the best, of which the mean has about this standard error; only a fed machine takes it."""
        if self.machine.kind != "fed":
            return self.machine.shortest
        single = self._single if self.has_errors else \
            self._known[1].max() * self.machine.rate * self.machine.shortest
        return max(single * max(self._surface.excess, 1.0) / error ** 2 / self.machine.rate / runs,
                   residences * self._residence[self.best], self.machine.shortest)

    def affordable(self, runs, deadline):
        """The duration of so many runs of the best that end by a deadline, by what the runs so far took [s]."""
        events = self.runs["events"].sum() / self.runs["wall_time"].sum() * self.threads * (deadline - time.monotonic())
        return events / self._rate[self.best] / runs

    def is_late(self):
        return self.deadline is not None and time.monotonic() > self.deadline


def usual_length(machine, rows):
    """How long a run must be in the middle of some of a fed machine, over the shortest."""
    if machine.kind != "fed" or not len(rows):
        return 1.0
    units = machine.longer(rows, machine.observed(rows))
    return max(float(np.median(np.where(np.isfinite(units), units, rows["duration"] / machine.shortest))), 1.0)


def seed_of(seed):
    """The first seed of a search's scenes. Raises ValueError."""
    if integer("seed", seed) > MOST_SEED:
        raise ValueError(f"seed = {seed}: must be an integer, 0 to {MOST_SEED}")
    return SEEDS * seed


def _different(machine, places):
    """Of places with the same settings, as of whole numbers, the first."""
    settings = [tuple(machine.settings(place).values()) for place in places]
    return places[sorted({setting: k for k, setting in reversed(list(enumerate(settings)))}.values())]


def _lifts(machine, places):
    """Machine.lift() of each place."""
    shape = SHAPE + (("base.inclination",) if machine.scene.values["base"].get("drive_frame") != "base" else ())
    decide = [k for k, key in enumerate(machine.keys)
              if key == "gravity" or key.startswith("base.") and not key.startswith(shape)]
    _, one, group = np.unique(places[:, decide], axis=0, return_index=True, return_inverse=True)
    return np.array([machine.lift(places[k]) for k in one])[group.ravel()]


def _distance(places, place):
    return np.abs(places - place).sum(axis=1).min()


def _halving(count):
    """The numbers below a count: ends first, then the middles of what is left."""
    order, spans = [0, count - 1], [(0, count - 1)]
    for low, high in spans:
        middle = (low + high) // 2
        if low < middle < high:
            order.append(middle)
            spans += [(low, middle), (middle, high)]
    return order


def _grid(ranges):
    if ranges in GRID:
        axes = np.meshgrid(*[np.linspace(0.0, 1.0, GRID[ranges])] * ranges, indexing="ij")
        return np.stack(axes, axis=-1).reshape(-1, ranges)
    return spread(ranges, CANDIDATES, 0)
