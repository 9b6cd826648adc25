"""Two kinds of one size and mass, friction 0 and 0.6."""
from reproduce.validation import farkas

STUDY = farkas.study("2", "friction", "friction", ("A: μ = 0", "B: μ = 0.6"), "SCENE")
