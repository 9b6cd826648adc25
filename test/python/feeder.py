"""A feeder that is cheap to search, for tests."""
THETA = "base.inclination"
SCENE = {"base": {"teeth": 8}, "boundary": "open", "feed": {"rate": 60.0},
         "species": [{"name": "A", "radius": 0.001, "mass": 0.010}, {"name": "B", "radius": 0.002, "mass": 0.001}]}
TWINS = [{"name": name, "radius": 0.002, "mass": 0.001} for name in "AB"]


def changed(**changes):
    return {**SCENE, **changes}
