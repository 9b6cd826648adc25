"""The points as Markdown: a column for each setting, a row for each quantity."""
from precision import errors, rungs
from precision.points import by_scene, find
from ratchet_sieve.texts import table as markdown

MM = 1e3  # per m
ROUNDING = 1e-12  # overlaps up to this are rounding [m]
ENERGIES = ("K_A", "K_B", "kinetic energy", "K_rot / K_trans")
DRIFTS = ("drift A", "drift B")


def condition(point):
    """What went wrong in it."""
    parts = [(point.through_base, "through the base"), (point.pushed_out, "pushed out"),
             (point.ended_early, "ended early")]
    return ", ".join(f"{count:g} {what}" for count, what in parts if count) or "—"


def overlap_text(point):
    return f"{MM * point.overlap:.1g}" if point.overlap > ROUNDING else "rounding"


def speed_up(point, exact):
    """@return exact time over the point's; None where one was not measured"""
    return exact.cost / point.cost if exact and exact.cost and point and point.cost else None


def speed_text(speed):
    return "—" if speed is None else f"{speed:.{0 if speed >= 10.0 else 1 if speed >= 1.0 else 2}f}"


def seeds(points):
    counts = sorted({mean.count for point in points for mean in point.means.values()})
    return f"n = {counts[0]}" if len(counts) == 1 else f"n = {counts[0]} to {counts[-1]}"


def quantities(point):
    """In the order of the scene."""
    return list(point.scene.observables)


def section(points, columns, reference):
    """The table of a scene. @param columns the points that are its columns"""
    exact = find(points, "exact")
    lines = [["times faster", *(speed_text(speed_up(point, exact)) for point in columns)]]
    for name in quantities(points[0]):
        known = reference(points, name)
        lines.append([f"{name}, %", *(errors.text(errors.relative(point.means.get(name), known)) for point in columns)])
    lines.append(["largest overlap, mm", *(overlap_text(point) for point in columns)])
    if any(condition(point) != "—" for point in columns):
        lines.append(["disks", *(condition(point) for point in columns)])
    return f"**{points[0].scene.title}** ({seeds(columns)})\n\n" + markdown(
        ["", *(point.label for point in columns)], lines)


def measured(points, family):
    return [point for point in points if point.family == family and point.is_measured()]


def method(groups):
    """Steps against the known value or the exact engine."""
    return "\n\n".join(section(points, measured(points, "steps"), errors.exact)
                       for points in groups.values() if measured(points, "steps"))


def bounds(groups):
    """The largest bound of each scene's drifts, energies and others, by step."""
    lines = []
    for points in groups.values():
        steps = {point.label: point for point in measured(points, "steps")}
        exact = find(points, "exact")
        names = [f"{1e3 * step:g} ms" for step in rungs.STEPS]
        if not steps:
            continue
        lines.append([points[0].scene.title, "times faster",
                      *(speed_text(speed_up(steps.get(name), exact)) for name in names)])
        for title, chosen in parts_of(points):
            lines.append(["", f"{title}, ≤ %", *(errors.bound_text(step_bound(points, steps.get(name), chosen))
                                                 for name in names)])
    return markdown(["scene", "", *(f"{1e3 * step:g} ms" for step in rungs.STEPS)], lines)


def parts_of(points):
    """@return pairs (title, names of quantities) of a scene"""
    groups = (("drifts", DRIFTS), ("energies", ENERGIES), ("Q", ("Q",)), ("P", ("P",)))
    for title, names in groups:
        own = [name for name in quantities(points[0]) if name in names]
        if own:
            yield title, own


def step_bound(points, point, names):
    if point is None:
        return None
    return errors.largest(errors.relative(point.means.get(name), errors.exact(points, name)) for name in names)


def floors(groups):
    """Rebound floors against the least one."""
    texts = []
    for points in groups.values():
        own = sorted((point for point in points if rungs.floor_of(point) and point.is_measured()
                      and rungs.floor_of(point) != rungs.REFERENCE_FLOOR), key=rungs.floor_of, reverse=True)
        if not any(point.family == "rebound floor" for point in own):
            continue
        table = section(points, own, errors.least_floor)
        texts.append(table.replace("| exact |", f"| {rungs.SCENES_FLOOR:g} m/s |", 1))
    return "\n\n".join(texts)


def model(groups):
    """Other parts of the model against the least floor: a row for each setting, for it has many."""
    texts = []
    for points in groups.values():
        own = [point for family in rungs.MODEL if family != "rebound floor" for point in measured(points, family)]
        if not own or points[0].scene.name != "fig8":
            continue
        names = [name for name in quantities(points[0]) if name != "N m g T"]
        exact = find(points, "exact")
        lines = [[f"{point.family}, {point.label}", speed_text(speed_up(point, exact)),
                  *(errors.text(errors.relative(point.means.get(name), errors.least_floor(points, name)))
                    for name in names)] for point in own]
        texts.append(f"**{points[0].scene.title}** ({seeds(own)})\n\n" + markdown(
            ["", "times faster", *(f"{name}, %" for name in names)], lines))
    return "\n\n".join(texts)


def verdict(error, claim):
    """Of a bound that was set before the scene was run."""
    if error is None:
        return "—"
    if errors.bound(error) <= claim:
        return "holds"
    return "fails the original bound" if abs(error.value) - error.half_width() > claim else "not decided"


def claims(groups):
    """The held-out scenes: a row for each step and quantity, a column for each scene."""
    scenes = list(groups.values())
    if not scenes:
        return ""
    lines = []
    for step, claim in rungs.CLAIMS.items():
        label = f"{1e3 * step:g} ms"
        columns = [find(points, "steps", label) for points in scenes]
        lines.append([f"**{label}**: times faster", "", *(
            speed_text(speed_up(point, find(points, "exact"))) for points, point in zip(scenes, columns))])
        for name in quantities(scenes[0][0]):
            cells = []
            for points, point in zip(scenes, columns):
                error = point and errors.relative(point.means.get(name), errors.exact(points, name))
                cells.append(f"{errors.text(error)}: {verdict(error, claim)}")
            lines.append([name, f"≤ {100.0 * claim:g}", *cells])
    return markdown(["", "bound set before, %", *(f"{points[0].scene.title} ({seeds(points)})" for points in scenes)],
                    lines)


def large_costs(points):
    """@return pairs (setting, (cost of the first second [s], of a simulated second after it [s]))"""
    scenes = list(by_scene([point for point in points if point.cost]).values())
    if len(scenes) != 2:
        return []
    found = []
    for first in scenes[0]:
        for whole in (point for point in scenes[1] if point.label == first.label):
            start, end = (point.scene.settings["duration"] for point in (first, whole))
            found.append((first, (first.cost * start, (whole.cost * end - first.cost * start) / (end - start))))
    return found


def large(points):
    found = large_costs(points)
    lines = [[point.label, f"{first:.2f}", f"{after:.2f}", f"{found[0][1][1] / after:.1f}"]
             for point, (first, after) in found]
    return markdown(["", "first second, s", "s per simulated s after it", "times faster"], lines)
