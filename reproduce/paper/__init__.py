"""The figures of the paper that the machine comes from."""
from reproduce.paper import fig5

STUDIES = (fig5.STUDY,)
