#!/usr/bin/python3
"""Runs clang-tidy on the sources of a build, several at a time.

A source that passed is skipped until it, a header that it includes, its compile command, .clang-tidy or clang-tidy
changes: BUILD_DIR/clang_tidy keeps an empty file for each that passed. Exit status: 0 without findings, 1 otherwise.
"""
import argparse
import concurrent.futures
import functools
import hashlib
import json
import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

# Joined sources stand in the build directory, which may be elsewhere.
CONFIG = Path(__file__).resolve().parents[2] / ".clang-tidy"
EXTRA_ARGUMENTS = ["-extra-arg=-std=c++17", "-extra-arg=-Wno-ignored-optimization-argument"]


def output_of(*command, cwd=None):
    return subprocess.run(command, cwd=cwd, capture_output=True, text=True, check=True).stdout


@functools.lru_cache(maxsize=None)
def digest(path):
    """Hash of a file's content; of nothing if it does not exist."""
    try:
        return hashlib.sha256(path.read_bytes()).hexdigest()
    except OSError:
        return ""


def dependencies(build_dir):
    """The files that each object file depends on, by its path below the build directory."""
    found = {}
    for line in output_of("ninja", "-t", "deps", cwd=build_dir).splitlines():
        if line.startswith("    "):
            found[target].append(build_dir / line.strip())
        elif line:
            target = re.match(r"(.*): #deps", line)[1]
            found[target] = []
    return found


def commands(build_dir, sources):
    """The compile commands of the files below `sources`, and of the files in the build that join them; each once."""
    roots = {sources, build_dir / sources.name}
    found = {}
    for entry in json.loads((build_dir / "compile_commands.json").read_text()):
        source = Path(entry["file"])
        if roots.intersection(source.parents):
            found.setdefault(source, entry["command"])
    return found


def key_of(command, read, tool):
    parts = [tool, command] + [f"{path} {digest(path)}" for path in sorted(read)]
    return hashlib.sha256("\n".join(parts).encode()).hexdigest()


def check(program, build_dir, source, stamp):
    """Returns clang-tidy's findings in one source; nothing if it passed."""
    run = subprocess.run([program, "-quiet", "-p", build_dir, f"--config-file={CONFIG}", *EXTRA_ARGUMENTS, source],
                         capture_output=True, text=True, check=False)
    if run.returncode == 0:
        stamp.touch()
        return ""
    return run.stdout + run.stderr


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build_dir", type=Path, help="built with Ninja, with compile_commands.json")
    parser.add_argument("sources", type=Path, help="directory below which sources are checked")
    parser.add_argument("--program", default="clang-tidy")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    arguments = parser.parse_args()
    build_dir, sources = arguments.build_dir.resolve(), arguments.sources.resolve()
    tool = output_of(arguments.program, "--version") + CONFIG.read_text()
    stamps = build_dir / "clang_tidy"
    stamps.mkdir(exist_ok=True)
    read = dependencies(build_dir)
    open_checks = {}
    for source, command in commands(build_dir, sources).items():
        words = shlex.split(command)
        target = words[words.index("-o") + 1]
        # Files not compiled in this build have no list of headers: they are checked each time.
        stamp = stamps / (key_of(command, read[target], tool) if target in read else "not_compiled")
        if not stamp.exists() or target not in read:
            open_checks[source] = stamp
    found = 0
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        runs = {pool.submit(check, arguments.program, build_dir, *one): one[0] for one in open_checks.items()}
        for done, run in enumerate(concurrent.futures.as_completed(runs), 1):
            report = run.result()
            found += bool(report)
            print(f"[{done}/{len(runs)}] {os.path.relpath(runs[run], sources)}\n{report}", end="", flush=True)
    print(f"{len(open_checks)} sources checked, {found} with findings")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
