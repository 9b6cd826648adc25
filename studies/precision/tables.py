"""How far the points are off their references, with the error of both: as Markdown, and as the figures of
accuracy.json."""
import dataclasses
import math

from ratchet_sieve.stats import Mean
from ratchet_sieve.texts import decimals_of, rounded, span, table as markdown
from precision.points import CLAIMS, FLOORS, REFERENCE_FLOOR, SCENES_FLOOR, STEPS, find, floor_of, ms

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
    percent = PERCENT * value
    if percent < 0.01:
        return "0.01"
    decimals = max(0, 1 - math.floor(math.log10(percent)))
    rounded_up = math.ceil(percent * 10 ** decimals - 1e-9) / 10 ** decimals
    return f"{rounded_up:.{0 if rounded_up >= 10.0 else decimals}f}"


ENERGIES = ("K_A", "K_B", "kinetic energy", "K_rot / K_trans")
DRIFTS = ("drift A", "drift B")


def seeds(points):
    return f"n = {span(sorted({mean.count for point in points for mean in point.means.values()}))}"


def about(points):
    """When these were measured, and where they were timed, by which physics."""
    parts = {"Errors": {point.measured for point in points}, "Times": {point.timed for point in points}}
    said = (f"{what}: " + "; ".join(str(origin) for origin in sorted(origins - {None}))
            for what, origins in parts.items() if origins - {None})
    return f"*{'. '.join(said)}.*\n\n"


def bounds(groups, known):
    """The largest bound of each scene's drifts, energies and others, by step. @param known figures()"""
    lines, used = [], []
    for name, points in groups.items():
        rows = {"speedup": "times faster", **{key: f"{title}, ≤ %" for key, title, _ in parts_of(points[0])}}
        steps = [point for point in points if point.family == "steps"]
        used += steps
        for key, title in rows.items() if steps else ():
            lines.append([points[0].scene.title if key == "speedup" else "", title,
                          *(known.get(f"{name}.{FAMILIES['steps']}{in_key(ms(step))}.{key}", "—") for step in STEPS)])
    return about(used) + markdown(["scene", "", *map(ms, STEPS)], lines)


def parts_of(point):
    """@return of each part of a scene's quantities the key of its bound, its title and their names"""
    groups = (("drifts", "drifts", DRIFTS), ("energies", "energies", ENERGIES), ("q", "Q", ("Q",)), ("p", "P", ("P",)))
    for key, title, names in groups:
        own = [name for name in point.scene.observables if name in names]
        if own:
            yield f"bound.{key}", title, own


# The numbers of a scene that are shown over the rebound floor.
OVER_FLOOR = {"fig3": ("drift A", "short / long"), "fig8": DRIFTS, "fig9": ("Q",), "dense": ("times faster", *DRIFTS),
              "violent": ("drift A",)}


def floors(groups, known):
    """Rebound floors against the least one. @param known figures()"""
    shown = [floor for floor in FLOORS if floor != REFERENCE_FLOOR]
    lines, used = [], []
    for name, numbers in OVER_FLOOR.items():
        points = groups.get(name, [])
        used += [point for point in points if floor_of(point) in shown]
        for number in numbers if points else ():
            key, unit = (f"error.{NAMES[number]}", ", %") if number in NAMES else ("speedup", "")
            found = {floor: known.get(f"{name}.floor_{in_key(f'{floor:g}')}.{key}", "—") for floor in shown}
            if key == "speedup" and f"{name}.exact.cost" in known:
                found[SCENES_FLOOR] = "1.0"  # the exact run itself, than which others are faster
            lines.append([f"{points[0].scene.title}: {number}{unit}", *found.values()])
    return about(used) + markdown(["", *(f"{floor:g} m/s" for floor in shown)], lines)


def verdict(error, claim):
    """Of a bound that was set before the scene was run."""
    if error is None:
        return "—"
    if bound(error) <= claim:
        return "holds"
    return "fails the original bound" if abs(error.value) - error.half_width() > claim else "not decided"


def failures(points, point, claim):
    """The errors that are not within a bound."""
    errors = {name: point and relative(point.means.get(name), exact_value(points, name))
              for name in points[0].scene.observables}
    found = [f"{name} {text(error)}: {verdict(error, claim)}" for name, error in errors.items()
             if verdict(error, claim) != "holds"]
    return "; ".join(found) or "all hold"


