"""Two kinds of one size and mass, friction 0 and 0.6."""
from ratchet_sieve.reproduce.validation import farkas

STUDY = farkas.study("2", "friction", ("A: μ = 0", "B: μ = 0.6"),
                     "1 m of teeth of 5 mm, h = 3.2 mm, A = 1.4 mm, d = 0.1 at the start, 300 s")
