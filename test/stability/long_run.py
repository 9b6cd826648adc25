"""One ball on a flat plate for a very long time: its phase is as accurate at the end as at the start."""
import csv
import json
import math
import pathlib
import subprocess
import tempfile

RADIUS = 0.001
RESTITUTION, AMPLITUDE, FREQUENCY, GRAVITY = 0.6, 0.00011, 50.0, 9.81
OMEGA = 2.0 * math.pi * FREQUENCY

# The period-one orbit hits at this phase (Luck & Mehta, Phys. Rev. E 48, 3988 (1993)).
PHASE = math.acos(GRAVITY * (1.0 - RESTITUTION) / (2.0 * FREQUENCY * AMPLITUDE * OMEGA * (1.0 + RESTITUTION)))

SETTLED = 60.0  # time at which the run has converged to the orbit [s]
WATCHED = 20.0  # [s]
HEAD = ("| Simulated time | Collisions so far | Hits watched | Largest deviation from the orbit's phase [rad] "
        "| A double's resolution of that time | Largest overlap so far / radius |\n|---|---|---|---|---|---|\n")


def scene():
    return {
        "base": {"teeth": 5, "tooth_height": 0.0, "amplitude": AMPLITUDE, "frequency": FREQUENCY, "phase": PHASE},
        "species": [{"name": "A", "radius": RADIUS, "mass": 0.001, "restitution": RESTITUTION, "friction": 0.0}],
        "contact": {"pair_collisions": False, "min_rebound_speed": 0.0},
        "initial": [{"species": "A", "x": 0.05, "y": RADIUS + AMPLITUDE * math.sin(PHASE) + 1e-6,
                     "vy": 0.5 * GRAVITY / FREQUENCY}],
    }


class Run:
    """A run of the ball that is continued from checkpoint to checkpoint."""

    def __init__(self, program, directory):
        self.program = program
        self.directory = pathlib.Path(directory)
        self.started = False
        (self.directory / "scene.yaml").write_text(json.dumps(scene()))

    def advance(self, time, *options):
        checkpoint = self.directory / "checkpoint"
        resume = ["--resume", checkpoint] if self.started else []
        self.started = True
        run = subprocess.run([self.program, self.directory / "scene.yaml", "--duration", repr(time),
                              "--checkpoint", checkpoint, *resume, *options],
                             capture_output=True, text=True, check=True)
        return json.loads(run.stdout)

    def watch(self, time):
        """Runs to `time`, then records the hits. Returns a row of the table, and the largest deviation."""
        hits = self.directory / "hits.csv"
        self.advance(time)
        summary = self.advance(time + WATCHED, "--collisions", hits)
        with open(hits, encoding="ascii") as file:
            times = [float(line["time"]) for line in csv.DictReader(file)]
        deviation = max(abs(math.remainder(math.fmod(t * FREQUENCY, 1.0) * 2.0 * math.pi, 2.0 * math.pi))
                        for t in times)
        resolution = OMEGA * math.ulp(time)
        overlap = summary["max_overlap"] / RADIUS
        row = (f"| {time:,.0f} s | {sum(summary['collisions'].values()):,} | {len(times)} | {deviation:.1e} "
               f"| {resolution:.1e} | {overlap:.1e} |")
        good = deviation <= 1e-10 + 4.0 * resolution and overlap <= 1e-9 and len(times) >= WATCHED * FREQUENCY - 1
        return row, good


def measure(program, end):
    """The rows of the table, and the number of failures."""
    rows, failed = [], 0
    with tempfile.TemporaryDirectory() as directory:
        run = Run(program, directory)
        for time in (SETTLED, end):
            row, good = run.watch(time)
            rows.append(row)
            failed += not good
            print(row, *([] if good else ["  WRONG"]), sep="\n", flush=True)
    return rows, failed
