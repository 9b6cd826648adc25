#!/usr/bin/python3
"""Writes the files and names of the version that is built, to test later ones with. Usage: write_files.py FOLDER

In the package's environment (. devel/setup.bash); programs: RATCHET_SIEVE_PROGRAMS, or those in devel/lib.
"""
import contextlib
import csv
import importlib
import inspect
import json
import os
import re
import shutil
import sqlite3
import subprocess
import sys
import tempfile
import warnings
import xml.etree.ElementTree as xml
from pathlib import Path

import rosgraph
import rospy
import rosservice
import yaml

import ratchet_sieve as rs
from ratchet_sieve.msg import BaseSetpoint
from ratchet_sieve.processes import TIMEOUT, free_port, wait_for
from ratchet_sieve.srv import LockStep

PACKAGE = Path(__file__).resolve().parents[2]
PROGRAMS = Path(os.environ.get("RATCHET_SIEVE_PROGRAMS", PACKAGE / "devel/lib/ratchet_sieve"))
COMMANDS = ("sieve_run", *(f"sieve_sweep {name}" for name in ("run", "status", "report", "export", "merge")),
            "sieve_separate", "sieve_analyze", "sieve_resimulate")
PYTHON = {rs: rs.__all__, rs.env: rs.env.__all__, rs.stats: ("Mean", "holm", "jackknife", "mean_of", "signs"),
          rs.plots: ("bins", "displacements", "sweep_curves", "sweep_map", "tracks")}
CONSTRUCTED = (rs.Scene, rs.Simulation, rs.env.SieveEnv, rs.env.SieveVectorEnv, rs.env.Task, rs.stats.Mean)


def output(program, *arguments, cwd=None):
    """What a program prints."""
    return subprocess.check_output([PROGRAMS / program, *arguments], cwd=cwd, text=True)


def scene_keys():
    """Of each key of a scene its type, unit, default and choices."""
    table = {}
    for line in output("sieve_run", "--keys").splitlines()[1:]:
        key, *cells = re.split(" {2,}", line)
        if key and cells:
            kind, unit, allowed, default = cells[:4]
            choices = re.split(", | or ", allowed) if kind == "choice" or key == "observe" else []
            table[key] = {"type": kind, "unit": unit, "default": default, "choices": choices}
    return table


def options(command):
    return re.findall(r"^ +(?:-\w, ?)?(--[\w-]+)", output(*command.split(), "--help"), re.MULTILINE)


def parameters(node):
    """Of --help, where `~rates/display, clock` are two."""
    lines = re.findall(r"^  (~[\w/]+)((?:, \w+)*)", output(node, "--help"), re.MULTILINE)
    return [re.sub(r"\w+$", "", first) + name for first, others in lines
            for name in [re.findall(r"\w+$", first)[0], *others.split(", ")[1:]]]


def messages():
    """The checksum of each message and service."""
    return {kind._type: kind._md5sum for module, mark in (("msg", "_md5sum"), ("srv", "_request_class"))
            for kind in vars(importlib.import_module(f"ratchet_sieve.{module}")).values() if hasattr(kind, mark)}


