"""What accuracy is measured on: scenes with their quantities and the known values of these, each with settings that
trade accuracy for speed, from coarse to fine; and the tables of what came of them.

accuracy.csv has the results of each setting, accuracy_costs.csv its processor time. The results are the same on every
machine, the times are not: each file says when, and the second where, a line was measured."""
import dataclasses
import math
import pathlib

from ratchet_sieve.stats import Mean, mean_of
from ratchet_sieve.tables import read_csv, write_csv

CONFIG = pathlib.Path(__file__).resolve().parent.parent.parent / "config"
GRAVITY = 9.81  # m/s^2

# Of the bouncing ball: test/core/bouncing_ball_test.cpp has the theory.
BALL_FREQUENCY = 50.0  # Hz
BALL_ACCELERATION = 1.1  # of the plate, over g: in the range where period one is stable
BALL_RESTITUTION = 0.6
BALL_MASS = 0.001  # kg


STEPS = (0.004, 0.002, 0.001, 0.0005, 0.00025)  # s
FLOORS = (0.2, 0.1, 0.05, 0.025, 0.0125, 0.005, 0.002, 0.001)  # m/s
REFERENCE_FLOOR = FLOORS[-1]  # m/s
SCENES_FLOOR = 0.05  # the floor in the scene files: that of the exact run itself [m/s]
CONTACT_DURATIONS = (3e-3, 1e-3, 3e-4, 1e-4, 3e-5)  # s
RESTITUTION_SPEEDS = (0.8, 0.4, 0.2, 0.1, 0.05)  # m/s
SMALL_FLOOR = 0.005  # m/s, beside another setting that does the floor's work
SPARING_FLOOR = 0.0125  # m/s, beside a part of the model that is left out
CLAIMS = {0.002: 0.05, 0.001: 0.05, 0.0005: 0.03}  # the bound set for each step before the held-out scenes were run

FLOOR_KEY = "contact.min_rebound_speed"


def ms(time):
    return f"{1e3 * time:g} ms"


def steps(step):
    return {"accuracy.method": "steps", "accuracy.step": step}


def without_spin(*species):
    return [("μ = 0", {**{f"species.{k}.friction": 0.0 for k in species}, FLOOR_KEY: SPARING_FLOOR})]


METHOD = {"steps": [(ms(step), steps(step)) for step in STEPS]}
CLAIMED = {"steps": [(ms(step), steps(step)) for step in CLAIMS]}
# Single disks are advanced exactly whatever the method.
OF_SINGLE_DISKS = {
    "rebound floor": [(f"{floor:g} m/s", {FLOOR_KEY: floor}) for floor in FLOORS if floor != SCENES_FLOOR],
    "contact duration": [(ms(t), {"contact.contact_duration": t, FLOOR_KEY: SMALL_FLOOR}) for t in CONTACT_DURATIONS],
    "restitution by speed": [(f"{v:g} m/s", {"contact.restitution_speed": v, FLOOR_KEY: SMALL_FLOOR})
                             for v in RESTITUTION_SPEEDS],
    "no spin": without_spin(0)}
OF_LAYERS = {
    **METHOD, **OF_SINGLE_DISKS,
    "floor, in steps of 1 ms": [(f"{floor:g} m/s", {**steps(0.001), FLOOR_KEY: floor}) for floor in FLOORS[:5]],
    "no spin": without_spin(0, 1),
    "no pairs": [("pairs left out", {"contact.pair_collisions": False, FLOOR_KEY: SPARING_FLOOR})]}


@dataclasses.dataclass
class Scene:
    """A scene file with some keys changed. The reference of a quantity is its known value, else the exact engine's."""
    name: str
    title: str
    source: object        # a file's name in config/, or the scene itself
    settings: dict
    observables: dict     # name -> a column of sieve_sweep export, or a function of all
    seeds: int            # of --quick
    families: dict        # beside the exact run: family -> pairs of a setting's name and its keys
    known: dict = dataclasses.field(default_factory=dict)

    def sweep(self, rung, seeds, span=None):
        scene = self.source if isinstance(self.source, dict) else str(CONFIG / self.source)
        settings = {**self.settings, **rung}
        if span:
            settings.update({"settle": 0.0, "duration": span})
        return {"scene": scene, "set": settings,
                "seed": {"first": seeds[0], "count": len(seeds)}}


