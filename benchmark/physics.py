"""The version of the physics that is measured."""
import pathlib
import re

from ratchet_sieve import origin

HEADER = pathlib.Path(__file__).resolve().parent.parent / "include/ratchet_sieve/core/physics_version.h"


def version():
    return re.search(r"PHYSICS_VERSION = (\d+)", HEADER.read_text(encoding="utf-8")).group(1)


def describe():
    """Date, machine and version of a measurement, as texts."""
    return {**origin.describe(), "version": f"physics version {version()}"}