def record(scene, bag):
    """Records a commanded run, on a master of its own. @return the topics and services of the node, with their types"""
    port = str(free_port())
    os.environ.update(ROS_MASTER_URI="http://localhost:" + port, ROS_HOSTNAME="localhost")
    core = subprocess.Popen(["rosmaster", "--core", "-p", port], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    rates = [f"_recording/{name}:=5" for name in ("particles", "bins", "base", "statistics")]
    try:
        wait_for(rosgraph.is_master_online, "rosmaster")
        sieve = subprocess.Popen([PROGRAMS / "sieve_node", "__name:=sieve", f"_scene_file:={scene}", f"_record:={bag}",
                                  "_start_paused:=true", *rates], stdout=subprocess.DEVNULL)
        wait_for(lambda: "/sieve/lock_step" in rosservice.get_service_list(), "sieve_node")
        step = rospy.ServiceProxy("/sieve/lock_step", LockStep)
        step([BaseSetpoint("inclination", 0.05), BaseSetpoint("frequency", 25.0)], 0.25)
        master = rosgraph.Master("/names")
        published, subscribed, services = ([name for name, nodes in table if "/sieve" in nodes]
                                           for table in master.getSystemState())
        types = {**dict(master.getTopicTypes()), **{name: rosservice.get_service_type(name) for name in services}}
        step([BaseSetpoint("amplitude", 0.0015)], 1.0)
        sieve.wait(TIMEOUT)
    finally:
        core.terminate()
        core.wait()
    return [{name: types[name] for name in names} for names in (published, subscribed, services)]


def calls():
    """The parameters of functions, of methods, and of constructors that users call; of other names null."""
    table = {}
    for module, names in PYTHON.items():
        for name in names:
            value, path = getattr(module, name), f"{module.__name__}.{name}"
            table[path] = None if inspect.isclass(value) and value not in CONSTRUCTED else parameters_of(value)
            for kind in value.__mro__ if inspect.isclass(value) else ():
                if kind.__module__.startswith("ratchet_sieve"):
                    table.update({f"{path}.{member}": parameters_of(getattr(value, member, None))
                                  for member in {*vars(kind), *vars(kind).get("__annotations__", {})}
                                  if not member.startswith("_")})
    return table


def parameters_of(value):
    """Each with its position, or * where it is only named, and = where it has a default; ... for any number of them."""
    if not callable(value):
        return None
    places = {inspect.Parameter.KEYWORD_ONLY: "*", inspect.Parameter.VAR_POSITIONAL: "...",
              inspect.Parameter.VAR_KEYWORD: "..."}
    return {of.name: places.get(of.kind, str(k)) + "=" * (of.default is not of.empty)
            for k, of in enumerate(inspect.signature(value).parameters.values())}


def columns(machine, tables):
    """Of arrays and tables; and the attributes of a run."""
    run = rs.run(machine, frames=1, collisions=True, progress=False)
    arrays = {"disks": run.simulation.disks, "frames.disks": run.frames.disks[0], "frames.base": run.frames.base,
              "frames.bins": run.frames.bins["A"], "exits": run.exits, "collisions": run.collisions.records}
    return {"run": list(vars(run)), **{name: list(array.dtype.names) for name, array in arrays.items()},
            **{path.name: next(csv.reader(path.open(newline=""))) for path in tables.rglob("*.csv")}}


def scene_values(folder):
    return {name: rs.Scene.load(folder / f"{name}.yaml").values for name in ("machine", "placed", "second")}


def bag_results(bag, folder, *options):
    """What is read from a bag. @param options of sieve_analyze"""
    output("sieve_analyze", bag, "--summary", folder / "analysis.json", *options)
    frames = rs.read_bag(bag).frames
    return {"analysis": json.loads((folder / "analysis.json").read_text()), "time": frames.time.tolist(),
            **{name: {column: array[column].tolist() for column in array.dtype.names}
               for name, array in (("disks", frames.disks[-1]), ("base", frames.base), ("bins", frames.bins["A"]))}}


def write(folder):
    warnings.simplefilter("ignore", rs.SieveWarning)
    shutil.copytree(Path(__file__).with_name("scenes"), folder)
    scenes = "".join(path.read_text() for path in folder.iterdir())
    for key in scene_keys():
        assert re.search(rf"\b{key.rpartition('.')[2]}:", scenes), f"no scene has the key {key}"
    machine, bag, sweep = folder / "machine.yaml", folder / "run.bag", folder / "sweep.yaml"
    with tempfile.TemporaryDirectory() as directory:
        tables = Path(directory)
        summary = output("sieve_run", machine, "--exits", folder / "exits.csv",
                         "--collisions", tables / "collisions.csv")
        output("sieve_run", machine, "--duration", "0.3", "--checkpoint", folder / "run.checkpoint")
        output("sieve_sweep", "run", "sweep.yaml", cwd=folder)
        with contextlib.closing(sqlite3.connect(folder / "sweep.db")) as results:
            results.execute("UPDATE cases SET host = 'here'").connection.commit()
        output("sieve_sweep", "export", sweep, "--out", folder / "cases.csv")
        node = record(machine, bag)
        results = {"summary": json.loads(summary), "scenes": scene_values(folder),
                   "bag": bag_results(bag, tables, "--out", tables / "tables")}
        for name in ("exits.csv", "cases.csv"):
            shutil.copy(folder / name, tables)
        names = {"version": rs.__version__, "physics": rs.origin.physics(), "keys": scene_keys(), "node": node,
                 "options": {command: options(command) for command in COMMANDS}, "messages": messages(),
                 "parameters": {name: parameters(name) for name in ("sieve_node", "sieve_display")},
                 "launch": {path.name: [of.get("name") for of in xml.parse(path).getroot().findall("arg")]
                            for path in (PACKAGE / "launch").glob("*.launch")},
                 "calls": calls(), "columns": columns(machine, tables)}
    (folder / "names.yaml").write_text(yaml.safe_dump(names, default_flow_style=None, width=118))
    (folder / "results.json").write_text(json.dumps(results, indent=1, sort_keys=True) + "\n")
    for name in ("sweep.db", "run.checkpoint", "results.json", "run.bag"):
        subprocess.run(["gzip", "-9n", folder / name], check=True)


if __name__ == "__main__":
    write(Path(sys.argv[1]))
