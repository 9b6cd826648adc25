"""What the machines of studies are, as a table: the values of the main keys, from the studies' sweeps."""
import functools

import yaml

from ratchet_sieve.plots import MM
from ratchet_sieve.texts import shown, table
from sweeps import DIRECTORY

# Header, keys (of several species: of each its own), factor from SI units.
COLUMNS = (("teeth", ("base.teeth",), 1), ("a", ("base.asymmetry",), 1), ("w [mm]", ("base.tooth_width",), MM),
           ("h [mm]", ("base.tooth_height",), MM),
           ("r [mm]", ("species.0.radius", "species.1.radius"), MM), ("d", ("density",), 1),
           ("e", ("species.0.restitution", "species.1.restitution"), 1),
           ("μ", ("species.0.friction", "species.1.friction"), 1),
           ("β", ("species.0.tangential_restitution", "species.1.tangential_restitution"), 1),
           ("v_min [m/s]", ("contact.min_rebound_speed",), 1), ("A [mm]", ("base.amplitude",), MM),
           ("f [Hz]", ("base.frequency",), 1), ("time [s]", ("duration",), 1))


@functools.lru_cache(maxsize=None)
def definition(sweep):
    """@return (scene, the rest) of a file of config/sweeps"""
    path = DIRECTORY / f"{sweep}.yaml"
    read = yaml.safe_load(path.read_text(encoding="utf-8"))
    scene = read.pop("scene")
    if isinstance(scene, str):
        scene = yaml.safe_load((path.parent / scene).read_text(encoding="utf-8"))
    return scene, read


def lookup(scene, key):
    """@return None where the scene has no such key"""
    for part in key.split("."):
        try:
            scene = scene[int(part) if isinstance(scene, list) else part]
        except (KeyError, IndexError):
            return None
    return scene


def listed(values):
    return [values["from"], values["to"]] if isinstance(values, dict) else values


def values_of(sweep, key):
    """All values of a key in a sweep, in order."""
    scene, rest = definition(sweep)
    value = rest.get("set", {}).get(key, lookup(scene, key))
    for swept in (rest.get("grid", {}), rest.get("zip", {})):
        if key in swept:
            return sorted(listed(swept[key]))
    return sorted({found for case in rest.get("cases", [{}]) if (found := case.get(key, value)) is not None})


def told(sweep, keys, scale):
    """One value, or the least and the greatest; of species that differ, each species' own."""
    texts = []
    for key in keys:
        if values := values_of(sweep, key):
            ends = [shown(scale * values[0]), shown(scale * values[-1])]
            texts.append(" to ".join(ends if ends[0] != ends[1] else ends[:1]))
    return "; ".join(dict.fromkeys(texts)) or "—"


def machines(studies):
    """A row for each sweep of the studies, in their order."""
    names = list(dict.fromkeys(name for study in studies for name in study.sweeps))
    seeds = (definition(name)[1]["seed"] for name in names)
    return table(["sweep", *(header for header, _, _ in COLUMNS), "n"],
                 [[name.partition("_")[2], *(told(name, keys, scale) for _, keys, scale in COLUMNS), seed["count"]]
                  for name, seed in zip(names, seeds)])
