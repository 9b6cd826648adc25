"""The settings that trade accuracy for speed: families, each from coarse to fine."""

STEPS = (0.004, 0.002, 0.001, 0.0005, 0.00025)  # s
LARGE_STEPS = (0.002, 0.001, 0.0005)  # of 10^4 disks [s]
FLOORS = (0.2, 0.1, 0.05, 0.025, 0.0125, 0.005, 0.002, 0.001)  # m/s
REFERENCE_FLOOR = FLOORS[-1]  # m/s
SCENES_FLOOR = 0.05  # the floor in the scene files [m/s]
CONTACT_DURATIONS = (3e-3, 1e-3, 3e-4, 1e-4, 3e-5)  # s
RESTITUTION_SPEEDS = (0.8, 0.4, 0.2, 0.1, 0.05)  # m/s
SMALL_FLOOR = 0.005  # m/s, beside another setting that does the floor's work
SPARING_FLOOR = 0.0125  # m/s, beside a part of the model that is left out

FLOOR_KEY = "contact.min_rebound_speed"


def steps(step, floor=None):
    return {"accuracy.method": "steps", "accuracy.step": step, **({} if floor is None else {FLOOR_KEY: floor})}


EXACT = {"exact": [("exact", {})]}
METHOD = {"steps": [(f"{1e3 * step:g} ms", steps(step)) for step in STEPS]}
MODEL = {
    # The scenes' floor is the exact run itself.
    "rebound floor": [(f"{floor:g} m/s", {FLOOR_KEY: floor}) for floor in FLOORS if floor != SCENES_FLOOR],
    "contact duration": [(f"{1e3 * t:g} ms", {"contact.contact_duration": t, FLOOR_KEY: SMALL_FLOOR})
                         for t in CONTACT_DURATIONS],
    "restitution by speed": [(f"{v:g} m/s", {"contact.restitution_speed": v, FLOOR_KEY: SMALL_FLOOR})
                             for v in RESTITUTION_SPEEDS],
    "floor, in steps of 1 ms": [(f"{floor:g} m/s", steps(0.001, floor)) for floor in FLOORS[:5]],
    "no spin": [("μ = 0", {"species.0.friction": 0.0, "species.1.friction": 0.0, FLOOR_KEY: SPARING_FLOOR})],
    "no pairs": [("pairs left out", {"contact.pair_collisions": False, FLOOR_KEY: SPARING_FLOOR})],
}


# The bound on the relative error that was set for each step before the held-out scenes were run.
CLAIMS = {0.002: 0.05, 0.001: 0.05, 0.0005: 0.03}


def floor_of(point):
    """Of a point in which nothing else is changed; None for others."""
    if point.family == "exact":
        return SCENES_FLOOR
    return point.rung[FLOOR_KEY] if point.family == "rebound floor" else None


def effort(point):
    """Times the seeds of the scene: references have more."""
    return 2.0 if floor_of(point) in (SCENES_FLOOR, REFERENCE_FLOOR) else 1.0


def of(scene):
    """The families that a scene is run with."""
    families = {**EXACT}
    if scene.name != "fig3":  # single disks are advanced exactly whatever the method
        families.update(METHOD)
    if scene.name in ("ball", "gas"):  # their references are known, their floor is 0
        return families
    model = dict(MODEL)
    if scene.name == "fig3":
        for name in ("no pairs", "floor, in steps of 1 ms"):
            del model[name]
        model["no spin"] = [("μ = 0", {"species.0.friction": 0.0, FLOOR_KEY: SPARING_FLOOR})]
    return {**families, **model}
