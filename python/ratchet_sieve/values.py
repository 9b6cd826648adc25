"""Results as they are named in a summary."""
from __future__ import annotations

from typing import Any, Mapping, Optional

# The units of a summary's numbers, by their names; "" has none. Of what has parts: one for all, or those of each.
OF_SPECIES: dict[str, Any] = {
    **dict.fromkeys(("count", "left", "right", "size_quality"), ""), "mean_vx": "m/s", "mean_vx_stderr": "m/s",
    "kinetic_translational": "J", "kinetic_rotational": "J", "collision_rate": "1/s",
    "size_classes": {"radius": "m", "count": "", "left": "", "right": "", "mean_vx": "m/s", "mean_vx_stderr": "m/s"},
}
UNITS: dict[str, Any] = {
    **OF_SPECIES,
    **dict.fromkeys(("seed", "plan", "events", "collisions", "short_to_long", "contacts_by_face", "quality",
                     "separation", "separation_by_mass", "pair_qualities", "processed", "purity", "recovery",
                     "collapses", "through_base", "pushed_out", "warnings", "counted"), ""),
    **dict.fromkeys(("energy_start", "energy_end"), "J"),
    "simulated_time": "s", "wall_time": "s", "base_impulse": "N s", "max_overlap": "m", "throughput": "1/s",
    "species": OF_SPECIES,
    "accuracy": {"reached": "", "confidence": "", "transient": "s", "mean_vx": "m/s", "quality": "", "separation": ""},
    "steady_needs": "s",
    "steady": {**dict.fromkeys(("separation", "separation_by_mass", "quality", "purity", "recovery", "inside"), ""), "from": "s",
               "throughput": {"mass": "kg/s", "number": "1/s"}, "exits": {"mass": "kg", "number": ""}},
    "residence_times": {"count": "", **dict.fromkeys(
        ("mean", "standard_deviation", "quantile_10", "median", "quantile_90", "from", "to"), "s")},
    "mass_flow": {"mass": "kg", "mean": "kg/s", "stderr": "kg/s", "flow": "kg/s", "time": "s"},
    "height_profile": {
        "disks": "", "share_above": "", "temperature": "J", "phase_from": "rad", "phase_to": "rad",
        "number_density": "1/m^2", "velocity_along": "m/s", "velocity_up": "m/s",
        **dict.fromkeys(("mean_height", "median_height", "quantile_90_height", "from", "to"), "m")},
}


def unit_of(name: str) -> Optional[str]:
    """The unit of a number of a summary, by its name there or as a column of a sweep; None: there is no such number."""
    units: Any = UNITS
    for part in name.split("."):  # those that are not found are names of species, bins and places
        if isinstance(units, Mapping):
            units = units.get(part, units if units is not UNITS else None)
    return units if isinstance(units, str) else None


class Values(dict):
    """A mapping whose items are attributes as well: summary.species[0].mean_vx. Undefined values are None."""

    @classmethod
    def of(cls, value: Any) -> Any:
        """The same with Values in place of all mappings within it."""
        if isinstance(value, dict):
            return cls((key, Values.of(item)) for key, item in value.items())
        if isinstance(value, list):
            return [Values.of(item) for item in value]
        return value

    def __getattr__(self, name: str) -> Any:
        try:
            return self[name]
        except KeyError:
            raise AttributeError(f"there is no {name}; there are {', '.join(map(str, self))}") from None

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *map(str, self)]


class Summary(Values):
    """The summary of a run, key by key as `sieve_run` prints it; see docs/recording.md.

    SI units: `unit("mean_vx")`. Undefined values are None.
    """

    @staticmethod
    def unit(name: str) -> str:
        """The unit of a number, such as "m/s"; "" for a number without one. A dotted name, such as
        "accuracy.mean_vx.half_width", is a part's, or a column's of a sweep. Raises KeyError if there is none."""
        unit = unit_of(name)
        if unit is None:
            raise KeyError(f"a summary has no number {name}")
        return unit

    def of_species(self, name: str) -> Values:
        """The results of a species. Raises KeyError if there is none of this name."""
        found: Values
        for found in self["species"]:
            if found["name"] == name:
                return found
        raise KeyError(f"there is no species {name!r}")

    def __repr__(self) -> str:
        lines = [f"{name:24} {_text(value)} {unit_of(name) or ''}".rstrip()
                 for name, value in self.items() if not isinstance(value, (dict, list))]
        for species in self["species"]:
            lines.append(f"species {species['name']}")
            lines += [f"  {name:22} {_text(value)} {unit_of(name) or ''}".rstrip()
                      for name, value in species.items() if not isinstance(value, (dict, list)) and name != "name"]
        return "\n".join(lines)


def _text(value: Any) -> str:
    if value is None:
        return "undefined"
    return f"{value:.6g}" if isinstance(value, float) else str(value)
