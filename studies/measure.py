"""Measures all that the documents state: every benchmark and study, one after the other, on a machine that does nothing
else. What is done is kept; an interruption loses the job that was running. With EDMD=DIR it is compared as well.

Exit status: 1 where a job failed or the machine is busy, 2 for wrong arguments, 130 after Ctrl-C.
"""
import argparse
import datetime
import json
import os
import pathlib
import signal
import subprocess
import sys
import time

import yaml

from ratchet_sieve import origin
from ratchet_sieve.places import WORK

LOOK = 0.5   # how long the processors are watched before a job [s]
QUIET = 0.1  # processors that others may use
PATIENCE = 600.0  # with a machine that is busy [s]
LAST = 30.0  # of a job that is interrupted [s]


def read_arguments():
    parser = argparse.ArgumentParser(prog="measure", description=__doc__.partition("\n\n")[0])
    parser.add_argument("--list", action="store_true", help="list the jobs, and which are done")
    parser.add_argument("--only", nargs="+", metavar="JOB", help="only these")
    parser.add_argument("--continue", action="store_true", dest="goes_on", help="keep what is done in the folder")
    parser.add_argument("--busy", action="store_true", help="measure on a busy machine, too; the load is noted")
    parser.add_argument("--folder", type=pathlib.Path, default=WORK / "out/measure", metavar="DIR",
                        help="of a log and a record of each job (default: out/measure)")
    parser.add_argument("--jobs", type=pathlib.Path, default=pathlib.Path(__file__).with_name("measurements.yaml"),
                        metavar="FILE", help="names and commands of the jobs (default: studies/measurements.yaml)")
    options = parser.parse_args()
    options.jobs = yaml.safe_load(options.jobs.read_text(encoding="utf-8"))
    for name in options.only or ():
        if name not in options.jobs:
            parser.error(f"--only {name}: no such job; there are {', '.join(options.jobs)}")
    done = [name for name in options.jobs if is_done(options.folder, name)]
    if done and not (options.goes_on or options.list):
        parser.error(f"{options.folder} has {len(done)} of {len(options.jobs)} jobs done: --continue keeps them")
    return options


def record_of(folder, name):
    path = folder / f"{name}.json"
    return json.loads(path.read_text(encoding="utf-8")) if path.exists() else {}


def is_done(folder, name):
    """With today's physics, on this machine."""
    record, now = record_of(folder, name), origin.describe_physics()
    return record.get("status") == 0 and all(record[key] == now[key] for key in ("machine", "version"))


def busy_processors():
    """How many processors others use, watched for a while."""
    def times():
        with open("/proc/stat", encoding="ascii") as stat:
            numbers = [int(number) for number in stat.readline().split()[1:9]]
        return sum(numbers), numbers[3] + numbers[4]  # all; idle and waiting for the disk
    before = times()
    time.sleep(LOOK)
    spent, idle = (after - early for after, early in zip(times(), before))
    return os.cpu_count() * (1.0 - idle / spent) if spent else 0.0


def wait_for_quiet(is_busy_allowed):
    """@return the load when nothing else runs, or at once where that is allowed. None: it stays busy"""
    until = time.monotonic() + PATIENCE
    while True:
        load = busy_processors()
        if load <= QUIET or is_busy_allowed:
            return load
        if time.monotonic() > until:
            return None
        print(f"busy: others use {load:.2f} of {os.cpu_count()} processors; waiting", flush=True)
        time.sleep(30.0)


def finish(command, log):
    """Runs a command. @return its exit status; an interruption ends all of its processes, and is raised again"""
    with subprocess.Popen(["bash", "-c", command], cwd=WORK, stdout=log, stderr=subprocess.STDOUT,
                          start_new_session=True) as process:
        try:
            return process.wait()
        except KeyboardInterrupt:
            os.killpg(process.pid, signal.SIGINT)
            try:
                process.wait(LAST)
            except subprocess.TimeoutExpired:
                os.killpg(process.pid, signal.SIGKILL)
            raise


def run(folder, name, command, load):
    """Runs a job, its output into NAME.log, and records it. @return its exit status"""
    begin = datetime.datetime.now()
    print(f"{name}: {begin:%Y-%m-%d %H:%M}, others use {load:.2f} of {os.cpu_count()} processors", flush=True)
    with open(folder / f"{name}.log", "w", encoding="utf-8") as log:
        status = finish(command, log)
    minutes = (datetime.datetime.now() - begin).total_seconds() / 60.0
    (folder / f"{name}.json").write_text(json.dumps({
        **origin.describe_physics(), "status": status, "minutes": round(minutes, 1), "load": round(load, 2)}) + "\n",
        encoding="utf-8")
    print(f"  {'done' if status == 0 else f'failed with {status}: see {folder / name}.log'}, {minutes:.1f} min",
          flush=True)
    return status


def main():
    options = read_arguments()
    names = [name for name in options.jobs if not options.only or name in options.only]
    if options.list:
        for name in names:
            print(f"{name}: {'done' if is_done(options.folder, name) else 'to do'}: {options.jobs[name]}")
        return 0
    options.folder.mkdir(parents=True, exist_ok=True)
    failed = 0
    for name in names:
        if is_done(options.folder, name):
            print(f"{name}: done before")
            continue
        load = wait_for_quiet(options.busy)
        if load is None:
            print(f"measure: {name}: the machine stays busy; --continue goes on later, --busy measures all the same",
                  file=sys.stderr)
            return 1
        failed += run(options.folder, name, options.jobs[name], load) != 0
    return 1 if failed else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        sys.exit(130)
