"""Where and when something was measured."""
import datetime
import os
import pathlib
import platform
import re

from ratchet_sieve.places import WORK


def processor():
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return platform.machine()


def system():
    if hasattr(platform, "freedesktop_os_release"):
        return platform.freedesktop_os_release().get("PRETTY_NAME", platform.system())
    return platform.system()


def describe():
    """@return the date of today and the machine, as texts"""
    return {"date": str(datetime.date.today()), "machine": f"{processor()}, {os.cpu_count()} cores, {system()}"}


def physics():
    """The version of the physics of this checkout."""
    header = WORK / "include/ratchet_sieve/core/physics_version.h"
    return re.search(r"PHYSICS_VERSION = (\d+)", header.read_text(encoding="utf-8")).group(1)


def describe_physics():
    """describe() with the version of the physics that is measured."""
    return {**describe(), "version": f"physics version {physics()}"}


def text(about=None):
    """@param about what describe() or describe_physics() gave; None: what this checkout gives"""
    about = about or describe_physics()
    return ", ".join(about[key] for key in ("date", "machine", "version") if key in about)
