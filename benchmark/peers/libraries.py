"""The versions of the other programs."""
import os
import pathlib
import re
import shutil
import subprocess

LIBRARIES = {"chipmunk": ("chipmunk_mixture", "Chipmunk"), "box2d": ("box2d_mixture", "Box2D")}


def package_version(path):
    """The package that a file belongs to, with its version; None if there is none."""
    if not shutil.which("dpkg-query"):
        return None
    for name in (path, os.path.realpath(path)):
        owner = subprocess.run(["dpkg-query", "-S", name], capture_output=True, text=True, check=False).stdout
        if owner:
            package = owner.split(": ", 1)[0]
            version = subprocess.run(["dpkg-query", "-W", "-f", "${Version}", package], capture_output=True, text=True,
                                     check=True).stdout
            return f"{package.split(':')[0]} {version}"
    return None


def linked_library(program, name):
    """The path of the shared library of that name that a program loads."""
    listing = subprocess.run(["ldd", str(program)], capture_output=True, text=True, check=False).stdout
    found = re.search(rf"lib{name}\S* => (\S+)", listing)
    return found.group(1) if found else None


def libraries(programs, lammps, runs):
    """One line for each other program."""
    lines = []
    for name, (program, title) in LIBRARIES.items():
        own = [run for run in runs if run["program"] == name]
        library = linked_library(programs / program, name) if own else None
        if not own:
            continue
        line = f"{title} {own[0]['version']} ({library and package_version(library) or 'not from a package'}"
        if any(run["debug"] for run in own):
            line += "; a debug build, by its own message"
        elif library and b"__assert_fail" in pathlib.Path(library).read_bytes():
            line += "; with its assertions compiled in"
        lines.append(line + ")")
    own = [run for run in runs if run["program"] == "lammps"]
    if own:
        package = package_version(shutil.which(lammps)) or "not from a package"
        lines.append(f"LAMMPS {own[0]['version']} ({package}; one process)")
    return lines
