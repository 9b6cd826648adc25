"""The results of a search: the front and the best machine of each kind, from fresh seeds."""
import dataclasses

from ratchet_sieve.optimise.machine import front
from ratchet_sieve.optimise.optimiser import seek
from ratchet_sieve.texts import counted

MOST_ON_FRONT = 8  # machines that are measured anew: of a longer front both ends and some between, evenly


@dataclasses.dataclass(frozen=True)
class Found:
    """The results of one kind of machine."""
    kind: object
    tried: list   # pairs (machine, Measured by the search's seeds) of all that are allowed
    front: list   # pairs (machine, Measured by held-out seeds)
    best: object  # such a pair: the highest goal by the search's seeds, at the search's throughput; None: there is none


def thinned(points):
    count = len(points)
    if count <= MOST_ON_FRONT:
        return points
    return [points[round(k * (count - 1) / (MOST_ON_FRONT - 1))] for k in range(MOST_ON_FRONT)]


def best_at(points, throughput):
    enough = [point for point in points if point[1].throughput.value >= throughput]
    return max(enough, key=lambda point: point[1].goal.value, default=None)


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
        again = [pair for pair in zip(chosen, trials.measure(chosen, search.held_out) if chosen else ())
                 if pair[1].is_whole()]
        anew = next((pair for pair in again if best and pair[0] == best[0]), None)
        found.append(Found(kind, tried, again, anew))
    return found
