"""What the samples of a run say: drifts and overlaps. Every program of the comparison writes them alike."""
import numpy
import yaml
from scipy.spatial import cKDTree

from ratchet_sieve.places import SHARE

SCENE_FILE = SHARE / "config/paper_fig8.yaml"
SCENE = yaml.safe_load(SCENE_FILE.read_text(encoding="utf-8"))
TIMEOUT = 900.0  # of wall time [s]: a longer run of a program has hung
TOUCH = 1e-12  # an overlap up to this is rounding [m]
LOOK = 0.01    # between two samples [s]
BLOCK = 0.5    # of time, over which a drift is a sample of its mean [s]
SEAM = 0.040   # two teeth [m]: no overlap is looked for so near to an end, where a program without a periodic boundary
               # moves disks onto each other, independently of its solver
ROUNDING = 1e-6  # of a block, so that the rounding of times does not delay its end to the next sample


def corners_of(base, teeth):
    """Foot and apex of these teeth, from left to right [m]."""
    return [((k + part) * base["tooth_width"], n) for k in teeth
            for part, n in ((0.0, 0.0), (base["asymmetry"], base["tooth_height"]))]


def height_above(base, x, y):
    """Distances from points to the base's surface, > 0 above it."""
    s, corners = x % base["tooth_width"], corners_of(base, range(-1, 3))
    nearest = numpy.full_like(s, numpy.inf)
    for (s1, n1), (s2, n2) in zip(corners, corners[1:]):
        along, up = s2 - s1, n2 - n1
        part = numpy.clip(((s - s1) * along + (y - n1) * up) / (along ** 2 + up ** 2), 0.0, 1.0)
        nearest = numpy.minimum(nearest, numpy.hypot(s - s1 - part * along, y - n1 - part * up))
    return numpy.copysign(nearest, y - numpy.interp(s, *zip(*corners)))


def largest_overlap(x, y, radii):
    """Of two disks [m]."""
    pairs = cKDTree(numpy.column_stack((x, y))).query_pairs(2.0 * radii.max(), output_type="ndarray")
    i, j = pairs.T
    return float((radii[i] + radii[j] - numpy.hypot(x[i] - x[j], y[i] - y[j])).max(initial=0.0))


def drifts(times, x, kinds):
    """@return of each block its mean velocities, one for each species [m/s]"""
    blocks, begin = [], 0
    for k, time in enumerate(times):
        span = time - times[begin]
        if span >= BLOCK * (1.0 - ROUNDING):
            moved = x[k] - x[begin]
            blocks.append([float(moved[kinds == kind].mean()) / span for kind in range(kinds.max() + 1)])
            begin = k
    return blocks


def measured(lines, kinds):
    """What compare_peers tells of a run's samples.
    @param lines of each sample its time and the base's displacement; then x, as if the base went on, and y of each disk
    @param kinds the species of each disk"""
    base, kinds = SCENE["base"], numpy.array(kinds)
    radii = numpy.array([species["radius"] for species in SCENE["species"]])[kinds]
    width = base["teeth"] * base["tooth_width"]
    times, displacements, xs, ys = lines[:, 0], lines[:, 1], lines[:, 2::2], lines[:, 3::2]
    overlap = base_overlap = 0.0
    behind = 0
    for displacement, x, y in zip(displacements, xs % width, ys):
        heights = height_above(base, x, y - displacement)
        behind = max(behind, int((heights < 0.0).sum()))
        inside = (x > SEAM) & (x < width - SEAM)
        overlap = max(overlap, largest_overlap(x[inside], y[inside], radii[inside]))
        base_overlap = max(base_overlap, float((radii - heights)[inside & (heights > 0.0)].max(initial=0.0)))
    return {"behind_base": behind, "overlap": overlap if overlap > TOUCH else 0.0,
            "base_overlap": base_overlap if base_overlap > TOUCH else 0.0, "drift_blocks": drifts(times, xs, kinds)}