def bouncing_balls():
    """Balls on the period-one orbit, far from each other. A ball hits the plate once in each period 1/f, and leaves and
    meets it with the speed g / (2 f), so that its mean kinetic energy is m g^2 / (24 f^2)."""
    omega = 2.0 * math.pi * BALL_FREQUENCY
    amplitude = BALL_ACCELERATION * GRAVITY / omega ** 2
    restitution = BALL_RESTITUTION
    phase = math.acos(math.pi * (1.0 - restitution) / (BALL_ACCELERATION * (1.0 + restitution))) - 0.05
    start = {"species": "A", "y": 0.001 + amplitude * math.sin(phase) + 1e-6, "vx": 0.0,
             "vy": GRAVITY / BALL_FREQUENCY / 2.0, "spin": 0.0}
    scene = {"base": {"tooth_height": 0.0, "frequency": BALL_FREQUENCY, "amplitude": amplitude, "phase": phase},
             "species": [{"name": "A", "radius": 0.001, "mass": BALL_MASS, "restitution": restitution, "friction": 0.0,
                          "tangential_restitution": 0.0}],
             "contact": {"min_rebound_speed": 0.0},
             "initial": [{**start, "x": 0.02 + 0.04 * k} for k in range(10)], "duration": 105.0, "settle": 5.0}
    return Scene("ball", "bouncing ball, period one", scene, {}, {"kinetic energy": "kinetic_translational.A"}, 2,
                 METHOD, {"kinetic energy": BALL_MASS * GRAVITY ** 2 / (24.0 * BALL_FREQUENCY ** 2)})


def lossless_gas():
    """test/core/equilibrium_test.cpp: perfectly rough, elastic disks over a base at rest."""
    rough = {"restitution": 1.0, "friction": 1e9, "tangential_restitution": 1.0}
    settings = {f"species.{k}.{key}": value for k in (0, 1) for key, value in rough.items()}
    settings.update({"density": 3.0, "base.amplitude": 0.0, "contact.min_rebound_speed": 0.0,
                     "pour.drop_height": 0.05, "duration": 60.0, "settle": 15.0})
    return Scene("gas", "lossless gas in equilibrium", "paper_fig8.yaml", settings,
                 {"K_rot / K_trans": lambda runs: ((runs["kinetic_rotational.A"] + runs["kinetic_rotational.B"]) / (
                     runs["kinetic_translational.A"] + runs["kinetic_translational.B"])),
                  "K_A / K_B": lambda runs: runs["kinetic_translational.A"] / runs["kinetic_translational.B"],
                  "energy, end / start": lambda runs: runs["energy_end"] / runs["energy_start"]}, 8, METHOD,
                 {"K_rot / K_trans": 0.5, "K_A / K_B": 1.0, "energy, end / start": 1.0})


DRIFTS = {"drift A": "mean_vx.A", "drift B": "mean_vx.B"}
LAYER = {**DRIFTS, "K_A": "kinetic_translational.A", "K_B": "kinetic_translational.B", "short / long": "short_to_long"}
FIG8_SPAN = (2.0, 17.0)  # s
SMALL_AND_LARGE = {"species.0.mass": 0.001, "species.1.mass": 0.001, "species.1.radius": 0.004}

