"""Studies: sweeps of runs, the claims that they test, their pictures, and the documents made from them."""
