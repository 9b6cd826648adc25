"""What is measured: scenes, each with settings from coarse to fine, and what came of them."""
import dataclasses

from precision import rungs, scenes
from ratchet_sieve.stats import mean_of


@dataclasses.dataclass
class Point:
    """A scene with one setting, and its results over the seeds."""
    scene: object
    family: str
    label: str
    rung: dict
    means: dict = dataclasses.field(default_factory=dict)  # quantity -> Mean
    cost: float = None       # processor time over simulated time; None: no run was completed
    overlap: float = 0.0     # the largest [m]
    pushed_out: int = 0      # times that a disk was behind the base's surface after a missed contact
    through_base: int = 0    # disks that stayed there
    ended_early: int = 0     # runs

    def key(self):
        return self.scene.name, self.family, self.label

    def fails(self):
        return self.through_base > 0 or self.ended_early > 0

    def is_measured(self):
        return bool(self.means) or self.ended_early > 0

    def take(self, summaries, ended_early):
        """@param summaries one for each completed run"""
        for name, of_run in self.scene.observables.items():
            mean = mean_of(value for value in map(of_run, summaries) if value is not None)
            if mean:
                self.means[name] = mean
        self.overlap = max((summary["max_overlap"] for summary in summaries), default=0.0)
        self.pushed_out = sum(summary.get("pushed_out", 0) for summary in summaries)
        self.through_base = sum(summary["through_base"] for summary in summaries)
        self.ended_early = ended_early


def planned(only=None):
    """@param only names of scenes; None: all"""
    points = [Point(scene, family, label, rung) for scene in scenes.development()
              for family, settings in rungs.of(scene).items() for label, rung in settings]
    for scene in (*scenes.held_out(), *scenes.large()):
        points.append(Point(scene, "exact", "exact", {}))
        steps = rungs.LARGE_STEPS if scene.name.startswith("large") else rungs.CLAIMS
        points += [Point(scene, "steps", f"{1e3 * step:g} ms", rungs.steps(step)) for step in steps]
    return [point for point in points if not only or point.scene.name in only]


def by_scene(points):
    """@return scene's name -> its points"""
    groups = {}
    for point in points:
        groups.setdefault(point.scene.name, []).append(point)
    return groups


def find(points, family, label=None):
    """The measured point of that family and label; None where there is none."""
    return next((point for point in points if point.family == family and label in (None, point.label)
                 and point.is_measured()), None)
