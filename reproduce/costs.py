"""The processor time that went into a results file, sweep by sweep. Kept beside it: a result is taken up at no cost."""
import json
import os
import subprocess


class Costs:
    def __init__(self, results):
        self.file = results.with_name(results.name + ".seconds.json")
        self.seconds = json.loads(self.file.read_text(encoding="utf-8")) if self.file.exists() else {}

    def run(self, name, command, output):
        """Runs a command for a sweep. @return its exit code"""
        with subprocess.Popen(command, stdout=output) as process:
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
        self.seconds[name] = self.seconds.get(name, 0.0) + usage.ru_utime + usage.ru_stime
        self.file.write_text(json.dumps(self.seconds, indent=1) + "\n", encoding="utf-8")
        return process.returncode

    def of(self, name):
        """Of all that was ever run for a sweep [s]; None where that is not known."""
        return self.seconds.get(name)
