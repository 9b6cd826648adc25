"""The scenes that accuracy is measured on, their quantities, and the known values of these."""
import dataclasses
import math
import pathlib

CONFIG = pathlib.Path(__file__).resolve().parent.parent.parent / "config"
GRAVITY = 9.81  # m/s^2

# Of the bouncing ball: test/core/bouncing_ball_test.cpp has the theory.
BALL_FREQUENCY = 50.0  # Hz
BALL_ACCELERATION = 1.1  # of the plate, over g: in the range where period one is stable
BALL_RESTITUTION = 0.6
BALL_MASS = 0.001  # kg


@dataclasses.dataclass
class Scene:
    """A scene file with some keys changed. The reference of a quantity is its known value, else the exact engine's."""
    name: str
    title: str
    source: object        # a file's name in config/, or the scene itself
    settings: dict
    observables: dict     # name -> function of the summary of a run
    seeds: int            # of --quick
    known: dict = dataclasses.field(default_factory=dict)

    def sweep(self, rung, seeds, span=None):
        scene = self.source if isinstance(self.source, dict) else str(CONFIG / self.source)
        settings = {**self.settings, **rung}
        if span:
            settings.update({"settle": 0.0, "duration": span})
        return {"scene": scene, "set": settings,
                "seed": {"first": seeds[0], "count": len(seeds)}}


def mean_vx(species):
    return lambda run: run["species"][species]["mean_vx"]


def kinetic(species):
    return lambda run: run["species"][species]["kinetic_translational"]


def spin_share(run):
    """Energy of rotation over that of translation."""
    return (sum(s["kinetic_rotational"] for s in run["species"])
            / sum(s["kinetic_translational"] for s in run["species"]))


def equipartition(run):
    return run["species"][0]["kinetic_translational"] / run["species"][1]["kinetic_translational"]


def vertical_impulse(run):
    return run["base_impulse"][1]


def weight(count_a, count_b, span):
    """The impulse that the base of Fig. 8 has to give within that time [N s]."""
    return (count_a * 0.010 + count_b * 0.001) * GRAVITY * span


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
    return Scene("ball", "bouncing ball, period one", scene, {}, {"kinetic energy": kinetic(0)}, 2,
                 {"kinetic energy": BALL_MASS * GRAVITY ** 2 / (24.0 * BALL_FREQUENCY ** 2)})


def lossless_gas():
    """test/core/equilibrium_test.cpp: perfectly rough, elastic disks over a base at rest."""
    rough = {"restitution": 1.0, "friction": 1e9, "tangential_restitution": 1.0}
    settings = {f"species.{k}.{key}": value for k in (0, 1) for key, value in rough.items()}
    settings.update({"density": 3.0, "base.amplitude": 0.0, "contact.min_rebound_speed": 0.0,
                     "pour.drop_height": 0.05, "duration": 60.0, "settle": 15.0})
    return Scene("gas", "lossless gas in equilibrium", "paper_fig8.yaml", settings,
                 {"K_rot / K_trans": spin_share, "K_A / K_B": equipartition,
                  "energy, end / start": lambda run: run["energy_end"] / run["energy_start"]}, 8,
                 {"K_rot / K_trans": 0.5, "K_A / K_B": 1.0, "energy, end / start": 1.0})


DRIFTS = {"drift A": mean_vx(0), "drift B": mean_vx(1)}
LAYER = {**DRIFTS, "K_A": kinetic(0), "K_B": kinetic(1), "short / long": lambda run: run["short_to_long"]}
FIG8_SPAN = (2.0, 17.0)  # s


def fig8():
    settle, end = FIG8_SPAN
    return Scene("fig8", "Fig. 8, mixture", "paper_fig8.yaml", {"settle": settle, "duration": end},
                 {**LAYER, "N m g T": vertical_impulse}, 10, {"N m g T": weight(262, 262, end - settle)})


def development():
    """The scenes by which settings were chosen."""
    return [
        bouncing_balls(),
        lossless_gas(),
        Scene("fig3", "Fig. 3, single disks", "paper_fig3.yaml", {"duration": 22.0, "settle": 2.0},
              {"drift A": mean_vx(0), "K_A": kinetic(0), "short / long": lambda run: run["short_to_long"]}, 8),
        fig8(),
        Scene("fig9", "Fig. 9, separation", "paper_fig9.yaml",
              {"base.teeth": 40, "density": 2.0, "duration": 30.0},
              {"Q": lambda run: run["quality"], "P": lambda run: run["processed"]}, 32),
        Scene("dense", "dense heap, d = 8", "paper_fig8.yaml", {"density": 8.0, "settle": 2.0, "duration": 8.0}, LAYER,
              6),
        Scene("violent", "violent, 40 g", "paper_fig8.yaml",
              {"base.amplitude": 0.0188, "settle": 2.0, "duration": 14.0}, LAYER, 8),
    ]


def held_out():
    """The scenes on which the claimed bounds are tested. No setting was chosen by them."""
    small_and_large = {"species.0.mass": 0.001, "species.1.mass": 0.001, "species.1.radius": 0.004}
    return [
        Scene("tilted", "mixture, θ = 0.105, d = 2, 30 Hz", "paper_fig8.yaml",
              {"base.inclination": 0.105, "density": 2.0, "base.frequency": 30.0, "settle": 2.0, "duration": 22.0},
              LAYER, 48),
        Scene("asymmetry", "mixture, a = 0.1, B of 5 mm, d = 4", "paper_fig8.yaml",
              {"base.asymmetry": 0.1, "species.1.radius": 0.005, "settle": 2.0, "duration": 22.0}, LAYER, 12),
        Scene("equal", "r = 1 and 4 mm, both 1 g, d = 3", "paper_fig8.yaml",
              {**small_and_large, "density": 3.0, "settle": 2.0, "duration": 22.0}, LAYER, 12),
    ]


LARGE_SPANS = (1.0, 3.0)  # s


def large():
    """10^4 disks: the cost of the first simulated second, in which all of them land, and of those after it."""
    return [Scene(f"large {span:g} s", f"10⁴ disks, {span:g} s", "paper_fig8.yaml",
                  {"base.teeth": 382, "settle": 0.0, "duration": span}, DRIFTS, 1) for span in LARGE_SPANS]