def claims(groups):
    """The held-out scenes: a row for each step, a column for each scene."""
    scenes = list(groups.values())
    if not scenes:
        return ""
    lines = [[ms(step), f"{PERCENT * claim:g}",
              *(failures(points, find(points, "steps", ms(step)), claim) for points in scenes)]
             for step, claim in CLAIMS.items()]
    return about(sum(scenes, [])) + markdown(
        ["step", "bound, %", *(f"{points[0].scene.title} ({seeds(points)})" for points in scenes)], lines)


def large_costs(groups):
    """@return pairs (setting, cost of a simulated second after the first one [s])"""
    found = []
    for first, whole in zip(*groups.values()) if len(groups) == 2 else ():
        if first.cost and whole.cost:
            start, end = (point.scene.settings["duration"] for point in (first, whole))
            found.append((first, (whole.cost * end - first.cost * start) / (end - start)))
    return found


NAMES = {"drift A": "drift_a", "drift B": "drift_b", "K_A": "k_a", "K_B": "k_b", "short / long": "short_to_long",
         "N m g T": "weight", "Q": "q", "P": "p", "kinetic energy": "energy", "K_rot / K_trans": "k_rot",
         "K_A / K_B": "equipartition", "energy, end / start": "energy_kept"}
FAMILIES = {"steps": "steps_", "rebound floor": "floor_", "contact duration": "contact_",
            "restitution by speed": "restitution_", "floor, in steps of 1 ms": "steps_1ms_floor_"}


def in_key(label):
    """As `1ms`, `0_025`."""
    return label.replace(" m/s", "").replace(" ", "").replace(".", "_")


def setting(point):
    """As `steps_1ms`, `floor_0_025`, `no_spin`."""
    prefix = FAMILIES.get(point.family)
    return prefix + in_key(point.label) if prefix else point.family.replace(" ", "_")


def of_errors(points, point, prefix, reference):
    found = {name: relative(point.means.get(name), reference(points, name)) for name in point.scene.observables}
    for name, error in found.items():
        if error is not None:
            yield f"{prefix}.error.{NAMES[name]}", text(error)
            yield f"{prefix}.bound.{NAMES[name]}", bound_text(bound(error))
    for key, _, names in parts_of(point):
        most = max((bound(found[name]) for name in names if found[name]), default=None)
        if most is not None:
            yield f"{prefix}.{key}", bound_text(most)


def of_scene(points):
    """Steps against the exact engine, what the model leaves out against the least floor."""
    name, exact = points[0].scene.name, find(points, "exact")
    if exact and exact.cost:
        yield f"{name}.exact.cost", f"{exact.cost:.3g}"
    for point in points:
        prefix = f"{name}.{setting(point)}"
        if exact and exact.cost and point.cost and point is not exact:
            speed = exact.cost / point.cost
            yield f"{prefix}.speedup", f"{speed:.{0 if speed >= 10.0 else 1 if speed >= 1.0 else 2}f}"
        if point.family == "steps":
            yield from of_errors(points, point, prefix, exact_value)
        elif name not in ("ball", "gas"):
            if point is exact:
                prefix = f"{name}.floor_{in_key(f'{SCENES_FLOOR:g}')}"
            if floor_of(point) != REFERENCE_FLOOR:
                yield from of_errors(points, point, prefix, least_floor)


def figures(groups, large, results, costs):
    """@param results, costs the origins of both, the newest last"""
    found = {"date": results[-1].date, "version": f"physics version {results[-1].physics}",
             "machine": costs[-1].machine, "costs.date": costs[-1].date,
             "costs.version": f"physics version {costs[-1].physics}",
             "reference.floor": f"{REFERENCE_FLOOR:g}"}
    for points in groups.values():
        found.update(of_scene(points))
    after = large_costs(large)
    for point, cost in after:
        found[f"large.{setting(point)}.cost"] = f"{cost:.2f}"
        if point.family == "steps":
            found[f"large.{setting(point)}.speedup"] = f"{after[0][1] / cost:.1f}"
    return found
