"""The points as Markdown."""
from precision import errors, rungs, scenes

MM = 1e3  # per m


def percent(found):
    if found is None:
        return "—"
    error, spread = found
    if spread == 0.0:
        return f"{100.0 * error:+.2g}" if error else "0"
    digits = 1 if spread < 0.02 else 0
    return f"{100.0 * error:+.{digits}f} ± {100.0 * spread:.{digits}f}"


def condition(point):
    """What went wrong in it, in few words."""
    said = []
    if point.leaked():
        said.append(f"{point.leaked()} through the base")
    if point.pushed_out():
        said.append(f"{point.pushed_out()} pushed out")
    if point.failures:
        said.append(f"{len(point.failures)} ended early")
    return ", ".join(said) or "—"


def cost(point):
    return "—" if point.cost() is None else f"{point.cost():.3g}"


def gain(point, exact):
    return "—" if point.cost() is None or not exact.cost() else f"{exact.cost() / point.cost():.2f}"


def names(points):
    return list(points[0].scene.observables)


def sections(by_scene, families, reference):
    """A table for each scene: its columns are what is observed there."""
    for points in by_scene.values():
        own = [p for p in points if p.family in families and (p.costs or p.failures)]
        if not own:
            continue
        exact = next(p for p in points if p.family == "exact")
        yield f"**{points[0].scene.title}**"
        yield ""
        yield "| | s per simulated s | times faster | " + " | ".join(f"{n}, %" for n in names(points)) + \
            " | largest overlap, mm | failed |"
        yield "|---" * (5 + len(names(points))) + "|"
        for point in own:
            found = [percent(errors.relative(point, name, reference(points, name))) for name in names(points)]
            label = point.label if point.family in ("exact", "steps") else f"{point.family}, {point.label}"
            yield f"| {label} | {cost(point)} | {gain(point, exact)} | " + " | ".join(found) + \
                f" | {MM * point.overlap():.2g} | {condition(point)} |"
        yield ""


def method(by_scene):
    """Steps, held against what is known, or the exact engine on the same scene."""
    return "\n".join(sections(by_scene, ("exact", "steps"), errors.exact))


def model(by_scene):
    """Rungs of the model, held against the exact engine as the floor goes to 0."""
    limited = {name: points for name, points in by_scene.items()
               if any(p.family == "rebound floor" for p in points)}
    return "\n".join(sections(limited, ("exact", *rungs.MODEL), errors.limit))


def verdict(found, bound):
    if found is None:
        return "—"
    error, spread = found
    if abs(error) <= bound:
        return "held"
    return "not sure: within two standard errors" if abs(error) <= bound + 2.0 * spread else "**exceeded**"


def bound_of(claim, name, reference):
    """What may be off, over the reference's value."""
    if reference is None or name not in scenes.DRIFTS:
        return claim
    return max(claim, rungs.SMALLEST_DRIFT_ERROR / abs(reference[0]))


def claims(by_scene):
    """Of scenes that no setting was chosen by."""
    lines = ["| scene | step, ms | times faster | | claimed, % | found, % | |", "|---|---|---|---|---|---|---|"]
    for points in by_scene.values():
        exact = next(p for p in points if p.family == "exact")
        for step, claim in rungs.CLAIMS.items():
            point = next(p for p in points if p.rung.get("accuracy.step") == step)
            for name in names(points):
                reference = errors.exact(points, name)
                found = errors.relative(point, name, reference)
                bound = bound_of(claim, name, reference)
                lines.append(f"| {points[0].scene.title} | {1e3 * step:g} | {gain(point, exact)} | {name} | "
                             f"≤ {100.0 * bound:.2g} | {percent(found)} | {verdict(found, bound)} |")
    return "\n".join(lines)


def large(short, longer):
    """@param short, longer the points of the run that is short, and of the one that goes on"""
    lines = ["| | first second, s | s per simulated s after it | times faster | failed |", "|---|---|---|---|---|"]
    after = []
    for first, whole in zip(short, longer):
        if first.cost() is None or whole.cost() is None:
            lines.append(f"| {first.label} | — | — | — | {condition(whole)} |")
            continue
        spans = [point.scene.settings["duration"] for point in (first, whole)]
        after.append((whole.cost() * spans[1] - first.cost() * spans[0]) / (spans[1] - spans[0]))
        lines.append(f"| {first.label} | {first.cost() * spans[0]:.2f} | {after[-1]:.2f} | "
                     f"{after[0] / after[-1]:.2f} | {condition(whole)} |")
    return "\n".join(lines)
