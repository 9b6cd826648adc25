"""Scenes at the limits of legal parameters, and the expected result of each."""
import copy
import math
from typing import NamedTuple

RUNS = "runs"          # to its end, without a collapse
GOES_ON = "goes on"    # to its end, through collapses that it counts
STOPS = "stops"        # to a collapse, which it reports
REFUSED = "refused"    # refused before it starts, with the wrong key


class Extreme(NamedTuple):
    """One scene, as a tree of its YAML."""

    group: str
    what: str
    scene: dict
    comes_to: str
    short: float  # duration where time is short [s]


def mixture(**base):
    """The two species of Fig. 8 over ten teeth."""
    return {
        "base": {"teeth": 10, "tooth_width": 0.02, "tooth_height": 0.006, "asymmetry": 0.3,
                 "amplitude": 0.002, "frequency": 23.0, **base},
        "species": [{"name": "A", "count": 60, "radius": 0.001, "mass": 0.010},
                    {"name": "B", "count": 60, "radius": 0.002, "mass": 0.001}],
        "contact": {"min_rebound_speed": 0.05},
        "duration": 20.0,
    }


def changed(scene, **sections):
    """With keys of sections (a dict), of the root, or of every species (species=dict) set."""
    scene = copy.deepcopy(scene)
    for name, value in sections.items():
        if name == "species":
            for species in scene["species"]:
                species.update(value)
        elif isinstance(value, dict):
            scene.setdefault(name, {}).update(value)
        else:
            scene[name] = value
    return scene


def sized(scene, radii, counts=(30, 30), masses=(0.010, 0.001)):
    """With species of these radii, counts and masses."""
    scene = copy.deepcopy(scene)
    for species, radius, count, mass in zip(scene["species"], radii, counts, masses):
        species.update(radius=radius, count=count, mass=mass)
    return scene


def scaled(length, time, **sections):
    """The mixture in other units: its lengths and times multiplied."""
    scene = mixture()
    for key in ("tooth_width", "tooth_height", "amplitude"):
        scene["base"][key] *= length
    scene["base"]["frequency"] /= time
    for species in scene["species"]:
        species["radius"] *= length
    scene["contact"]["min_rebound_speed"] *= length / time
    scene["gravity"] = 9.81 * length / time ** 2
    scene["pour"] = {"drop_height": 0.02 * length}
    scene["duration"] *= time
    return changed(scene, **sections)


def heap(**contact):
    """Disks that lose nearly all their energy come to rest in a heap on a base at rest."""
    scene = changed(mixture(amplitude=0.0), species={"restitution": 0.1, "count": 150},
                    contact={"min_rebound_speed": 0.0, **contact}, duration=3.0)
    return scene


def amplitude_of(acceleration):
    return acceleration * 9.81 / (2.0 * math.pi * 23.0) ** 2


def frequency_of(acceleration):
    return math.sqrt(acceleration * 9.81 / 0.002) / (2.0 * math.pi)


BOUNDARIES = ("periodic", "walled", "open")


def profiled(corners, teeth=10, **base):
    """On teeth of this outline."""
    scene = mixture(teeth=teeth, profile=corners, **base)
    for key in ("tooth_width", "tooth_height", "asymmetry"):
        del scene["base"][key]
    return scene


def smallest_radius(scene):
    """Of all disks of a scene [m]."""
    return min(species["radius"] * least_factor(species) for species in scene["species"])


def least_factor(species):
    size = species.get("size", {"distribution": "uniform", "spread": 0.0})
    if size["distribution"] == "table":
        return size["radii"][0] / species["radius"]
    return {"uniform": 1.0 - size["spread"], "normal": 1.0 - 3.0 * size["spread"],
            "lognormal": math.exp(-3.0 * size["spread"])}[size["distribution"]]


