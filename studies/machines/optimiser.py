"""Searches for machines of one kind with a high goal (Q, unless the search names another) and a high throughput, by
Optuna's tree-structured Parzen estimators (Watanabe, arXiv 2304.11127; of several objectives: Ozaki et al., GECCO 2020,
doi 10.1145/3377930.3389817).

Q of one seed is noisy, and so are other goals: a trial is the mean over some seeds, the sampler draws from densities
over all trials, so that a single lucky one does not decide, and the results come from fresh seeds (held_out).
"""
import pathlib
import tempfile
import warnings

import optuna
import yaml

from ratchet_sieve.texts import counted
from machines.search import Found, best_at, front, measured, require_goal, thinned
from sweeps import export

BATCH = 8     # trials at a time, for the cores to share
DIGITS = 4    # of a value that is tried, so that scenes are readable
FIRST = 16    # trials that are spread over the ranges before densities are used
SEED = 1      # of the sampler: the same search tries the same machines

optuna.logging.set_verbosity(optuna.logging.WARNING)
warnings.filterwarnings("ignore", category=optuna.exceptions.ExperimentalWarning)


class Trials:
    """Measures machines by sieve_sweep, each once."""

    def __init__(self, options, search):
        self.options, self.search = options, search
        self.version = None  # of the program that made the results

    def measure(self, machines, seeds):
        """@param machines all with the same keys. @return of each a Measured or None"""
        search = self.search
        sweep = {"scene": search.scene, "set": search.settings, "cases": machines,
                 "seed": {"first": seeds.first, "count": seeds.count}}
        with tempfile.TemporaryDirectory() as directory:
            file = pathlib.Path(directory) / "machines.yaml"
            file.write_text(yaml.safe_dump(sweep, sort_keys=False), encoding="utf-8")
            # A machine whose run fails is not allowed: the search goes on.
            rows = export(self.options.program, file, self.options.results, self.options.jobs)
        if rows:
            require_goal(search.goal, rows, search.path)
            self.version = f"{rows[-1]['version']}, physics version {rows[-1]['physics']:g}"
        return [measured(rows.where(machine), search.scene_of(machine)["base"], seeds, search.goal)
                for machine in machines]


def suggested(trial, search, kind):
    machine = {}
    for key in kind.vary:
        low, high = search.ranges[key]
        if isinstance(low, int) and isinstance(high, int):
            machine[key] = trial.suggest_int(key, low, high)
        else:
            machine[key] = float(f"{trial.suggest_float(key, low, high):.{DIGITS}g}")
    return machine


def make_study(kind, known):
    sampler = optuna.samplers.TPESampler(seed=SEED, multivariate=True, constant_liar=True, n_startup_trials=FIRST,
                                         constraints_func=lambda trial: trial.user_attrs["lacking"])
    study = optuna.create_study(directions=["maximize", "maximize"], sampler=sampler)
    for machine in known:
        study.enqueue_trial({key: machine.get(key, kind.start.get(key)) for key in kind.vary})
    return study


def tell(study, trial, found, least_processed):
    """How far P is below its limit says that a machine is not allowed."""
    if found is None:
        trial.set_user_attr("lacking", [1.0])
        study.tell(trial, state=optuna.trial.TrialState.FAIL)
    else:
        trial.set_user_attr("lacking", [least_processed - found.processed.value])
        study.tell(trial, (found.goal.value, found.throughput.value))


def seek(search, kind, known, trials, say):
    """@param known machines that are tried first: good ones of the kind before
    @return pairs (machine, Measured by the search's seeds) of all allowed machines, in the order of their trials"""
    study, allowed = make_study(kind, known), []
    for first in range(0, kind.trials, BATCH):
        asked = [study.ask() for _ in range(min(BATCH, kind.trials - first))]
        machines = [suggested(trial, search, kind) for trial in asked]
        for trial, machine, found in zip(asked, machines, trials.measure(machines, search.seeds)):
            tell(study, trial, found, search.least_processed)
            if found and found.processed.value >= search.least_processed:
                allowed.append((machine, found))
        best = max((found.goal.value for _, found in allowed), default=None)
        say(f"{kind.name}: {first + len(asked)} of {counted(kind.trials, 'machine')}, {len(allowed)} allowed, "
            f"best {search.label} " + ("—" if best is None else f"{best:.3f}"))
    return allowed


def find(search, trials, say):
    """@return a Found for each kind; each search begins with the best machines of the kind before"""
    found, chosen = [], []
    for kind in search.kinds:
        tried = seek(search, kind, chosen, trials, say)
        best = best_at(tried, search.throughput)
        chosen = [machine for machine, _ in thinned(front(tried))]
        if best and best[0] not in chosen:
            chosen.append(best[0])
        say(f"{kind.name}: {counted(len(chosen), 'machine')} again, by "
            f"{counted(search.held_out.count, 'fresh seed')}")
        again = [pair for pair in zip(chosen, trials.measure(chosen, search.held_out) if chosen else ()) if pair[1]]
        anew = next((pair for pair in again if best and pair[0] == best[0]), None)
        found.append(Found(kind, tried, again, anew))
    return found
