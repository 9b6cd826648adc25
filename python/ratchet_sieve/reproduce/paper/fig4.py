"""Fig. 4: an inclination of 0.209 turns the current of Fig. 3."""
from ratchet_sieve import plots
from ratchet_sieve.reproduce import verdicts
from ratchet_sieve.reproduce.paper import displacements


def claims(samples):
    return [verdicts.Claim("3", "Fig. 4", "θ = 0.209 turns that current to the left", (
        verdicts.below("⟨V_x⟩ < 0", displacements.velocity(samples), 0.0, plots.MM, "mm/s"),
        verdicts.counted("its mean moves to the left from each time to the next",
                         displacements.further(samples, -1.0)),
        displacements.spreads(samples)))]


STUDY = displacements.study("fig4", "Fig. 4: displacements at θ = 0.209", claims)
