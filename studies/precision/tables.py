"""How far the points are off their references, with the error of both: as Markdown, a column for each setting and a row
for each quantity, and as the figures of accuracy.json."""
import dataclasses
import math
import re

from ratchet_sieve.stats import Mean
from ratchet_sieve.texts import decimals_of, rounded, span, table as markdown
from precision.points import (CLAIMS, MODEL, REFERENCE_FLOOR, SCENES_FLOOR, STEPS, by_scene, find, floor_of)

PERCENT = 100.0
LEAST = 1e-3  # that is printed [%]


def exact_value(points, name):
    """The value that is known, or that of the exact engine on the same scene; None where it was not measured."""
    point = find(points, "exact")
    if point is None:
        return None
    known = point.scene.known.get(name)
    return point.means.get(name) if known is None else Mean(known, 0.0, 2)


def least_floor(points, name):
    """That of the exact engine at the least rebound floor; None where it was not measured."""
    point = find(points, "rebound floor", f"{REFERENCE_FLOOR:g} m/s")
    return point and point.means.get(name)


def relative(observed, reference):
    """@return the error over the reference's value, as a Mean with the standard error of both; None where one is
    missing or has no standard error"""
    if observed is None or reference is None or None in (observed.error, reference.error):
        return None
    ratio = observed.value / reference.value
    spread = observed.minus(reference.scaled(ratio)).scaled(1.0 / reference.value)
    return dataclasses.replace(spread, value=math.copysign(ratio - 1.0, (ratio - 1.0) * reference.value))


def bound(error):
    """What the error is at most, at 95 %: its estimate and the half-width of its interval."""
    return abs(error.value) + error.half_width()


def largest(found):
    """The largest bound of several errors; None where there is none."""
    return max((bound(error) for error in found if error is not None), default=None)


def is_seen(error):
    """Whether the interval of 95 % leaves 0 out."""
    return abs(error.value) > error.half_width()


def text(error):
    """As +1.2 ± 0.4, in per cent with the half-width at 95 %."""
    if error is None:
        return "—"
    half = PERCENT * error.half_width()
    if half < LEAST:
        return f"{PERCENT * error.value:+.2g}".replace("-", "−") if PERCENT * abs(error.value) >= LEAST else "0"
    value = rounded(PERCENT * error.value, decimals_of(half))
    return f"{value if value.startswith('−') else '+' + value} ± {rounded(half, decimals_of(half))}"


def bound_text(value):
    """In per cent, rounded up to two digits."""
    if value is None:
        return "—"
    percent = PERCENT * value
    if percent < 0.01:
        return "0.01"
    decimals = max(0, 1 - math.floor(math.log10(percent)))
    rounded_up = math.ceil(percent * 10 ** decimals - 1e-9) / 10 ** decimals
    return f"{rounded_up:.{0 if rounded_up >= 10.0 else decimals}f}"


MM = 1e3  # per m
ROUNDING = 1e-12  # overlaps up to this are rounding [m]
ENERGIES = ("K_A", "K_B", "kinetic energy", "K_rot / K_trans")
DRIFTS = ("drift A", "drift B")


def condition(point):
    """What went wrong in it."""
    parts = {"through the base": point.through_base, "pushed out": point.pushed_out, "ended early": point.ended_early}
    return ", ".join(f"{count:g} {what}" for what, count in parts.items() if count) or "—"


def overlap_text(point):
    return f"{MM * point.overlap:.1g}" if point.overlap > ROUNDING else "rounding"


def speed_up(point, exact):
    """@return exact time over the point's; None where one was not measured"""
    return exact.cost / point.cost if exact and exact.cost and point and point.cost else None


def speed_text(speed):
    return "—" if speed is None else f"{speed:.{0 if speed >= 10.0 else 1 if speed >= 1.0 else 2}f}"


def seeds(points):
    return f"n = {span(sorted({mean.count for point in points for mean in point.means.values()}))}"


def quantities(point):
    """In the order of the scene."""
    return list(point.scene.observables)


def section(points, columns, reference):
    """The table of a scene. @param columns the points that are its columns"""
    exact = find(points, "exact")
    lines = [["times faster", *(speed_text(speed_up(point, exact)) for point in columns)]]
    for name in quantities(points[0]):
        known = reference(points, name)
        lines.append([f"{name}, %", *(text(relative(point.means.get(name), known)) for point in columns)])
    lines.append(["largest overlap, mm", *(overlap_text(point) for point in columns)])
    if any(condition(point) != "—" for point in columns):
        lines.append(["disks", *(condition(point) for point in columns)])
    return f"**{points[0].scene.title}** ({seeds(columns)})\n\n" + markdown(
        ["", *(point.label for point in columns)], lines)


def measured(points, family):
    return [point for point in points if point.family == family and point.is_measured()]


def with_floors(points):
    """Those in which the rebound floor alone is changed, and the scene itself; the largest floor first."""
    own = [point for point in points if floor_of(point) not in (None, REFERENCE_FLOOR) and point.is_measured()]
    return sorted(own, key=floor_of, reverse=True)


def method(groups):
    """Steps against the known value or the exact engine."""
    return "\n\n".join(section(points, measured(points, "steps"), exact_value)
                       for points in groups.values() if measured(points, "steps"))


