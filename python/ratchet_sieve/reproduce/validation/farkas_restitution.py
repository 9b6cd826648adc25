"""Two kinds of one size and mass, restitution 0.4 and 0.8."""
from ratchet_sieve.reproduce.validation import farkas

STUDY = farkas.study("1", "restitution", ("A: e = 0.4", "B: e = 0.8"),
                     "1 m of teeth of 5 mm, h = 4 mm, A = 1.4 mm, d = 0.1 at the start, 200 s")
