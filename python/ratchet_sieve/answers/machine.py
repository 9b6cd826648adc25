"""What is measured of a machine, by which runs, and how sure one run is of it."""
import numbers
import pathlib
import warnings

import numpy as np
import pandas

from ratchet_sieve import sweeps
from ratchet_sieve.answers.unknown import prior_of
from ratchet_sieve.arguments import mapping, number, path_of
from ratchet_sieve.errors import SceneError, SieveWarning, warn
from ratchet_sieve.goals import LEFT, LEFT_MASS, RIGHT, RIGHT_MASS, Goal
from ratchet_sieve.scene import scene_of
from ratchet_sieve.tables import writing

FED = 400              # disks that the shortest run of a fed machine is given
PERIODS = 40.0         # of the drive, in which a choked one is found to be so
RESIDENCES = 10.0      # mean times in the machine that a run of a fed machine lasts, once they are known
LEAST_RESIDENCES = 8.0  # a shorter one may not settle
LONGEST = 40.0         # such a run over the shortest one
GROWTH = 4.0           # a run that has not settled is run again longer by so much at most
MARGIN = 1.1           # of such a run's length, over what the run before it says is needed
GROWS = 2.0            # what a second costs once the machine has filled, over what it costs while it fills
FEWEST = 5             # disks of each species that must have left a poured machine
LEAST_WORKING = 0.8    # of the runs that judge a setting, which must say something
LEAST_PROCESSED = 0.5  # P of a poured machine that works
NOT_VARIED = ("seed", "duration", "settle")
NO_GOALS = ("seed", "wall_time", "events", "simulated_time", "physics")
SIDES = ("left", "right")
# Why a run says nothing.
FILLING, CHOKED, EMPTY = "still filling", "choked", "a bin stayed empty"
NOT_EMPTIED, FEW = "not emptied by half", "too few of its disks left"
CUT = "cut by the budget"
NO_DRIFT, FAILED = "too short to tell a mean velocity", "failed"
STEPS = 1000           # of a range at least, to which settings are rounded
WITHIN = {"fed": 0.02, "poured": 0.02, "closed": 0.001}  # closed: [m/s]
GOALS = {"fed": "separation", "poured": "separation", "closed": "difference of mean_vx"}