# By which settings were chosen. Of balls and gas the references are known, and their floor is 0.
DEVELOPMENT = (
    bouncing_balls(),
    lossless_gas(),
    Scene("fig3", "Fig. 3, single disks", "paper_fig3.yaml", {"duration": 22.0, "settle": 2.0},
          {name: LAYER[name] for name in ("drift A", "K_A", "short / long")}, 8, OF_SINGLE_DISKS),
    Scene("fig8", "Fig. 8, mixture", "paper_fig8.yaml", {"settle": FIG8_SPAN[0], "duration": FIG8_SPAN[1]},
          {**LAYER, "N m g T": "base_impulse.y"}, 10, OF_LAYERS,
          {"N m g T": 262 * (0.010 + 0.001) * GRAVITY * (FIG8_SPAN[1] - FIG8_SPAN[0])}),  # of the base [N s]
    Scene("fig9", "Fig. 9, separation", "paper_fig9.yaml", {"base.teeth": 40, "density": 2.0, "duration": 30.0},
          {"Q": lambda runs: runs["quality"], "P": "processed"}, 32, OF_LAYERS),
    Scene("dense", "dense heap, d = 8", "paper_fig8.yaml", {"density": 8.0, "settle": 2.0, "duration": 8.0}, LAYER, 6,
          OF_LAYERS),
    Scene("violent", "violent, 40 g", "paper_fig8.yaml", {"base.amplitude": 0.0188, "settle": 2.0, "duration": 14.0},
          LAYER, 8, OF_LAYERS))

# On which the claimed bounds are tested. No setting was chosen by them.
HELD_OUT = (
    Scene("tilted", "mixture, θ = 0.105, d = 2, 30 Hz", "paper_fig8.yaml",
          {"base.inclination": 0.105, "density": 2.0, "base.frequency": 30.0, "settle": 2.0, "duration": 22.0}, LAYER,
          48, CLAIMED),
    Scene("asymmetry", "mixture, a = 0.1, B of 5 mm, d = 4", "paper_fig8.yaml",
          {"base.asymmetry": 0.1, "species.1.radius": 0.005, "settle": 2.0, "duration": 22.0}, LAYER, 12, CLAIMED),
    Scene("equal", "r = 1 and 4 mm, both 1 g, d = 3", "paper_fig8.yaml",
          {**SMALL_AND_LARGE, "density": 3.0, "settle": 2.0, "duration": 22.0}, LAYER, 12, CLAIMED))

# 10^4 disks: the cost of the first simulated second, in which all of them land, and of those after it.
LARGE = tuple(Scene(f"large {span:g} s", f"10⁴ disks, {span:g} s", "paper_fig8.yaml",
                    {"base.teeth": 382, "settle": 0.0, "duration": span}, DRIFTS, 1, CLAIMED) for span in (1.0, 3.0))


def floor_of(point):
    """Of a point in which nothing else is changed; None for others."""
    if point.family == "exact":
        return SCENES_FLOOR
    return point.rung[FLOOR_KEY] if point.family == "rebound floor" else None


def effort_of(point):
    """Times the seeds of the scene: references have more."""
    return 2.0 if floor_of(point) in (SCENES_FLOOR, REFERENCE_FLOOR) else 1.0


@dataclasses.dataclass
class Point:
    """A scene with one setting, and its results over the seeds."""
    scene: object
    family: str
    label: str
    rung: dict
    means: dict = dataclasses.field(default_factory=dict)  # quantity -> Mean
    counts: dict = dataclasses.field(default_factory=dict)  # of COUNTS, of all runs; none: it was not measured
    cost: float = None       # processor time over simulated time; None: no run was completed
    measured: object = dataclasses.field(default=None, compare=False)  # Origin of the results ...
    timed: object = dataclasses.field(default=None, compare=False)     # ... and of the cost

    def key(self):
        return self.scene.name, self.family, self.label

    def set_results(self, rows, ended_early):
        """@param rows of the completed runs"""
        means = {name: mean_of(rows.samples(field)) for name, field in self.scene.observables.items()}
        self.means = {name: mean for name, mean in means.items() if mean}
        self.counts = {"overlap": max(rows.samples("max_overlap"), default=0.0),
                       **{name: sum(rows.samples(name)) for name in ("pushed_out", "through_base")},
                       "ended_early": ended_early}


