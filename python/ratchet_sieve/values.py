"""Results as they are named in a summary."""
from __future__ import annotations

from typing import Any

# Of every number of a summary that has a unit, by the last part of its name.
UNITS = {
    "simulated_time": "s", "wall_time": "s", "transient": "s", "mean_vx": "m/s", "mean_vx_stderr": "m/s",
    "kinetic_translational": "J", "kinetic_rotational": "J", "collision_rate": "1/s", "base_impulse": "N s",
    "energy_start": "J", "energy_end": "J", "max_overlap": "m", "radius": "m",
}


class Values(dict):
    """A mapping whose items are attributes as well: summary.species[0].mean_vx. Undefined values are None."""

    @classmethod
    def of(cls, value: Any) -> Any:
        """The same with Values in place of all mappings."""
        if isinstance(value, dict):
            return cls((key, cls.of(item)) for key, item in value.items())
        if isinstance(value, list):
            return [cls.of(item) for item in value]
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
        """The unit of a number, such as "m/s"; "" for a number without one."""
        return UNITS.get(name.rsplit(".", 1)[-1], "")

    def of_species(self, name: str) -> Values:
        """The results of a species. Raises KeyError if there is none of this name."""
        found: Values
        for found in self["species"]:
            if found["name"] == name:
                return found
        raise KeyError(f"there is no species {name!r}")

    def __repr__(self) -> str:
        lines = [f"{name:24} {_text(value)} {self.unit(name)}".rstrip()
                 for name, value in self.items() if not isinstance(value, (dict, list))]
        for species in self["species"]:
            lines.append(f"species {species['name']}")
            lines += [f"  {name:22} {_text(value)} {self.unit(name)}".rstrip()
                      for name, value in species.items() if not isinstance(value, (dict, list)) and name != "name"]
        return "\n".join(lines)


def _text(value: Any) -> str:
    if value is None:
        return "undefined"
    return f"{value:.6g}" if isinstance(value, float) else str(value)