class Machine:
    """A scene, the ranges of its keys, and the number that is to be large: of an open machine the separation, of a
    closed one the difference of the species' mean velocities, or a column of a sweep's results.

    A fed machine is judged while it works: its runs are as long as they must be, whatever `duration` says. A poured
    one is judged after its duration, and so is a closed one.
    """

    def __init__(self, scene, over, goal=None, unknown=None):
        """@param unknown of which each run draws its own: as Prior takes it, or an Unknown. Raises ValueError,
        SceneError."""
        self.scene = scene_of(scene)
        self.unknown = prior_of(self.scene, unknown)
        if self.unknown:
            self.scene = self._changed(self.unknown.middle)
        self.keys = list(mapping("over", over, '{"base.inclination": (0.0, 0.35)}'))
        if not self.keys:
            raise ValueError('over: must name a range, such as {"base.inclination": (0.0, 0.35)}')
        ranges = [range_of(key, over[key]) for key in self.keys]
        self._require_numbers()
        for key in self.unknown.keys if self.unknown else ():
            if key in self.keys:
                raise ValueError(f"over[{key!r}]: is unknown as well")
        if dict(zip(self.keys, ranges)).get("feed.rate", (1.0,))[0] <= 0.0:
            raise ValueError("over['feed.rate']: must begin above 0")
        self.low, self.high = np.array(ranges, dtype=float).T
        self._decimals = [0 if self._is_whole(key, ends) else int(np.ceil(np.log10(STEPS / (ends[1] - ends[0]))))
                          for key, ends in zip(self.keys, ranges)]
        values = self.scene.values
        self.kind = "closed" if values["boundary"] != "open" else "fed" if values["feed"]["rate"] > 0.0 else "poured"
        if goal is not None and (not goal or not isinstance(goal, str)):
            self._refuse_goal(goal)
        self.goal = goal or GOALS[self.kind]
        self.is_signed = goal is None
        self._require_species()
        ends = [self._changed(self.settings(np.full(len(self.keys), corner))) for corner in (0.0, 1.0)]
        known, everywhere = ({text.rpartition("[")[2] for text in of.warnings} for of in (self.scene, ends[1]))
        for text in ends[0].warnings:  # of what is implausible at both ends, as of mm for m
            if text.rpartition("[")[2] in everywhere - known:
                warn(text)
        self.share_goal = _share_goal(self.goal, self.scene.species)
        self.rate = self._lowest("feed.rate", values["feed"]["rate"])  # of the feed [1/s]
        self.shortest = values["duration"]
        self.rarest = None  # (name, share) of a kind that makes runs long
        self.plain = self.shortest  # as long as the shortest would be without it
        if self.kind == "fed":
            shares = np.array([species["share"] for species in values["species"]])
            least = shares[shares > 0.0].min()
            if least < 0.5 * shares.mean():
                self.rarest = self.scene.species[int(np.flatnonzero(shares == least)[0])], least / shares.sum()
            known = PERIODS / max(self._lowest("base.frequency", values["base"]["frequency"]), 1.0)
            self.plain = values["settle"] + max(FED / self.rate, known)
            self.shortest = values["settle"] + max(FED * shares.mean() / least / self.rate, known)

    def _lowest(self, key, own):
        """Of a key's range, or the scene's own value."""
        return float(self.low[self.keys.index(key)]) if key in self.keys else own

    def _is_whole(self, key, ends):
        """Whether a key takes whole numbers alone. Raises SceneError if it takes neither end."""
        if not all(isinstance(end, numbers.Integral) for end in ends):
            return False
        self._changed({key: ends[0]})
        try:
            self._changed({key: ends[0] + 0.5})
        except SceneError:
            return True
        return False

    def _require_numbers(self):
        """Raises ValueError for a key that a search cannot vary."""
        for key in self.keys:
            try:
                value = self.scene[key]
            except KeyError:
                value = 0.0  # an optional key, or none at all, which the scene's reader will say
            if key in NOT_VARIED or isinstance(value, (bool, str, list, dict)):
                raise ValueError(f"over[{key!r}]: must be a key whose value is a number, other than "
                                 f"{', '.join(NOT_VARIED)}")

    def _require_goal(self, rows):
        """Raises ValueError."""
        if self.goal in NO_GOALS or self.goal not in rows or rows[self.goal].dtype == object:
            self._refuse_goal(self.goal)

    def _refuse_goal(self, goal):
        raise ValueError(f"goal = {goal!r}: must be a column of numbers of a sweep's results, such as "
                         f"purity.left.mass.{self.scene.species[0]}")

    def _require_species(self):
        species = self.scene.species
        if len({name.lower() for name in species}) < len(species):  # columns of results are those of SQLite
            raise ValueError(f"species: {', '.join(species)}: must have names that differ in more than case")
        if len(species) < 2:
            raise ValueError(f"species: {species[0]} is alone: there is nothing to separate it from")
        if self.is_signed and len(species) > 2:
            goals = [f"mean_vx.{name}" for name in species] if self.kind == "closed" else \
                [f"purity.{side}.mass.{name}" for name in species for side in ("left", "right")]
            raise ValueError(f"species: must be two, which are to be separated; there are {len(species)}: give a goal, "
                             f"one of {', '.join(goals)}" + ("" if self.kind == "closed" else
                                                             "; or with recovery in place of purity"))

    def settings(self, place):
        """@param place (d,) from 0 to 1 within the ranges. @return the value of each key"""
        values = self.low + np.asarray(place) * (self.high - self.low)
        return {key: round(float(value), decimals) + 0.0 if decimals else round(float(value))
                for key, value, decimals in zip(self.keys, values, self._decimals)}

    def place(self, settings):
        """@param settings value of each key, or of some: else the scene's own. @return (d,) from 0 to 1. Raises
        ValueError for one beyond its range, or of another key."""
        for key in mapping("start", settings, '{"base.inclination": 0.1}'):
            if key not in self.keys:
                raise ValueError(f"start: {key}: must be one of {', '.join(self.keys)}")
        values = np.array([settings[key] if key in settings else self.scene[key] for key in self.keys], dtype=float)
        beyond = (values < self.low) | (values > self.high)
        if beyond.any():
            k = int(beyond.argmax())
            raise ValueError(f"{self.keys[k]} = {values[k]:g}: must be {self.low[k]:g} to {self.high[k]:g}")
        return (values - self.low) / (self.high - self.low)

    def write(self, path, texts, plot):
        """Writes what was found. @param texts map from the endings of paths to functions that give a file's text; other
        endings are those of pictures. Raises OSError, ValueError, also for a file that the scene was read from."""
        self.scene.require_other(("path", path_of("path", path)))
        ending = pathlib.Path(path).suffix
        with writing(path) as part:
            if ending in texts:
                part.write_text(texts[ending](), encoding="utf-8")
            else:
                figure = plot().figure
                if ending[1:] not in figure.canvas.get_supported_filetypes():
                    raise ValueError(f"path = {path}: must end in {', '.join(texts)}, .png, .svg or .pdf")
                figure.savefig(part, format=ending[1:])

    def _changed(self, values):
        """The scene with other values; what is implausible at a place that may never be chosen is not said. Raises
        SceneError."""
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", SieveWarning)
            return self.scene.replace(values)

    def lift(self, place):
        """The base's peak acceleration downwards over gravity: below 1 it throws no disk up."""
        return float(self._changed(self.settings(place))._engine.lift)

    def run(self, places, durations, seeds, observe=(), changes=None, unknown=None, **options):
        """Runs the machine at some places: each for its duration, which only a fed one takes.
        @param unknown an Unknown in place of the machine's own
        @param seeds (first, count) @param changes of keys of the scene @param options of sweep()
        @return a row for each run, the seeds of a place together; with a budget the index counts them, for some may be
        missing"""
        ends = {"accuracy.mean_vx": 0.0, "accuracy.quality": 0.0, **(changes or {})}
        if self.kind == "fed":
            ends["feed.on_choke"] = "stop"
        if observe:
            ends["observe"] = sorted({*self.scene.values.get("observe", ()), *observe})
        cases = [{**self.settings(place), **({"duration": round(float(duration), 3)} if self.kind == "fed" else {})}
                 for place, duration in zip(places, durations)]
        if unknown := unknown or self.unknown:
            own = range(seeds[0], seeds[0] + seeds[1])
            cases, seeds = [of for k, case in enumerate(cases) for of in unknown.cases_of(case, own, k)], None
        rows = sweeps.sweep(self._changed(ends), cases=cases, seeds=seeds, **{"progress": False, **options})
        return rows[(rows["status"] != "cut") | (rows["simulated_time"] > 0.0)] if len(rows) else rows

    def observed(self, rows):
        """@return what each run says: `value`, its `variance`, both NaN where it says nothing, and `why` that is so;
        `open`, whether a longer one may, and how long it `needs` to be [s]; `residence`, the mean time in the machine
        of all disks [s], and `rate`, the events that a simulated second takes. Of a goal that is no share the variances
        are relative ones."""
        if not self.is_signed and not self.share_goal:
            self._require_goal(rows)
        seen = pandas.DataFrame({
            "value": _column(rows, self.goal), "rate": (rows["events"] + 1.0) / rows["simulated_time"],
            "residence": 0.0, "variance": np.nan, "why": "", "open": False, "needs": np.nan}, index=rows.index)
        of_kind = {"closed": self._observed_closed, "poured": self._observed_poured, "fed": self._observed_fed}
        of_kind[self.kind](rows, seen)
        seen.loc[(seen["why"] == "") & seen["value"].isna(), "why"] = EMPTY
        cut = _column(rows, "status") == "cut"
        seen.loc[cut & (seen["why"] != ""), ["why", "open"]] = CUT, True
        seen.loc[_column(rows, "status") == "failed", "why"] = FAILED
        seen["rate"] = seen["rate"].fillna(seen["rate"].max()).fillna(1.0)  # of a run that ended its process
        seen.loc[seen["why"] != "", ["value", "variance"]] = np.nan
        return seen

    def longer(self, rows, seen, most=np.inf):
        """How long a run must be that may say more than each one has, over the shortest; infinite where none may: it
        says all, or it is to be too long by what a run of a quarter of the longest shows, or too costly.
        @param most events that such a run may take"""
        if self.kind != "fed":
            units = at_last = np.where(seen["open"], 1.0, np.inf)
        else:
            last, needed = (values.to_numpy() / self.shortest for values in (rows["duration"], MARGIN * seen["needs"]))
            units = np.minimum(np.fmax(2.0 * last, np.minimum(needed, GROWTH * last)), LONGEST)
            too_long = (last >= (1.0 - 1e-9) * LONGEST) | (last >= (1.0 - 1e-9) * LONGEST / GROWTH) & (needed > LONGEST)
            units = np.where(seen["why"] == CUT, last, np.where(too_long, np.inf, units))
            units = np.where(seen["open"], units, np.inf)
            at_last = np.fmax(units, np.minimum(needed, LONGEST))
        events = np.where(seen["why"] == FILLING, GROWS, 1.0) * at_last * self.shortest * seen["rate"]
        return np.where((events <= most) | (seen["why"] == CUT), units, np.inf)

    def usual_events(self, seen):
        """Of a run of the shortest duration: the upper quartile."""
        return self.shortest * float(seen["rate"].quantile(0.75))

    def _observed_closed(self, rows, seen):
        seen["variance"] = 1.0
        if self.is_signed:
            first, second = self.scene.species
            seen["value"] = rows[f"mean_vx.{first}"] - rows[f"mean_vx.{second}"]
            seen["variance"] = rows[f"mean_vx_stderr.{first}"] ** 2 + rows[f"mean_vx_stderr.{second}"] ** 2
            seen.loc[seen["value"].isna() | ~(seen["variance"] > 0.0), "why"] = NO_DRIFT

    def _observed_poured(self, rows, seen):
        bins = self.bins(rows)
        self._count(bins, rows["simulated_time"], seen)
        seen.loc[(bins[:, :, LEFT] + bins[:, :, RIGHT] < FEWEST).any(axis=1), "why"] = FEW
        seen.loc[rows["processed"].fillna(0.0) < LEAST_PROCESSED, "why"] = NOT_EMPTIED

    def _observed_fed(self, rows, seen):
        """By its steady state, of which a run without one says why."""
        inside, flow = (_column(rows, f"steady.{name}.value") for name in ("inside", "throughput.number"))
        unknown = rows["simulated_time"] * (1.0 - rows["processed"].fillna(0.0))
        seen["residence"] = (inside / flow).where(flow > 0.0, unknown)
        seen["value"] = _column(rows, steady_column(self.goal))
        self._count(self.bins(rows), rows["simulated_time"] - _column(rows, "steady.from").fillna(0.0), seen)
        reason = _column(rows, "steady_reason").fillna("").astype(str)
        why = reason.str.partition(":")[0]
        seen["needs"] = _column(rows, "steady_needs").astype(float)
        planned = rows["duration"] if "duration" in rows else rows["simulated_time"]
        why[(rows["simulated_time"] < (1.0 - 1e-9) * planned) & (_column(rows, "status") != "cut")] = CHOKED
        seen["why"] = why
        seen["open"] = ~why.isin(["", CHOKED])

    def _count(self, bins, seconds, seen):
        """The variances, of disks each by itself, with one more at either side so that n of n is no certainty."""
        if self.share_goal:
            seen["variance"] = self.share_goal.measured(bins, seconds.to_numpy()).error ** 2
        elif self.is_signed:
            left, right = bins[:, :, LEFT], bins[:, :, RIGHT]
            counted = left + right
            of_species = (left + 0.5) * (right + 0.5) / (counted + 1.0) ** 3
            seen["variance"] = of_species.sum(axis=1) * 2.0 / counted.shape[1]
        else:
            seen["variance"] = self.shortest / seconds.clip(lower=1e-9)

    def bins(self, rows):
        """What left, of a fed machine while it was steady: as ratchet_sieve.goals has it, (runs, species, 5)."""
        found = np.zeros((len(rows), len(self.scene.species), 5))
        for side, count, mass in (("left", LEFT, LEFT_MASS), ("right", RIGHT, RIGHT_MASS)):
            for k, name in enumerate(self.scene.species):
                if self.kind == "fed":
                    found[:, k, count] = _column(rows, f"steady.exits.{side}.number.{name}").fillna(0.0)
                    found[:, k, mass] = _column(rows, f"steady.exits.{side}.mass.{name}").fillna(0.0)
                else:
                    found[:, k, count] = rows[f"{side}.{name}"]
                    found[:, k, mass] = found[:, k, count] * self.scene._engine.mean_masses[k]
        return found