def collisions():
    """Limits of the collision law's coefficients."""
    for value in (0.0, 1.0):
        yield "restitution", f"e = {value:g}", changed(mixture(), species={"restitution": value}), RUNS
    yield ("restitution", "e = 1, no rebound floor",
           changed(mixture(), species={"restitution": 1.0}, contact={"min_rebound_speed": 0.0}), RUNS)
    for friction in (0.0, 1e3):
        for tangential in (-1.0, 0.0, 1.0):
            coefficients = {"friction": friction, "tangential_restitution": tangential}
            # A disk that neither slips nor loses spin gets wedged between two faces within seconds, in most runs.
            wedges = friction > 0.0 and tangential == 1.0
            yield ("friction", f"μ = {friction:g}, β = {tangential:g}",
                   changed(mixture(), species=coefficients, duration=2.0 if wedges else 5.0), RUNS)
    rough = {"friction": 1e3, "tangential_restitution": 1.0}
    for factor in (1e-3, 1e-2, 1.0):
        yield ("inertia", f"α = {factor:g}, μ = 1000, β = 1",
               changed(mixture(), species={"inertia_factor": factor, **rough}, duration=5.0), RUNS)


def shapes():
    """Degenerate and extreme teeth."""
    yield "teeth", "a = 0: left faces vertical", mixture(asymmetry=0.0), RUNS
    yield "teeth", "a = 1: right faces vertical", mixture(asymmetry=1.0), RUNS
    yield "teeth", "h = 0: flat", mixture(tooth_height=0.0), RUNS
    needles = mixture(tooth_height=0.4)
    yield "teeth", "needles, h = 20 w: disks wedge", needles, STOPS
    yield ("teeth", "needles, goes on", changed(needles, contact={
        "on_collapse": "rebound", "collapse_events": 10000}), GOES_ON)
    yield "teeth", "needles, μ = 1000", changed(needles, species={"friction": 1e3}, duration=1.0), RUNS


def profiles():
    """Teeth of any outline, in all boundaries."""
    needle = [[0, 0], [0.0099, 0], [0.01, 0.1], [0.0101, 0], [0.02, 0]]
    wave = [[2e-4 * i, round(0.006 * math.sin(0.02 * math.pi * i) + 5e-4 * math.sin(0.3 * math.pi * i), 6)]
            for i in range(101)]
    slots = [[0, 0], [0.0045, 0], [0.0045, 0.006], [0.009, 0.006], [0.009, -0.02], [0.0102, -0.02], [0.0102, 0.006],
             [0.015, 0.006], [0.015, 0], [0.02, 0]]
    plateau = [[0, 0], [0.003, 0.006], [0.012, 0.006], [0.016, 0], [0.02, 0]]
    fine = [[0, 0], [2e-5, 6e-5], [4e-5, 2e-5], [6e-5, 6e-5], [6e-5, 0], [1e-4, 0]]
    for boundary in BOUNDARIES:
        for what, scene in (("needles a hundredth of a tooth wide, 5 w high", profiled(needle)),
                            ("a rough wave of 100 faces", profiled(wave)),
                            ("vertical faces, slots narrower than a disk", profiled(slots)),
                            ("a plateau, θ = 0.3 rad", profiled(plateau, inclination=0.3)),
                            ("teeth a tenth of the radius, two apices", profiled(fine, teeth=2000))):
            yield "profile", f"{what}, {boundary}", changed(scene, boundary=boundary, duration=10.0), RUNS


def wide_sizes():
    """Disks of one species as wide apart as 1:50 and as a lognormal, in all boundaries."""
    for boundary in BOUNDARIES:
        few = changed(mixture(), boundary=boundary, duration=5.0)
        table = {"distribution": "table", "radii": [3e-4, 0.0149, 0.015], "weights": [49, 0, 1], "mass_exponent": 2}
        wide = changed(few, species={"radius": 3e-4, "size": table})
        yield "sizes", f"radii 1:50, masses 1:2500, {boundary}", wide, RUNS
        balls = changed(wide, species={"size": dict(table, mass_exponent=3)}, contact={
            "on_collapse": "rebound", "collapse_events": 10000})
        yield "sizes", f"radii 1:50, masses 1:125,000, goes on, {boundary}", balls, GOES_ON
        yield "sizes", f"lognormal, σ = 0.5, {boundary}", changed(
            few, species={"size": {"distribution": "lognormal", "spread": 0.5}}), RUNS


