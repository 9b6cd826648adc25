"""The shape of the base, of its part `base` of a scene."""
import math


def outline(base):
    """The corners (s, n) of one tooth, from (0, 0) to (w, 0) [m]."""
    if "profile" in base:
        return [tuple(corner) for corner in base["profile"]]
    width = base["tooth_width"]
    return [(0.0, 0.0), (base["asymmetry"] * width, base["tooth_height"]), (width, 0.0)]


def length(base):
    """Of all teeth [m]."""
    return base["teeth"] * (base["profile"][-1][0] if "profile" in base else base["tooth_width"])


def surface(base):
    """The corners (s, n) of all teeth, from the first foot to the last [m]."""
    corners = outline(base)
    return corners[:1] + [(k * corners[-1][0] + s, n) for k in range(base["teeth"]) for s, n in corners[1:]]


def in_world(points, inclination, displacement):
    """Of points (s, n) of the base, docs/model.md [m]."""
    c, s = math.cos(inclination), math.sin(inclination)
    dx, dy = displacement
    return [(dx + along * c - up * s, dy + along * s + up * c) for along, up in points]
