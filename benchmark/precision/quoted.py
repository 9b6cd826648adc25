"""The figures of accuracy.json, which documents quote."""
import re

from precision import errors, rungs, tables
from precision.points import find

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
    found = {name: errors.relative(point.means.get(name), reference(points, name)) for name in tables.quantities(point)}
    for name, error in found.items():
        if error is not None:
            yield f"{prefix}.error.{NAMES[name]}", errors.text(error)
            yield f"{prefix}.bound.{NAMES[name]}", errors.bound_text(errors.bound(error))
    for title, names in tables.parts_of(points):
        largest = errors.largest(found[name] for name in names)
        if largest is not None and title in ("drifts", "energies"):
            yield f"{prefix}.bound.{title}", errors.bound_text(largest)


def of_scene(points):
    """Steps against the exact engine, what the model leaves out against the least floor."""
    name, exact = points[0].scene.name, find(points, "exact")
    if exact and exact.cost:
        yield f"{name}.exact.cost", f"{exact.cost:.3g}"
    for point in points:
        prefix = f"{name}.{setting(point)}"
        speed = tables.speed_up(point, exact)
        if speed is not None and point is not exact:
            yield f"{prefix}.speedup", tables.speed_text(speed)
        if point.family == "steps":
            yield from of_errors(points, point, prefix, errors.exact)
        elif name not in ("ball", "gas"):
            floor = rungs.floor_of(point)
            if point is exact:
                prefix = f"{name}.floor_{rungs.SCENES_FLOOR:g}".replace("0.", "0_")
            if floor != rungs.REFERENCE_FLOOR:
                yield from of_errors(points, point, prefix, errors.least_floor)


def figures(groups, large, results, costs):
    """@param results, costs the origins of both, the newest last"""
    found = {"date": results[-1].date, "version": f"physics version {results[-1].physics}",
             "machine": costs[-1].machine, "costs.date": costs[-1].date, "costs.version": f"physics version {costs[-1].physics}",
             "reference.floor": f"{rungs.REFERENCE_FLOOR:g}"}
    for points in groups.values():
        found.update(of_scene(points))
    after = tables.large_costs(large)
    for point, (_, cost) in after:
        found[f"large.{setting(point)}.cost"] = f"{cost:.2f}"
        if point.family == "steps":
            found[f"large.{setting(point)}.speedup"] = f"{after[0][1][1] / cost:.1f}"
    return found
