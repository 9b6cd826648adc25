"""How far a point is off its reference, and how sure that is."""
import math

from precision import rungs


def limit(points, name):
    """Of the exact engine as the rebound floor goes to 0: the weighted straight line through the smallest floors.
    @return value at 0 and its standard error; None where that cannot be told"""
    floors = [(rungs.floor_of(p), *(p.observed(name) or (0.0, 0.0))) for p in points
              if rungs.floor_of(p) in rungs.EXTRAPOLATED]
    if not all(error > 0.0 for _, _, error in floors):
        return None
    s = sx = sy = sxx = sxy = 0.0
    for x, y, error in floors:
        w = 1.0 / error ** 2
        s, sx, sy, sxx, sxy = s + w, sx + w * x, sy + w * y, sxx + w * x * x, sxy + w * x * y
    determinant = s * sxx - sx * sx
    return (sxx * sy - sx * sxy) / determinant, math.sqrt(sxx / determinant)


def exact(points, name):
    """@return what is known, or what the exact engine has of the same scene, and its standard error"""
    point = next(p for p in points if p.family == "exact")
    if name in point.scene.known:
        return point.scene.known[name], 0.0
    return point.observed(name)


def relative(point, name, reference):
    """@return error over the reference's value, and the standard error of that; None where nothing was observed"""
    observed = point.observed(name)
    if observed is None or reference is None:
        return None
    value, error = reference
    return (observed[0] - value) / abs(value), math.hypot(observed[1], error) / abs(value)
