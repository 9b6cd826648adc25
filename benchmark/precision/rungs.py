"""What accuracy is traded by: families of settings, each from coarse to fine."""

STEPS = (0.004, 0.002, 0.001, 0.0005, 0.00025)  # s
FLOORS = (0.2, 0.1, 0.05, 0.025, 0.0125)  # m/s
EXTRAPOLATED = (0.05, 0.025, 0.0125)  # to the limit of no floor [m/s]
SCENES_FLOOR = 0.05  # what the scene files have [m/s]
CONTACT_DURATIONS = (3e-3, 1e-3, 3e-4, 1e-4, 3e-5)  # s
RESTITUTION_SPEEDS = (0.8, 0.4, 0.2, 0.1, 0.05)  # m/s
SMALL_FLOOR = 0.005  # m/s, where another rung does the floor's work

FLOOR_KEY = "contact.min_rebound_speed"


def steps(step, floor=None):
    return {"accuracy.method": "steps", "accuracy.step": step, **({} if floor is None else {FLOOR_KEY: floor})}


EXACT = {"exact": [("exact", {})]}
METHOD = {"steps": [(f"{1e3 * step:g} ms", steps(step)) for step in STEPS]}
MODEL = {
    # That of the scene files is the exact run itself.
    "rebound floor": [(f"{floor:g} m/s", {FLOOR_KEY: floor}) for floor in FLOORS if floor != SCENES_FLOOR],
    "contact duration": [(f"{1e3 * t:g} ms", {"contact.contact_duration": t, FLOOR_KEY: SMALL_FLOOR})
                         for t in CONTACT_DURATIONS],
    "restitution by speed": [(f"{v:g} m/s", {"contact.restitution_speed": v, FLOOR_KEY: SMALL_FLOOR})
                             for v in RESTITUTION_SPEEDS],
    "floor, in steps of 1 ms": [(f"{floor:g} m/s", steps(0.001, floor)) for floor in FLOORS],
    "no spin": [("μ = 0", {"species.0.friction": 0.0, "species.1.friction": 0.0, FLOOR_KEY: EXTRAPOLATED[-1]})],
    "no pairs": [("pairs left out", {"contact.pair_collisions": False, FLOOR_KEY: EXTRAPOLATED[-1]})],
}


# What a recommended step is off by at most, in drifts, energies, Q and P, over what the exact engine has.
CLAIMS = {0.002: 0.05, 0.001: 0.05, 0.0005: 0.03}

# A drift may be off by this whatever it is: near the angle at which it turns, no share of it says anything.
SMALLEST_DRIFT_ERROR = 0.001  # m/s


def floor_of(point):
    """Of those points whose only rung it is; None of others."""
    if point.family == "exact":
        return SCENES_FLOOR
    return point.rung[FLOOR_KEY] if point.family == "rebound floor" else None


def effort(point):
    """What others are held against is run for longer."""
    return 2.0 if floor_of(point) in EXTRAPOLATED else 1.0


def of(scene):
    """The families that a scene is run with."""
    families = {**EXACT}
    if scene.name != "fig3":  # single disks go in lanes, whatever the method
        families.update(METHOD)
    if scene.name in ("ball", "gas"):  # no floor, no limit of one: what they are held against is known
        return families
    model = dict(MODEL)
    if scene.name == "fig3":
        for name in ("no pairs", "floor, in steps of 1 ms"):
            del model[name]
        model["no spin"] = [("μ = 0", {"species.0.friction": 0.0, FLOOR_KEY: EXTRAPOLATED[-1]})]
    return {**families, **model}