def planned(only=None):
    """@param only names of scenes; None: all"""
    return [Point(scene, family, label, rung) for scene in (*DEVELOPMENT, *HELD_OUT, *LARGE)
            if not only or scene.name in only
            for family, settings in {"exact": [("exact", {})], **scene.families}.items() for label, rung in settings]


def of_scenes(points, scenes):
    """@return for each of these scenes that was measured, by its name, its measured points"""
    groups = {scene.name: [point for point in points if point.scene.name == scene.name and point.counts]
              for scene in scenes}
    return {name: own for name, own in groups.items() if own}


def find(points, family, label=None):
    """The point of that family and label; None where there is none."""
    return next((point for point in points if point.family == family and label in (None, point.label)), None)


RESULTS, COSTS = "accuracy.csv", "accuracy_costs.csv"
KEY = ["scene", "family", "setting"]
RESULT_COLUMNS = [*KEY, "quantity", "runs", "mean", "standard_error", "measured", "physics"]
COST_COLUMNS = [*KEY, "processor_s_per_simulated_s", "measured", "machine", "physics"]
# Quantities that are no means over runs: the largest overlap [m], how often a disk was behind the base's surface after
# a missed contact, disks that stayed there, runs that ended early.
COUNTS = ("overlap", "pushed_out", "through_base", "ended_early")


@dataclasses.dataclass(frozen=True, order=True)
class Origin:
    date: str
    machine: str
    physics: str  # version

    def __str__(self):
        return ", ".join(part for part in (self.date, self.machine, f"physics version {self.physics}") if part)


def origin_of(line):
    return Origin(line["measured"], line.get("machine", ""), line["physics"])


def lines_of(path, is_kept):
    """@return the file's lines that are, as maps from column to text; none where there is no file"""
    lines = read_csv(path).to_dict("records") if path.exists() else []
    return [line for line in lines if is_kept(tuple(line[column] for column in KEY))]


def result_lines(point):
    for name, mean in point.means.items():
        yield {"quantity": name, "runs": mean.count, "mean": f"{mean.value:.10g}",
               "standard_error": "" if mean.error is None else f"{mean.error:.4g}"}
    for name, count in point.counts.items():
        yield {"quantity": name, "mean": f"{count:.4g}"}


def cost_lines(point):
    return [] if point.cost is None else [{"processor_s_per_simulated_s": f"{point.cost:.3g}"}]


def save(directory, points, origin, with_costs):
    """Replaces the lines of these points, and keeps the others."""
    about = {"measured": origin.date, "machine": origin.machine, "physics": origin.physics}
    for name, columns, lines in ((RESULTS, RESULT_COLUMNS, result_lines), (COSTS, COST_COLUMNS, cost_lines)):
        if lines is result_lines or with_costs:
            kept = lines_of(directory / name, lambda key: key not in {point.key() for point in points})
            new = ({**dict(zip(KEY, point.key())), **line, **about} for point in points for line in lines(point))
            write_csv(directory / name, columns, (*kept, *new))


def load(directory, points):
    """Puts the results in the files into the points. @return the origins of the results and of the costs, the newest
    last"""
    known = {point.key(): point for point in points}
    results, costs = (lines_of(directory / name, known.__contains__) for name in (RESULTS, COSTS))
    for line in results:
        point, name = known[tuple(line[column] for column in KEY)], line["quantity"]
        point.measured = origin_of(line)
        if name in COUNTS:
            point.counts[name] = float(line["mean"])
        else:
            error = float(line["standard_error"]) if line["standard_error"] else None
            point.means[name] = Mean(float(line["mean"]), error, int(line["runs"]))
    for line in costs:
        point = known[tuple(line[column] for column in KEY)]
        point.cost, point.timed = float(line["processor_s_per_simulated_s"]), origin_of(line)
    return [sorted(set(map(origin_of, lines))) for lines in (results, costs)]