def sizes():
    """Ratios of disks to teeth, to the machine, and to each other."""
    for ratio in (1e-3, 1e-2, 0.1, 1.0, 10.0, 100.0):
        radius = ratio * 0.02
        teeth = max(3, int(8 * ratio))
        scene = changed(sized(mixture(teeth=teeth), (radius, 0.5 * radius)), duration=20.0 if ratio < 1.0 else 3.0)
        yield "disk to tooth", f"r / w = {ratio:g} and half of it", scene, RUNS
    yield "disk to machine", "r / W = 4e-6 and half of it", sized(mixture(), (8e-7, 4e-7)), RUNS
    yield "disk to machine", "r / W = 1e-7", sized(mixture(), (2e-8, 2e-8)), REFUSED
    uneven = changed(sized(mixture(), (1e-4, 1e-2), (100, 5), (1e-6, 1.0)), duration=5.0)
    yield "disk to disk", "radii 1 : 100, masses 1 : 10⁶: light disks crushed", uneven, STOPS
    yield ("disk to disk", "the same, goes on", changed(uneven, contact={
        "on_collapse": "rebound", "collapse_events": 10000}), GOES_ON)


def drives():
    """Inclinations, and drives from none to far beyond any feeder's."""
    for angle in (1.5, -1.5, 0.8):
        for boundary in BOUNDARIES:
            yield "inclination", f"θ = {angle:g} rad, {boundary}", changed(
                mixture(inclination=angle), boundary=boundary, duration=10.0), RUNS
            yield "inclination", f"θ = {angle:g} rad, drive of the deck, {boundary}", changed(
                mixture(inclination=angle, drive_frame="base", horizontal_amplitude=-0.001), boundary=boundary,
                duration=10.0), RUNS
    yield "drive", "A = 0", mixture(amplitude=0.0), RUNS
    yield "drive", "f = 0", mixture(frequency=0.0), RUNS
    for acceleration in (1e-3, 1e-2, 0.1, 1.0, 10.0, 100.0, 1e3, 1e4):
        few = {"duration": 10.0} if acceleration >= 1e3 else {}
        yield ("drive", f"A ω² = {acceleration:g} g by A",
               changed(mixture(amplitude=amplitude_of(acceleration)), **few), RUNS)
        yield ("drive", f"A ω² = {acceleration:g} g by f",
               changed(mixture(frequency=frequency_of(acceleration)), **few), RUNS)
    alone = changed(mixture(amplitude=amplitude_of(1e4)), contact={"pair_collisions": False}, duration=3000.0)
    yield "drive", "A ω² = 10⁴ g by A, single disks: flights of 20 km", alone, RUNS
    yield "gravity", "g = 0", changed(mixture(), gravity=0.0, pour={"speed": 0.1}), RUNS
    yield "gravity", "g = 10⁴ m/s²", changed(mixture(), gravity=1e4, duration=1.0), RUNS


def orbits():
    """Drives with a horizontal part and harmonics."""
    for boundary in BOUNDARIES:
        yield "orbit", f"A_x = A, oblique, {boundary}", changed(
            mixture(horizontal_amplitude=0.002), boundary=boundary, duration=10.0), RUNS
    circle = {"horizontal_phase": 0.5 * math.pi}
    for acceleration in (0.1, 10.0, 1e3):
        amplitude = amplitude_of(acceleration)
        yield "orbit", f"a circle, A ω² = {acceleration:g} g", changed(
            mixture(amplitude=amplitude, horizontal_amplitude=amplitude, **circle), duration=10.0), RUNS
    yield "orbit", "A = 0, A_x = 10 mm: to and fro alone", changed(
        mixture(amplitude=0.0, horizontal_amplitude=0.01), duration=10.0), RUNS
    yield "orbit", "θ = 1.5 rad, oblique, walled", changed(
        mixture(inclination=1.5, horizontal_amplitude=-0.002), boundary="walled", duration=10.0), RUNS
    hundredth = {"multiple": 100, "amplitude": 2e-6, "horizontal_amplitude": 2e-6, "horizontal_phase": 1.0}
    yield "orbit", "k = 100 with A_k = A / 1000", changed(mixture(harmonics=[hundredth]), duration=5.0), RUNS


