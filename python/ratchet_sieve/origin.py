"""Where and when something was measured."""
import datetime
import os
import pathlib
import platform


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


def text(about=None):
    """@param about what describe() gave"""
    return "{date}, {machine}".format(**(about or describe()))
