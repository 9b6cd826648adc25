"""Studies: sweeps of runs, what they say about a printed claim, their pictures, and the document made of them."""