def walls():
    """Walls from lower than a disk to the largest legal height."""
    for height in (1e-4, 0.01, 1000.0):
        yield "walls", f"{height:g} m high", changed(
            mixture(wall_height=height), boundary="walled", duration=10.0), RUNS
    for angle in (1.5, -1.5):
        yield "walls", f"0.05 m high, θ = {angle:g} rad", changed(
            mixture(wall_height=0.05, inclination=angle), boundary="walled", duration=10.0), RUNS


def amounts():
    """From no disk to many, and heaps at rest."""
    for count in (0, 1, 2):
        yield "number", f"N = {count}", sized(mixture(), (0.001, 0.002), (count, 0)), RUNS
    many = changed(sized(mixture(teeth=3822), (0.001, 0.002), (50000, 50000)), duration=1.0)
    yield "number", "N = 100,000", many, RUNS
    yield "dense heap", "e = 0.1, neither rule: collapses", heap(), STOPS
    yield "dense heap", "e = 0.1, neither rule, goes on", heap(
        on_collapse="rebound", collapse_events=1000), GOES_ON
    yield "dense heap", "e = 0.1, v_min = 0.05 m/s", heap(min_rebound_speed=0.05), RUNS
    yield "dense heap", "e = 0.1, v_min = 0.01 m/s", heap(min_rebound_speed=0.01), RUNS
    yield "dense heap", "e = 0.1, t_c = 1 ms", heap(contact_duration=1e-3), RUNS
    yield "dense heap", "e = 0.1, t_c = 1 ms, v_min = 0.01 m/s", heap(
        contact_duration=1e-3, min_rebound_speed=0.01), RUNS


def floors():
    """The minimum rebound speed from 0 to more than the drive's speed."""
    yield "rebound floor", "v_min = 0", changed(mixture(), contact={"min_rebound_speed": 0.0}), STOPS
    yield "rebound floor", "v_min = 0, goes on", changed(mixture(), contact={
        "min_rebound_speed": 0.0, "on_collapse": "rebound", "collapse_events": 10000}), GOES_ON
    yield "rebound floor", "v_min = 10⁻⁶ m/s", changed(mixture(), contact={"min_rebound_speed": 1e-6}), STOPS
    for speed in (1e-4, 1e-3, 1e-2, 0.1, 1.0):
        yield "rebound floor", f"v_min = {speed:g} m/s", changed(mixture(), contact={"min_rebound_speed": speed}), RUNS


def by_speed():
    """A speed-dependent restitution, without minimum rebound speed and contact duration."""
    def scene(speed, exponent=0.75, of=mixture):
        return changed(of(), contact={"min_rebound_speed": 0.0, "restitution_speed": speed,
                                      "restitution_exponent": exponent})
    for speed in (10.0, 2.0, 0.1, 0.01):
        # The disks reach the base with about 1 m/s. With a v_0 far below that they come to rest, at 1 m/s some do.
        yield "restitution by speed", f"v_0 = {speed:g} m/s, q = 0.75", scene(speed), RUNS if speed >= 2.0 else STOPS
    yield "restitution by speed", "v_0 = 1 m/s, q = 0.2", scene(1.0, 0.2), STOPS
    yield "restitution by speed", "v_0 = 1 m/s, q = 2", scene(1.0, 2.0), RUNS
    yield ("restitution by speed", "dense heap, e = 0.1, v_0 = 1 m/s, q = 0.75",
           changed(scene(1.0, of=heap), duration=6.0), STOPS)


def units():
    """The same machine in other units."""
    yield "units", "μm and MHz: w = 1 μm, f = 1 MHz, g scaled", scaled(
        5e-5, 23e-6, gravity=1e4, duration=5e-4), RUNS
    yield "units", "μm and MHz under 9.81 m/s²", scaled(
        5e-5, 23e-6, gravity=9.81, duration=0.05), RUNS
    yield "units", "km: w = 1 km, r = 50 and 100 m", scaled(
        5e4, math.sqrt(5e4), species={"mass": 1e6}), RUNS


def extremes():
    """All of them, in the order of the table."""
    for part in (collisions, shapes, profiles, sizes, wide_sizes, drives, orbits, walls, amounts, floors, by_speed, units):
        for group, what, scene, comes_to in part():
            yield Extreme(group, what, scene, comes_to, 0.05 * scene["duration"])
