"""The processor time that each sweep of a results file took. It is kept in a file beside the results."""
import json
import os
import subprocess


class SweepFailed(Exception):
    """With a message of one line."""


def read_seconds(file):
    try:
        seconds = json.loads(file.read_text(encoding="utf-8")) if file.exists() else {}
    except ValueError:
        seconds = None
    if not isinstance(seconds, dict) or not all(isinstance(value, (int, float)) for value in seconds.values()):
        raise SweepFailed(f"{file}: must be a JSON object of numbers, and is damaged; remove it: only the processor "
                          "times of earlier runs are lost")
    return seconds


class Costs:
    def __init__(self, results):
        self.file = results.with_name(results.name + ".seconds.json")
        self.seconds = read_seconds(self.file)

    def run(self, name, command, output):
        """Runs a command for a sweep. @return its exit code"""
        with subprocess.Popen(command, stdout=output) as process:
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
        self.seconds[name] = self.seconds.get(name, 0.0) + usage.ru_utime + usage.ru_stime
        aside = self.file.with_name(self.file.name + ".part")
        aside.write_text(json.dumps(self.seconds, indent=1) + "\n", encoding="utf-8")
        aside.replace(self.file)
        return process.returncode

    def of(self, name):
        """All that was run for a sweep [s]; None where it is not known."""
        return self.seconds.get(name)
