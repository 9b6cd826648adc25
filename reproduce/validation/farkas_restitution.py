"""Two kinds of one size and mass, restitution 0.4 and 0.8."""
from reproduce.validation import farkas

STUDY = farkas.study("1", "restitution", "restitution", ("A: e = 0.4", "B: e = 0.8"), "SCENE")