def bounds(groups):
    """The largest bound of each scene's drifts, energies and others, by step."""
    lines = []
    for points in groups.values():
        steps = {point.label: point for point in measured(points, "steps")}
        exact = find(points, "exact")
        names = [f"{1e3 * step:g} ms" for step in STEPS]
        if not steps:
            continue
        lines.append([points[0].scene.title, "times faster",
                      *(speed_text(speed_up(steps.get(name), exact)) for name in names)])
        for title, chosen in parts_of(points):
            lines.append(["", f"{title}, ≤ %", *(bound_text(step_bound(points, steps.get(name), chosen))
                                                 for name in names)])
    return markdown(["scene", "", *(f"{1e3 * step:g} ms" for step in STEPS)], lines)


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
    return largest(relative(point.means.get(name), exact_value(points, name)) for name in names)


def floors(groups):
    """Rebound floors against the least one."""
    found = {name: with_floors(points) for name, points in groups.items()}
    return "\n\n".join(
        section(groups[name], own, least_floor).replace("| exact |", f"| {SCENES_FLOOR:g} m/s |", 1)
        for name, own in found.items() if any(point.family == "rebound floor" for point in own))


def model(groups):
    """Other parts of the model against the least floor, of Fig. 8: a row for each setting, for it has many."""
    points = groups.get("fig8", [])
    own = [point for family in MODEL if family != "rebound floor" for point in measured(points, family)]
    if not own:
        return ""
    names = [name for name in quantities(points[0]) if name != "N m g T"]
    lines = [[f"{point.family}, {point.label}", speed_text(speed_up(point, find(points, "exact"))),
              *(text(relative(point.means.get(name), least_floor(points, name))) for name in names)] for point in own]
    return f"**{points[0].scene.title}** ({seeds(own)})\n\n" + markdown(
        ["", "times faster", *(f"{name}, %" for name in names)], lines)


def verdict(error, claim):
    """Of a bound that was set before the scene was run."""
    if error is None:
        return "—"
    if bound(error) <= claim:
        return "holds"
    return "fails the original bound" if abs(error.value) - error.half_width() > claim else "not decided"


def claims(groups):
    """The held-out scenes: a row for each step and quantity, a column for each scene."""
    scenes = list(groups.values())
    if not scenes:
        return ""
    lines = []
    for step, claim in CLAIMS.items():
        label = f"{1e3 * step:g} ms"
        columns = [find(points, "steps", label) for points in scenes]
        lines.append([f"**{label}**: times faster", "", *(
            speed_text(speed_up(point, find(points, "exact"))) for points, point in zip(scenes, columns))])
        for name in quantities(scenes[0][0]):
            cells = []
            for points, point in zip(scenes, columns):
                error = point and relative(point.means.get(name), exact_value(points, name))
                cells.append(f"{text(error)}: {verdict(error, claim)}")
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


NAMES = {"drift A": "drift_a", "drift B": "drift_b", "K_A": "k_a", "K_B": "k_b", "short / long": "short_to_long",
         "N m g T": "weight", "Q": "q", "P": "p", "kinetic energy": "energy", "K_rot / K_trans": "k_rot",
         "K_A / K_B": "equipartition", "energy, end / start": "energy_kept"}
FAMILIES = {"steps": "steps_", "rebound floor": "floor_", "contact duration": "contact_",
            "restitution by speed": "restitution_", "floor, in steps of 1 ms": "steps_1ms_floor_"}


def setting(point):
    """As `steps_1ms`, `floor_0_025`, `no_spin`."""
    if point.family in FAMILIES:
        return FAMILIES[point.family] + re.sub(r"[ .]", lambda found: "_" if found.group() == "." else "",
                                               point.label.replace(" m/s", ""))
    return point.family.replace(" ", "_")


def of_errors(points, point, prefix, reference):
    found = {name: relative(point.means.get(name), reference(points, name)) for name in quantities(point)}
    for name, error in found.items():
        if error is not None:
            yield f"{prefix}.error.{NAMES[name]}", text(error)
            yield f"{prefix}.bound.{NAMES[name]}", bound_text(bound(error))
    for title, names in parts_of(points):
        most = largest(found[name] for name in names)
        if most is not None and title in ("drifts", "energies"):
            yield f"{prefix}.bound.{title}", bound_text(most)


def of_scene(points):
    """Steps against the exact engine, what the model leaves out against the least floor."""
    name, exact = points[0].scene.name, find(points, "exact")
    if exact and exact.cost:
        yield f"{name}.exact.cost", f"{exact.cost:.3g}"
    for point in points:
        prefix = f"{name}.{setting(point)}"
        speed = speed_up(point, exact)
        if speed is not None and point is not exact:
            yield f"{prefix}.speedup", speed_text(speed)
        if point.family == "steps":
            yield from of_errors(points, point, prefix, exact_value)
        elif name not in ("ball", "gas"):
            floor = floor_of(point)
            if point is exact:
                prefix = f"{name}.floor_{SCENES_FLOOR:g}".replace("0.", "0_")
            if floor != REFERENCE_FLOOR:
                yield from of_errors(points, point, prefix, least_floor)


def figures(groups, large, results, costs):
    """@param results, costs the origins of both, the newest last"""
    found = {"date": results[-1].date, "version": f"physics version {results[-1].physics}",
             "machine": costs[-1].machine, "costs.date": costs[-1].date, "costs.version": f"physics version {costs[-1].physics}",
             "reference.floor": f"{REFERENCE_FLOOR:g}"}
    for points in groups.values():
        found.update(of_scene(points))
    after = large_costs(large)
    for point, (_, cost) in after:
        found[f"large.{setting(point)}.cost"] = f"{cost:.2f}"
        if point.family == "steps":
            found[f"large.{setting(point)}.speedup"] = f"{after[0][1][1] / cost:.1f}"
    return found