def steady_column(goal):
    """The column of a goal's steady value; of one that has none that of all the run."""
    parts = goal.split(".", 3)
    name = {"separation": "steady.separation.value", "separation_by_mass": "steady.separation_by_mass.value",
            "quality": "steady.quality.value", "throughput": "steady.throughput.number.value"}.get(goal)
    if parts[0] in ("purity", "recovery") and len(parts) == 4:
        name = "steady.{}.{}.{}.value.{}".format(*parts)
    return name or goal


def _share_goal(goal, species):
    """Of a goal such as purity.left.mass.A; None of another."""
    parts = goal.split(".", 3)
    if len(parts) < 4 or parts[0] not in ("purity", "recovery") or parts[1] not in SIDES or \
            parts[2] not in ("number", "mass") or parts[3] not in species:
        return None
    return Goal(f"{parts[0]}:{parts[3]}:{parts[1]}" + (":mass" if parts[2] == "mass" else ""), species)


def flow_of(rows):
    """The throughput of each run of a fed machine, while it was steady, or of all of it [1/s]."""
    return _column(rows, "steady.throughput.number.value").fillna(rows["counted"] / rows["simulated_time"])


def _column(rows, name):
    """NaN where there is none: no run had such a number."""
    return rows[name] if name in rows else pandas.Series(np.nan, index=rows.index)


def range_of(key, ends):
    """@return (from, to). Raises ValueError."""
    try:
        low, high = ends
    except (TypeError, ValueError):
        raise ValueError(f"over[{key!r}] = {ends!r}: must be a pair (from, to)") from None
    number(f"over[{key!r}], from", low)
    number(f"over[{key!r}], to", high)
    if not low < high:
        raise ValueError(f"over[{key!r}] = {low!r} to {high!r}: must have a width: from below to")
    return low, high
