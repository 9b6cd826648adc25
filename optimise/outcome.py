"""What a search comes to: of each kind of machine the front, and the best one, by seeds that were not searched by."""
import dataclasses

from optimise.machine import front
from optimise.optimiser import seek

MOST_ON_FRONT = 8  # machines that are measured anew; of a longer front the ends and those between, evenly


@dataclasses.dataclass(frozen=True)
class Found:
    """A kind of machine."""
    kind: object
    tried: list   # pairs (machine, Measured by the search's seeds) of all that are allowed
    front: list   # pairs (machine, Measured by held-out seeds)
    best: object  # such a pair: highest Q, by the search's seeds, at the search's throughput; None: there is none


def thinned(points):
    count = len(points)
    if count <= MOST_ON_FRONT:
        return points
    return [points[round(k * (count - 1) / (MOST_ON_FRONT - 1))] for k in range(MOST_ON_FRONT)]


def best_at(points, throughput):
    enough = [point for point in points if point[1].throughput.value >= throughput]
    return max(enough, key=lambda point: point[1].quality.value, default=None)


def find(search, trials, say):
    """@return a Found for each kind; each begins with what was best of the one before"""
    found, chosen = [], []
    for kind in search.kinds:
        tried = seek(search, kind, chosen, trials, say)
        best = best_at(tried, search.throughput)
        chosen = [machine for machine, _ in thinned(front(tried))]
        if best and best[0] not in chosen:
            chosen.append(best[0])
        say(f"{kind.name}: {len(chosen)} machines again, with {search.held_out.count} other seeds")
        again = [pair for pair in zip(chosen, trials.measure(chosen, search.held_out) if chosen else ())
                 if pair[1].is_whole()]
        anew = next((pair for pair in again if best and pair[0] == best[0]), None)
        found.append(Found(kind, tried, again, anew))
    return found
