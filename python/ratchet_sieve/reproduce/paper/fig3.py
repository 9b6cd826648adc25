"""Fig. 3: single disks drift to the right and spread."""
from ratchet_sieve import plots
from ratchet_sieve.reproduce import verdicts
from ratchet_sieve.reproduce.paper import displacements


def claims(samples):
    return [verdicts.Claim("1", "Fig. 3", "the displacement distribution drifts to the right and spreads with time", (
        verdicts.above("⟨V_x⟩ > 0", displacements.velocity(samples), 0.0, plots.MM, "mm/s"),
        verdicts.counted("its mean moves to the right from each time to the next",
                         displacements.further(samples, 1.0)),
        displacements.spreads(samples)))]


STUDY = displacements.study("fig3", "Fig. 3: displacements at θ = 0", claims)
